"""Passes that Python calls, of `core/passes/tessellation/balance.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Call
from bondem._tables.tessellation_tables import BalanceField, CellBranches


def apply_balance(cell_branches: CellBranches, balance_field: BalanceField) -> Call:
    """Computes the equation of each cell for given multipliers: its column sums of facet corrections."""
    return Call("apply_balance", (cell_branches, balance_field))
