"""Results of fracture: fragments, cracks and emissions. Functions take arrays and return arrays."""
