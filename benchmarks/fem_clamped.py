"""What an exact continuum does in the tests of a clamped specimen: a finite-element reference.

Strength of materials takes the clamped section for a rigid plane and the bar for a line. A specimen of spheres
is held and loaded at the few spheres that touch its ends. This script solves three-dimensional elasticity on a
cylinder (trilinear hexahedra) in three ways and prints each result relative to strength of materials with the
length from wall to wall:

    face      the face x = 0 held, tractions on the face x = L
    slab      all material up to x = R̄ held, tractions on the face x = L
    spheres   the material inside the spheres of Face("x_min") of a packing held, the loads of Face("x_max") on
              the material inside its spheres, whose mean motion is what counts

Each way also gets an impact: x = L (or the spheres there) pushed at a held velocity, arrival at x = 0 at half
the plateau.

Run: python benchmarks/fem_clamped.py [--cells 32] [--count 10000] [--seed 1]        (a few minutes)
"""

import argparse
import time

import numpy as np
import pyamg
from scipy.linalg import eigh
from scipy.sparse import csr_matrix, diags
from scipy.sparse.linalg import cg, eigsh
from skfem import Basis, BilinearForm, ElementHex1, ElementVector, MeshHex, asm
from skfem.helpers import dot
from skfem.models.elasticity import lame_parameters, linear_elasticity

import bondem as bd
from bondem.labtests.beams import Bar, CrossSection
from bondem.labtests.gauge_length import rigid_motion

E, NU, RHO = 72.5e9, 0.17, 2201.0
SHAPE = bd.Cylinder(radius=5e-3, length=40e-3)


def cylinder_mesh(cells: int) -> MeshHex:
    """A disc of quadrilaterals, extruded over a length that is finest at both ends."""
    fine = 2.0 * SHAPE.radius / cells
    step, places = fine, [0.0]
    while places[-1] < 0.5 * SHAPE.length:
        places.append(places[-1] + step)
        if places[-1] > 0.6 * SHAPE.radius:
            step = min(1.25 * step, 2.5 * fine)
    half = np.array(places) / places[-1] * 0.5 * SHAPE.length
    length = np.concatenate([half, SHAPE.length - half[-2::-1]])
    disc, quads = disc_mesh(cells)
    n = len(disc)
    p = np.stack([np.repeat(length, n), *np.tile(disc, (len(length), 1)).T])
    # the local order of corners is that of a unit cube of scikit-fem
    cube = MeshHex.init_tensor(*[np.array([0.0, 1.0])] * 3)
    corner = {(0, 0): 0, (1, 0): 1, (1, 1): 2, (0, 1): 3}
    layers = n * np.arange(len(length) - 1)[:, None]
    places = cube.p[:, cube.t[:, 0]].T.astype(int)
    t = [(layers + n * x + quads[None, :, corner[y, z]]).ravel() for x, y, z in places.tolist()]
    return MeshHex(p, np.array(t))


def disc_mesh(cells: int) -> tuple[np.ndarray, np.ndarray]:
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


