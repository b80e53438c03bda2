"""Cases of `loading_paths.py`: strength and fracture energy on loading paths whose answer is known."""
