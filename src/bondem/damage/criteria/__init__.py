"""Failure criteria, one file each."""
