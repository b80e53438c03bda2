"""The cell law: facets and cells of a tessellation under one potential."""
