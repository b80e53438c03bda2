"""Passes that Python calls, of `core/passes/tessellation/balance.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Call
from bondem._tables.tessellation_tables import BalanceField, CellBranches


def apply_balance(cell_branches: CellBranches, balance_field: BalanceField) -> Call:
    """Applies the operator N of the balanced shares to the tensors of all cells."""
    return Call("apply_balance", (cell_branches, balance_field))
