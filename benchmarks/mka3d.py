"""The cell law beside the variant of Mka3D, on the same bodies.

Mka3D (Mariotti 2007; Monasse and Mariotti 2012) is the elastic cell law with M = 1; its facets bend with E I/L and
twist with G I_p/L, where those of bondem bend with 2G I/L and do not twist by default. The variant is made here by
replacing the two functions that form these constants; nothing else differs: bodies, masses, free facets and solvers
are the same. Measured are E and ν in bulk and of a bar, the first bending of clamped strips one to four cells thick,
the celerity of plane waves, and free frequencies of a beam and a plate against finite elements.

Run: python benchmarks/mka3d.py [--counts 300 1000] [--seeds 1 2 3] [--nu 0.2 0.4] [--out FILE]
It writes benchmarks/results/mka3d.json.
"""

import argparse
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np

import bondem as bd
from bondem.errors import ThinBodyWarning
from bondem.model import cell_constants
from cell_bodies import cut, free_modes, mesh
from cell_moduli import bar_test
from cell_waves import LENGTH, celerity
from continuum import Continuum
from kept import RESULTS, keep, origin
from matching import matched

#: Variants: whether θ has M⁻¹, and how facets resist a relative rotation.
VARIANTS = {
    "bondem": (True, "bending"),
    "bondem, facets with twist": (True, "full"),
    "M⁻¹ with facets of Mka3D": (True, "Mka3D"),
    "Mka3D": (False, "Mka3D"),
}
#: Plane waves in the length of the periodic cell.
NUMBERS = (1, 2, 4, 8)
SHAPES = ("beam", "plate")
#: Cells across the thickness of the strips.
THICK = (1, 2, 4)


@contextmanager
def variant(name: str, nu: float) -> Iterator[bd.CellBond]:
    """Law for E = 1 of a variant; models that are made inside have its constants."""
    corrected, rotation = VARIANTS[name]
    corrections, resistance = cell_constants._corrections, cell_constants._resistance

    def of_mka3d(S: np.ndarray, normal: np.ndarray, stiffness: np.ndarray, kind: str) -> np.ndarray:
        """E I/L about the axes in the plane, G I_p/L about the normal; `stiffness` is 2 G / L."""
        bending = resistance(S, normal, stiffness, "bending")
        polar = stiffness * np.einsum("mii->m", S)
        return (1.0 + nu) * bending + 0.5 * polar[:, None, None] * normal[:, :, None] * normal[:, None, :]

    try:
        if not corrected:
            cell_constants._corrections = lambda body, facets, cells: np.tile(np.eye(3), (len(cells.volume), 1, 1))
        if rotation == "Mka3D":
            cell_constants._resistance = of_mka3d
        yield bd.CellBond(E=1.0, nu=nu, facet_rotation="bending" if rotation == "Mka3D" else rotation)
    finally:
        cell_constants._corrections, cell_constants._resistance = corrections, resistance


def moduli(count: int, seed: int, nu: float) -> list[dict[str, Any]]:
    """E and ν of a periodic cell and of a bar 4 × 1 × 1 between smooth platens."""
    torus, bar = (
        bd.connect(bd.pack(shape, count=count, spread=0.25, seed=seed), method="laguerre")
        for shape in (bd.Cell((1.0, 1.0, 1.0)), bd.Box((4.0, 1.0, 1.0)))
    )
    rows = []
    for name in VARIANTS:
        with variant(name, nu) as law:
            bulk = bd.bulk_moduli(torus, law)
            rows.append({"variant": name, "bulk": {"E": bulk.E, "nu": bulk.nu}, "bar": bar_test(bar, nu, law)})
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


def thin(thick: int, seed: int, nu: float) -> list[dict[str, Any]]:
    """Error of the first bending of a clamped strip of unit cells, 12 times as long as thick."""
    counts = (12 * thick, thick + 1, thick)
    grid = np.stack(np.meshgrid(*(np.arange(n) for n in counts), indexing="ij"), axis=-1).reshape(-1, 3)
    unequal = np.random.default_rng(seed).uniform(-0.15, 0.15, grid.shape) * (np.array(counts) > 1)
    particles = bd.Particles(grid + 0.5 + unequal, 0.3, shape=bd.Box(counts))
    body = bd.connect(particles, method="laguerre")
    continuum = Continuum.box(counts, cell=0.5 * thick)
    exact = continuum.vibration(1.0, nu, 1.0, count=3, held="x_min").frequency[0]
    rows = []
    for name in VARIANTS:
        with variant(name, nu) as law, warnings.catch_warnings():
            warnings.simplefilter("ignore", ThinBodyWarning)
            found = bd.solve_modes(bd.Model(body, law, 1.0, boundary=[bd.Fix(bd.Face("x_min"))]), count=3)
        across = (found.shape[:, :, :3] ** 2).sum(axis=1)
        first = int(np.flatnonzero(across.argmax(axis=1) == 2)[0])
        rows.append({"variant": name, "error": float(found.frequency[first] / exact - 1.0)})
    return rows


def main(arguments: list[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--counts", type=int, nargs="+", default=[300, 1000], help="numbers of cells")
    parser.add_argument("--seeds", type=int, nargs="+", default=[1, 2, 3], help="seeds of the packings")
    parser.add_argument("--nu", type=float, nargs="+", default=[0.2, 0.4], help="Poisson's ratios")
    parser.add_argument("--out", type=Path, default=RESULTS / "mka3d.json", help="file of the results")
    given = parser.parse_args(arguments)
    report: dict[str, Any] = origin() | {"moduli": [], "bodies": [], "thin": [], "waves": []}

    def add(part: str, rows: list[dict[str, Any]], **where: Any) -> None:
        report[part] += [where | row for row in rows]
        keep(given.out, report)
        for row in rows:
            print(part, where, row, flush=True)

    most = max(given.counts)
    for seed, nu in product(given.seeds, given.nu):
        for count in given.counts:
            add("moduli", moduli(count, seed, nu), nu=nu, seed=seed, count=count)
        for thick in THICK:
            add("thin", thin(thick, seed, nu), nu=nu, seed=seed, thick=thick)
        add("waves", waves(most, seed, nu), nu=nu, seed=seed, count=most)
        for shape, count in product(SHAPES, given.counts):
            add("bodies", frequencies(shape, count, seed, nu), shape=shape, count=count, nu=nu, seed=seed)


if __name__ == "__main__":
    main()
