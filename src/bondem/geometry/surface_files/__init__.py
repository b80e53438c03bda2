"""Readers of surface files: STL, OBJ, 3MF, PLY and OFF."""
