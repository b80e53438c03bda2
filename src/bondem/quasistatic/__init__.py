"""Fracture without inertia: one event after the other, each at the load factor at which it is next."""
