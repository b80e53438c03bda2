"""Plates, thin bodies and nearly incompressible tubes of cells, against finite elements and Lamé's solution.

The cell law has balanced shares, twist of facets beside free walls and gradients of the dilatation. Packings with
seeds 31 to 35, which were used for nothing before, show what it achieves. Nothing is fitted; E = ρ = 1.

    modes      first six natural frequencies of plates, beams, sheets, strips, columns, an L-beam and a tube,
               against triquadratic finite elements. Modes are matched by their shapes (`measures/matching.py`)
    lame       thick tube in plane strain with a pressure in the bore, against Lamé's solution
    meshes     largest difference of six frequencies from a mesh 1.5 times finer, or 1.5 times coarser where the mesh
               is fine

Bodies "cubes" are boxes of cubic cells of edge 1; in "moved" the centres are moved by up to 0.2 along every axis,
also across layers. All others are packings: "quench" with κ = 25 %, or "even". Law "before" is that of bondem before
the balanced shares: A w M⁻¹n, twist in layers one cell thick alone, no gradients. It has seeds 31 and 32.
"""

import warnings
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import product
from typing import Any

import numpy as np

import bondem as bd
from bondem.errors import AuxeticWarning, BondemError, FillingWarning, ThinBodyWarning, UnitWarning
from bondem.interactions.cells import cell_constants
from bondem.interactions.cells.dilatation_gradients import GradientConstants
from bondem.interactions.cells.free_walls import FreeWalls
from bondem.io.older_bodies import with_corrected_normals
from validation.frame.record import Record
from validation.measures.continuum import Continuum, Corners, Vibration
from validation.measures.matching import groups

PARTS = ("modes", "lame", "meshes")
SEEDS = (31, 32, 33, 34, 35)
#: Packings of the former law, and of bodies that take long or are only stated.
FEW = 2
LAWS = ("bondem", "before")
#: Modes of finite elements; the last group of equal frequencies is incomplete and is left out.
MODES, FIRST = 9, 6
#: Centres of moved cells are this far from those of cubes, at most, along each axis [edges].
JITTER = 0.2
#: Relative difference of frequencies of modes of one group; share of turning about x above which a mode is torsion.
GAP, TORSION = 1e-3, 0.8
#: Points of cells of thin bodies whose motion distinguishes modes: centres of columns do not move in torsion.
WITHIN = 0.2 * np.concatenate([np.eye(3), -np.eye(3)])
THIN_NU = (0.2, 0.4)
#: Tube: inner and outer radius, length; the inner part of the wall whose mean hoop stress is compared.
INNER, OUTER, LENGTH, INNERMOST = 1.0, 2.0, 0.6, 0.2
LAME_NU = (0.3, 0.45, 0.49, 0.499, 0.4999)
#: Numbers of cells of the tube and how many seeds each has.
LAME_COUNTS = {600: 5, 2000: 3}


@dataclass(frozen=True)
class Body:
    """A body of cells and its finite elements.

    Attributes:
        boxes: boxes that meet face to face, whose union is the body.
        steps: edges of finite elements along x, y, z; they are halved twice beside `refined` places.
        kinds: kinds of cells: "cubes", "moved", "quench", "even".
        counts: numbers of cells of packings with the number of their seeds; of cubes and moved cells the edges say.
        nus: Poisson's ratios.
        thickness: of the thinnest part.
        held: face that is clamped.
        refined: places along x, y, z.
        fine: how much finer the mesh is with which that of the body is compared.
    """

    boxes: tuple[Corners, ...]
    steps: tuple[float, float, float]
    kinds: tuple[str, ...] = ("quench",)
    counts: tuple[tuple[int, int], ...] = ((0, len(SEEDS)),)
    nus: tuple[float, ...] = THIN_NU
    thickness: float = 1.0
    held: str | None = None
    refined: tuple[tuple[float, ...], ...] = ((), (), ())
    fine: float = 1.5

    @property
    def size(self) -> tuple[float, float, float]:
        """Edges of the box around the body."""
        x, y, z = np.array(self.boxes, dtype=float)[:, 1].max(axis=0)
        return float(x), float(y), float(z)

    @property
    def shape(self) -> bd.Shape:
        """Shape to pack."""
        shape = bd.Box(self.boxes[0][1])
        for lower, upper in self.boxes[1:]:
            shape = shape | bd.Box(tuple(np.subtract(upper, lower))).moved(tuple(lower))
        return shape

    def solid(self, fine: float = 1.0) -> Continuum:
        """Mesh the body; `fine` divides the steps."""
        return Continuum.of(self.boxes, cell=np.divide(self.steps, fine).tolist(), refined=self.refined)


