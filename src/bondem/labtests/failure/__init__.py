"""Tests to failure, each in a file with the name of its function."""
