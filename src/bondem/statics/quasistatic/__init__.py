"""Fracture without inertia, as a sequence of events, each at its own load factor."""
