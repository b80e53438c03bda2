"""Cases of `loading_paths.py`: strength and fracture energy on loading paths whose answer is known."""

import os

# Bodies are small: a second thread costs more than it brings, and cases run beside each other.
os.environ.setdefault("NUMBA_NUM_THREADS", "1")
