"""Table [specimen] of a study: the plan of a packing, or a file of particles."""

import warnings
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from bondem._plausibility import is_long
from bondem.errors import StudyError, UnitWarning
from bondem.geometry.elementary_shapes import Ball, Box, Cell, Cylinder, Shape
from bondem.geometry.surface import Surface
from bondem.io.importing import read_particles
from bondem.labtests.failure.shear import punch_specimen
from bondem.packing import EVEN, METHOD, Method, pack
from bondem.packing.sizes import SPREAD, Lognormal, Sieve, SizeLaw, Uniform
from bondem.specimen.aggregates import Aggregates
from bondem.specimen.particles import Particles
from bondem.study.toml_table import TomlTable, made

SHAPES = ("cylinder", "box", "ball", "cell", "surface", "punch")
SIZE_LAWS = ("uniform", "lognormal", "sieve")
TARGETS = ("coordination_number", "volume_fraction", "jamming")


@dataclass(frozen=True, kw_only=True)
class SpecimenPlan:
    """Plan of a packing.

    Attributes:
        shape: shape that the elements fill.
        count: number of elements.
        sizes: law of the radii; None for the method "even", which makes equal spheres.
        method: packing method.
        target: one or none of coordination_number, volume_fraction and jamming, by name, as for `bd.pack`.
    """

    shape: Shape
    count: int
    sizes: SizeLaw | None = Uniform()
    method: Method = METHOD
    target: Mapping[str, Any] = field(default_factory=dict)

    def particles(self, seed: int, progress: Callable[[float], None], around: Aggregates | None = None) -> Particles:
        """Pack the shape with a seed; cells end on the surfaces of the aggregates `around`, if given."""
        return pack(
            self.shape, count=self.count, sizes=self.sizes, method=self.method, seed=seed, progress=progress,
            around=around, **self.target,
        )  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class ImportPlan:
    """Plan of a specimen from a file of particles.

    Attributes:
        file: path of a file that `bd.read_particles` can read.
        unit: unit of length of the file [m]; None for metres, with a warning if that is improbable.
        shape: shape that the particles fill, for files without one; None for that of the file, or their bounding box.
    """

    file: Path
    unit: float | None = None
    shape: Shape | None = None

    def particles(self, seed: int, progress: Callable[[float], None], around: Aggregates | None = None) -> Particles:
        """Read the particles of the file; `seed` and `around` have no effect."""
        particles = made("specimen.particles", lambda: read_particles(self.file, unit=self.unit, shape=self.shape))
        progress(1.0)
        return particles


def read_specimen(table: TomlTable, folder: Path) -> SpecimenPlan | ImportPlan:
    """Read the plan of the specimen from its table; paths of files are relative to `folder`.

    Raises:
        StudyError: a key that is unknown, missing, out of range or in conflict with another.
    """
    with table:
        if table.has("particles"):
            file = table.file("particles", folder)
            shape = _shape(table, folder) if table.has("shape") else None
            return ImportPlan(file=file, unit=table.unit("unit"), shape=shape)
        method = table.text("method", default=METHOD)
        if method == EVEN:
            _refuse_sizes(table)
        return SpecimenPlan(
            shape=_shape(table, folder),
            count=table.count("count"),
            sizes=None if method == EVEN else _sizes(table),
            method=method,
            target={} if method == EVEN else _target(table),
        )


def _refuse_sizes(table: TomlTable) -> None:
    for key in ("spread", "sizes", *TARGETS):
        if table.has(key):
            raise StudyError(
                f"'{table.name(key)}' is an option of other methods, as '{EVEN}' makes equal spheres that hardly"
                " touch; leave it out"
            )


def _shape(table: TomlTable, folder: Path) -> Shape:
    kind = table.text("shape")
    if kind == "surface":
        file, unit = table.file("file", folder), table.unit("unit")
        return made(table.name("file"), lambda: Surface(file, unit=unit))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UnitWarning)  # the one below names the key
        shape = _plain(kind, table)
    lower, upper = shape.bounds
    longest = float((upper - lower).max())
    if is_long(longest) and not table.has_text("radius", "length", "size"):
        warnings.warn(
            f"'{table.name('shape')}': the {kind} is {longest:.4g} m long; if its numbers are millimetres, write"
            ' "5 mm" instead of 5, and if they are metres, "5 m"', UnitWarning, stacklevel=2,
        )  # fmt: skip
    return shape


def _plain(kind: str, table: TomlTable) -> Shape:
    match kind:
        case "cylinder":
            radius, length = table.number("radius"), table.number("length")
            return made(table.name("radius"), lambda: Cylinder(radius=radius, length=length))
        case "ball":
            ball = table.number("radius")
            return made(table.name("radius"), lambda: Ball(radius=ball))
        case "punch":
            keys = ("diameter", "height", "ring", "width", "depth")
            given = {key: table.number(key, default=None) for key in keys}
            chosen = {key: value for key, value in given.items() if value is not None}
            return made(table.name("shape"), lambda: punch_specimen(**chosen))
    size = table.lengths("size")
    if kind == "box" and table.has("notch"):
        return _notched(table, size)
    return made(table.name("size"), lambda: Box(size) if kind == "box" else Cell(size))


def _notched(table: TomlTable, size: tuple[float, float, float]) -> Shape:
    """Create a box along x with a notch from below at mid-length, over its full width along z."""
    length, height, thick = size
    with table.section("notch") as notch:
        width = notch.number("width", below=length)
        depth = notch.number("depth", below=height)
    slot = Box((width, 2.0 * depth, 3.0 * thick)).moved((0.5 * (length - width), -depth, -thick))
    return made(table.name("notch"), lambda: Box(size).cut(slot, name="notch"))


def _sizes(table: TomlTable) -> SizeLaw:
    if not table.has("sizes"):
        return Uniform(table.number("spread", default=SPREAD))
    if table.has("spread"):
        raise StudyError(
            f"'{table.name('spread')}' and [{table.name('sizes')}] are both given; give one of them, not both"
        )
    with table.section("sizes") as sizes:
        match sizes.text("law"):
            case "uniform":
                return Uniform(sizes.number("spread"))
            case "lognormal":
                cv, cut = sizes.number("cv"), sizes.number("cut", default=Lognormal.cut)
                return made(table.name("sizes"), lambda: Lognormal(cv, cut))
        diameters, passing = sizes.numbers("diameters"), sizes.numbers("mass_passing")
        return made(table.name("sizes"), lambda: Sieve(diameters, passing))


def _target(table: TomlTable) -> dict[str, Any]:
    found = {name: table.number(name, default=None) for name in ("coordination_number", "volume_fraction")}
    found["jamming"] = table.flag("jamming", default=False) or None
    given = {name: value for name, value in found.items() if value is not None}
    if len(given) > 1:
        raise StudyError(
            f"several targets are given: {' and '.join(repr(table.name(name)) for name in given)}; give only one"
        )
    return given
