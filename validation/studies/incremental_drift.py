"""Where the papers' incremental formulation drifts, beside the total one: turning, spinning, and closed cycles."""

import math
from collections.abc import Iterator
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from scipy.spatial.transform import Rotation

import bondem as bd
from bondem._threads import threads
from bondem.dynamics.explicit import integrate
from bondem.report.style import BLUE, GREEN, GREY, INK, ORANGE, sheet
from validation.frame.record import Record
from validation.measures.printed_rates import Printed

FORMS = ("total", "incremental")
ELASTIC = ("normal", "shear", "bending", "twisting")
TURNS, STRAIN = 10, 2e-3
STEEL, RADIUS = bd.materials.steel, 0.2
AREA, SECOND = math.pi * RADIUS**2, math.pi * RADIUS**4 / 4.0


def law(form: Any, radius: float = RADIUS) -> bd.EulerBernoulli:
    return bd.EulerBernoulli(E=STEEL.E, nu=STEEL.nu, radius=radius, formulation=form)


def rod(count: int = 7) -> bd.Lattice:
    """Touching spheres along x, each bonded to the next."""
    return bd.connect(bd.Particles(np.arange(count)[:, None] * np.array([2.0 * RADIUS, 0.0, 0.0]), RADIUS))


def block() -> bd.Lattice:
    """A bar of 6 × 2 × 2 spheres with bonds along edges and across faces."""
    grid = np.stack(np.meshgrid(range(6), range(2), range(2), indexing="ij"), axis=-1).reshape(-1, 3)
    return bd.connect(bd.Particles(2.0 * RADIUS * grid, RADIUS), reach=1.45)


BODIES = {"rod": (rod, RADIUS), "lattice": (block, 0.5 * RADIUS)}


def loaded(lattice: bd.Lattice, radius: float, strain: float) -> tuple[np.ndarray, np.ndarray]:
    """Displacements [m] and rotations [rad] of a body stretched, bent and twisted by about `strain` each."""
    x = lattice.particles.position[:, 0]
    ends = bd.Index(np.flatnonzero(x == x.min())), bd.Index(np.flatnonzero(x == x.max()))
    tension, couple = strain * STEEL.E * AREA, strain * STEEL.E * SECOND / RADIUS
    pull = bd.Load(ends[1], force=(tension, 0.0, 0.0), moment=(couple, couple, couple))
    static = bd.solve_static(bd.Model(lattice, law("total", radius), STEEL.rho, boundary=[bd.Fix(ends[0]), pull]))
    return static.displacement, static.rotation


class Puppet:
    """A body all elements of which are driven, so that its forces depend on the path alone, not on inertia."""

    def __init__(self, lattice: bd.Lattice, bond: bd.BondLaw) -> None:
        self.lattice, self.bond = lattice, bond
        self.place = lattice.particles.position.copy()
        self.state: bd.State | None = None
        self.gauges = {"end": bd.Gauge(bd.Index(far_end(lattice)), "force", "sum")}

    def go(self, path: np.ndarray, rate: np.ndarray, dt: float) -> tuple[float, np.ndarray]:
        """Along positions (k + 1, n, 3) [m], one a step, at angular velocities (n, 3) [rad/s]; energy, end force."""
        steps = len(path) - 1
        times = tuple((dt * np.arange(steps + 1)).tolist())
        drives = []
        for k, (positions, spin) in enumerate(zip((path - path[0]).transpose(1, 2, 0), rate, strict=True)):
            x, y, z = (bd.Table(times, tuple(component.tolist())) for component in positions)
            drives.append(bd.Drive(bd.Index([k]), x=x, y=y, z=z, **dict(zip(("wx", "wy", "wz"), spin, strict=True))))
        model = bd.Model(self.lattice, self.bond, STEEL.rho, boundary=drives)
        if self.state is not None:
            self.state.begin(model)
            self.state.time = 0.0
        plan = bd.Plan(duration=steps * dt, dt=dt, every=steps, gauges=self.gauges)
        run = integrate(model, plan, state=self.state)
        self.state, self.place = run.state, path[-1]
        energy = run.history.energy
        return float(sum(energy[name][-1] for name in ELASTIC)), run.history["end"][-1]


def far_end(lattice: bd.Lattice) -> np.ndarray:
    """Elements at the right end."""
    x = lattice.particles.position[:, 0]
    return np.flatnonzero(x > x.max() - 1e-9)