def box(x: float, y: float, z: float) -> tuple[Corners, ...]:
    return (((0.0, 0.0, 0.0), (x, y, z)),)


PLATE, FLAT, COARSER = (9.6, 6.4), (0.5, 0.5, 0.5), 1.0 / 1.5
GRID = {"kinds": ("cubes", "moved")}
ALL_NU = (0.0, 0.2, 0.3, 0.4)
#: L-beam 10 × 3 × 3 with legs of 1, and a square tube 16 × 6 × 6 with a wall of 1.
ANGLE: tuple[Corners, ...] = (((0, 0, 0), (10, 3, 1)), ((0, 0, 1), (10, 1, 3)))
TUBE: tuple[Corners, ...] = (
    ((0, 0, 0), (16, 6, 1)), ((0, 0, 5), (16, 6, 6)), ((0, 0, 1), (16, 1, 5)), ((0, 5, 1), (16, 6, 5)),
)  # fmt: skip
BODIES = {
    "plate": Body(box(*PLATE, 1.0), FLAT, counts=((1200, 5), (2500, 5), (3900, FEW)), nus=ALL_NU,
                  refined=((0.0, PLATE[0]), (0.0, PLATE[1]), ())),
    "beam": Body(box(8.0, 1.0, 1.0), (0.5, 1 / 6, 1 / 6), counts=((350, 5), (700, 5), (2000, 5)), nus=ALL_NU),
    "sheet": Body(box(8.0, 7.0, 1.0), FLAT, refined=((0.0, 8.0), (0.0, 7.0), ()), **GRID),
    "clamped sheet": Body(box(8.0, 7.0, 1.0), FLAT, held="x_min", refined=((0.0, 8.0), (0.0, 7.0), ()), **GRID),
    "strip": Body(box(12.0, 2.0, 1.0), (0.5, 1 / 6, 1 / 6), fine=COARSER, **GRID),
    "column": Body(box(14.0, 1.0, 1.0), (0.6, 1 / 6, 1 / 6), fine=COARSER, **GRID),
    "sheet of two layers": Body(box(16.0, 14.0, 2.0), (1.0, 1.0, 1.0), counts=((0, FEW),), thickness=2.0,
                                refined=((0.0, 16.0), (0.0, 14.0), ()), **GRID),
    "strip of two layers": Body(box(24.0, 3.0, 2.0), (1.0, 0.5, 0.5), thickness=2.0, **GRID),
    "L-beam": Body(ANGLE, (0.5, 1 / 3, 1 / 3), kinds=("even",), counts=((1300, 5),), refined=((), (1.0,), (1.0,)),
                   fine=COARSER),
    "clamped plate": Body(box(*PLATE, 1.0), FLAT, counts=((1200, 5),), held="x_min",
                          refined=((0.0, PLATE[0]), (0.0, PLATE[1]), ())),
    "square tube": Body(TUBE, (1.4, 0.5, 0.5), kinds=("even",), counts=((1500, FEW),),
                        refined=((), (1.0, 5.0), (1.0, 5.0)), fine=COARSER),
}  # fmt: skip


@contextmanager
def law_of(name: str) -> Iterator[None]:
    """Models that are made inside have the law of this name; bodies come from `shared`."""
    twist, of = cell_constants.twist_at_walls, vars(GradientConstants)["of"]
    try:
        if name == "before":
            cell_constants.twist_at_walls = _twist_in_layers
            none: Any = staticmethod(lambda *_: GradientConstants.none())
            GradientConstants.of = none
        yield
    finally:
        cell_constants.twist_at_walls, GradientConstants.of = twist, of


def shared(body: bd.Lattice, law: str, boundary: Sequence[Any]) -> bd.Lattice:
    """Return a body with the shares of a law."""
    return body if law == "bondem" else with_corrected_normals(body, boundary)


def _twist_in_layers(
    S: np.ndarray, area: np.ndarray, normal: np.ndarray, stiffness: np.ndarray, walls: FreeWalls, cells: Any
) -> np.ndarray:
    """Twist of facets as it was before: within layers one cell thick, of one direction, and nowhere else."""
    del area
    one, other = (walls.layer[cell, 0] for cell in cells)
    across = 0.5 * (np.einsum("ma,mab,mb->m", one, S, one) + np.einsum("ma,mab,mb->m", other, S, other))
    within = (one**2).sum(axis=1) * (other**2).sum(axis=1) > 0.5
    return (stiffness * across * within)[:, None, None] * normal[:, :, None] * normal[:, None, :]


