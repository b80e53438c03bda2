"""Shapes of specimens: their surface, walls and moments."""