def deform(body: Puppet | Printed, displacement: np.ndarray, rotation: np.ndarray, steps: int):
    """In proportion, in a time of one second; energy and end force."""
    share = np.linspace(0.0, 1.0, steps + 1)[:, None, None]
    return body.go(body.place + share * displacement, rotation, 1.0 / steps)


def turn(body: Puppet | Printed, steps: int, chunk: int = 128) -> Iterator[tuple[float, np.ndarray]]:
    """Turn after turn about z, of one second each, in `steps` steps; energy and end force after each."""
    start, step = body.place.copy(), 2.0 * math.pi / steps
    across = np.cross([0.0, 0.0, 1.0], start)
    rate = np.tile([0.0, 0.0, 2.0 * math.pi], (len(start), 1))
    for _ in range(TURNS):
        energy, force = 0.0, np.zeros(3)
        for first in range(0, steps, chunk):
            angle = step * np.arange(first, min(first + chunk, steps) + 1)[:, None, None]
            path = np.cos(angle) * start + np.sin(angle) * across + (1.0 - np.cos(angle)) * start * [0.0, 0.0, 1.0]
            energy, force = body.go(path, rate, 1.0 / steps)
        yield energy, force


def turning(steps_a_turn: tuple[int, ...]) -> list[dict]:
    """End force after every turn, against that before the first."""
    rows = []
    for name, (make, radius) in BODIES.items():
        lattice = make()
        shape = loaded(lattice, radius, STRAIN)
        for form in (*FORMS, "as printed"):
            for steps in steps_a_turn:
                bond = law("total" if form == "as printed" else form, radius)
                body = Printed(lattice, bond, far_end(lattice)) if form == "as printed" else Puppet(lattice, bond)
                force = deform(body, *shape, 1000)[1]
                after = [end for _, end in turn(body, steps)]
                strain = 2.0 * math.pi**2 * TURNS / steps
                rows.append(
                    {"body": name, "form": form, "steps_a_turn": steps,
                     "force_error": [float(np.linalg.norm(f - force) / np.linalg.norm(force)) for f in after],
                     "expected_as_printed": strain * STEEL.E * AREA / float(np.linalg.norm(force))}
                )  # fmt: skip
    return rows


def momentum(model: bd.Model, state: bd.State) -> np.ndarray:
    """Angular momentum about the origin [kg·m²/s]."""
    own = model.inertia[:, None] * state.angular_velocity
    return (np.cross(state.position, model.mass[:, None] * state.velocity) + own).sum(axis=0)


def spinning(shares: tuple[float, ...]) -> list[dict]:
    """Free bodies that spin about z and vibrate: ten turns at several shares of the critical step."""
    rows = []
    for body, (make, radius) in BODIES.items():
        lattice = make()
        centre = lattice.particles.position.mean(axis=0)
        u, turned = loaded(lattice, radius, STRAIN)
        half = 0.5 * np.ptp(lattice.particles.position[:, 0])
        spin = 0.003 * math.sqrt(STEEL.E / STEEL.rho) / half  # tips at 0.3 % of the speed of sound
        about = np.array([0.0, 0.0, spin])
        shake = 0.2 * spin
        for form in FORMS:
            model = bd.Model(lattice, law(form, radius), STEEL.rho)
            for share in shares:
                state = bd.State(model)
                state.set_motion(
                    velocity=np.cross(about, lattice.particles.position - centre) + shake * (u - u.mean(axis=0)),
                    angular_velocity=about + shake * (turned - turned.mean(axis=0)),
                )
                before = momentum(model, state)
                turn = float(2.0 * math.pi / spin)
                settled = bd.solve_explicit(model, duration=0.0, safety=share, every=0)
                every = max(1, round(turn / settled.dt / 40))
                run = bd.solve_explicit(model, duration=TURNS * turn, dt=settled.dt, every=every, state=state)
                ledger = run.history.energy
                total: Any = sum(ledger[name] for name in ("translation", "rotation", *ELASTIC))
                rows.append(
                    {"body": body, "form": form, "share_of_critical": share, "steps_a_turn": float(turn / run.dt),
                     "largest_energy_error": float(np.abs(total / total[0] - 1.0).max()),
                     "momentum_error": float(
                         np.linalg.norm(momentum(model, run.state) - before) / np.linalg.norm(before)
                     )}
                )  # fmt: skip
    return rows


