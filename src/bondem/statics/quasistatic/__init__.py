"""Fracture without inertia: one event after another, each at its own load factor."""
