"""Damage: criteria, strengths and their scatter, softening, and the events of breakage."""
