"""Rows: what one packing or one test of it gives."""
