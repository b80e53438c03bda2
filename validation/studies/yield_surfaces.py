"""The surfaces of Rankine and of Mohr and Coulomb as bonds of the non-local law are judged (figure 9 of the paper).

Many pairs of spheres far apart from each other, each with a bond. The two elements of a pair get stresses whose mean
is the one that is looked at, by principal values and in a random direction, and that differ from it at random by up
to 5 MPa; `bd.failure_index` says whether the bond breaks. Along rays from the hydrostatic axis, at pressures that
both criteria bear, the stress at which it does is found by bisection: no formula of a criterion enters.

Criteria as in Celigueta et al. (2020): σ_R = 6 MPa; c = 14.5 MPa, φ = 60°, tension = c / tan φ.
"""

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

import bondem as bd
from bondem.report.style import BLUE, GREY, ORANGE, sheet
from validation.frame.record import Record

ANGLE, COHESION, TENSION = math.radians(60.0), 14.5e6, 6e6
CRITERIA: dict[str, bd.Criterion] = {
    "Rankine": bd.Rankine(tension=TENSION),
    "Mohr-Coulomb": bd.MohrCoulomb(tension=COHESION / math.tan(ANGLE), cohesion=COHESION, friction_angle=ANGLE),
}
#: Stresses between which bisection looks [Pa], and its steps.
FARTHEST, HALVINGS = 600e6, 50
#: What the stresses of the two ends of a bond differ from their mean [Pa].
APART = 5e6
#: Hydrostatic stresses of the rays, √3 times the mean [Pa]; rays about the axis.
LEVELS, TURNS = np.linspace(-80e6, 20e6, 81), 181
Rays = tuple[np.ndarray, np.ndarray]


def judged(criterion: bd.Criterion, count: int, seed: int = 1) -> Callable[[np.ndarray], np.ndarray]:
    """A function that says how near to breaking bonds are by principal stresses (count, 3) [Pa]."""
    place = np.zeros((2 * count, 3))
    place[:, 0] = np.repeat(10.0 * np.arange(count), 2)
    place[1::2, 1] = 2.0
    pairs = bd.Lattice(
        bd.Particles(position=1e-3 * place, radius=np.full(2 * count, 1e-3)),
        np.arange(2 * count).reshape(count, 2),
    )
    model = bd.Model(pairs, bd.NonLocal(E=40e9, nu=0.2, areas="weighted", lever="contact"), 2400.0, failure=criterion)
    state, rng = model.state(), np.random.default_rng(seed)
    turn = Rotation.random(count, rng=rng).as_matrix()
    apart = rng.uniform(-APART, APART, (count, 6))

    def index(principal: np.ndarray) -> np.ndarray:
        full = np.einsum("kab,kb,kcb->kac", turn, principal, turn)
        mean = full[:, [0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]]
        state.stress[:] = np.stack([mean + apart, mean - apart], axis=1).reshape(-1, 6)[model.layout.order]
        return bd.failure_index(model, state)

    return index


def reached(criterion: bd.Criterion, rays: Rays) -> np.ndarray:
    """How far from its start along each ray a bond breaks [Pa]; NaN where it does at the start, or nowhere."""
    start, along = rays
    index = judged(criterion, len(start))
    low, high = np.zeros(len(start)), np.full(len(start), FARTHEST)
    inside = index(start) < 1.0
    found = inside & (index(start + high[:, None] * along) >= 1.0)
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        broken = index(start + middle[:, None] * along) >= 1.0
        low, high = np.where(broken, low, middle), np.where(broken, middle, high)
    return np.where(found, high, np.nan)


def about_the_axis() -> Rays:
    """Rays from the hydrostatic axis across it, all levels by all turns."""
    axis = np.ones(3) / math.sqrt(3.0)
    first, second = np.array([2.0, -1.0, -1.0]) / math.sqrt(6.0), np.array([0.0, 1.0, -1.0]) / math.sqrt(2.0)
    turn = np.linspace(0.0, 2.0 * math.pi, TURNS)
    across = np.cos(turn)[:, None] * first + np.sin(turn)[:, None] * second
    start = np.repeat(LEVELS[:, None] * axis, TURNS, axis=0)
    return start, np.tile(across, (len(LEVELS), 1))


