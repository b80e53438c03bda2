"""A crack that meets an interface between two stiffnesses, strong or weak: it goes on, or is deflected.

A crack normal to an interface is deflected where the toughness of the interface, over that of the material ahead, is
below G_d/G_p: about a quarter for equal stiffnesses, a fifth where the material ahead is a third as stiff and two
fifths where it is three times as stiff (He and Hutchinson, Int. J. Solids Struct. 25, 1989, figure 3 as we remember
it). A tenth is to deflect it in both, and an interface as tough as the materials is to let it through. Quantities:
length of the interface that has parted to both sides of the crack, over l, and how far the crack has gone beyond the
interface, over l. Deflected: more than 2 l and less than 1 l; through: less than 1 l and more than 2 l.

Fixed before the runs: the compact specimen of `validation.cases.toughness`, W = 14 l, a notch of 0.4 W, the interface
3 l ahead of it across the whole specimen, plane strain, both materials with the same f_t and G_f; E of 40 GPa before
the interface, and a third or three times of it behind; the weak interface with f_t/3 and G_f/10, evaluated by its own
traction; cells of 0.45 l, of one size so that they end on the interface; two in the thickness. Runs end at 0.15 of
the peak; in a first round they ended at half of it, which is where the crack meets the interface: three of four had
not come to it.
"""

from dataclasses import dataclass

import numpy as np

import bondem as bd
from validation.cases.case import Claim
from validation.cases.path_case import LOST, Outcome, PathCase
from validation.cases.spared import SparedRankine
from validation.cases.toughness import ENERGY, LENGTH, NU, RHO, TENSION, CompactTension, E

#: Width W, notch, and distance of the interface from it, over l.
OVER, NOTCH, AHEAD = 14.0, 5.6, 3.0
#: Strength and toughness of a weak interface over those of the materials [-].
WEAK = (1.0 / 3.0, 0.1)
# Size of cells and thickness over l.
_CELLS, _THICK = 0.45, 0.9
_RIPPLE, _TOGETHER, _UNTIL = 0.05, 0.01, 0.15


@dataclass(frozen=True)
class InterfaceCrack(PathCase):
    """A compact specimen of two materials.

    Attributes:
        ratio: E behind the interface over E before it [-].
        weak: whether the interface is weak.
    """

    ratio: float = 1.0
    weak: bool = False

    @property
    def plate(self) -> CompactTension:
        """The specimen without notch; its thickness is four times its cells."""
        return CompactTension(OVER, 0.25 * _THICK)

    @property
    def at(self) -> float:
        """Place of the interface, x from the line of the load [m]."""
        return (NOTCH + AHEAD) * LENGTH

    @property
    def shape(self) -> bd.Shape:
        return self.plate.notched(NOTCH * LENGTH, _CELLS * LENGTH)

    @property
    def behind(self) -> bd.Plane:
        """The material behind the interface."""
        return bd.Plane(point=(self.at, 0.0, 0.0), normal=(1.0, 0.0, 0.0))

    @property
    def size(self) -> float:
        return _CELLS / self.finer * LENGTH

    def packed(self, seed: int) -> bd.Particles:
        return bd.pack(self.shape, size=self.size, method="even", seed=seed, around=self.behind)

    def run(self, seed: int) -> Outcome:
        body, plate, rest, behind = self.body(seed), self.plate, bd.Everything(), self.behind
        loads, read = plate.ends(body)
        walls = [bd.Fix(bd.Face(name), translation="z", rotation="") for name in ("z_min", "z_max")]
        material = SparedRankine(tension=TENSION, fracture_energy=ENERGY, lines=plate.spared)
        strength, energy = WEAK if self.weak else (1.0, 1.0)
        joint = bd.Rankine(
            tension=strength * TENSION, fracture_energy=energy * ENERGY, on="traction" if self.weak else "stress"
        )
        failure: dict[bd.Region | tuple[bd.Region, bd.Region], bd.Criterion] = {
            rest: material, behind: material, (rest - behind, behind): joint,
        }  # fmt: skip
        law: dict[bd.Region, bd.CellBond] = {
            rest: bd.CellBond(E=E, nu=NU),
            behind: bd.CellBond(E=self.ratio * E, nu=NU),
        }
        model = bd.Model(body, law, RHO, failure=failure, boundary=[*walls, *loads])
        path = bd.solve_quasistatic(model, read, ripple=_RIPPLE, together=_TOGETHER, until=_UNTIL)
        assert body.facets is not None
        side = behind.mask(body)
        across = side[body.pairs[:, 0]] != side[body.pairs[:, 1]]
        lost = path.bond_integrity < 1.0 - LOST
        beyond = body.facets.centroid[lost & ~across, 0].max(initial=self.at) - self.at
        return Outcome(
            body=body, integrity=path.bond_integrity, curve=np.column_stack([path.displacement, path.load]),
            values={"parted": float(body.facets.area[lost & across].sum() / plate.thickness / LENGTH),
                    "beyond": float(beyond / LENGTH), "peak": path.peak},
        )  # fmt: skip


def _case(ratio: float, weak: bool) -> InterfaceCrack:
    ahead, kind = "stiffer" if ratio > 1.0 else "softer", "weak" if weak else "strong"
    parted, beyond = (
        (Claim("parted", 2.0, np.inf, "above 2 l"), Claim("beyond", 0.0, 1.0, "below 1 l")) if weak
        else (Claim("parted", 0.0, 1.0, "below 1 l"), Claim("beyond", 2.0, np.inf, "above 2 l"))
    )  # fmt: skip
    return InterfaceCrack(
        name=f"interface_{ahead}_{kind}", title=f"{kind} interface, {ahead} ahead", claims=(parted, beyond),
        window=((NOTCH - 2.0) * LENGTH, (NOTCH + 9.0) * LENGTH, -5.5 * LENGTH, 5.5 * LENGTH), ratio=ratio, weak=weak,
    )  # fmt: skip


INTERFACES = tuple(_case(ratio, weak) for ratio in (3.0, 1.0 / 3.0) for weak in (False, True))
