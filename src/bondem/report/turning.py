"""Data of a rotatable picture of spheres in the page of a report, in few bytes."""

import base64
from dataclasses import dataclass

import numpy as np
from matplotlib import colormaps
from matplotlib.colors import to_hex

from bondem._types import Floats
from bondem.labtests.failure_tests import FAILURE_TESTS
from bondem.report.findings import Examined
from bondem.report.style import SEQUENTIAL

# Largest number of elements that are all drawn; of larger specimens only those near the surface are drawn.
_MOST = 6000
# Largest depth of drawn elements of larger specimens below the surface, in mean radii.
_DEEP = 2.2
# Number of colours, and largest drawn displacement over the size of the specimen.
_COLOURS, _MOVED = 24, 0.08


@dataclass(frozen=True)
class Turning:
    """Data of the rotatable picture of spheres.

    Attributes:
        place: coordinates of the centres from -1 to 1, times 32 000, as 16-bit integers, three per element, base64.
        size: radii over the largest, times 255, as bytes, base64.
        colour: indices of the colours as bytes, base64.
        colours: colours in the notation of HTML.
        largest: largest radius over half of the longest edge [-].
        caption: caption of the picture.
    """

    place: str
    size: str
    colour: str
    colours: list[str]
    largest: float
    caption: str


def turning_of(one: Examined) -> Turning:
    """Return data of elements at rest, coloured by radius, or after the first test to failure, by displacement."""
    particles = one.lattice.particles
    centre, radius = particles.position, particles.radius
    chosen = np.arange(len(radius))
    if len(radius) > _MOST:
        chosen = np.flatnonzero(particles.envelope.depth(particles.position) < _DEEP * particles.mean_radius)
    moved = [
        outcome.curves["displacement"] for name, outcome in one.outcomes.items()
        if name in FAILURE_TESTS and "displacement" in outcome.curves
    ]  # fmt: skip
    value, caption = radius, "coloured by radius"
    if moved:
        value = np.linalg.norm(moved[0], axis=1)
        size = float(np.ptp(centre, axis=0).max())
        factor = _MOVED * size / max(float(value.max()), 1e-300)
        centre = centre + factor * np.asarray(moved[0])
        caption = f"after the first test, coloured by how far each has moved, drawn {factor:.0f} times as far"
    below = " Only those near the surface are drawn." if len(chosen) < len(radius) else ""
    lower, upper = centre.min(axis=0), centre.max(axis=0)
    half = 0.5 * float((upper - lower).max())
    place = (centre[chosen] - 0.5 * (lower + upper)) / half
    scale = colormaps[SEQUENTIAL]
    return Turning(
        place=in_base64(np.rint(32_000.0 * np.clip(place, -1.0, 1.0)).astype("<i2")),
        size=in_base64(np.rint(255.0 * radius[chosen] / radius.max()).astype(np.uint8)),
        colour=in_base64(_shade(value)[chosen]),
        colours=[to_hex(scale(k / (_COLOURS - 1))) for k in range(_COLOURS)],
        largest=float(radius.max()) / half,
        caption=f"Elements {caption}: drag to turn, pinch or scroll with Ctrl to come nearer.{below}",
    )


def _shade(value: Floats) -> np.ndarray:
    low, width = float(value.min()), float(np.ptp(value))
    share = (value - low) / width if width > 0.0 else np.full(len(value), 0.5)
    return np.minimum((_COLOURS * share).astype(np.uint8), _COLOURS - 1)


def in_base64(values: np.ndarray) -> str:
    """Return the bytes of an array as base64."""
    return base64.b64encode(np.ascontiguousarray(values).tobytes()).decode("ascii")
