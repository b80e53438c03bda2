"""Discs of Brazilian tests: their shape, and closed forms of the stress at their centre."""

import math
from dataclasses import dataclass

import numpy as np

from bondem._types import Floats
from bondem.errors import InputError
from bondem.labtests.arguments import refuse_turned
from bondem.labtests.line_probe import walls_along
from bondem.specimen.lattice import Lattice
from bondem.specimen.regions import Index, Region

#: Largest half angle of the strips [rad].
WIDEST = math.radians(20.0)
# Stress and strain at the centre are evaluated within these shares of the radius.
_CENTRE, _GAUGE = 0.25, 0.5


@dataclass(frozen=True, eq=False)
class Disc:
    """Disc with the axis x, loaded along y.

    Attributes:
        middle: centre of the disc [m], (3,).
        diameter: diameter D [m].
        thickness: thickness t [m].
        flat: half the angle of its flats seen from the axis [rad]; None for a plain cylinder.
    """

    middle: Floats
    diameter: float
    thickness: float
    flat: float | None

    def refuse_angle(self, half_angle: float | None) -> None:
        """Raise InputError for a half angle of strips if the disc has flats."""
        if self.flat is not None and half_angle is not None:
            raise InputError(
                "labtests.brazilian: half_angle is an option of plain cylinders; leave it out for a disc with flats"
            )


def require_disc(body: Lattice) -> Disc:
    """Return the disc of a body: a cylinder along x, plain or with the faces "top" and "bottom" as flats.

    Raises:
        InputError: another shape, a turned one, or a hole at the centre.
    """
    refuse_turned("brazilian", body, "top bottom")
    shape = body.particles.envelope
    lower, upper = shape.bounds
    length, height, diameter = (float(extent) for extent in upper - lower)
    middle = 0.5 * (lower + upper)
    if not shape.contains(middle).all():
        raise InputError(
            "labtests.brazilian: the disc has a hole at its centre, where its strength and strains are evaluated;"
            " use a solid disc, or drive a bd.Model of this one with bd.solve_explicit"
        )
    if {"top", "bottom"} <= set(shape.faces):
        if body.cells is None:
            _, walls = walls_along(shape, middle, middle + np.array([0.0, 0.501 * diameter, 0.0]))
            flat = float(walls[0])
        else:
            on = body.on_face("top")
            flat = float(np.average(body.cells.free.centroid[on, 1], weights=body.cells.free.area[on])) - middle[1]
        return Disc(middle, diameter, length, math.acos(min(flat / (0.5 * diameter), 1.0 - 1e-6)))
    if not {"side", "x_min", "x_max"} <= set(shape.faces) or abs(height - diameter) > 1e-6 * diameter:
        raise InputError(
            "labtests.brazilian: the body is not a cylinder along x; use bd.Cylinder, or one whose flats across y are"
            ' the faces "top" and "bottom"'
        )
    return Disc(middle, diameter, length, None)


def stamped(half_angle: float) -> float:
    """Return the centre stress over 2 P / (π D t) [-] under smooth rigid stamps on strips of a `half_angle` [rad]."""
    angle = math.pi * (np.arange(64) + 0.5) / 64
    sine = math.sin(half_angle) * np.cos(angle)
    return float((np.sqrt(1.0 - sine**2) * (1.0 - 4.0 * sine**2)).mean())


def flattened(half_angle: float) -> float:
    """Return the centre stress over 2 P / (π D t) [-] for flats of a `half_angle` [rad], by Wang et al. (2004)."""
    c, s = math.cos(half_angle), math.sin(half_angle) / half_angle
    return (2.0 * c**3 + c + s) ** 2 / (8.0 * (c + s)) / s


def centre_stress(position: Floats, volume: Floats, across: Floats, disc: Disc) -> float:
    """Evaluate the stress σ_zz at the centre [Pa], by a quadratic fit to elements within a quarter of the radius.

    Args:
        position: places of the elements relative to the centre [m], (n, 3).
        volume: volumes of the elements [m³], (n,).
        across: stress σ_zz of the elements [Pa], (n,).
        disc: the disc.
    """
    near = np.hypot(position[:, 1], position[:, 2]) < _CENTRE * 0.5 * disc.diameter
    weight = np.sqrt(volume[near])[:, None]
    y, z = position[near, 1], position[near, 2]
    columns = np.column_stack([np.ones(len(y)), y**2, z**2])
    return float(np.linalg.lstsq(weight * columns, weight[:, 0] * across[near], rcond=None)[0][0])


def middle_of_disc(body: Lattice, disc: Disc) -> Region:
    """Select the elements whose distance from the axis of the disc is below half its radius."""
    position = body.centre - disc.middle
    return Index(np.flatnonzero(np.hypot(position[:, 1], position[:, 2]) < _GAUGE * 0.5 * disc.diameter))
