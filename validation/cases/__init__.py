"""Published fracture tests, a file each: geometry, material, supports, and what a run is held against."""
