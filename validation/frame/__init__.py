"""What every study shares: rows, the runner, tables, the page, and the command."""