class Continuum:
    """Stiffness and lumped mass of the cylinder."""

    def __init__(self, cells: int) -> None:
        self.mesh = cylinder_mesh(cells)
        basis = Basis(self.mesh, ElementVector(ElementHex1()), intorder=2)
        self.K = asm(linear_elasticity(*lame_parameters(E, NU)), basis).tocsr()
        mass = asm(BilinearForm(lambda u, v, w: RHO * dot(u, v)), basis)
        self.mass = np.asarray(mass.sum(axis=1)).ravel()
        self.points = self.mesh.p.T
        # of the mesh, so that its polygonal boundary is not counted as an error
        self.volume = self.mass[::3].sum() / RHO
        along_y = np.zeros((len(self.points), 3))
        along_y[:, 1] = self.points[:, 1]
        self.second_moment = float(along_y.ravel() @ (mass @ along_y.ravel())) / RHO / SHAPE.length

    def bar(self) -> Bar:
        I = self.second_moment
        return Bar(SHAPE.length, CrossSection(self.volume / SHAPE.length, I, 2 * I, I, 2 * I, True), E, NU, RHO)

    def solver(self, held: np.ndarray):
        """A function f -> u with the points of `held` fixed."""
        free = np.flatnonzero(~np.repeat(held, 3))
        K = csr_matrix(self.K[free][:, free])
        modes = np.zeros((len(self.points), 3, 6))
        modes[:, range(3), range(3)] = 1.0
        for axis in range(3):
            modes[:, :, 3 + axis] = np.cross(np.eye(3)[axis], self.points / SHAPE.radius)
        modes = modes.reshape(-1, 6)[free]
        levels = pyamg.smoothed_aggregation_solver(
            K.tobsr((3, 3)), B=modes, strength=("symmetric", {"theta": 0.0}), max_coarse=600
        )
        precondition = levels.aspreconditioner()

        def solve(load: np.ndarray) -> np.ndarray:
            u = np.zeros(len(load))
            u[free], info = cg(K, load[free], rtol=1e-8, maxiter=500, M=precondition)
            assert info == 0, "conjugate gradients did not converge"
            return u

        return solve, free

    def frequencies(self, solve, free: np.ndarray, shapes: np.ndarray) -> dict[str, float]:
        """First axial, bending and torsional frequency by subspace iteration from the static shapes."""
        X = shapes.copy()
        mass = diags(self.mass)
        for _ in range(2):
            X = np.hstack([X, np.stack([solve(column) for column in (mass @ X[:, -4:]).T], axis=1)])
            X /= np.abs(X).max(axis=0)
        # a shift of the basis to its independent part
        Q, size, _ = np.linalg.svd(np.sqrt(self.mass)[:, None] * X, full_matrices=False)
        X = (Q[:, size > 1e-7 * size[0]]) / np.sqrt(self.mass)[:, None]
        values, vectors = eigh(X.T @ (self.K @ X))
        V = (X @ vectors).reshape(len(self.points), 3, -1)
        y, z = self.points[:, 1:].T
        m = self.mass[::3]
        share = np.stack(
            [
                np.einsum("n,nk->k", m, V[:, 0]) ** 2 / m.sum(),
                np.einsum("n,nk->k", m, V[:, 1]) ** 2 / m.sum(),
                np.einsum("n,nk->k", m, y[:, None] * V[:, 2] - z[:, None] * V[:, 1]) ** 2 / (m @ (y * y + z * z)),
            ]
        )
        first = np.sqrt(values) / (2 * np.pi)
        axial, torsional = first[np.argmax(share[0])], first[np.argmax(share[2])]
        pair = np.flatnonzero(values < 1.2 * values[0])[:2]
        bending = np.sqrt(np.average(values[pair], weights=share[1, pair])) / (2 * np.pi)
        return {"f axial": axial, "f bending": bending, "f torsion": torsional}


    def celerity(self, pushed: np.ndarray, measure) -> float:
        """Wave speed as `bd.labtests.impact` measures it, over √(E/ρ); central differences, lumped mass [-]."""
        c = np.sqrt(E / RHO)
        expected = SHAPE.length / c
        scale = 1.0 / np.sqrt(self.mass)
        dynamic = csr_matrix(diags(scale) @ self.K @ diags(scale))
        dt = 1.8 / np.sqrt(eigsh(dynamic, k=1, tol=1e-2, return_eigenvectors=False)[0])
        driven = np.flatnonzero(np.repeat(pushed, 3) & (np.arange(self.K.shape[0]) % 3 == 0))
        u, v = np.zeros((2, self.K.shape[0]))
        v[driven] = -1.0
        time, far = [], []
        while len(time) * dt < 2.7 * expected:
            u += dt * v
            v -= dt * (self.K @ u) / self.mass
            v[driven] = -1.0
            time.append((len(time) + 1.5) * dt)
            far.append(-measure(v.reshape(-1, 3))[0])
        time, far = np.array(time), np.array(far)
        half = 0.5 * far[time >= 1.4 * expected].mean()
        first = int(np.argmax(far >= half))
        return expected / float(np.interp(half, far[first - 1 : first + 1], time[first - 1 : first + 1]))


def unit_loads(points: np.ndarray, weight: np.ndarray, n: int) -> np.ndarray:
    """Nodal loads of a unit force along x and y, one along z, and a unit moment about x, (3 n, 4)."""
    loads = np.zeros((n, 3, 4))
    share = weight / weight.sum()
    loads[:, 0, 0] = loads[:, 1, 1] = loads[:, 2, 2] = share
    y, z = points[:, 1:].T
    polar = (share * (y * y + z * z)).sum()
    loads[:, 1, 3], loads[:, 2, 3] = -share * z / polar, share * y / polar
    return loads.reshape(3 * n, 4)


