"""Readers of files that hold surfaces: STL, OBJ, 3MF, PLY and OFF."""