def in_the_plane() -> Rays:
    """Rays from no stress in the plane σ3 = 0."""
    turn = np.linspace(0.0, 2.0 * math.pi, 721)
    return np.zeros((len(turn), 3)), np.column_stack([np.cos(turn), np.sin(turn), np.zeros(len(turn))])


#: From no stress: towards tension, compression, tension from all sides, shear.
SIMPLE = {"tension": (1, 0, 0), "compression": (-1, 0, 0), "all sides": (1, 1, 1), "shear": (1, -1, 0)}


def strengths(name: str) -> dict[str, float | None]:
    """Of simple states [Pa]; None where there is none."""
    along = np.array(list(SIMPLE.values()), dtype=float)
    found = reached(CRITERIA[name], (np.zeros((len(along), 3)), along))
    return {state: None if math.isnan(one) else float(one) for state, one in zip(SIMPLE, found, strict=True)}


def closed(name: str) -> dict[str, float | None]:
    """The same by eqs (8) and (9) [Pa]."""
    if name == "Rankine":
        return {"tension": TENSION, "compression": None, "all sides": TENSION, "shear": TENSION}
    sine, twice = math.sin(ANGLE), 2.0 * COHESION * math.cos(ANGLE)
    return {"tension": twice / (1.0 + sine), "compression": twice / (1.0 - sine),
            "all sides": COHESION / math.tan(ANGLE), "shear": 0.5 * twice}  # fmt: skip


def draw_surfaces(path: Path) -> None:
    """Both surfaces in the space of principal stresses, and both in the plane σ3 = 0."""
    start, along = about_the_axis()
    with sheet(path, 12.4, 4.2, columns=0) as (figure, _):
        for n, (name, criterion) in enumerate(CRITERIA.items()):
            far = reached(criterion, (start, along))
            shape = len(LEVELS), TURNS
            place = 1e-6 * (start + np.nan_to_num(far)[:, None] * along)
            place[np.isnan(far)] = np.nan
            x, y, z = (place[:, a].reshape(shape) for a in range(3))
            ax: Any = figure.add_subplot(1, 3, n + 1, projection="3d")
            ax.plot_surface(x, y, z, color=(ORANGE, BLUE)[n], alpha=0.75, linewidth=0.1, edgecolor=GREY, rcount=41,
                            ccount=91)  # fmt: skip
            ends = 1e-6 * np.array([LEVELS[0], LEVELS[-1]]) / math.sqrt(3.0)
            ax.plot(ends, ends, ends, color="black", linestyle="--", linewidth=0.8)
            ax.set(xlabel="σ1 [MPa]", ylabel="σ2 [MPa]", zlabel="σ3 [MPa]", title=name)
            for one in (ax.xaxis, ax.yaxis, ax.zaxis):
                one.set_ticks([-150, -100, -50, 0])
            ax.view_init(elev=22, azim=35)
        ax = figure.add_subplot(1, 3, 3)
        for name, criterion in CRITERIA.items():
            rays = in_the_plane()
            far = 1e-6 * reached(criterion, rays)
            ax.plot(far * rays[1][:, 0], far * rays[1][:, 1], color=(ORANGE, BLUE)[name != "Rankine"], label=name)
        ax.axhline(0.0, color=GREY, linewidth=0.6)
        ax.axvline(0.0, color=GREY, linewidth=0.6)
        ax.set(xlabel="σ1 [MPa]", ylabel="σ2 [MPa]", title="σ3 = 0", xlim=(-120, 20), ylim=(-120, 20), aspect="equal")
        ax.legend(frameon=False, loc="center")


def measure(record: Record) -> None:
    """Find the strengths of both criteria."""
    cases = [
        {"criterion": name, "state": state, "found": found, "closed": closed(name)[state]}
        for name in CRITERIA for state, found in strengths(name).items()
    ]  # fmt: skip
    record.keep(cases=cases)
    for one in cases:
        print(one)


def draw(_: Record, folder: Path) -> None:
    """The surfaces, found anew."""
    draw_surfaces(folder / "celigueta_surfaces.png")
