"""Notched plates cut from one packing at several angles: a crack takes the same work whatever its direction."""

import math

import numpy as np

import bondem as bd
from validation.studies.paths.driving import ENERGY, LAW, RANKINE
from validation.studies.paths.rows import Row

#: Angles between the packing and the plate [degrees], and how far the work may be from its mean over them [-].
ANGLES, LIMIT = (0.0, 30.0, 45.0), 0.04
SIZE, NOTCH = (80e-3, 80e-3, 16e-3), (4e-3, 26e-3)
# Seeds nearer to the surface than this share of a cell are left out: their cells would be slivers.
_DEPTH = 0.15


def plate(angle: float, seed: int, count: int) -> bd.Lattice:
    """A plate with a notch along y, cut at an angle about z from a packing of a larger box."""
    large = 1.5 * SIZE[0], 1.5 * SIZE[1], SIZE[2]
    wanted = round(count * math.prod(large) / math.prod(SIZE))
    place = bd.pack(bd.Box(large), count=wanted, method="even", seed=seed).position
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    turn = np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])
    middle, own = 0.5 * np.array(large), 0.5 * np.array(SIZE)
    place = (place - middle) @ turn.T + own
    slot = bd.Box((NOTCH[0], 2.0 * NOTCH[1], 3.0 * SIZE[2]))
    shape = bd.Box(SIZE).cut(slot.moved((0.5 * (SIZE[0] - NOTCH[0]), -NOTCH[1], -SIZE[2])), name="notch")
    cell = (math.prod(SIZE) / count) ** (1.0 / 3.0)
    place = place[shape.depth(place) > _DEPTH * cell]
    return bd.connect(bd.Particles(place, np.full(len(place), 0.1 * cell), shape=shape), method="laguerre")


def turned(seed: int, count: int) -> list[Row]:
    """Work over the ligament at each angle over the mean of all; and the mean over G_f."""
    works = []
    for angle in ANGLES:
        test = bd.labtests.direct_tension(plate(angle, seed, count), LAW, RANKINE, traverses=30.0)
        works.append(test.work)
    mean = float(np.mean(works))
    return [
        Row("turned", f"work at {angle:g} degrees over the mean", work / mean, 1.0, LIMIT,
            note=f"{work / ENERGY:.3f} G_f")
        for angle, work in zip(ANGLES, works, strict=True)
    ]  # fmt: skip
