"""Bonds as beams: one module per law, and the constants and tables that all laws share."""
