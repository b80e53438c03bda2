"""Bonds as beams: one file for each law, and the constants and tables of all."""
