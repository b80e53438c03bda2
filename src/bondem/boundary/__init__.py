"""Boundary conditions: who is held, driven or loaded, by how much, and the walls."""