def small_rotations(strains: tuple[float, ...], steps: int = 20_000) -> list[dict]:
    """Stretched, bent and twisted in proportion: end forces of both forms."""
    rows = []
    lattice = rod()
    u, turned = loaded(lattice, RADIUS, 1.0)
    for strain in strains:
        force, other = (
            deform(Puppet(lattice, law(form)), strain * u, strain * turned, steps)[1] for form in FORMS
        )
        rows.append(
            {"strain": strain, "force_difference": float(np.linalg.norm(other - force) / np.linalg.norm(force))}
        )
    return rows


def cycled(form: str, angle: float, cycles: int, steps: int) -> tuple[float, list[float]]:
    """Bend about y, twist, unbend, untwist: energy at the widest, and at the end of every cycle [J].

    Element k of the n of a rod is turned by R = Ry(β k/n) Rx(τ k/n), and lies where the mean of R and that of the
    element before, times the bond, says; (β, τ) goes round a square of side `angle`.
    """
    lattice = rod()
    puppet = Puppet(lattice, law(form))
    n = len(lattice.particles)
    share = np.linspace(0.0, 1.0, n)
    y, x = np.array([0.0, 1.0, 0.0]), np.array([1.0, 0.0, 0.0])

    def places(bend: float) -> np.ndarray:
        along = Rotation.from_rotvec(np.outer(bend * share, y)).apply(x)
        hops = RADIUS * (along[1:] + along[:-1])
        return np.concatenate([np.zeros((1, 3)), np.cumsum(hops, axis=0)])

    bent = Rotation.from_rotvec(np.outer(angle * share, y))
    up = np.stack([places(bend) for bend in np.linspace(0.0, angle, steps + 1)])
    straight, full = np.repeat(up[:1], steps + 1, axis=0), np.repeat(up[-1:], steps + 1, axis=0)
    turns = share[:, None] * angle
    legs = ((up, turns * y), (full, turns * bent.apply(x)), (up[::-1], -turns * y), (straight, -turns * x))
    widest, ends = 0.0, []
    for _ in range(cycles):
        energies = [puppet.go(path, rate, 1.0 / steps)[0] for path, rate in legs]
        widest = max(widest, energies[1])
        ends.append(energies[-1])
    return widest, ends


def cycles(angles: tuple[float, ...]) -> list[dict]:
    """What is left of the force after one closed cycle, and its growth over ten."""
    rows: list[dict] = []
    for form in FORMS:
        for angle in angles:
            for steps in (500, 2000, 8000):
                widest, ends = cycled(form, angle, 1, steps)
                rows.append(
                    {"form": form, "angle": angle, "steps_a_leg": steps, "cycles": 1,
                     "left": math.sqrt(abs(ends[-1]) / widest)}
                )  # fmt: skip
        widest, ends = cycled(form, angles[-1], TURNS, 2000)
        rows.append(
            {"form": form, "angle": angles[-1], "steps_a_leg": 2000, "cycles": TURNS,
             "left": [math.sqrt(abs(e) / widest) for e in ends]}
        )  # fmt: skip
    return rows


def order(x: list[float], y: list[float]) -> float:
    """Slope of log y against log x."""
    return float(np.polyfit(np.log(x), np.log(y), 1)[0])


def orders(result: dict) -> dict:
    """Orders in the time step, and in the angle, that the runs show."""
    found = {}
    for body, form in product(BODIES, ("incremental", "as printed")):
        rows = [r for r in result["turning"] if r["body"] == body and r["form"] == form][-3:]
        error = [r["force_error"][-1] for r in rows]
        found[f"turning, {body}, {form}: order in dt"] = -order([r["steps_a_turn"] for r in rows], error)
    rows = [r for r in result["cycles"] if r["form"] == "incremental" and r["cycles"] == 1]
    finest = [r for r in rows if r["steps_a_leg"] == max(r["steps_a_leg"] for r in rows)]
    found["cycles: order of what is left in the angle"] = order(
        [r["angle"] for r in finest], [r["left"] for r in finest]
    )
    return found


def named_ticks(ax: Axes, values: list) -> None:
    """Less than two decades: ticks at the values themselves."""
    ax.set_xticks(values, [f"{value:g}" for value in values])
    ax.set_xticks([], minor=True)


