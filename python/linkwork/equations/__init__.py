"""The equations of motion at one state: their terms, a consistent initial state, their stiffness."""
