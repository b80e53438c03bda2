"""Brazilian test of bonded spheres: a disc with flats between plane platens, or a cylinder loaded on two strips."""

import math
from functools import partial

import numpy as np

from bondem._checks import number
from bondem._types import Floats, Ints
from bondem.boundary.gauges import Gauge, StrainGauge
from bondem.errors import InputError
from bondem.labtests.bonded_platens import LEAST, REACH, RECORDS, BondedSpecimen, Side
from bondem.labtests.disc import WIDEST, Disc, centre_stress, flattened, middle_of_disc, require_disc, stamped
from bondem.labtests.quasi_static_rig import Rig, RunOptions, StrengthTest
from bondem.model.model import Model
from bondem.observables.element_stress import element_stress
from bondem.specimen.regions import Index

# Half angle of the strips of a plain cylinder [rad], and lower limit of half their width in mean radii. Narrower
# strips break off single spheres before the cylinder splits.
_STRIP, _RADII = math.radians(10.0), 1.5
# Share of the peak at which a disc has split [-].
_SPLIT = 0.7


def split_bonded(
    specimen: BondedSpecimen, *, half_angle: float | None, friction: float, ending: float | None, options: RunOptions
) -> tuple[StrengthTest, float, float, float]:
    """Compress a disc of bonded spheres along y.

    Planes with a coefficient of `friction` [-] press on the flats of a disc. On a plain cylinder, the elements of two
    strips of a half angle [rad] approach along y; None for 10°, or more if radii are large. The test ends at a share
    `ending` of the peak load [-]; None for 0.7.

    Returns:
        Result of the test, elastic stress σ_zz at the centre over 2 P / (π D t) [-] (NaN for the non-local law), its
        theoretical value [-], and the half angle of flats or strips [rad].

    Raises:
        InputError: no disc, an angle out of range or without elements, or friction on strips or on flats of cells.
    """
    disc = require_disc(specimen.lattice)
    bottom, top, angle, factor = _pressed_elements(specimen, disc, half_angle, friction)
    section = 0.5 * math.pi * disc.diameter * disc.thickness
    compliance, force = specimen.response(1, bottom, top, section, 1.0, -3.0)
    centre = _centre(specimen, disc, bottom, top) * section
    if disc.flat is not None:
        below, above = (
            Side(layer, share, partial(specimen.platen, 1, side, friction))
            for layer, side, share in ((bottom, -1.0, 0.0), (top, 1.0, 1.0))
        )
        near, far, model = specimen.sides(1, (below,), (above,))
    else:
        near, far = ((Gauge(Index(strip), "force"),) for strip in (bottom, top))

        def model(speed: float, begin: float) -> Model:
            return specimen.driven(1, ((bottom, 0.0), (top, speed)), begin)

    rig = Rig(
        axis=1, sign=-1.0, near=near, far=far, section=section, torn=disc.diameter * disc.thickness,
        length=disc.diameter, size=disc.diameter, expected=force / section, way=compliance * force,
        reach=REACH * compliance * force, ending=_SPLIT if ending is None else ending, traverses=math.nan,
        model=model, gauge=StrainGauge(middle_of_disc(specimen.lattice, disc)), strain=_strained, least=LEAST,
        records=RECORDS,
    )  # fmt: skip
    test = specimen.load(rig, options)
    return test, centre, factor, angle


def _centre(specimen: BondedSpecimen, disc: Disc, bottom: Ints, top: Ints) -> float:
    """Compute the elastic stress σ_zz at the centre per load [1/m²]; NaN for the non-local law."""
    if not specimen.bare.interaction.has_potential:  # a static solution does not store its stresses
        return math.nan
    static = specimen.pressed(1, bottom, top)
    found = element_stress(static.model, static)
    load = abs(float(static.reaction[top, 1].sum()))
    return centre_stress(found.centre - disc.middle, found.volume, found.stress[:, 2, 2], disc) / load


def _pressed_elements(
    specimen: BondedSpecimen, disc: Disc, half_angle: float | None, friction: float
) -> tuple[Ints, Ints, float, float]:
    """Select the loaded elements at bottom and top, as indices (k,) each.

    The result also has the half angle of flats or strips [rad], and the theoretical centre stress over 2 P / (π D t).
    """
    disc.refuse_angle(half_angle)
    if disc.flat is not None:
        specimen.require_smooth(friction)
        bottom, top = (specimen.layer(1, side) for side in (-1.0, 1.0))
        return bottom, top, disc.flat, flattened(disc.flat)
    if friction > 0.0:
        raise InputError(
            f"labtests.brazilian: platen_friction = {friction:g}: the strips of a plain cylinder of bonded spheres"
            ' are smooth; use a disc with the flats "top" and "bottom", which planes with friction press'
        )
    mean, radius = float(specimen.bare.contact_radius.mean()), 0.5 * disc.diameter
    usual = max(_STRIP, math.asin(min(_RADII * mean / radius, 1.0)))
    advice = f"half an angle in (0, {WIDEST:.3g}) rad; finer packings allow for narrow strips"
    angle = number(
        "labtests.brazilian", "half_angle", usual if half_angle is None else half_angle, above=0.0,
        below=WIDEST, advice=advice,
    )  # fmt: skip
    y, z = (specimen.lattice.centre - disc.middle)[:, 1:].T
    rim = (np.hypot(y, z) + specimen.bare.contact_radius > radius - mean) & specimen.lattice.connected
    bottom, top = (np.flatnonzero(rim & (np.abs(np.arctan2(z, side * y)) < angle)) for side in (-1.0, 1.0))
    if not len(bottom) or not len(top):
        raise InputError(
            f"labtests.brazilian: half_angle = {angle:.3g} rad contains no element; give a larger half_angle"
            " or a finer packing"
        )
    return bottom, top, angle, stamped(angle)


def _strained(strains: Floats) -> Floats:
    """Compute 2 P / (π D t E) [-], (k,), from the normal strains at the centre of a disc, (k, 3), for σ_x = 0."""
    return -0.5 * (strains[:, 1] + strains[:, 2] - strains[:, 0])
