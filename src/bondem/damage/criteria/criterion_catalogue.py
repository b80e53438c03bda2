"""Catalogue of the failure criteria, by the names of their classes."""

from bondem.damage.criteria.criterion import Criterion
from bondem.damage.criteria.drucker_prager import DruckerPrager
from bondem.damage.criteria.elliptic import Elliptic
from bondem.damage.criteria.hydrostatic import Hydrostatic
from bondem.damage.criteria.linear_sum import LinearSum
from bondem.damage.criteria.mohr_coulomb import MohrCoulomb
from bondem.damage.criteria.peripheral_stress import PeripheralStress
from bondem.damage.criteria.rankine import Rankine
from bondem.damage.criteria.stress_criterion import StressCriterion

CRITERIA: dict[str, type[Criterion]] = {
    criterion.__name__: criterion
    for criterion in (
        PeripheralStress, MohrCoulomb, LinearSum, Elliptic, Rankine, DruckerPrager, Hydrostatic, StressCriterion,
    )
}  # fmt: skip
