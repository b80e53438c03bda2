"""The table [specimen] of a study: what to pack, or which particles to read."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, TypeVar

from bondem.errors import InputError, StudyError
from bondem.io.importing import read_particles
from bondem.packing import METHODS, pack
from bondem.packing.sizes import Lognormal, Sieve, SizeLaw, Uniform
from bondem.specimen.geometry import Ball, Box, Cell, Cylinder, Shape
from bondem.specimen.particles import Particles
from bondem.specimen.surface import UNITS, Surface
from bondem.study.toml_table import TomlTable

SHAPES = ("cylinder", "box", "ball", "cell", "surface")
SIZE_LAWS = ("uniform", "lognormal", "sieve")
TARGETS = ("coordination_number", "volume_fraction", "jamming")
#: κ of a study that says nothing about sizes [-].
SPREAD = 0.25

_Made = TypeVar("_Made")


@dataclass(frozen=True, kw_only=True)
class SpecimenPlan:
    """What to pack.

    Attributes:
        shape: what the elements fill.
        count: number of elements.
        sizes: law of the radii.
        method: of packing.
        target: at most one of coordination_number, volume_fraction and jamming, by name, as `bd.pack` takes it.
    """

    shape: Shape
    count: int
    sizes: SizeLaw = Uniform(SPREAD)
    method: str = "quench"
    target: Mapping[str, Any] = field(default_factory=dict)

    def particles(self, seed: int, progress: Callable[[float], None]) -> Particles:
        """The packing of this seed."""
        return pack(
            self.shape, count=self.count, sizes=self.sizes, method=self.method, seed=seed, progress=progress,
            **self.target,
        )  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class ImportPlan:
    """Which particles to read.

    Attributes:
        file: any that `bd.read_particles` knows.
        unit: the file's unit of length [m].
        shape: what the particles fill, where the file does not say; None for its own, or their bounding box.
    """

    file: Path
    unit: float = 1.0
    shape: Shape | None = None

    def particles(self, seed: int, progress: Callable[[float], None]) -> Particles:
        """The particles of the file, whatever the seed."""
        particles = read_particles(self.file, unit=self.unit, shape=self.shape)
        progress(1.0)
        return particles


def read_specimen(table: TomlTable, folder: Path) -> SpecimenPlan | ImportPlan:
    """What the table says; files are looked for from `folder`.

    Raises:
        StudyError: a key that is unknown, missing, out of range or at odds with another.
    """
    with table:
        if table.has("particles"):
            file = folder / table.text("particles")
            if not file.is_file():
                raise StudyError(f"'{table.name('particles')}': there is no file '{file}'; check the path")
            shape = _shape(table, folder) if table.has("shape") else None
            unit = UNITS[table.text("unit", default="m", choices=tuple(UNITS))]
            return ImportPlan(file=file, unit=unit, shape=shape)
        return SpecimenPlan(
            shape=_shape(table, folder),
            count=table.count("count", least=100),
            sizes=_sizes(table),
            method=table.text("method", default="quench", choices=METHODS),
            target=_target(table),
        )


def _shape(table: TomlTable, folder: Path) -> Shape:
    match table.text("shape", choices=SHAPES):
        case "cylinder":
            radius = table.number("radius", "m", above=0.0)
            return Cylinder(radius=radius, length=table.number("length", "m", above=0.0))
        case "box":
            return Box(table.lengths("size"))
        case "ball":
            return Ball(radius=table.number("radius", "m", above=0.0))
        case "cell":
            return Cell(table.lengths("size"))
    file = folder / table.text("file")
    unit = table.text("unit", choices=tuple(UNITS)) if table.has("unit") else None
    return _made(table.name("file"), lambda: Surface(file, unit=unit))


def _sizes(table: TomlTable) -> SizeLaw:
    if not table.has("sizes"):
        return Uniform(table.number("spread", "-", default=SPREAD, above=-1e-12, below=2.0))
    if table.has("spread"):
        raise StudyError(f"give '{table.name('spread')}' or [{table.name('sizes')}], not both")
    with table.section("sizes") as sizes:
        match sizes.text("law", choices=SIZE_LAWS):
            case "uniform":
                return Uniform(sizes.number("spread", "-", above=-1e-12, below=2.0))
            case "lognormal":
                cv, cut = sizes.number("cv", "-"), sizes.number("cut", "-", default=Lognormal.cut)
                return _made(table.name("sizes"), lambda: Lognormal(cv, cut))
        diameters, passing = sizes.numbers("diameters"), sizes.numbers("mass_passing")
        return _made(table.name("sizes"), lambda: Sieve(diameters, passing))


def _target(table: TomlTable) -> dict[str, Any]:
    z = table.number("coordination_number", "-", default=None, above=0.0, below=12.0)
    fraction = table.number("volume_fraction", "-", default=None, above=0.0, below=0.8)
    jamming = table.flag("jamming", default=False) or None
    values = zip(TARGETS, (z, fraction, jamming), strict=True)
    given = {name: value for name, value in values if value is not None}
    if len(given) > 1:
        raise StudyError(f"give one target of {' and '.join(repr(table.name(name)) for name in given)}, not several")
    return given


def _made(key: str, make: Callable[[], _Made]) -> _Made:
    """What `make` returns; where it refuses, the message names the key."""
    try:
        return make()
    except InputError as error:
        raise StudyError(f"'{key}': {error}") from error
