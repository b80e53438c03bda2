"""Criteria of failure, one a file: parameters, and the scalar function that judges one bond."""
