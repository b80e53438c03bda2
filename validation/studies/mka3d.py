"""The cell law beside the variant of Mka3D, on the same bodies.

Mka3D (Mariotti 2007; Monasse and Mariotti 2012) is the elastic cell law with plain shares A w n; its facets bend with
E I/L and twist with G I_p/L, where those of bondem bend with 2G I/L and twist beside free walls only, and it has no
gradients of the dilatation. The variant is made here by replacing the functions that form these constants; bodies,
masses, walls, free facets and solvers are the same. Mka3D's papers use Voronoi cells and its mesh generator cuts
boxes into cubes, so both are here beside Laguerre cells. Measured are E and ν in bulk and of a bar, the first bending
of clamped strips one to four cells thick, free sheets of the same thicknesses, the celerity of plane waves, and free
frequencies of a beam and a plate, against triquadratic finite elements.
"""

import warnings
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import lru_cache, partial
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np

import bondem as bd
from bondem.errors import FillingWarning, ThinBodyWarning, UnitWarning
from bondem.interactions.cells import cell_constants
from validation.figures.mka3d import draw_variants
from validation.frame.record import Record
from validation.measures.bodies import free_modes, mesh
from validation.measures.continuum import Continuum, Vibration
from validation.measures.matching import matched
from validation.studies.cell_bodies import cut
from validation.studies.cell_moduli import bar_test
from validation.studies.cell_waves import LENGTH, celerity

#: Variants: whether shares are balanced, and how facets resist a relative rotation.
VARIANTS: dict[str, tuple[bool, Any]] = {
    "bondem": (True, "bending"),
    "bondem, facets with twist": (True, "full"),
    "balanced shares with facets of Mka3D": (True, "Mka3D"),
    "Mka3D": (False, "Mka3D"),
}
#: Plane waves in the length of the periodic cell.
NUMBERS = (1, 2, 4, 8)
#: Bodies, and how many times as many cells as asked for: 300 cannot be packed into them with every seed.
SHAPES = {"beam": 2, "plate": 3}
#: As many times as many cells in the periodic cell of waves: with fewer, cells are neighbours of their own images.
WAVES = 4
#: Edges of a sheet over its thickness.
SHEET = (8, 7, 1)


@contextmanager
def variant(name: str, nu: float) -> Iterator[bd.CellBond]:
    """Law for E = 1 of a variant; models that are made inside have its constants."""
    balanced, rotation = VARIANTS[name]
    ways, resistance = cell_constants.ways, cell_constants.resistance

    def of_mka3d(S: np.ndarray, normal: np.ndarray, stiffness: np.ndarray, rotation: str) -> np.ndarray:
        """E I/L about the axes in the plane, G I_p/L about the normal; `stiffness` is 2 G / L."""
        bending = (1.0 + nu) * resistance(S, normal, stiffness, "bending")
        polar = 0.5 * stiffness * np.einsum("mii->m", S) * (rotation == "full")
        return bending + polar[:, None, None] * normal[:, :, None] * normal[:, None, :]

    try:
        if not balanced:
            cell_constants.ways = lambda facets: (facets.normal, facets.normal)
        if rotation == "Mka3D":
            cell_constants.resistance = of_mka3d
        # "full": without gradients of θ and twist at free walls, and with twist of facets at walls that hold it
        yield bd.CellBond(E=1.0, nu=nu, facet_rotation="full" if rotation == "Mka3D" else rotation)
    finally:
        cell_constants.ways, cell_constants.resistance = ways, resistance


def tessellated(particles: bd.Particles, cells: str) -> bd.Lattice:
    """Laguerre cells of spheres, or Voronoi cells of their centres."""
    if cells == "Voronoi":
        particles = bd.Particles(particles.position, particles.radius.min(), shape=particles.shape)
    return bd.connect(particles, method="laguerre")


def moduli(count: int, seed: int, nu: float) -> list[dict[str, Any]]:
    """E and ν of a periodic cell and of a bar 4 × 1 × 1 between smooth platens."""
    packings = [
        bd.pack(shape, count=count, spread=0.25, seed=seed)
        for shape in (bd.Cell((1.0, 1.0, 1.0)), bd.Box((4.0, 1.0, 1.0)))
    ]
    rows = []
    for cells in ("Laguerre", "Voronoi"):
        torus, bar = (tessellated(packing, cells) for packing in packings)
        for name in VARIANTS:
            with variant(name, nu) as law:
                bulk, pulled = bd.bulk_moduli(torus, law), bar_test(bar, nu, law)
            rows.append(
                {"cells": cells, "variant": name, "bulk": {"E": bulk.E, "nu": bulk.nu}, "bar": pulled}
            )  # fmt: skip
    return rows


def frequencies(shape: str, count: int, seed: int, nu: float) -> list[dict[str, Any]]:
    """Errors of the first six free frequencies."""
    part, theory = cut(shape, count, seed), free_modes(shape, nu)
    middle = part.centre.mean(axis=0)
    expected = mesh(shape).sampler(middle + 0.999 * (part.centre - middle))(theory.shape)
    rows = []
    for name in VARIANTS:
        with variant(name, nu) as law:
            found = bd.solve_modes(bd.Model(part, law, 1.0), count=len(theory.frequency) + 3)
        assert part.cells is not None
        pairs = matched(found, part.cells.volume, theory, expected)
        rows.append({"variant": name, "errors": [p.measured / p.reference - 1.0 for p in pairs for _ in p.modes][:6]})
    return rows


