"""How far a run is from the exact motion: measures, a finer run, the verdict."""
