"""Checks of arguments that several laboratory tests share."""

import math
from typing import Any

import numpy as np

from bondem._checks import instance, number, possible
from bondem.errors import InputError
from bondem.geometry.face_patches import face_patches
from bondem.specimen.lattice import Lattice

# Largest angle between the normal of a loaded face and the axis of the load [rad]; surface files have seven digits.
_TILT = 1e-4

_RULES: dict[str, dict[str, Any]] = {
    "E": {"above": 0.0, "unit": "Pa", "advice": "the Young's modulus of the specimen in Pa"},
    "nu": {"above": -1.0, "below": 0.5, "advice": "the Poisson's ratio of the specimen, in (-1, 0.5)"},
    "rho": {"above": 0.0, "unit": "kg/m³", "advice": "a positive density in kg/m³"},
    "density": {"above": 0.0, "unit": "kg/m³", "advice": "a positive density of the elements in kg/m³"},
    "stress": {"unit": "Pa", "advice": "a stress in Pa other than zero"},
    "velocity": {"above": 0.0, "unit": "m/s", "advice": "a positive velocity in m/s"},
    "periods": {"above": 0.0, "advice": "a positive number of periods"},
    "depth": {"least": 0.0, "advice": "a depth of zero or more, in mean radii"},
}


def check(test: str, lattice: object, *, faces: str = "x_min x_max", **given: object) -> None:
    """Check that a lattice is one bonded body with loaded faces normal to the load, and that numbers are in range.

    Args:
        test: name of the calling function, for messages.
        lattice: the specimen.
        faces: names of the loaded faces, separated by blanks.
        **given: further arguments by name, such as E [Pa], nu [-], density [kg/m³] or depth in mean radii [-].

    Raises:
        InputError: a value of the wrong type or out of range, no bonds, several bodies, or a turned face.
    """
    specimen = instance(f"labtests.{test}", "lattice", lattice, Lattice, "a lattice, from bd.connect")
    if not len(specimen.pairs):
        raise InputError(f"labtests.{test}: the lattice has no bonds; connect it with bd.connect")
    specimen.bodies.require_one(f"labtests.{test}")
    refuse_turned(test, specimen, faces)
    for name, value in given.items():
        if name == "density" and isinstance(value, np.ndarray) and value.ndim:
            _each(test, value, len(specimen.particles))
            continue
        found = number(f"labtests.{test}", name, value, **_RULES[name])
        if name == "stress" and found == 0.0:
            raise InputError(f"labtests.{test}: stress = 0; give {_RULES[name]['advice']}")


def refuse_turned(test: str, specimen: Lattice, faces: str) -> None:
    """Raise InputError if a face of a specimen, such as "x_max", does not point along its axis, or has no end x_min.

    "top" and "bottom" are along y. Other faces that the shape does not have are not checked.
    """
    shape = specimen.particles.envelope
    missing = [name for name in ("x_min", "x_max") if "x_min" in faces and name not in shape.faces]
    if missing:
        for axis, order in (("y", [1, 2, 0]), ("z", [2, 0, 1])):
            if {f"{axis}_min", f"{axis}_max"} <= set(shape.faces):
                raise InputError(
                    f"labtests.{test}: the ends are {axis}_min and {axis}_max, not x_min and x_max; turn the surface"
                    f" before packing: bd.Surface(vertices=part.vertices[:, {order}], triangles=part.triangles)"
                )
        raise InputError(
            f"labtests.{test}: a {type(shape).__name__} has no face '{missing[0]}'; give a body with flat ends, as"
            " bd.Box(...) or bd.Box(...) & part"
        )
    for face in (name for name in faces.split() if name in shape.faces):
        axis = {"top": 1, "bottom": 1}.get(face, "xyz".find(face[0]))
        out = face_patches(shape, face, 0.1 * float(np.ptp(shape.bounds, axis=0).max()))[1].sum(axis=0)
        along = out[axis] * (1.0 if face.endswith(("max", "top")) else -1.0)
        angle = math.atan2(np.linalg.norm(np.delete(out, axis)), along)
        if angle > _TILT:
            raise InputError(
                f"labtests.{test}: the face '{face}' is turned by {angle:.3g} rad from the axis {'xyz'[axis]} of the"
                " load; turn the specimen back by .rotated(axis, angle)"
            )


def _each(test: str, density: np.ndarray, count: int) -> None:
    """Raise InputError unless an array has one positive density per element [kg/m³], (count,)."""
    numbers = density.dtype.kind in "fiu" and density.shape == (count,)
    if not (numbers and possible(density) and (density > 0.0).all()):
        raise InputError(
            f"labtests.{test}: density has type {density.dtype} and shape {density.shape}; give a positive density"
            f" [kg/m³], or one for each of the {count} elements"
        )
