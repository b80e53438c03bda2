"""Catalogue of the laws of bonds and cells, by the names of their classes."""

from collections.abc import Mapping

from bondem.interactions.beams.assignment import BondAssignment
from bondem.interactions.beams.beam_interaction import BeamInteraction
from bondem.interactions.beams.bond_law import BondLaw
from bondem.interactions.beams.contact_bond import ContactBond
from bondem.interactions.beams.euler_bernoulli import EulerBernoulli
from bondem.interactions.beams.free_parameter import RADIUS_RATIO, FreeParameter
from bondem.interactions.beams.obermayr import Obermayr
from bondem.interactions.beams.parallel_bond import ParallelBond
from bondem.interactions.beams.timoshenko import Timoshenko
from bondem.interactions.cells.cell_bond import CellBond
from bondem.interactions.cells.cell_constants import CellAssignment
from bondem.interactions.cells.cell_interaction import CellInteraction
from bondem.interactions.interaction import Interaction
from bondem.interactions.non_local.non_local_interaction import NonLocalInteraction
from bondem.interactions.non_local.non_local_law import NonLocal

#: Laws of a specimen: a bond law or laws by region, a cell law or cell laws by region, or the non-local law.
AnyLaw = BondAssignment | CellAssignment | NonLocal

# Bond laws in the order of recommendation. Euler–Bernoulli bonds are those of the paper that bondem follows, and
# their only parameter beside E_μ is geometric. Obermayr and parallel bonds reach the widest range of ν, by a factor
# on the shear stiffness alone. Timoshenko bonds hardly change ν, and contact bonds allow elements to roll.
_LAWS: tuple[type[BondLaw], ...] = (EulerBernoulli, Obermayr, ParallelBond, Timoshenko, ContactBond)

#: Every law by the name of its class.
LAWS: dict[str, type[BondLaw]] = {law.__name__: law for law in _LAWS}

#: Bond laws for calibrated packings. Laws without moments are left out: elements that may roll have no static
#: solution.
CALIBRATED: dict[str, type[BondLaw]] = {name: law for name, law in LAWS.items() if law.moments}

#: Laws of bodies cut into cells, by the name of the class: they have the material's own E and ν, and no calibration.
CELL_LAWS: dict[str, type[CellBond]] = {law.__name__: law for law in (CellBond,)}

#: Laws without regions and without calibration, by the name of the class.
WHOLE_LAWS: dict[str, type] = {NonLocal.__name__: NonLocal}

#: The law of the paper (André et al. 2012), the default of studies.
DEFAULT: type[BondLaw] = EulerBernoulli

#: r̃ and every parameter beside it that a law varies, by name.
PARAMETERS: dict[str, FreeParameter] = {one.name: one for one in (RADIUS_RATIO, *(law.free for law in _LAWS))}


def named(law: str) -> str:
    """Return the common name of a bond or cell law by the name of its class, or this name itself for other laws."""
    known = LAWS | CELL_LAWS
    return known[law].title if law in known else law


def kind_of(bond: object) -> type[Interaction]:
    """Return the class of interaction of a law, or of laws by region; that of beams for any other object."""
    laws = tuple(bond.values()) if isinstance(bond, Mapping) else (bond,)
    for kind in (CellInteraction, NonLocalInteraction):
        if any(isinstance(law, kind.law) for law in laws):
            return kind
    return BeamInteraction
