"""Files: the run file (output and restart in one), particles, and exchange with other programs."""
