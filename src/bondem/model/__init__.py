"""What is simulated: a lattice with bonds, masses and boundary conditions, and its state."""
