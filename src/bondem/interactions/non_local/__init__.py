"""The non-local law of Celigueta et al. (2020)."""
