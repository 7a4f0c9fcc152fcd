"""A result: its quantities by name, and the file that holds them."""
