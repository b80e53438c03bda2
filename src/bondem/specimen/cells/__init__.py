"""The shape cut into one cell an element: facets, volumes, what of the surface belongs to which cell."""
