"""Table of the report on the quality of packings, with explanations of the measures."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np

from bondem._types import Vector
from bondem.report.findings import Examined
from bondem.report.numbers import percent, signed_percent, with_unit
from bondem.specimen.fabric import LIMITS, Fabric


@dataclass(frozen=True)
class QualityRow:
    """Row of the table: one measure of all packings.

    Attributes:
        name: name of the measure.
        first: value of the first packing.
        range: smallest and largest value of all packings, "" for a single packing.
        limit: limit of the verdict, or "".
        meaning: explanation in one sentence.
    """

    name: str
    first: str
    range: str
    limit: str
    meaning: str


def quality_rows(specimens: Sequence[Examined]) -> list[QualityRow]:
    """Return the rows of the table of quality for all packings of spheres; empty for cells."""
    known = [one.quality for one in specimens if one.quality is not None]
    return [] if not known else [
        _row(known, name, measure, write, LIMITS.get(limit), meaning)
        for name, measure, write, limit, meaning in _MEASURES
    ]


def _row(
    packings: Sequence[Fabric], name: str, measure: Callable[[Fabric], float], write: Callable[[float], str],
    limit: float | None, meaning: str,
) -> QualityRow:  # fmt: skip
    values = [float(measure(one)) for one in packings]
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


def _elements(one: Fabric) -> int:
    return int(one.coordination_histogram.sum())


_three = partial(with_unit, digits=3)
_MEASURES: tuple[tuple[str, Callable[[Fabric], float], Callable[[float], str], str, str], ...] = (
    ("volume fraction φ", lambda one: one.volume_fraction, with_unit, "",
     "Volume of the elements over that of the shape; overlaps count twice. Random spheres jam near 0.64."),
    ("φ of the core", lambda one: one.core_volume_fraction, with_unit, "",
     "Volume fraction at least three mean radii from every wall, without the gaps at walls: that of the material."),
    ("coordination number z", lambda one: one.coordination_number, with_unit, "",
     "Mean number of bonds per element."),
    ("z of the backbone", lambda one: one.backbone_coordination_number, with_unit, "",
     "Mean number of bonds between elements that are held in place: 6 at jamming, fewer near supporting walls,"
     " more beyond jamming."),
    ("loose elements", lambda one: one.loose / _elements(one), percent, "",
     "Elements held by fewer than four others and walls, so free to move: rattlers in the sense of jamming. Bonded,"
     " they transmit load nevertheless."),
    ("elements not connected", lambda one: one.rattlers / _elements(one), percent, "rattlers",
     "Elements without a bond to the specimen, or in a small separate piece: excluded from every test."),
    ("largest overlap / R̄", lambda one: one.largest_overlap, percent, "",
     "Largest overlap of a pair. A coordination beyond that of jamming requires overlap."),
    ("fineness", lambda one: one.fineness, _three, "",
     "Edge of a cube with the volume of the shape, in mean diameters: the size of the specimen relative to its"
     " elements."),
    ("smallest extent", lambda one: one.smallest_extent, _three, "",
     "Smallest extent of the shape along x, y or z, in mean diameters; below about ten, walls dominate."),
    ("isotropy error e, eq (11)", lambda one: one.isotropy_error, _three, "",
     "Mean square difference of the shares of bond directions on 320 faces from 1/320: the published measure; small"
     " for any packing."),
    ("anisotropy beyond chance", lambda one: one.rms_excess, percent, "",
     "Variation of the number of bonds with direction, rms. Walls align the bonds next to them."),
    ("anisotropy of the core", lambda one: one.core_rms_excess, percent, "rms_excess",
     "Anisotropy two mean radii or more from every wall: that of the material. A crystal has several hundred %."),
    ("preferred direction", lambda one: one.core_stretch, percent, "stretch",
     "Largest difference of an eigenvalue of the fabric tensor of the core from 1/3, over 1/3."),
    ("strata of density", lambda one: _worst(one.strata.density), percent, "density",
     "Difference between slices of the core, rms beyond chance, along the worst of x, y, z. Gravity leaves strata."),
    ("strata of coordination", lambda one: _worst(one.strata.coordination), percent, "coordination",
     "Difference of the bonds per element between slices of the core, rms beyond chance, along the worst axis."),
    ("strata of size", lambda one: _worst(one.strata.size), percent, "size",
     "Difference of the mean radius between slices, over the standard deviation of radii: segregation by size."),
    ("change of density", lambda one: _worst(one.strata.density_gradient), signed_percent, "",
     "Change of density from end to end of the core by a linear fit, along the worst axis."),
    ("layers", lambda one: _worst(one.strata.layers), percent, "layers",
     "Amplitude of the density of centres as a wave of about one diameter: 0 in a random packing, up to 200 % in"
     " plane layers."),
)  # fmt: skip