@lru_cache(maxsize=1)
def cut(name: str, kind: str, count: int, seed: int | None) -> bd.Lattice:
    """Body of cells of a name."""
    body = BODIES[name]
    if kind in ("cubes", "moved"):
        edges = [round(edge) for edge in body.size]
        centre = np.stack(np.meshgrid(*map(np.arange, edges), indexing="ij"), axis=-1).reshape(-1, 3) + 0.5
        if kind == "moved":
            centre += np.random.default_rng(seed).uniform(-JITTER, JITTER, centre.shape)
        particles = bd.Particles(centre, 0.25, shape=body.shape)
    elif kind == "even":
        particles = bd.pack(body.shape, count=count, method="even", seed=seed or 0)
    else:
        particles = bd.pack(body.shape, count=count, spread=0.25, seed=seed or 0)
    return bd.connect(particles, method="laguerre")


@lru_cache(maxsize=2)
def mesh(name: str, fine: float = 1.0) -> Continuum:
    return BODIES[name].solid(fine)


@lru_cache(maxsize=8)
def exact(name: str, nu: float, fine: float = 1.0) -> Vibration:
    """Modes of the finite elements."""
    return mesh(name, fine).vibration(1.0, nu, 1.0, count=MODES, held=BODIES[name].held)


def modes(name: str, kind: str, count: int, seed: int | None, nu: float, law: str) -> dict[str, Any]:
    """Errors of the first six frequencies, and which of them are torsion about x."""
    body, theory = cut(name, kind, count, seed), exact(name, nu)
    held = BODIES[name].held
    boundary = [] if held is None else [bd.Fix(bd.Face(held))]
    with law_of(law):
        model = bd.Model(shared(body, law, boundary), bd.CellBond(E=1.0, nu=nu), 1.0, boundary=boundary)
        found = bd.solve_modes(model, count=MODES + 3)
    assert body.cells is not None
    volume, middle = body.cells.volume, body.centre.mean(axis=0)
    around = WITHIN if kind in GRID["kinds"] else np.zeros((1, 3))
    place = (body.centre[:, None] + around).reshape(-1, 3)
    moved = found.shape[:, :, None, :3] + np.cross(found.shape[:, :, None, 3:], around)
    seen = replace(found, shape=moved.reshape(len(moved), -1, 3))
    expected = mesh(name).sampler(middle + 0.999 * (place - middle))(theory.shape)
    return {
        "cells": len(volume), "thick": round(float(BODIES[name].thickness / volume.mean() ** (1.0 / 3.0)), 2),
        "errors": _errors(seen, np.repeat(volume, len(around)), theory, expected),
        "torsion": [bool(one > TORSION) for one in _about_x(expected, place - middle)[:FIRST]],
    }  # fmt: skip


def _errors(found: Any, volume: np.ndarray, theory: Vibration, expected: np.ndarray) -> list[float]:
    """Return the first six errors, as `matched`, whose larger gap pools modes of strips."""
    root = np.sqrt(volume)[:, None]
    seen, wanted = ((root * shape[:, :, :3]).reshape(len(shape), -1) for shape in (found.shape, expected))
    likeness = (seen @ wanted.T) ** 2 / np.outer((seen**2).sum(axis=1), (wanted**2).sum(axis=1))
    errors: list[float] = []
    for group in groups(theory.frequency, GAP):
        alike = likeness[:, group].sum(axis=1)
        best = np.argsort(-alike)[: len(group)]
        one, other = (float(np.sqrt((f**2).mean())) for f in (found.frequency[best], theory.frequency[group]))
        errors += [round(one / other - 1.0, 6) for _ in group]
    return errors[:FIRST]


def _about_x(shape: np.ndarray, place: np.ndarray) -> np.ndarray:
    """Share of modes, (count, n, 3), that turns sections about the axis x, for places relative to it, (n, 3)."""
    section = ((place[:, 0] - place[:, 0].min()) / np.ptp(place[:, 0]) * 7.999).astype(int)
    lever = np.cross([1.0, 0.0, 0.0], place)
    turned = np.stack([np.bincount(section, one) for one in (shape * lever).sum(axis=2)])
    return (turned**2 / np.bincount(section, (lever**2).sum(axis=1))).sum(axis=1) / (shape**2).sum(axis=(1, 2))


