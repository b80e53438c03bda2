"""CUDA twins of the loops: one thread an element, a bond, or a part of a sum; loaded only for `device="gpu"`."""
