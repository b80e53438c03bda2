"""Drucker–Prager criterion: shear strength that grows with pressure, defined by two material strengths."""

import math
from dataclasses import dataclass

from bondem._checks import number
from bondem._plausibility import physical
from bondem.damage.bilinear import Bilinear
from bondem.damage.cohesive_softening import Slip, Softening, StressIndex, check_crack, check_slip
from bondem.damage.criteria.criterion import Criterion
from bondem.errors import InputError

_ROOT = math.sqrt(3.0)
_NAME = "DruckerPrager"


@dataclass(frozen=True, kw_only=True)
class DruckerPrager(Criterion):
    """Failure of cells where the shear of their stress reaches a cohesion that grows with pressure.

        √J2 + α I1 ≥ k     J2 = s:s/2 of the deviator s,  I1 = σ1 + σ2 + σ3,  tension positive

    Two of three strengths are given, and the third follows. f_t and f_c are uniaxial strengths, and f_h is that in
    equal tension from all sides:

        α = (f_c - f_t) / √3 (f_c + f_t)      k = 2 f_c f_t / √3 (f_c + f_t) = 3 α f_h

    Without a fracture energy, facets in tension (t·n > 0) break at once where σ* of `bd.Rankine` reaches the cone,
    also if the cells are under pressure. A body splits along the load, because facets in compression cannot open.

    With a fracture energy the cone has two sides. For I1 > 0 facets in tension crack as for `bd.Rankine`, up to the
    opening 2 G_f / f_t. For I1 ≤ 0 cells yield on their mean stress, √J2 + α I1 ≥ r k. r falls from 1 to 0 with the
    mean slip of the cells half a band width away, so that a band dissipates G_II per area. Friction (α) remains.
    Facets of a cell that has slipped and has no cohesion break.

    Attributes:
        tension: f_t [Pa].
        compression: f_c [Pa], positive, f_t or more.
        hydrostatic: f_h [Pa], above 2/3 f_t.
        fracture_energy: G_f of tension [J/m²]; None for brittle facets.
        fracture_energy_shear: G_II of slip [J/m²], inf for a constant cohesion; 10 G_f by default.
        dilatancy: β of the flow potential √J2 + β I1 [-], in [0, α]; the volume grows by 3 β of the slip.
        band_width: width of shear bands between cells [m], by which G_II becomes a work per volume; None for four
            cells, of the size of each.
        friction: μ on the faces of closed cracks [-].
        curve: softening curve of cracks; None for a straight line.

    Reference: Drucker and Prager (1952).

    Raises:
        InputError: The strengths are not two, or no cone passes through them; a value is out of range; or a parameter
            of yielding is given without the fracture energy of tension.
    """

    tension: float | None = None
    compression: float | None = None
    hydrostatic: float | None = None
    fracture_energy: float | None = None
    fracture_energy_shear: float | None = None
    dilatancy: float = 0.0
    band_width: float | None = None
    friction: float = 0.0
    curve: Bilinear | None = None

    def __post_init__(self) -> None:
        super().__post_init__()
        given = [name for name in ("tension", "compression", "hydrostatic") if getattr(self, name) is not None]
        for name in given:
            physical(_NAME, name, getattr(self, name))
        if len(given) != 2:
            raise InputError(
                f"{_NAME}: {', '.join(given) or 'no strength'} given; give two of tension, compression and"
                " hydrostatic, the third follows"
            )
        self._check_cone()
        check_crack(_NAME, self.fracture_energy, self.friction, self.curve)
        number(_NAME, "dilatancy", self.dilatancy, least=0.0)
        if self.dilatancy > self.slope:
            raise InputError(f"{_NAME}: dilatancy = {self.dilatancy:g}; give β in [0, α] = [0, {self.slope:.4g}]")
        check_slip(_NAME, self.fracture_energy, self.fracture_energy_shear, self.dilatancy, self.band_width)

    def _check_cone(self) -> None:
        ft, fc, fh = self.tension, self.compression, self.hydrostatic
        if ft is not None and fc is not None and fc < ft:
            raise InputError(f"{_NAME}: compression = {fc:g} Pa is below tension = {ft:g} Pa; give at least as much")
        if ft is not None and fh is not None and 3.0 * fh <= 2.0 * ft:
            raise InputError(
                f"{_NAME}: hydrostatic = {fh:g} Pa is no more than 2/3 of tension = {ft:g} Pa, where no compression"
                " fails; give more"
            )

    @property
    def slope(self) -> float:
        """Slope α of the cone [-]."""
        ft, fc, fh = self.tension, self.compression, self.hydrostatic
        if ft is None:
            assert fc is not None
            assert fh is not None
            return fc / (_ROOT * (3.0 * fh + fc))
        if fc is None:
            assert fh is not None
            return ft / (_ROOT * (3.0 * fh - ft))
        return (fc - ft) / (_ROOT * (fc + ft))

    @property
    def strength(self) -> float:
        """Strength k in pure shear [Pa]."""
        if self.hydrostatic is not None:
            return 3.0 * self.slope * self.hydrostatic
        assert self.tension is not None
        return self.tension * (1.0 / _ROOT + self.slope)

    @property
    def softening(self) -> Softening:
        slope, k, energy = self.slope, self.strength, self.fracture_energy
        slips: tuple[Slip, ...] = ()
        if energy is not None:
            shear = self.fracture_energy_shear
            slips = (Slip(
                cone=True, cohesion=k, strength=k, slope=slope, dilation=self.dilatancy,
                fracture_energy=10.0 * energy if shear is None else shear, width=self.band_width,
            ),)  # fmt: skip
        return Softening(
            tension=k / (1.0 / _ROOT + slope), fracture_energy=energy or 0.0, friction=self.friction, slips=slips,
            surface=StressIndex(function="cone", values=(slope, k, float(len(slips)))),
            curve=self.curve,
        )  # fmt: skip
