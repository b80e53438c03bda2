"""Physics of one bond: parameters as frozen data, and the scalar functions that every loop calls."""
