"""Many studies at once: what is varied, on which cluster, and the table of all."""
