"""Tests of bondem. Numbers that pages print are those of the kernels of OpenBLAS for this CPU, not of others."""

import os

# Read when NumPy is imported; other kernels round otherwise, and fractures follow the last bit.
os.environ.pop("OPENBLAS_CORETYPE", None)
