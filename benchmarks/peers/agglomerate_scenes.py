"""Scenes of agglomerates of bonded spheres that fall on a floor or tumble in a drum."""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from alike import Alike

import bondem as bd

RADIUS, DENSITY, NU, SHARE = 5e-3, 2500.0, 0.2, 0.6
#: Strength over E: tension of the section of a bond, twice that in shear, bending and twisting [-].
STRENGTH = 8e-3
FRICTION, GRAVITY = 0.5, 9.81
#: Duration of motion before and after the first contact, over RADIUS / speed.
AHEAD, AFTER = 0.2, 4.0
#: Distance of the centres of stacked bodies [m].
APART = 2.3 * RADIUS


def agglomerate(each: int, seed: int = 1) -> bd.Lattice:
    """Return a ball of `each` bonded spheres that do not overlap."""
    packed = bd.pack(bd.Ball(radius=RADIUS), count=each, seed=seed)
    bonds = bd.connect(packed, tolerance=0.01)
    # no overlaps, because LAMMPS has none without force: spheres of broken bonds would push each other apart
    i, j = bonds.pairs.T
    shrunk = min(1.0, float((bonds.length / (packed.radius[i] + packed.radius[j])).min()))
    return bd.Lattice(bd.Particles(packed.position, shrunk * packed.radius), bonds.pairs)


