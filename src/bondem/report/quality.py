"""The table of the report that says how good the packings are, for readers new to these measures."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from bondem._types import Vector
from bondem.report.findings import Examined
from bondem.report.numbers import percent, signed_percent, with_unit
from bondem.specimen.fabric import LIMITS


@dataclass(frozen=True)
class QualityRow:
    """One measure.

    Attributes:
        name: what it is called.
        first: value of the first packing.
        range: least and largest of all packings, "" where there is one only.
        limit: of the verdict, or "".
        meaning: what it says, in a sentence.
    """

    name: str
    first: str
    range: str
    limit: str
    meaning: str


def quality_rows(specimens: Sequence[Examined]) -> list[QualityRow]:
    """The measures of all packings, the first of which is shown by itself."""
    return [
        _row(specimens, name, measure, write, LIMITS.get(limit), meaning)
        for name, measure, write, limit, meaning in _MEASURES
    ]


def _row(
    specimens: Sequence[Examined],
    name: str,
    measure: Callable[[Examined], float],
    write: Callable[[float], str],
    limit: float | None,
    meaning: str,
) -> QualityRow:
    values = [float(measure(one)) for one in specimens]
    known = [value for value in values if math.isfinite(value)]
    ends = [write(value) for value in (min(known), max(known))] if known else ["–"]
    return QualityRow(
        name=name,
        first=write(values[0]) if math.isfinite(values[0]) else "–",
        range=" … ".join(dict.fromkeys(ends)) if len(values) > 1 else "",
        limit=percent(limit).replace(".00", "") if limit is not None else "",
        meaning=" ".join(meaning.split()),
    )


def _worst(values: Vector) -> float:
    known = values[np.isfinite(values)]
    return float(known[np.argmax(np.abs(known))]) if len(known) else math.nan


def _elements(one: Examined) -> int:
    return len(one.lattice.particles)


def _four(value: float) -> str:
    return with_unit(value)


def _three(value: float) -> str:
    return with_unit(value, digits=3)


_MEASURES: tuple[tuple[str, Callable[[Examined], float], Callable[[float], str], str, str], ...] = (
    ("volume fraction φ", lambda one: one.quality.volume_fraction, _four, "",
     "Volume of the elements over that of the shape; what overlaps counts twice. Random spheres jam near 0.64."),
    ("φ of the core", lambda one: one.quality.core_volume_fraction, _four, "",
     "The same, three mean radii or more from every wall: walls leave gaps, so this is what the material has."),
    ("coordination number z", lambda one: one.quality.coordination_number, _four, "",
     "Bonds of an element, the mean over all."),
    ("z of the backbone", lambda one: one.quality.backbone_coordination_number, _four, "",
     "The mean over the elements that are held in place, of the bonds between them: 6 at jamming, fewer where walls"
     " do part of the holding, more beyond."),
    ("loose elements", lambda one: one.quality.loose / _elements(one), percent, "",
     "Held by fewer than four others and walls, so free to move: rattlers in the sense of jamming. Bonded, they take"
     " part all the same."),
    ("elements not connected", lambda one: one.quality.rattlers / _elements(one), percent, "rattlers",
     "In no bond with the specimen, or in a small piece beside it: left out of every test."),
    ("largest overlap / R̄", lambda one: one.quality.largest_overlap, percent, "",
     "The deepest pair. Coordination beyond that of jamming is bought with overlap."),
    ("fineness", lambda one: one.quality.fineness, _three, "",
     "Mean diameters in the edge of a cube with the volume of the shape: how much larger the specimen is than its"
     " elements."),
    ("smallest extent", lambda one: one.quality.smallest_extent, _three, "",
     "Of the shape along x, y or z, in mean diameters; below ten or so, walls rule all of it."),
    ("isotropy error e, eq (11)", lambda one: one.quality.isotropy_error, _three, "",
     "Mean square difference of the shares of bond directions on 320 faces from 1/320: the measure in print; small"
     " for any packing."),
    ("anisotropy beyond chance", lambda one: one.quality.rms_excess, percent, "",
     "How much the number of bonds differs from direction to direction, rms. Walls line up the bonds next to them."),
    ("the same in the core", lambda one: one.quality.core_rms_excess, percent, "rms_excess",
     "Two mean radii or more from every wall: that of the material. A crystal has some hundred per cent."),
    ("preferred direction", lambda one: one.quality.core_stretch, percent, "stretch",
     "Largest difference of an eigenvalue of the fabric tensor of the core from 1/3, over 1/3."),
    ("strata of density", lambda one: _worst(one.quality.strata.density), percent, "density",
     "Difference between slices of the core, rms beyond chance, along the worst of x, y, z. Gravity leaves strata."),
    ("strata of coordination", lambda one: _worst(one.quality.strata.coordination), percent, "coordination",
     "The same of the bonds of an element."),
    ("strata of size", lambda one: _worst(one.quality.strata.size), percent, "size",
     "The same of the mean radius, over the standard deviation of the radii: whether large and small have parted."),
    ("change of density", lambda one: _worst(one.quality.strata.density_gradient), signed_percent, "",
     "From end to end of the core by a straight line, along the worst axis."),
    ("layers", lambda one: _worst(one.quality.strata.layers), percent, "layers",
     "Amplitude of the density of centres as a wave about a diameter long: 0 in a random packing, up to 200 % in"
     " plane layers."),
)  # fmt: skip
