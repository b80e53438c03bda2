"""Stress of cells about a hole, against three-dimensional elasticity, and how the hottest cell approaches the peak.

A plate 40 × 20 × 4 mm with a hole of radius 4 mm is pulled between smooth platens. An eighth of it is meshed with
triquadratic hexahedra, curved at the hole. What is compared is one quantity: `bd.cell_stress`, and the mean of the
finite elements' stress over the same cell, cut into tetrahedra of four points each; both over the mean stress of the
end. "About the hole" are cells with their centre less than two radii from its axis, "hottest" the hundredth of all
cells that the finite elements stress most along the pull.
"""

from collections.abc import Callable
from functools import lru_cache, partial
from itertools import product

import numpy as np
from scipy.interpolate import RegularGridInterpolator
from scipy.sparse.linalg import splu
from skfem import Basis, ElementHex1, ElementHex2, ElementVector, MeshHex, MeshHex2

import bondem as bd
from bondem.specimen.tessellation.polyhedra import polyhedra
from validation.frame.record import Record
from validation.measures.continuum import Continuum

LENGTH, WIDTH, THICKNESS, RADIUS = 40e-3, 20e-3, 4e-3, 4e-3
MIDDLE = np.array([0.5 * LENGTH, 0.5 * WIDTH, 0.5 * THICKNESS])
PULL = 1e-3
#: Elements of the eighth: along a quarter of the rim, across the ring, in the rest, through half the thickness.
#: With (16, 10, 6, 4) the peak at the rim is 0.2 % higher.
MESH = (24, 14, 8, 5)
Field = Callable[[np.ndarray], np.ndarray]


def _mapped(place: np.ndarray) -> np.ndarray:
    """From s (0 at the rim, 1 … 2 beyond the square), t (0 … 2 along the rim) and z to the plate [m], (3, n)."""
    s, t, z = place
    side = 0.5 * WIDTH
    outer = np.stack([np.where(t <= 1.0, side, side * (2.0 - t)), np.where(t <= 1.0, side * t, side)])
    ring = (1.0 - s) * RADIUS * np.stack([np.cos(0.25 * np.pi * t), np.sin(0.25 * np.pi * t)]) + s * outer
    return np.concatenate([np.where(s <= 1.0, ring, np.stack([side * s, side * t])), z[None]])


def _unmapped(x: np.ndarray) -> np.ndarray:
    """The place of points of the eighth, by Newton's method, (3, n)."""
    side, far = 0.5 * WIDTH, x[0] > 0.5 * WIDTH
    turned = x[1] > x[0]  # the upper octant is the mirror of the lower one
    low = np.where(turned, x[1::-1], x[:2])
    s = np.clip((low[0] - RADIUS) / (side - RADIUS), 0.0, 1.0)
    t = np.arctan2(low[1], low[0]) / (0.25 * np.pi)
    for _ in range(30):
        c, d = np.cos(0.25 * np.pi * t), np.sin(0.25 * np.pi * t)
        off = np.stack([(1 - s) * RADIUS * c + s * side, (1 - s) * RADIUS * d + s * side * t]) - low
        a, b = side - RADIUS * c, side * t - RADIUS * d
        e = -(1 - s) * RADIUS * 0.25 * np.pi * d
        f = (1 - s) * RADIUS * 0.25 * np.pi * c + s * side
        det = a * f - b * e
        s, t = s - (f * off[0] - e * off[1]) / det, t - (a * off[1] - b * off[0]) / det
    assert np.abs(off).max(where=~far, initial=0.0) < 1e-12
    t = np.where(turned, 2.0 - t, t)
    return np.stack([np.where(far, x[0] / side, s), np.where(far, x[1] / side, t), x[2]])


def _lines() -> tuple[np.ndarray, ...]:
    rim, ring, rest, through = MESH
    s = np.concatenate([np.linspace(0.0, 1.0, ring + 1) ** 1.6, np.linspace(1.0, 2.0, rest + 1)[1:]])
    z = 0.5 * THICKNESS * (1.0 - np.linspace(1.0, 0.0, through + 1) ** 1.6)
    return s, np.linspace(0.0, 2.0, rim + 1), z


