"""Explicit dynamics: the step as lists of passes, schemes, damping, time step, events and history."""
