"""What a run found, as data: states, quantities of bodies and joints, a summary."""
