"""Specimens that laboratory tests need: uncut bars, notched beams, bored cylinders, balls."""

from collections.abc import Callable
from dataclasses import dataclass

from bondem.geometry.elementary_shapes import Ball, BoundingBox, Box, Cylinder
from bondem.geometry.shape import Cut, Shape

# Names of the faces of cuts that specimens may have, and the name of a specimen without a bar axis.
NOTCH, BORING, BALL = "notch", "boring", "ball"


@dataclass(frozen=True)
class Requirements:
    """Specimens that a test needs: `fits` returns True for a suitable shape; `advice` names one for messages."""

    fits: Callable[[Shape], bool]
    advice: str


def broken_only(shape: Shape) -> str | None:
    """Return the reason why a shape has no tension test, "notch", "boring" or "ball"; None for other shapes."""
    return BALL if isinstance(shape, Ball) else cut_as(shape)


def cut_as(shape: Shape) -> str | None:
    """Return the cut of a shape, "notch" or "boring"; None for an uncut shape or other cuts."""
    return shape.name if isinstance(shape, Cut) and shape.name in (NOTCH, BORING) else None


DISC = Requirements(lambda shape: isinstance(shape, Cylinder), 'a specimen.shape of "cylinder"')
BEAM = Requirements(
    lambda shape: isinstance(shape, Box | BoundingBox) or cut_as(shape) == NOTCH,
    'a specimen.shape of "box", notched or not',
)
BORED = Requirements(lambda shape: cut_as(shape) == BORING, 'specimen.shape = "punch"')
BALLS = Requirements(lambda shape: isinstance(shape, Ball), 'specimen.shape = "ball"')
