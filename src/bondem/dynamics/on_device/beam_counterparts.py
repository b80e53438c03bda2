"""Beams on a device."""

import numpy as np

from bondem._passes import kernels
from bondem._tables.columns import WORKS_OF_PORTION
from bondem._tables.device_tables import LoadsOfBonds, StrainPortions
from bondem._tables.step_tables import Portions, Strain
from bondem.dynamics.on_device.translation import (
    Counterpart,
    Given,
    Made,
    Translation,
    bonds,
    in_order,
    length_of,
    one_thread,
    over,
)

#: Loads of bonds are those of their dashpots.
DASHED: Made = {LoadsOfBonds: lambda run, _: run.dashed}


def _strained(_: Translation, given: Given) -> int:
    """Return the number of portions of beams whose strain changes."""
    return -(-len(given[Strain].bond) // WORKS_OF_PORTION)


def _portions(run: Translation, given: Given) -> StrainPortions:
    def make() -> StrainPortions:
        return StrainPortions(np.zeros(2, dtype=np.int64), np.zeros((_strained(run, given), len(strain.schedule))))

    strain = given[Strain]
    return run.once(strain, make)


_STRAINS: Made = {StrainPortions: _portions}

COUNTERPARTS: dict[str, Counterpart] = {
    "follow_strains": in_order(
        over(kernels.follow_strain_factors, one_thread, _STRAINS),
        over(kernels.strain_portion, _strained, _STRAINS),
        over(kernels.add_work_of_strains, one_thread, _STRAINS),
    ),
    "add_beam_loads": over(kernels.load_beam, bonds),
    "add_alike_beam_loads": over(kernels.load_alike_beam, bonds),
    "add_dashpot_loads": over(kernels.load_dashpot, bonds, DASHED),
    "check_beams": over(kernels.check_portion, length_of(Portions, lambda p: p.turned)),
    "sum_beam_energies": over(kernels.sum_portion_of_beams, length_of(Portions, lambda p: p.bonds)),
}
