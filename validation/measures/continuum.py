"""Three-dimensional elasticity of boxes and unions of boxes by finite elements: what a specimen should do.

Triquadratic hexahedra on a tensor mesh, refined towards held faces and re-entrant edges, where the stress is
singular. With E, ν, ρ given, a `Continuum` tells its free or clamped natural frequencies and what a force and a
moment on a face do to that face, to 0.2 % or better (halve `cell` and compare).
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np
from scipy.sparse import csc_matrix
from scipy.sparse.linalg import LinearOperator, eigsh, splu
from skfem import Basis, BilinearForm, ElementHex2, ElementVector, FacetBasis, LinearForm, MeshHex, asm
from skfem.helpers import ddot, dot, sym_grad, trace

Corners = tuple[Sequence[float], Sequence[float]]

#: L-bracket of examples/bracket.stl: a foot along x, held at x_min, and an arm along z, loaded at z_max [m].
BRACKET: tuple[Corners, ...] = (((0, 0, 0), (40e-3, 12e-3, 8e-3)), ((32e-3, 0, 0), (40e-3, 12e-3, 30e-3)))


@BilinearForm
def _dilation(u, v, w):
    return trace(sym_grad(u)) * trace(sym_grad(v))


@BilinearForm
def _distortion(u, v, w):
    return 2.0 * ddot(sym_grad(u), sym_grad(v))


@BilinearForm
def _inertia(u, v, w):
    return dot(u, v)


@dataclass(frozen=True, eq=False)
class Vibration:
    """Natural modes.

    Attributes:
        frequency: ascending, rigid motions left out [Hz], (count,).
        shape: nodal values, normalised to φᵀ M φ = 1 with ρ = 1, (dofs, count).
    """

    frequency: np.ndarray
    shape: np.ndarray


@dataclass(frozen=True, eq=False)
class Continuum:
    """A union of boxes that meet face to face, meshed.

    Attributes:
        basis: displacement, three components on triquadratic hexahedra.
    """

    basis: Basis

    @classmethod
    def of(
        cls, boxes: Sequence[Corners], *, cell: float | Sequence[float],
        refined: Sequence[Sequence[float]] = ((), (), ()),
    ) -> "Continuum":  # fmt: skip
        """Mesh a union of boxes.

        Args:
            boxes: lower and upper corner of each [m].
            cell: edge of the cells [m], or edges along x, y and z.
            refined: places along x, y and z at which the two cells next to each are halved, and halved again [m].
        """
        corners = np.array(boxes, dtype=float)
        edges = np.broadcast_to(cell, 3).tolist()
        lines = [_lines(np.unique(corners[:, :, d]), edges[d], refined[d]) for d in range(3)]
        mesh = MeshHex.init_tensor(*lines)
        middle = mesh.p[:, mesh.t].mean(axis=1).T[:, None]
        inside = ((middle > corners[:, 0]) & (middle < corners[:, 1])).all(axis=2).any(axis=1)
        if not inside.all():
            mesh = mesh.restrict(np.flatnonzero(inside))
        return cls(Basis(mesh, ElementVector(ElementHex2()), intorder=4))

    @classmethod
    def box(cls, size: Sequence[float], *, cell: float) -> "Continuum":
        """A box from the origin, refined towards its ends x_min and x_max."""
        return cls.of([((0, 0, 0), size)], cell=cell, refined=((0.0, size[0]), (), ()))

    @classmethod
    def bracket(cls, *, cell: float) -> "Continuum":
        """The L-bracket, refined towards its held end and its re-entrant edge."""
        (_, (_, _, height)), ((inner, _, _), _) = BRACKET
        return cls.of(BRACKET, cell=cell, refined=((0.0, inner), (), (height,)))

    def between(self, inside: float, *faces: str) -> "Continuum":
        """What lies between planes `inside` [m] of faces; the quarter of the body next to each has to be a prism."""
        mesh = self.basis.mesh
        p = mesh.p.copy()
        for face in faces:
            axis, sign = "xyz".index(face[0]), 1.0 if face.endswith("max") else -1.0
            end, quarter = (sign * p[axis]).max(), 0.25 * np.ptp(mesh.p[axis])
            p[axis] -= sign * inside * np.maximum(1.0 - (end - sign * p[axis]) / quarter, 0.0)
        return Continuum(Basis(type(mesh)(p, mesh.t), self.basis.elem, intorder=4))

    @cached_property
    def _forms(self) -> tuple[csc_matrix, csc_matrix, csc_matrix]:
        """K = λ K_λ + G K_G, and M for ρ = 1."""
        dilation, distortion, inertia = (asm(form, self.basis).tocsc() for form in (_dilation, _distortion, _inertia))
        return dilation, distortion, inertia

    def stiffness(self, E: float, nu: float) -> csc_matrix:
        """K [N/m]."""
        dilation, distortion, _ = self._forms
        return E * nu / ((1 + nu) * (1 - 2 * nu)) * dilation + E / (2 * (1 + nu)) * distortion

    @property
    def mass(self) -> csc_matrix:
        """M for ρ = 1 [m³]."""
        return self._forms[2]

    @property
    def volume(self) -> float:
        """[m³]."""
        return float(self.mass.sum()) / 3.0

    def _plane(self, face: str):
        """Function that tells points (3, ...) on "x_min" ... "z_max"."""
        axis, points = "xyz".index(face[0]), self.basis.mesh.p
        at = points[axis].max() if face.endswith("max") else points[axis].min()
        return lambda x: np.abs(x[axis] - at) < 1e-9 * np.ptp(points)

    def _free(self, held: str | None) -> np.ndarray:
        free = np.ones(self.basis.N, dtype=bool)
        if held:
            free[self.basis.get_dofs(self._plane(held)).all()] = False
        return np.flatnonzero(free)

    def vibration(self, E: float, nu: float, rho: float, *, count: int = 6, held: str | None = None) -> Vibration:
        """Lowest modes of the body, free or with a face held."""
        free, rigid = self._free(held), 0 if held else 6
        scale = E / np.ptp(self.basis.mesh.p, axis=1).max() ** 2
        # in units that make ω² of order one; the shift lies below all of them, so the matrix is definite
        K, M = (matrix[free][:, free].tocsc() for matrix in (self.stiffness(E, nu) / scale, self.mass))
        shift = -0.01
        inverse = _factor(K - shift * M)
        solve = LinearOperator(K.shape, matvec=inverse.solve, dtype=float)
        square, vector = eigsh(K, k=count + rigid, M=M, sigma=shift, OPinv=solve, v0=np.ones(len(free)))
        order = np.argsort(square)
        if rigid and not np.abs(square[order[:6]]).max() < 1e-6 * square[order[6]]:
            raise RuntimeError("a free body has six rigid motions; these modes have fewer")
        shape = np.zeros((self.basis.N, count))
        shape[free] = vector[:, order[rigid:]]
        return Vibration(np.sqrt(square[order[rigid:]] * scale / rho) / (2 * np.pi), shape)

    def response(
        self,
        E: float,
        nu: float,
        *,
        held: str,
        loaded: str,
        loads: Sequence[tuple[Sequence[float], Sequence[float]]],
        lever: Sequence[float] = (0.0, 0.0, 0.0),
    ) -> np.ndarray:
        """Mean displacement [m] and rotation [rad] of a face under each (force, moment) on it, (loads, 6).

        Tractions vary linearly over the face, as `bd.Load` spreads forces: F/S + b × r, where b gives the moment
        about the centre of the face. The motion is that of the closest rigid body. With a `lever`, the force acts,
        and the displacement is taken, that far from the centre of the face [m].
        """
        average, motions = self._face_motion(loaded)
        carried = np.eye(6)
        carried[3:, :3] = np.cross(np.asarray(lever, dtype=float), np.eye(3)).T
        per_load = carried @ np.array([np.concatenate(load) for load in loads], dtype=float).T
        free = self._free(held)
        nodal = motions @ average @ per_load
        u = np.zeros_like(nodal)
        u[free] = _factor(self.stiffness(E, nu)[free][:, free].tocsc()).solve(nodal[free])
        return (carried.T @ average @ motions.T @ u).T

    def _face_motion(self, name: str) -> tuple[np.ndarray, np.ndarray]:
        """(6, 6) that turns work into motion on a face, and the nodal work of unit motions, (dofs, 6)."""
        facets = self.basis.mesh.facets_satisfying(self._plane(name), boundaries_only=True)
        face = FacetBasis(self.basis.mesh, self.basis.elem, facets=facets, intorder=4)
        weight, place = face.dx, np.asarray(face.global_coordinates())
        centre = (place * weight).sum(axis=(1, 2)) / weight.sum()
        arm = place - centre[:, None, None]
        polar = np.einsum("ifq,jfq,fq->ij", arm, arm, weight)
        average = np.zeros((6, 6))
        average[:3, :3] = np.eye(3) / weight.sum()
        average[3:, 3:] = np.linalg.inv(np.trace(polar) * np.eye(3) - polar)
        columns = []
        for unit in np.eye(3):
            columns.append(np.broadcast_to(unit[:, None, None], arm.shape))
        for unit in np.eye(3):
            columns.append(np.cross(unit, arm, axisb=0, axisc=0))
        work = LinearForm(lambda v, w: dot(w.motion, v))
        return average, np.stack([asm(work, face, motion=column) for column in columns], axis=1)

    def sampler(self, points: np.ndarray) -> Callable[[np.ndarray], np.ndarray]:
        """Turns modes (dofs, count) into displacements at points (n, 3) inside, (count, n, 3)."""
        probe = self.basis.probes(points.T)
        return lambda shape: np.moveaxis((probe @ shape).reshape(3, len(points), -1), (0, 1, 2), (2, 1, 0))


def _factor(matrix: csc_matrix):
    return splu(matrix, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True})


def _lines(breaks: np.ndarray, cell: float, refined: Sequence[float]) -> np.ndarray:
    """Places of mesh lines: through all breaks, `cell` apart, twice halved next to the refined places."""
    steps = [np.linspace(a, b, max(2, round((b - a) / cell)) + 1)[:-1] for a, b in pairwise(breaks)]
    lines = np.append(np.concatenate(steps), breaks[-1])
    for place in refined:
        for _ in range(2):
            k = int(np.abs(lines - place).argmin())
            added = [0.5 * (lines[k] + lines[m]) for m in (k - 1, k + 1) if 0 <= m < len(lines)]
            lines = np.sort(np.append(lines, added))
    return lines