def reference(nu: float) -> tuple[Field, dict[str, float]]:
    """Stress at points of the plate (n, 3) over the mean stress of the end, (n, 3, 3), and the peaks of it."""
    plain = MeshHex.init_tensor(*_lines())
    middle = plain.p[:, plain.t].mean(axis=1)
    plain = plain.restrict(np.flatnonzero((middle[0] < 1.0) | (middle[1] < 1.0)))
    curved = MeshHex2.from_mesh(plain)
    curved = MeshHex2(_mapped(curved.doflocs), curved.t)
    basis = Basis(curved, ElementVector(ElementHex2()), intorder=4)
    K = Continuum(basis).stiffness(1.0, nu)
    u = np.zeros(basis.N)
    held = []
    for axis, at, value in ((0, 0.0, 0.0), (1, 0.0, 0.0), (2, 0.0, 0.0), (0, 0.5 * LENGTH, PULL * LENGTH)):
        on = basis.get_dofs(lambda x, axis=axis, at=at: np.abs(x[axis] - at) < 1e-9).all(f"u^{axis + 1}")
        u[on] = value
        held.append(on)
    free = np.setdiff1d(np.arange(basis.N), np.concatenate(held))
    u[free] = splu(K[free][:, free].tocsc(), permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0,
                   options={"SymmetricMode": True}).solve(-(K @ u)[free])  # fmt: skip
    mean = (K @ u)[held[-1]].sum() / (0.25 * WIDTH * THICKNESS)
    inside = _interpolated(plain, curved, u, nu, mean)

    def everywhere(points: np.ndarray) -> np.ndarray:
        off = (points - MIDDLE).T
        sign = np.where(off < 0.0, -1.0, 1.0)
        return inside(_unmapped(np.abs(off))) * np.einsum("an,bn->nab", sign, sign)

    z = np.linspace(0.0, 0.5 * THICKNESS, 41)
    rim = inside(np.stack([np.zeros_like(z), np.full_like(z, 2.0), z]))[:, 0, 0]
    return everywhere, {"middle": float(rim[0]), "surface": float(rim[-1]), "largest": float(rim.max())}


def _interpolated(plain: MeshHex, curved: MeshHex2, u: np.ndarray, nu: float, mean: float) -> Field:
    """The stress at places: linear between the points of the elements where it is most exact, 2 × 2 × 2 in each."""
    lines = _lines()
    one = 0.5 + np.array([-0.5, 0.5]) / np.sqrt(3.0)
    local = np.stack(np.meshgrid(one, one, one, indexing="ij")).reshape(3, 8)
    basis = Basis(curved, ElementVector(ElementHex2()), quadrature=(local, np.full(8, 0.125)))
    grad = np.asarray(basis.interpolate(u).grad)
    strain = 0.5 * (grad + np.swapaxes(grad, 0, 1))
    lame, G = nu / ((1 + nu) * (1 - 2 * nu)), 0.5 / (1 + nu)
    stress = 2 * G * strain + lame * np.einsum("aaeq->eq", strain) * np.eye(3)[:, :, None, None]
    axes = [(a[:-1, None] + np.diff(a)[:, None] * one).ravel() for a in lines]
    # the axes of an element are not those of the mesh: each point goes where it lies
    place = np.asarray(Basis(plain, ElementHex1(), quadrature=basis.quadrature).global_coordinates())
    step = [np.searchsorted(0.5 * (a[1:] + a[:-1]), x) for a, x in zip(axes, place, strict=True)]
    grid = np.zeros((*map(len, axes), 3, 3))
    grid[tuple(step)] = np.moveaxis(stress / mean, (0, 1), (2, 3))
    ring, half = 2 * MESH[1], MESH[0]
    near = RegularGridInterpolator((axes[0][:ring], *axes[1:]), grid[:ring], bounds_error=False, fill_value=None)
    rest = RegularGridInterpolator(
        (axes[0][ring:], axes[1][:half], axes[2]), grid[ring:, :half], bounds_error=False, fill_value=None
    )
    return lambda place: np.where((place[0] <= 1.0)[:, None, None], near(place.T), rest(place.T))