@dataclass(frozen=True, kw_only=True)
class Fall:
    """Scene of bodies that hit a floor at a speed [m/s], stacked as a cube above it."""

    bodies: int = 50
    each: int = 200
    speed: float
    seed: int = 1  # of the packing
    E: float = 1e9
    damping: float = 0.0  # share of the critical damping of a contact [-]
    down: tuple[float, float, float] = (0.0, 0.0, -1.0)

    @property
    def duration(self) -> float:
        """Duration from the start until AFTER the first contact [s]."""
        return (AHEAD + AFTER) * RADIUS / self.speed

    def stacked(self, rock: bd.Lattice) -> bd.Lattice:
        """Return the stacked bodies, with the lowest sphere at z = 0."""
        side = int(np.ceil(self.bodies ** (1.0 / 3.0)))
        k = np.arange(self.bodies)
        places = APART * np.column_stack([k % side, k // side % side, k // side**2])
        all_of = bd.replicate(rock, places, rotations="random", seed=1)
        lowest = float((all_of.particles.position[:, 2] - all_of.particles.radius).min())
        return all_of.moved((0.0, 0.0, -lowest))

    @property
    def walls(self) -> list[bd.PlaneWall]:
        """Walls of the scene: the floor alone."""
        return [bd.PlaneWall((0, 0, -AHEAD * RADIUS), (0, 0, 1))]

    @property
    def gauges(self) -> dict[str, Any]:
        """Gauge of the force on the floor."""
        return {"floor": bd.WallGauge(0, "force")}

    def fixes(self, rough: str, smooth: str) -> str:
        """Return the commands of LAMMPS for the floor, given contact models with and without friction."""
        return f"fix floor all wall/gran {rough} zplane {-AHEAD * RADIUS:.17g} NULL"

    def balance(self, model: bd.Model, start: bd.State, run: bd.ExplicitResult) -> dict[str, float]:
        """Return impulse over gained momentum, and momentum along the floor over that of the fall [-]."""
        gained = model.mass @ (run.state.velocity - start.velocity)
        pushed = -float(np.trapezoid(run.history["floor"][:, 2], run.history.time))
        given = pushed - float(model.mass.sum()) * GRAVITY * run.state.time
        fell = float(model.mass.sum()) * self.speed
        return {"impulse": given / float(gained[2]), "sideways": float(np.abs(gained[:2]).max()) / fell}


@dataclass(frozen=True, kw_only=True)
class Drum:
    """Scene of bodies that fall on the shell of a rotating drum, whose length follows from their number."""

    bodies: int = 1000
    each: int = 60
    seed: int = 1
    speed: float = 1.0
    duration: float = 0.015  # [s]
    radius: float = 15.0 * RADIUS
    E: float = 1e7
    damping: float = 0.2
    down: tuple[float, float, float] = (0.0, -1.0, 0.0)

    @property
    def spin(self) -> float:
        """Angular velocity of the drum, 60 % of that at which bodies would stay on the shell [rad/s]."""
        return 0.6 * math.sqrt(GRAVITY / self.radius)

    @property
    def turn(self) -> float:
        """Duration of a turn of the drum [s]."""
        return 2.0 * math.pi / self.spin

    @property
    def section(self) -> np.ndarray:
        """Positions of bodies in the lower half of the section of the drum [m], (k, 2)."""
        reach = int(self.radius / APART)
        x, y = APART * np.mgrid[-reach : reach + 1, -reach : 1].reshape(2, -1)
        return np.column_stack([x, y])[np.hypot(x, y) < self.radius - 1.05 * RADIUS]

    @property
    def length(self) -> float:
        """Length of the drum between its ends [m]."""
        return APART * math.ceil(self.bodies / len(self.section))

    def stacked(self, rock: bd.Lattice) -> bd.Lattice:
        """Return the stacked bodies, layer by layer along the axis z."""
        where = self.section
        k = np.arange(self.bodies)
        z = APART * (k // len(where) + 0.5) - 0.5 * self.length
        return bd.replicate(rock, np.column_stack([where[k % len(where)], z]), rotations="random", seed=1)

    @property
    def walls(self) -> list[Any]:
        """Walls of the drum: the rotating shell, and two fixed ends without friction."""
        turn = bd.Driven(spin=self.spin, axis=(0, 0, 1))
        ends = [bd.PlaneWall((0, 0, 0.5 * s * self.length), (0, 0, -s), friction=0.0) for s in (-1, 1)]
        return [bd.CylinderWall(self.radius, axis=(0, 0, 1), motion=turn), *ends]

    @property
    def gauges(self) -> dict[str, Any]:
        """Gauges of the displacement of each sphere of a body, averaged over all bodies."""
        alike = (bd.Index(range(k, self.bodies * self.each, self.each)) for k in range(self.each))
        return {str(k): bd.Gauge(spheres, "displacement") for k, spheres in enumerate(alike)}

    def fixes(self, rough: str, smooth: str) -> str:
        """Return the commands of LAMMPS for the drum.

        The shell is a region, because a `zcylinder` adds up its velocity over the spheres.
        """
        half, inside = 0.5 * self.length, f"cylinder z 0 0 {self.radius:.17g} INF INF side in units box"
        return "\n".join((
            f"variable turn equal {self.spin:.17g}*step*dt", f"region shell {inside} rotate v_turn 0 0 0 0 0 1",
            f"fix shell all wall/gran/region {rough} region shell",
            f"fix ends all wall/gran {smooth} zplane {-half:.17g} {half:.17g}",
        ))  # fmt: skip

    def balance(self, model: bd.Model, start: bd.State, run: bd.ExplicitResult) -> dict[str, float]:
        """Return the gain of angular momentum over the moments by drum and weight [-], and the number of turns.

        After a whole turn also the mean torque over that of the weight [-], and the lever of the weight [m]. The
        torque of the drum is its work per angle.
        """
        history, weight = run.history, GRAVITY * float(model.mass.sum())
        share = model.mass[: self.each] / model.mass[: self.each].sum()
        place = sum(share[k] * history[str(k)] for k in range(self.each)) + self.centre(model, start)
        weighed = weight * place[:, 0]
        # angular impulse of the drum on the bodies since the start
        drum = (history.energy["work"] - weight * (place[0, 1] - place[:, 1])) / self.spin
        gained = _spun(model, run.state) - _spun(model, start)
        given = drum[-1] - drum[0] - float(np.trapezoid(weighed, history.time))
        found = {"balance": float(gained / given), "turns": float(history.time[-1]) / self.turn}
        if found["turns"] >= 1.0:
            last = np.flatnonzero(history.time >= history.time[-1] - self.turn)
            pulled = np.trapezoid(weighed[last], history.time[last])
            found["torque"] = float((drum[last[-1]] - drum[last[0]]) / pulled)
            found["lever"] = float(place[last, 0].mean())
        return found

    @staticmethod
    def centre(model: bd.Model, state: bd.State) -> np.ndarray:
        """Return the centre of mass of all bodies [m], (3,)."""
        return model.mass @ state.position / model.mass.sum()


def _spun(model: bd.Model, state: bd.State) -> float:
    """Return the angular momentum about the z axis [N·m·s]."""
    x, v = state.position, state.velocity
    orbit = model.mass * (x[:, 0] * v[:, 1] - x[:, 1] * v[:, 0])
    return float((orbit + model.inertia * state.angular_velocity[:, 2]).sum())


Scene = Fall | Drum


def stiffness(rock: bd.Lattice, E: float) -> dict[str, float]:
    """Return stiffnesses of an Euler–Bernoulli beam of the mean bond length, and its strengths for `LinearSum`."""
    r, length = SHARE * rock.particles.mean_radius, float(rock.length.mean())
    area, second = np.pi * r**2, 0.25 * np.pi * r**4
    tension = STRENGTH * E
    return {
        "kn": E * area / length, "ks": 12.0 * E * second / length**3, "kb": E * second / length,
        "kt": E / (1.0 + NU) * second / length, "radius": r, "force": tension * area, "shear": 2.0 * tension * area,
        "bending": 2.0 * tension * second / r, "twisting": 2.0 * tension * second / r,
    }  # fmt: skip


def model_of(scene: Scene, *, rubs: bool = True) -> tuple[bd.Model, bd.State, dict[str, float]]:
    """Return model and initial state of a scene, and the `stiffness` of its bonds; no friction unless it `rubs`."""
    rock = agglomerate(scene.each, scene.seed)
    bond, radius = stiffness(rock, scene.E), rock.particles.mean_radius
    law = Alike(E=scene.E, nu=NU, **{name: bond[name] for name in ("kn", "ks", "kb", "kt", "radius")})
    failure = bd.LinearSum(**{name: bond[name] for name in ("force", "shear", "bending", "twisting")})
    # kn = E π R² / 2R of two mean spheres
    contact = bd.LinearContact(
        E=2.0 * bond["kn"] / (np.pi * radius), kappa=3.5, friction=FRICTION if rubs else 0.0,
        damping=scene.damping, stress_free=False,
    )  # fmt: skip
    model = bd.Model(
        scene.stacked(rock), law, DENSITY, contact=contact, failure=failure, walls=scene.walls,
        boundary=[bd.Gravity(GRAVITY, scene.down)],
    )  # fmt: skip
    state = model.state()
    state.velocity = tuple(scene.speed * x for x in scene.down)
    return model, state, bond
