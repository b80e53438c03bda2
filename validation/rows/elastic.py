"""The elastic constants of one packing with one bond law, as a row of a study.

A periodic cell gives its bulk moduli, a bar those of a tension test: the affine fit, and the paper's eqs (12)–(15).
"""

from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from bondem.calibration.response import Response
from bondem.interactions.beams.bond_law import BondLaw
from bondem.interactions.law_catalogue import PARAMETERS
from validation.rows.packings import PackingRequest, PackingTest, shared_lattice

#: What is measured; some of it in bars only, and slopes where they are asked for.
MEASURED = ("E", "nu", "stiffness_ratio", "E_paper", "nu_paper", "axial_share", "exponent", "nu_slope", "seconds")

#: Where: without walls, or in the paper's bar; told by `periodic` of a row.
SHAPES = {True: "periodic cell", False: "cylinder 10 x 40 mm"}


@dataclass(frozen=True)
class ElasticRequest(PackingTest):
    """Elastic constants of a packing with a law.

    Attributes:
        packing: the packing, made before.
        law: its bonds.
        slopes: whether to find how E and ν change with r̃, too.
    """

    law: BondLaw
    slopes: bool = False

    @property
    def asked(self) -> dict[str, Any]:
        """See `Request`; E_mu [Pa], nu_mu and the other parameters of the law [-]."""
        law = asdict(self.law)
        named = {"law": type(self.law).__name__, "E_mu": law.pop("E"), "nu_mu": law.pop("nu")}
        return super().asked | named | {name: law.get(name) for name in PARAMETERS}

    def measured(self, folder: Path) -> dict[str, Any]:
        """Solve.

        Returns:
            E [Pa], ν and E/E_μ; of bars also eqs (14) and (15) and the share of the energy that is in the elongation
            of bonds; where slopes are asked for, d ln E / d ln r̃ and dν / dr̃, by adjoints.
        """
        lattice = shared_lattice(self.packing, folder)
        solved = Response(lattice, self.law)
        found: dict[str, Any] = dict.fromkeys(MEASURED[:-1])
        found |= {"E": solved.E, "nu": solved.nu, "stiffness_ratio": solved.E / self.law.E}
        if solved.tension is not None:
            energy = solved.tension.solution.energy
            found |= {
                "E_paper": solved.tension.E_paper,
                "nu_paper": solved.tension.nu_paper,
                "axial_share": energy.normal / energy.total,
            }
        if self.slopes:
            slope = solved.slope("radius_ratio")
            assert self.law.radius_ratio is not None
            found |= {"exponent": self.law.radius_ratio * slope.log_E, "nu_slope": slope.nu}
        return found


def cells_and_bars(count: int, spread: float, *, cells: int, bars: int) -> list[PackingRequest]:
    """Packings of 6.2 contacts an element: periodic cells, seeds 1 … cells, then bars, seeds 1 … bars."""
    return [
        PackingRequest(count, spread, "quench", "contacts", seed, form == "cube", form)
        for form, last in (("cube", cells), ("bar", bars))
        for seed in range(1, last + 1)
    ]