def means(body: bd.Lattice, chosen: np.ndarray, field: Field) -> np.ndarray:
    """The mean of a field over chosen cells, (chosen, 3, 3): tetrahedra from centre to polygons, 4 points each."""
    assert body.cells is not None
    outline = polyhedra(body)
    size = np.diff(outline.start)
    fans = np.repeat(np.arange(len(size)), size - 2)
    second = np.arange(len(fans)) - np.repeat(np.cumsum(size - 2) - (size - 2), size - 2) + 1
    kept = np.isin(outline.cell[fans], chosen)
    fans, second = fans[kept], second[kept]
    cell = np.searchsorted(chosen, outline.cell[fans])
    first = outline.start[fans]
    corner = np.stack([outline.vertex[first + step] for step in (0 * second, second, second + 1)])
    apex = body.centre[chosen][cell]
    arm = corner - apex
    volume = np.einsum("na,na->n", arm[0], np.cross(arm[1], arm[2])) / 6.0
    total = np.bincount(cell, weights=volume, minlength=len(chosen))
    assert np.allclose(total, body.cells.volume[chosen], rtol=1e-6)
    far, near = 0.5854101966249685, 0.1381966011250105
    mean = np.zeros((len(chosen), 3, 3))
    weights = near * np.ones((4, 4)) + (far - near) * np.eye(4)
    for one in weights:
        points = one[0] * apex + np.einsum("k,kna->na", one[1:], corner)
        np.add.at(mean, cell, 0.25 * volume[:, None, None] * field(points))
    return mean / total[:, None, None]


@lru_cache(maxsize=1)
def cut(count: int, seed: int) -> bd.Lattice:
    """The plate as a body."""
    hole = bd.Cylinder(RADIUS, 10e-3).rotated("y", np.pi / 2).moved((MIDDLE[0], MIDDLE[1], 8e-3))
    shape = bd.Box((LENGTH, WIDTH, THICKNESS)) - hole
    return bd.connect(bd.pack(shape, count=count, spread=0.25, seed=seed), method="laguerre")


def pulled(body: bd.Lattice, nu: float) -> np.ndarray:
    """Stress of the cells between smooth platens over the mean stress of the end, (n, 3, 3)."""
    aside = int(np.linalg.norm(body.centre - MIDDLE * (0.25, 1.0, 1.0), axis=1).argmin())
    held = [
        bd.Fix(bd.Face("x_min"), translation="x", rotation=""), bd.Drive(bd.Face("x_max"), x=2.0 * PULL * LENGTH),
        bd.Fix(bd.Index([aside]), translation="yz", rotation="x"),
    ]  # fmt: skip
    model = bd.Model(body, bd.CellBond(E=1.0, nu=nu), 1.0, boundary=held)
    static = bd.solve_static(model)
    end = body.centre[:, 0] > 0.75 * LENGTH
    return bd.cell_stress(model, static) / (static.reaction[end, 0].sum() / (WIDTH * THICKNESS))


def compared(found: np.ndarray, wanted: np.ndarray, hottest: int) -> dict[str, float]:
    """Errors of the stress of cells about the hole (n, 3, 3)."""
    off = np.sqrt(((found - wanted) ** 2).sum(axis=(1, 2)))
    size = np.sqrt((wanted**2).sum(axis=(1, 2)))
    hot = np.argsort(-wanted[:, 0, 0])[:hottest]
    ratio = found[hot, 0, 0] / wanted[hot, 0, 0]
    return {
        "rms": float(np.sqrt((off**2).mean() / (size**2).mean())), "hot_mean": float(ratio.mean() - 1.0),
        "hot_rms": float(np.sqrt(((ratio - 1.0) ** 2).mean())), "hot_worst": float(np.abs(ratio - 1.0).max()),
        "hottest": float(found[:, 0, 0].max()), "hottest_wanted": float(wanted[:, 0, 0].max()),
        "hottest_error": float(found[:, 0, 0].max() / wanted[:, 0, 0].max() - 1.0), "hot": hottest,
    }  # fmt: skip


def measure(
    record: Record, *, counts: tuple[int, ...] = (2500, 10_000, 40_000), seeds: tuple[int, ...] = (1, 2),
    nus: tuple[float, ...] = (0.2, 0.4),
) -> None:  # fmt: skip
    """Measure all cases."""
    theory = {nu: reference(nu) for nu in nus}
    record.keep(mesh=MESH, peaks={str(nu): found for nu, (_, found) in theory.items()})
    for count, seed, nu in product(counts, seeds, nus):
        record.add(partial(measured, count, seed, nu, theory[nu][0]), "rows", count=count, seed=seed, nu=nu)


def measured(count: int, seed: int, nu: float, field: Field) -> dict[str, float]:
    """Errors of one plate."""
    body = cut(count, seed)
    assert body.cells is not None
    chosen = np.flatnonzero(np.hypot(*(body.centre - MIDDLE)[:, :2].T) < 2.0 * RADIUS)
    wanted, size = means(body, chosen, field), float(body.cells.volume.mean() ** (1.0 / 3.0))
    sizes = {"cells": len(chosen), "thickness": THICKNESS / size, "radius": RADIUS / size}
    return sizes | compared(pulled(body, nu)[chosen], wanted, count // 100)