LOOK = {"total": (GREEN, "o"), "incremental": (BLUE, "s"), "as printed": (ORANGE, "^")}
LINES = {"rod": "-", "lattice": ":"}


def draw_turns(result: dict, path: Path) -> None:
    names = {"total": "total", "incremental": "incremental", "as printed": "incremental, as printed"}
    finest = max(r["steps_a_turn"] for r in result["turning"])
    with sheet(path, 8.6, 3.5, 1, 2) as (_, (turns, steps)):
        for form, (colour, mark) in LOOK.items():
            for body, line in LINES.items():
                rows = [r for r in result["turning"] if r["body"] == body and r["form"] == form]
                chosen = next(r for r in rows if r["steps_a_turn"] == finest)
                look = {"color": colour, "mfc": "none", "lw": 1.0, "ms": 4.5}
                label = names[form] if body == "rod" else None
                turns.semilogy(range(1, TURNS + 1), chosen["force_error"], mark + line, label=label, **look)
                errors = [r["force_error"][-1] for r in rows]
                steps.loglog([r["steps_a_turn"] for r in rows], errors, mark + line, **look)
        expected = [r for r in result["turning"] if r["body"] == "rod" and r["form"] == "as printed"]
        steps.loglog([r["steps_a_turn"] for r in expected], [r["expected_as_printed"] for r in expected], "--",
                     color=INK, lw=1.0, label="EA · 2π²N/S over the end force")  # fmt: skip
        turns.set(xlabel="turns [-]", ylabel="error of the end force [-]")
        turns.set_title(f"Held and turned, {finest} steps a turn")
        turns.legend()
        steps.set(xlabel="steps a turn, S [-]", ylabel="error of the end force [-]", title="After ten turns")
        named_ticks(steps, sorted({r["steps_a_turn"] for r in result["turning"]}))
        for body, line in LINES.items():
            steps.plot([], [], line, color=GREY, lw=1.0, label=body)
        steps.legend()


def draw_spin_and_cycle(result: dict, path: Path) -> None:
    with sheet(path, 8.6, 3.5, 1, 2) as (_, (spin, cycle)):
        for form in FORMS:
            colour, mark = LOOK[form]
            for body, line in LINES.items():
                rows = [r for r in result["spinning"] if r["body"] == body and r["form"] == form]
                spin.loglog([r["steps_a_turn"] for r in rows], [r["largest_energy_error"] for r in rows], mark + line,
                            color=colour, mfc="none", lw=1.0, ms=4.5 if form == "total" else 7.5,
                            label=f"{form}, {body}")  # fmt: skip
            rows = [r for r in result["cycles"] if r["form"] == form and r["cycles"] == 1]
            for size, count in zip((8.0, 5.5, 3.0), sorted({r["steps_a_leg"] for r in rows}), strict=True):
                some = [r for r in rows if r["steps_a_leg"] == count]
                cycle.loglog([r["angle"] for r in some], [r["left"] for r in some], mark + "-", color=colour,
                             mfc="none", lw=0.8, ms=size, label=f"{form}, {count} steps a leg")  # fmt: skip
        spin.set(xlabel="steps a turn, S [-]", ylabel="error of the energy [-]", title="Spinning freely, ten turns")
        named_ticks(spin, [5000, 10_000, 20_000, 50_000])
        spin.legend(fontsize=8)
        cycle.set(xlabel="bend and twist [rad]", ylabel="force left over its peak [-]")
        named_ticks(cycle, sorted({r["angle"] for r in result["cycles"]}))
        cycle.set_title("Bent, twisted, unbent, untwisted")
        cycle.legend(fontsize=7.5, loc="center right")


def measure(record: Record) -> None:
    """Measure both formulations."""
    with threads(1):
        result: dict = {"turning": turning((512, 2048, 8192))}
        result["spinning"] = spinning((0.8, 0.4, 0.2))
        result["small_rotations"] = small_rotations((1e-5, 1e-4, 1e-3, 1e-2), 5000)
        result["cycles"] = cycles((0.05, 0.1, 0.2, 0.4))
    result["orders"] = orders(result)
    record.keep(**result)


def draw(record: Record, folder: Path) -> None:
    """Turns, and spins beside cycles."""
    draw_turns(record.data, folder / "incremental_drift.png")
    draw_spin_and_cycle(record.data, folder / "incremental_drift_cycles.png")
