"""The plain two-phase step, as short as it can be: what bondem's step must beat to be worth its blocks and tiles.

A loop over bonds that writes a force and two torques for each, then a loop over elements that adds up their own in
a fixed order and moves them (leapfrog); structures of arrays, threads by `prange`, nothing else. The physics is
bondem's scalar law for Euler–Bernoulli bonds in a periodic cell; that the motion is the same is checked first.

python benchmarks/plain_step.py [--elements 10000 100000] [--threads 1 2] [--repeat 7] [--steps 1000]
"""

import argparse

import numpy as np
from numba import njit, prange

import bondem as bd
from bondem.laws.beam_energy import bond_force
from bondem.laws.rotations import turn
from bondem.model.state import State
from paired import SOURCE, Worker, head, in_turns, machine, specimen_file

CHECK = 20  # steps after which poses are compared
SAME = 1e-12  # difference of positions over the mean radius, and of quaternions, that is rounding


@njit(parallel=True, fastmath={"contract"}, error_model="numpy")
def steps_of(steps, x, v, q, w, i, j, X, L, moduli, period, f, a, b, inward, outward, out_bond, mass, inertia, dt):
    """Go `steps` steps; v and w are half a step behind x and q."""
    kn, A, B, kt = moduli
    for _ in range(steps):
        for k in prange(len(i)):
            p, r = i[k], j[k]
            dx, dy, dz = x[0, r] - x[0, p], x[1, r] - x[1, p], x[2, r] - x[2, p]
            dx -= period[0] * np.rint(dx * period[3])
            dy -= period[1] * np.rint(dy * period[4])
            dz -= period[2] * np.rint(dz * period[5])
            s = 1.0 / L[k]
            f[0, k], f[1, k], f[2, k], a[0, k], a[1, k], a[2, k], b[0, k], b[1, k], b[2, k] = bond_force(
                dx, dy, dz, q[0, p], q[1, p], q[2, p], q[3, p], q[0, r], q[1, r], q[2, r], q[3, r],
                X[0, k], X[1, k], X[2, k], L[k], s * kn, s * A, s * B, s * A, s * kt,
            )  # fmt: skip
        for e in prange(len(mass)):
            fx = fy = fz = tx = ty = tz = 0.0
            for k in range(inward[e], inward[e + 1]):
                fx, fy, fz = fx + f[0, k], fy + f[1, k], fz + f[2, k]
                tx, ty, tz = tx + b[0, k], ty + b[1, k], tz + b[2, k]
            for n in range(outward[e], outward[e + 1]):
                k = out_bond[n]
                fx, fy, fz = fx - f[0, k], fy - f[1, k], fz - f[2, k]
                tx, ty, tz = tx + a[0, k], ty + a[1, k], tz + a[2, k]
            kick, spin = dt / mass[e], dt / inertia[e]
            v[0, e], v[1, e], v[2, e] = v[0, e] + kick * fx, v[1, e] + kick * fy, v[2, e] + kick * fz
            w[0, e], w[1, e], w[2, e] = w[0, e] + spin * tx, w[1, e] + spin * ty, w[2, e] + spin * tz
            x[0, e], x[1, e], x[2, e] = x[0, e] + dt * v[0, e], x[1, e] + dt * v[1, e], x[2, e] + dt * v[2, e]
            q[0, e], q[1, e], q[2, e], q[3, e] = turn(
                q[0, e], q[1, e], q[2, e], q[3, e], dt * w[0, e], dt * w[1, e], dt * w[2, e]
            )


class PlainStep:
    """A periodic model of Euler–Bernoulli bonds of one material, at first unstrained, in motion (n, 3) [m/s]."""

    def __init__(self, model: bd.Model, velocity: np.ndarray, dt: float) -> None:
        law, lattice, self.layout = model.bond, model.lattice, model.layout
        order, bond = self.layout.order, self.layout.bond_order
        n, m, L = len(order), len(bond), lattice.length[bond]
        radius = law.radius_ratio * lattice.particles.mean_radius
        EA, EI = np.pi * law.E * radius**2, 0.25 * np.pi * law.E * radius**4
        GJ = EI / (1.0 + law.nu)
        direction = lattice.branch[bond] / L[:, None] * np.where(self.layout.flipped, -1.0, 1.0)[:, None]
        self.x = np.ascontiguousarray(lattice.particles.position[order].T)
        self.q = np.concatenate([np.ones((1, n)), np.zeros((3, n))])
        self.arguments = (
            self.x, np.ascontiguousarray(velocity[order].T), self.q, np.zeros((3, n)), self.layout.i, self.layout.j,
            np.ascontiguousarray(direction.T), L, (EA, 4.0 * EI - GJ, 2.0 * EI + GJ, GJ), model.period,
            *np.empty((3, 3, m)), self.layout.in_start, self.layout.out_start, self.layout.out_bond,
            model.mass[order], model.inertia[order], dt,
        )  # fmt: skip

    def run(self, steps: int) -> None:
        steps_of(steps, *self.arguments)


def apart(model: bd.Model, velocity: np.ndarray, dt: float, steps: int = CHECK) -> float:
    """Largest difference between poses of the plain step and of bondem, positions over the mean radius."""
    plain, state = PlainStep(model, velocity, dt), State(model)
    plain.run(steps)
    state.set_motion(velocity=velocity)
    state = bd.solve_explicit(model, duration=steps * dt, dt=dt, every=0, state=state).state
    far = np.abs(plain.x[:, plain.layout.rank].T - state.position).max() / model.lattice.particles.mean_radius
    return float(max(far, np.abs(plain.q[:, plain.layout.rank].T - state.orientation).max()))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--elements", type=int, nargs="+", default=[10_000, 100_000])
    parser.add_argument("--threads", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--repeat", type=int, default=7)
    parser.add_argument("--steps", type=int, help="of a sample [a second or so]")
    options = parser.parse_args()
    print(", ".join(f"{key}: {value}" for key, value in machine().items()))
    cores = max(options.threads)
    with Worker(SOURCE, cores=cores) as plain, Worker(SOURCE, cores=cores) as bondem:
        print(f"{'elements':>9}{'threads':>8}{head(('plain', 'bondem'))}")
        for elements in options.elements:
            path = str(specimen_file(bondem, elements))
            bonds = bondem.ask("load", path=path)["bonds"]
            far = plain.ask("load", path=path, code="plain")["apart"]
            assert far < SAME, f"poses differ by {far:.1e} after {CHECK} steps"
            for count in options.threads:
                pairs = in_turns(plain, bondem, bonds, threads=count, repeat=options.repeat, steps=options.steps)
                print(f"{elements:>9}{count:>8}{pairs.line()}  poses {far:.0e} apart", flush=True)


if __name__ == "__main__":
    main()
