"""The model: a lattice with bonds, masses and boundary conditions, and its state."""