@lru_cache(maxsize=1)
def thick_tube(count: int, seed: int) -> bd.Lattice:
    bore = bd.Cylinder(radius=INNER, length=3.0 * LENGTH).moved((-LENGTH, 0.0, 0.0))
    shape = bd.Cylinder(radius=OUTER, length=LENGTH).cut(bore, name="bore")
    return bd.connect(bd.pack(shape, count=count, method="even", seed=seed or 0), method="laguerre")


def lame(count: int, seed: int, nu: float, law: str) -> dict[str, float]:
    """Errors of the mean of u_r, of the mean hoop stress of the innermost wall, and rms of the hoop stress."""
    body, pressure = thick_tube(count, seed), 1e-3
    faces = body.particles.envelope.faces
    boundary: list[Any] = [bd.Fix(bd.Face(end), translation="x", rotation="") for end in ("x_min", "x_max")]
    boundary.append(bd.Pressure(bd.Face(next(face for face in faces if face.startswith("bore"))), pressure))
    with law_of(law):
        model = bd.Model(shared(body, law, boundary), bd.CellBond(E=1.0, nu=nu), 1.0, boundary=boundary)
        result = bd.solve_static(model)
        stress = bd.cell_stress(model, result) / pressure
    r = np.hypot(*body.centre[:, 1:].T)
    radial = np.column_stack([np.zeros(len(r)), body.centre[:, 1:] / r[:, None]])
    around = np.cross([1.0, 0.0, 0.0], radial)
    assert body.cells is not None
    volume, moved = body.cells.volume, (result.displacement * radial).sum(axis=1) / pressure
    mean = INNER**2 / (OUTER**2 - INNER**2)
    deviator = mean * OUTER**2
    u, hoop = (1.0 + nu) * ((1.0 - 2.0 * nu) * mean * r + deviator / r), mean + deviator / r**2
    found = np.einsum("na,nab,nb->n", around, stress, around)
    inner = r < INNER + INNERMOST * (OUTER - INNER)
    return {
        "u_r": float((volume * moved).sum() / (volume * u).sum()) - 1.0,
        "hoop": float((volume * found)[inner].sum() / (volume * hoop)[inner].sum()) - 1.0,
        "rms": float(np.sqrt((volume * (found - hoop) ** 2).sum() / (volume * hoop**2).sum())),
    }


def meshes(name: str, nu: float, fine: float) -> dict[str, float]:
    """Largest difference of six frequencies from another mesh."""
    ratio = exact(name, nu).frequency[:FIRST] / exact(name, nu, fine).frequency[:FIRST]
    return {"difference": float(np.abs(ratio - 1.0).max())}


def add(record: Record, part: str, measure: Callable[..., dict[str, Any]], **case: Any) -> None:
    """Measure a case; a body that cannot be made is stored with the error."""

    def rows() -> list[dict[str, Any]]:
        try:
            return [measure(**case)]
        except BondemError as error:
            return [{"failed": str(error)}]

    record.add(rows, part, **case)


def measure_modes(record: Record, names: Sequence[str], seeds: Sequence[int]) -> None:
    """Measure the frequencies of bodies."""
    for name in names:
        body = BODIES[name]
        for kind, (count, most) in product(body.kinds, body.counts):
            some = (None,) if kind == "cubes" else tuple(seed for seed in seeds if seed in SEEDS[:most])
            for seed, nu, law in product(some, body.nus, LAWS):
                if law == "bondem" or seed is None or seed in SEEDS[:FEW]:
                    add(record, "modes", modes, name=name, kind=kind, count=count, seed=seed, nu=nu, law=law)


def measure_lame(record: Record, seeds: Sequence[int]) -> None:
    """Measure the thick tube."""
    for count, most in LAME_COUNTS.items():
        for seed, nu, law in product(SEEDS[:most], LAME_NU, LAWS):
            if seed in seeds and (law == "bondem" or seed in SEEDS[:FEW]):
                add(record, "lame", lame, count=count, seed=seed, nu=nu, law=law)


def measure(
    record: Record, *, parts: tuple[str, ...] = tuple(PARTS), bodies: tuple[str, ...] = tuple(BODIES),
    seeds: tuple[int, ...] = SEEDS,
) -> None:  # fmt: skip
    """Measure frequencies, tubes, and meshes of the references."""
    for expected in (AuxeticWarning, FillingWarning, ThinBodyWarning, UnitWarning):
        warnings.simplefilter("ignore", expected)
    if "lame" in parts:
        measure_lame(record, seeds)
    if "modes" in parts:
        measure_modes(record, bodies, seeds)
    if "meshes" in parts:
        for name in bodies:
            add(record, "meshes", meshes, name=name, nu=BODIES[name].nus[-1], fine=BODIES[name].fine)
