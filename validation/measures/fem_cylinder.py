"""Finite elements of a cylinder whose ends are finer than its middle: the continuum beside a specimen of spheres.

Trilinear hexahedra. The disc is a rounded square inside a ring; towards both ends it is halved twice, and where a
finer disc meets a coarser one its points move as the coarser one interpolates. All discs have the same outline.
"""

from collections.abc import Callable

import numpy as np
import pyamg
from scipy.linalg import eigh
from scipy.sparse import coo_matrix, csr_matrix, diags, eye, kron
from scipy.sparse.linalg import cg, eigsh
from skfem import Basis, BilinearForm, ElementHex1, ElementVector, MeshHex, asm
from skfem.models.elasticity import lame_parameters, linear_elasticity

import bondem as bd
from bondem.labtests.beam_tests import Bar, CrossSection

E, NU, RHO = 72.5e9, 0.17, 2201.0
SHAPE = bd.Cylinder(radius=5e-3, length=40e-3)
#: How deep the finest discs reach, deeper than the spheres at a face, and the next ones [m].
FINEST, FINER = 1e-3, 2e-3
#: Length of the elements in the middle [m]: they are too stiff in bending by 0.55 (length / diameter)² = 0.05 %.
MIDDLE = SHAPE.radius / 16.0

Solve = Callable[[np.ndarray], np.ndarray]


def disc(cells: int) -> tuple[np.ndarray, np.ndarray]:
    """Points (n, 2) [m] and quadrilaterals (m, 4) of a disc: a rounded square inside a ring."""
    core, rings = cells // 2, cells // 4
    s = np.linspace(-1.0, 1.0, core + 1)
    a, b = (part.ravel() for part in np.meshgrid(s, s, indexing="ij"))
    points = [0.55 * np.stack([a * np.sqrt(1.0 - 0.3 * b * b), b * np.sqrt(1.0 - 0.3 * a * a)], axis=1)]
    number = np.arange((core + 1) ** 2).reshape(core + 1, core + 1)
    quads = [np.stack([number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]], axis=-1).reshape(-1, 4)]
    inner = np.concatenate([number[:-1, 0], number[-1, :-1], number[:0:-1, -1], number[0, :0:-1]])
    edge = points[0][inner]
    angle = -0.75 * np.pi + 2.0 * np.pi * np.arange(len(inner)) / len(inner)
    rim = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    for k in range(1, rings + 1):
        outer = (core + 1) ** 2 + (k - 1) * len(inner) + np.arange(len(inner))
        points.append(edge + k / rings * (rim - edge))
        quads.append(np.stack([inner, outer, np.roll(outer, -1), np.roll(inner, -1)], axis=1))
        inner = outer
    return SHAPE.radius * np.concatenate(points), np.concatenate(quads)


def halved(points: np.ndarray, quads: np.ndarray) -> tuple[np.ndarray, np.ndarray, csr_matrix]:
    """Every quadrilateral in four: points, quadrilaterals, and the interpolation from the old points, (new, old)."""
    n, m = len(points), len(quads)
    sides = np.sort(np.stack([quads, np.roll(quads, -1, axis=1)], axis=-1), axis=-1).reshape(-1, 2)
    edges, of = np.unique(sides, axis=0, return_inverse=True)
    side = n + of.reshape(m, 4)
    middle = n + len(edges) + np.arange(m)
    rows = np.concatenate([np.arange(n), np.repeat(n + np.arange(len(edges)), 2), np.repeat(middle, 4)])
    columns = np.concatenate([np.arange(n), edges.ravel(), quads.ravel()])
    weights = np.repeat([1.0, 0.5, 0.25], [n, 2 * len(edges), 4 * m])
    interpolation = coo_matrix((weights, (rows, columns)), shape=(middle[-1] + 1, n)).tocsr()
    parts = [np.stack([quads[:, k], side[:, k], middle, side[:, k - 1]], axis=1) for k in range(4)]
    return interpolation @ points, np.concatenate(parts), interpolation


def extruded(points: np.ndarray, quads: np.ndarray, x: np.ndarray) -> MeshHex:
    """Layers of hexahedra over a disc, between planes x [m]; points in the order of the planes."""
    n = len(points)
    # the local order of corners is that of a unit cube of scikit-fem
    cube = MeshHex.init_tensor(*[np.array([0.0, 1.0])] * 3)
    corner = {(0, 0): 0, (1, 0): 1, (1, 1): 2, (0, 1): 3}
    layers = n * np.arange(len(x) - 1)[:, None]
    places = cube.p[:, cube.t[:, 0]].T.astype(int)
    t = [(layers + n * i + quads[None, :, corner[j, k]]).ravel() for i, j, k in places.tolist()]
    return MeshHex(np.stack([np.repeat(x, n), *np.tile(points, (len(x), 1)).T]), np.array(t))


