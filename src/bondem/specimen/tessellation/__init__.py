"""The shape cut into one cell per element: facets, volumes, and the part of the surface of each cell."""
