"""Laws of bonds, cells, non-local springs and contacts, with their constants and tables."""
