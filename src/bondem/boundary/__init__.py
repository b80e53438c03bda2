"""Boundary conditions: fixed, driven and loaded elements, schedules over time, and walls."""