def waves(count: int, seed: int, nu: float) -> list[dict[str, Any]]:
    """Celerity of plane waves of several lengths over that of the material."""
    body = bd.connect(bd.pack(bd.Cell((LENGTH, 1.0, 1.0)), count=count, spread=0.25, seed=seed), method="laguerre")
    size, rows = (LENGTH / count) ** (1.0 / 3.0), []
    for name in VARIANTS:
        with variant(name, nu) as law:
            model = bd.Model(body, law, 1.0)
            for kind, axis, exact in (("P", 0, np.sqrt(law.lame + 2.0 * law.G)), ("S", 1, np.sqrt(law.G))):
                for number in NUMBERS:
                    ratio = celerity(model, number, axis, float(exact)) / float(exact)
                    rows.append(
                        {"variant": name, "wave": kind, "elements": LENGTH / number / size, "ratio": ratio}
                    )  # fmt: skip
    return rows


def unit_cells(edges: tuple[int, ...], seed: int | None) -> bd.Lattice:
    """A box of cubes of edge 1, or of unequal cells of that size, even where it is one cell thick."""
    grid = np.stack(np.meshgrid(*(np.arange(n) for n in edges), indexing="ij"), axis=-1).reshape(-1, 3) + 0.5
    if seed is not None:
        grid += np.random.default_rng(seed).uniform(-0.15, 0.15, grid.shape) * (np.array(edges) > 1)
    return bd.connect(bd.Particles(grid, 0.3, shape=bd.Box(edges)), method="laguerre")


@lru_cache(maxsize=8)
def continuum(edges: tuple[int, ...], nu: float, held: str | None) -> tuple[Continuum, Vibration]:
    """The body of these edges and its lowest modes for E = ρ = 1."""
    solid = Continuum.box(edges, cell=0.5 * min(edges))
    return solid, solid.vibration(1.0, nu, 1.0, count=5, held=held)


def strip(thick: int, seed: int | None, nu: float) -> list[dict[str, Any]]:
    """Error of the first bending of a clamped strip, 12 times as long as thick and one cell wider."""
    edges = (12 * thick, thick + 1, thick)
    body, (_, exact) = unit_cells(edges, seed), continuum(edges, nu, "x_min")
    rows = []
    for name in VARIANTS:
        with variant(name, nu) as law:
            found = bd.solve_modes(bd.Model(body, law, 1.0, boundary=[bd.Fix(bd.Face("x_min"))]), count=3)
        across = (found.shape[:, :, :3] ** 2).sum(axis=1)
        first = int(np.flatnonzero(across.argmax(axis=1) == 2)[0])
        rows.append({"variant": name, "errors": [float(found.frequency[first] / exact.frequency[0] - 1.0)]})
    return rows


def sheet(thick: int, seed: int | None, nu: float) -> list[dict[str, Any]]:
    """Errors of the first three free frequencies of a sheet 8 × 7 times as wide as thick."""
    edges = tuple(n * thick for n in SHEET)
    body, (solid, exact) = unit_cells(edges, seed), continuum(edges, nu, None)
    expected = solid.sampler(body.centre)(exact.shape)
    rows = []
    for name in VARIANTS:
        with variant(name, nu) as law:
            found = bd.solve_modes(bd.Model(body, law, 1.0), count=8)
        assert body.cells is not None
        pairs = matched(found, body.cells.volume, exact, expected)
        rows.append({"variant": name, "errors": [p.measured / p.reference - 1.0 for p in pairs for _ in p.modes][:3]})
    return rows


THIN = {"strip": (strip, (1, 2, 4)), "sheet": (sheet, (1, 2, 4))}


def measure_thin(record: Record, nus: Sequence[float], seeds: Sequence[int]) -> None:
    """Strips and sheets; the thickest sheet of unequal cells with the first seed alone."""
    for nu, (body, (solve, thicknesses)) in product(nus, THIN.items()):
        for thick in thicknesses:
            some = seeds[:1] if body == "sheet" and thick > 2 else seeds
            for seed in (None, *some):
                case = {"body": body, "cells": "cubes" if seed is None else "unequal", "nu": nu, "thick": thick}
                record.add(partial(solve, thick, seed, nu), "thin", seed=seed, **case)


def measure(
    record: Record, *, counts: tuple[int, ...] = (300,), seeds: tuple[int, ...] = (1, 2, 3),
    nus: tuple[float, ...] = (0.2, 0.4),
) -> None:  # fmt: skip
    """Measure both variants on the same bodies."""
    for expected in (FillingWarning, ThinBodyWarning, UnitWarning):
        warnings.simplefilter("ignore", expected)
    measure_thin(record, nus, seeds)
    for count, seed, nu in product(counts, seeds, nus):
        case = {"nu": nu, "seed": seed}
        record.add(partial(moduli, count, seed, nu), "moduli", count=count, **case)
        for shape, times in SHAPES.items():
            most = times * count
            record.add(partial(frequencies, shape, most, seed, nu), "bodies", shape=shape, count=most, **case)
        if seed == seeds[0]:
            most = WAVES * count
            record.add(partial(waves, most, seed, nu), "waves", count=most, **case)


def draw(record: Record, folder: Path) -> None:
    """Thin bodies, and the stress of cells."""
    draw_variants(record.data, folder / "mka3d.png")
