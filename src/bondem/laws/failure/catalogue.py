"""Catalogue of the failure criteria, by the names of their classes."""

from bondem.laws.failure.criterion import Criterion
from bondem.laws.failure.drucker_prager import DruckerPrager
from bondem.laws.failure.elliptic import Elliptic
from bondem.laws.failure.hydrostatic import Hydrostatic
from bondem.laws.failure.linear_sum import LinearSum
from bondem.laws.failure.mohr_coulomb import MohrCoulomb
from bondem.laws.failure.peripheral_stress import PeripheralStress
from bondem.laws.failure.rankine import Rankine
from bondem.laws.failure.stress_criterion import StressCriterion

CRITERIA: dict[str, type[Criterion]] = {
    criterion.__name__: criterion
    for criterion in (
        PeripheralStress, MohrCoulomb, LinearSum, Elliptic, Rankine, DruckerPrager, Hydrostatic, StressCriterion,
    )
}  # fmt: skip
