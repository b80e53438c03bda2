"""Division of a shape into one cell per element: facets, volumes, and the part of the surface of each cell."""