def report(name: str, model: Continuum, held, loads, measure, pushed, arrived) -> None:
    """Solve one way of holding and loading, and print all results relative to theory.

    `measure` and `arrived` turn displacements (n, 3) into the motion of the loaded and of the far face (6,).
    """
    bar = model.bar()
    began = time.perf_counter()
    solve, free = model.solver(held)
    shapes = np.stack([solve(load) for load in loads.T], axis=1)
    u = shapes.reshape(len(model.points), 3, 4)
    rows = {
        "tension": measure(u[:, :, 0])[0] / bar.extension(1.0),
        "bending": measure(u[:, :, 1])[1] / bar.deflection(1.0),
        "bending (Timoshenko)": measure(u[:, :, 1])[1] / bar.deflection(1.0, shear=True),
        "torsion": measure(u[:, :, 3])[3] / bar.twist(1.0),
    }
    f = model.frequencies(solve, free, shapes)
    rows |= {
        "f axial": f["f axial"] / bar.axial_frequency,
        "f bending": f["f bending"] / bar.bending_frequency,
        "f bending (Timoshenko)": f["f bending"] / bar.bending_frequency_timoshenko,
        "f torsion": f["f torsion"] / bar.torsional_frequency,
        "celerity": model.celerity(pushed, arrived),
    }
    print(f"{name}: {held.sum()} points held, {time.perf_counter() - began:.0f} s")
    for key, ratio in rows.items():
        print(f"    {key:24s}{100 * (ratio - 1):+8.2f} %")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cells", type=int, default=32, help="elements across the diameter")
    parser.add_argument("--count", type=int, default=10_000, help="spheres of the packing")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()

    model = Continuum(options.cells)
    points = model.points
    x = points[:, 0]
    n = len(points)
    print(f"{model.mesh.nelements} hexahedra, {3 * n} unknowns")

    end = np.abs(x - SHAPE.length) < 1e-9
    weight = np.where(end, model.mass[::3], 0.0)
    loads = unit_loads(points, weight, n)

    def face(u: np.ndarray) -> np.ndarray:
        mean = (weight[:, None] * u).sum(axis=0) / weight.sum()
        return np.concatenate([mean, rigid_motion(points[end], u[end])[3:]])

    def far_face(u: np.ndarray) -> np.ndarray:
        share = np.where(x < 1e-9, model.mass[::3], 0.0)
        return share @ u / share.sum()

    report("face", model, x < 1e-9, loads, face, end, far_face)

    particles = bd.pack(SHAPE, count=options.count, spread=0.25, seed=options.seed)
    lattice = bd.connect(particles)
    deep = x < particles.mean_radius
    report("slab", model, deep, loads, face, x > SHAPE.length - particles.mean_radius, far_face)

    first, last = (bd.Face(name).select(lattice) for name in ("x_min", "x_max"))
    held, inside = _inside(points, particles, first), _inside(points, particles, last)
    share = inside / inside.sum(axis=1, keepdims=True)
    centres = share @ points
    loads = np.einsum("pn,pck->nck", share, _sphere_loads(lattice, len(last)))
    far_share = held.mean(axis=0)
    far_share /= far_share.sum()

    def spheres(u: np.ndarray) -> np.ndarray:
        moved = share @ u
        return np.concatenate([moved.mean(axis=0), rigid_motion(centres, moved)[3:]])

    def far_spheres(u: np.ndarray) -> np.ndarray:
        return far_share @ u

    gripped, pushed = ((part > 0.0).any(axis=0) for part in (held, inside))
    report("spheres", model, gripped, loads.reshape(3 * n, 4), spheres, pushed, far_spheres)


def _inside(points: np.ndarray, particles, chosen: np.ndarray) -> np.ndarray:
    """Which points lie in which sphere, (spheres, points); at least the nearest one."""
    distance = np.linalg.norm(points[None] - particles.position[chosen][:, None], axis=2)
    inside = distance <= particles.radius[chosen][:, None]
    inside[np.arange(len(chosen)), distance.argmin(axis=1)] = True
    return inside.astype(float)


def _sphere_loads(lattice, count: int) -> np.ndarray:
    """Forces on the spheres as `bd.Load` gives them, (spheres, 3, 4)."""
    loads = np.zeros((count, 3, 4))
    for k, (force, moment) in enumerate([((1, 0, 0), 0), ((0, 1, 0), 0), ((0, 0, 1), 0), ((0, 0, 0), 1)]):
        _, nodal = bd.Load(bd.Face("x_max"), force=force, moment=(moment, 0, 0)).nodal(lattice)
        loads[:, :, k] = nodal[:, :3]
    return loads


if __name__ == "__main__":
    main()
