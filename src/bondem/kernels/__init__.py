"""Compiled loops over bonds and elements. The physics they call lives in `bondem.laws`."""
