"""Physics of one bond: parameters as frozen data; `core/laws/` has the functions of the passes."""
