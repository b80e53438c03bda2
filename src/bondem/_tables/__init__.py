"""Tables of the core, written by `python -m tests.core.tables`."""