def piled(layer: csr_matrix, count: int) -> csr_matrix:
    """The matrix of `count` equal layers on each other, from that of one."""
    n = layer.shape[0] // 2
    lower, above, upper = layer[:n, :n], layer[:n, n:], layer[n:, n:]
    first, up = diags([1.0] * count + [0.0]), eye(count + 1, k=1)
    last = diags([0.0] + [1.0] * count)
    return csr_matrix(kron(first, lower) + kron(last, upper) + kron(up, above) + kron(up.T, above.T))


def planes(cells: int) -> list[tuple[int, np.ndarray]]:
    """How often the disc is halved, and the equidistant planes x [m], of the five parts of the length."""
    finest = 2.0 * SHAPE.radius / (4 * cells)
    first = finest * np.arange(np.ceil(FINEST / finest) + 1)
    second = np.linspace(first[-1], FINER, round((FINER - first[-1]) / (2.0 * finest)) + 1)
    length = SHAPE.length
    middle = np.linspace(FINER, length - FINER, round((length - 2.0 * FINER) / MIDDLE) + 1)
    return [(2, first), (1, second), (0, middle), (1, length - second[::-1]), (2, length - first[::-1])]


class Continuum:
    """Stiffness, and mass, consistent and lumped, of the cylinder.

    Args:
        cells: elements across the diameter in the middle; four times as many at the ends.
    """

    def __init__(self, cells: int) -> None:
        discs = [disc(cells)]
        finer = []
        for _ in range(2):
            *shape, interpolation = halved(*discs[-1])
            discs.append((shape[0], shape[1]))
            finer.append(interpolation)
        parts = planes(cells)
        # a plane between two parts has the points of the coarser one
        levels = [min(parts[k][0], parts[k + 1][0]) for k in range(len(parts) - 1)]
        points, owners, starts = [], [], [0]
        for k, (level, x) in enumerate(parts):
            own = [level] * len(x)
            own[0] = levels[k - 1] if k else level
            own[-1] = levels[k] if k < len(levels) else level
            first = 1 if k else 0  # the last plane of the part before
            for place, which in zip(x[first:].tolist(), own[first:], strict=True):
                flat = discs[which][0]
                points.append(np.column_stack([np.full(len(flat), place), flat]))
                starts.append(starts[-1] + len(flat))
            owners.append((own, len(starts) - 1 - len(x)))
        self.points = np.concatenate(points)
        n = len(self.points)
        self.elements = sum(len(discs[level][1]) * (len(x) - 1) for level, x in parts)
        K, M = csr_matrix((3 * n, 3 * n)), csr_matrix((n, n))
        for (own, at), (level, x) in zip(owners, parts, strict=True):
            blocks = [finer[level - 1] if which < level else eye(len(discs[level][0])) for which in own]
            moves = _placed(blocks, np.array(starts[at:]), n)
            mesh = extruded(*discs[level], x[:2])
            vector = Basis(mesh, ElementVector(ElementHex1()), intorder=2)
            stiff = piled(asm(linear_elasticity(*lame_parameters(E, NU)), vector), len(x) - 1)
            scalar = asm(BilinearForm(lambda u, v, w: RHO * u * v), Basis(mesh, ElementHex1(), intorder=2))
            scalar = piled(scalar, len(x) - 1)
            M = M + moves.T @ scalar @ moves
            moves = kron(moves, eye(3), format="csr")
            K = K + moves.T @ stiff @ moves
        self.K, self.M = csr_matrix(K), csr_matrix(kron(M, eye(3)))
        self.lumped = np.asarray(self.M.sum(axis=1)).ravel()
        # of the mesh, so that its polygonal boundary is not counted as an error
        y = self.points[:, 1]
        area, I = (float(part) / RHO / SHAPE.length for part in (M.sum(), y @ (M @ y)))
        self.bar = Bar(SHAPE.length, CrossSection(area, I, 2 * I, I, 2 * I, True), E, NU, RHO)

    def solver(self, held: np.ndarray) -> Solve:
        """A function f -> u with the points of `held` fixed."""
        free = np.flatnonzero(~np.repeat(held, 3))
        K = csr_matrix(self.K[free][:, free])
        modes = np.zeros((len(self.points), 3, 6))
        modes[:, range(3), range(3)] = 1.0
        for axis in range(3):
            modes[:, :, 3 + axis] = np.cross(np.eye(3)[axis], self.points / SHAPE.radius)
        modes = modes.reshape(-1, 6)[free]
        levels = pyamg.smoothed_aggregation_solver(
            K.tobsr((3, 3)),
            B=modes,
            strength=("symmetric", {"theta": 0.0}),
            max_coarse=600,
            coarse_solver="splu",
        )
        precondition = levels.aspreconditioner()

        def solve(load: np.ndarray) -> np.ndarray:
            u = np.zeros(len(load))
            u[free], info = cg(K, load[free], rtol=1e-6, maxiter=500, M=precondition)
            assert info == 0, "conjugate gradients did not converge"
            return u

        return solve

    def frequencies(self, solve: Solve, shapes: np.ndarray) -> tuple[float, float, float]:
        """First axial, bending and torsional frequency [Hz]: Rayleigh–Ritz on static shapes and their iterates."""
        X = np.hstack([shapes, np.stack([solve(column) for column in (self.M @ shapes).T], axis=1)])
        # of length one, then orthogonal, so that the small problem is well conditioned
        X /= np.sqrt(np.einsum("nk,nk->k", X, self.M @ X))
        size, turn = np.linalg.eigh(X.T @ (self.M @ X))
        X = X @ (turn[:, size > 1e-9] / np.sqrt(size[size > 1e-9]))
        values, vectors = eigh(X.T @ (self.K @ X))
        V = (X @ vectors).reshape(len(self.points), 3, -1)
        y, z = self.points[:, 1:].T
        m = self.lumped[::3]
        share = np.stack(
            [
                np.einsum("n,nk->k", m, V[:, 0]) ** 2 / m.sum(),
                np.einsum("n,nk->k", m, V[:, 1]) ** 2 / m.sum(),
                np.einsum("n,nk->k", m, y[:, None] * V[:, 2] - z[:, None] * V[:, 1]) ** 2 / (m @ (y * y + z * z)),
            ]
        )
        first = np.sqrt(values) / (2 * np.pi)
        pair = np.flatnonzero(values < 1.2 * values[0])[:2]
        bending = np.sqrt(np.average(values[pair], weights=share[1, pair])) / (2 * np.pi)
        return float(first[np.argmax(share[0])]), float(bending), float(first[np.argmax(share[2])])

    def celerity(self, pushed: np.ndarray, measure: Callable[[np.ndarray], np.ndarray]) -> float:
        """Wave speed as `bd.labtests.impact` measures it, over √(E/ρ); central differences, lumped mass [-]."""
        c = np.sqrt(E / RHO)
        expected = SHAPE.length / c
        scale = 1.0 / np.sqrt(self.lumped)
        dynamic = csr_matrix(diags(scale) @ self.K @ diags(scale))
        dt = 1.8 / np.sqrt(eigsh(dynamic, k=1, tol=1e-2, return_eigenvectors=False)[0])
        driven = np.flatnonzero(np.repeat(pushed, 3) & (np.arange(self.K.shape[0]) % 3 == 0))
        u, v = np.zeros((2, self.K.shape[0]))
        v[driven] = -1.0
        step = self.K.multiply((dt / self.lumped)[:, None]).tocsr()
        time, far = [], []
        while len(time) * dt < 2.7 * expected:
            u += dt * v
            v -= step @ u
            v[driven] = -1.0
            time.append((len(time) + 1.5) * dt)
            far.append(-measure(v.reshape(-1, 3))[0])
        time, far = np.array(time), np.array(far)
        half = 0.5 * far[time >= 1.4 * expected].mean()
        first = int(np.argmax(far >= half))
        return expected / float(np.interp(half, far[first - 1 : first + 1], time[first - 1 : first + 1]))


def _placed(blocks: list, columns: np.ndarray, n: int) -> csr_matrix:
    """Blocks below each other, at these of `n` columns."""
    parts = [block.tocoo() for block in blocks]
    rows = np.cumsum([0] + [part.shape[0] for part in parts])
    row = np.concatenate([part.row + start for part, start in zip(parts, rows[:-1].tolist(), strict=True)])
    column = np.concatenate([part.col + columns[k] for k, part in enumerate(parts)])
    values = np.concatenate([part.data for part in parts])
    return csr_matrix((values, (row, column)), shape=(rows[-1], n))
