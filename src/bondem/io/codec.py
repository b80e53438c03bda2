"""Conversion of frozen dataclasses to JSON and back, for an explicit list of types.

`{"type": "Face", "name": "x_min", "depth": 0.02}` has the arguments of the object. An unknown type or key raises an
error, so that files of a newer bondem are rejected instead of misread. Numbers keep every bit, as JSON prints the
shortest text that reads back exactly.
"""

from collections.abc import Mapping
from dataclasses import fields
from typing import Any

import numpy as np

from bondem.boundary.conditions import Drive, Fix, Load
from bondem.boundary.gauges import Gauge, StrainGauge, WallGauge
from bondem.boundary.loads import Absorbing, BodyForce, Eigenstrain, Pressure
from bondem.boundary.schedules import Constant, Ramp, Table
from bondem.boundary.wall_motions import Driven, Free, Servo
from bondem.boundary.walls import CylinderWall, PlaneWall, SphereWall
from bondem.damage.bilinear import Bilinear
from bondem.damage.criteria.criterion_catalogue import CRITERIA
from bondem.damage.criteria.stress_criterion import StressCriterion
from bondem.damage.scatter import Normal, Weibull
from bondem.dynamics.damping import BondDamping, LocalDamping, MassDamping
from bondem.dynamics.events import AtRest, ContactEnd, LoadDrop
from bondem.dynamics.plan import Plan
from bondem.dynamics.schemes import TchamwaWielgosz, VelocityVerlet
from bondem.errors import RunFileError
from bondem.geometry.elementary_shapes import Ball, BoundingBox, Box, Cell, Cylinder
from bondem.geometry.shape import Cut, Joined, Overlap, Placed
from bondem.geometry.surface import Surface
from bondem.interactions.contact.adhesion import Adhesion
from bondem.interactions.contact.contact_law import LinearContact
from bondem.interactions.contact.hertz_mindlin import HertzMindlin
from bondem.interactions.law_catalogue import CELL_LAWS, LAWS, WHOLE_LAWS
from bondem.specimen.aggregates import Aggregates
from bondem.specimen.regions import Body, Difference, Everything, Face, Index, Intersection, Plane, Union, Within

_TYPES: dict[str, type] = {
    cls.__name__: cls
    for cls in (
        *LAWS.values(), *CELL_LAWS.values(), *WHOLE_LAWS.values(), *CRITERIA.values(), Bilinear, Weibull, Normal,
        LocalDamping, BondDamping, MassDamping, TchamwaWielgosz, VelocityVerlet, AtRest, ContactEnd, LoadDrop, Plan,
        LinearContact, HertzMindlin, Adhesion, PlaneWall, CylinderWall, SphereWall, Driven, Servo, Free,
        Drive, Fix, Load, Pressure, BodyForce, Absorbing, Eigenstrain, Gauge, WallGauge, StrainGauge,
        Constant, Ramp, Table,
        Ball, BoundingBox, Box, Cell, Cylinder, Surface, Placed, Overlap, Joined, Cut,
        Aggregates, Body, Difference, Everything, Face, Index, Intersection, Plane, Union, Within,
    )
}  # fmt: skip

_MOST_BITS = 64
# Files write the default rotation of a Fix as "xyz", as earlier versions did, and "xyz", if it was named, as "zyx".
_WRITTEN: dict[Any, Any] = {None: "xyz", "xyz": "zyx"}
_READ: dict[Any, Any] = {"xyz": None, "zyx": "xyz"}


def encode(value: Any) -> Any:
    """Encode a value of known dataclasses, mappings, sequences, text and numbers for JSON.

    Raises:
        RunFileError: a type that is not in the list, or an integer of more than 64 bits.
    """
    match value:
        case int() if value.bit_length() > _MOST_BITS:
            raise RunFileError(f"a whole number of {value.bit_length()} bits cannot be written; give one of 64 bits")
        case None | bool() | int() | float() | str():
            return value
        case np.generic():
            return encode(value.item())
        case np.ndarray():
            return encode(value.tolist())
        case list() | tuple():
            return [encode(item) for item in value]
        case Mapping():
            return {"type": "Mapping", "entries": [[encode(key), encode(item)] for key, item in value.items()]}
    name = type(value).__name__
    if _TYPES.get(name) is not type(value):
        raise RunFileError(f"an object of type {name} cannot be written to a run file; use types of bondem")
    return {"type": name} | {key: encode(item) for key, item in _arguments(value).items()}


def _arguments(value: Any) -> dict[str, Any]:
    if isinstance(value, StressCriterion):  # the name stands for the function
        parts = ("fracture_energy", "friction", "curve", "scatter", "parameters")
        return {"function": value.name} | {name: getattr(value, name) for name in parts}
    if isinstance(value, Drive):
        return {"region": value.region, "friction": value.friction} | value.arguments
    if isinstance(value, Fix):
        return vars(value) | {"rotation": _WRITTEN.get(value.rotation, value.rotation)}
    if isinstance(value, Driven):
        return value.components | ({"axis": value.axis, "about": value.about} if value.turns else {})
    return {item.name: getattr(value, item.name) for item in fields(value)}


def decode(data: Any) -> Any:
    """Decode a JSON value that `encode` returned; sequences become tuples.

    Raises:
        RunFileError: a type or key unknown to this version.
        InputError: a value that the type itself rejects.
    """
    match data:
        case list():
            return tuple(decode(item) for item in data)
        case {"type": "Mapping", "entries": entries}:
            return {decode(key): decode(item) for key, item in entries}
        case {"type": name, **given}:
            return _rebuild(name, given)
        case dict():
            raise RunFileError(f"{sorted(data)} has no type; give a file that bondem wrote")
    return data


def _rebuild(name: str, given: dict[str, Any]) -> Any:
    if name not in _TYPES:
        raise RunFileError(f"unknown type '{name}'; read the file with the bondem version that wrote it")
    if name == StressCriterion.__name__:
        raise RunFileError(
            f"the criterion of the run uses the function {given.get('function')}, which a file cannot store; give"
            " it again: failure=bd.StressCriterion(...) as it was"
        )
    if name == Servo.__name__:
        given = {"damping": 0.0} | given  # files of versions whose platens were not damped
    if name == Fix.__name__:
        given |= {"rotation": _READ.get(given.get("rotation"), given.get("rotation"))}
    try:
        return _TYPES[name](**{key: decode(item) for key, item in given.items()})
    except TypeError as error:
        raise RunFileError(f"{name}: {error}; read the file with the bondem version that wrote it") from error
