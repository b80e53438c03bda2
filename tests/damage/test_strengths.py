"""Two spheres and a beam between them break where closed forms say, in static poses and in explicit runs.

In a plane, with ℓ and γ the length and direction of the branch, elements turned by α_i and α_j about z, and j by ψ
about its own axis before that, p = γ - α_i and q = γ - α_j, the energy of a beam is

    U = ½ kn (ℓ - L)² + ½ A sin²p + B sin p sin q + ½ C sin²q + 2 kt (1 - cos²((α_j - α_i)/2) cos²(ψ/2))

and what it bears are its derivatives: N by ℓ, Q by γ over ℓ, the moments about z by α_i and α_j. Twisting adds the
torque 2 kt w v, with w and v scalar and vector of q_j q_i*, and v·x, v·y, v·z = sin(ψ/2) cos μ, sin(ψ/2) sin μ,
cos(ψ/2) sin((α_j - α_i)/2), where μ = (α_i + α_j)/2.
"""

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.spatial.transform import Rotation

import bondem as bd
from tests.models import time_step
from tests.recording import Record
from tests.specimens import two_spheres

R, L, RADIUS = 0.5e-3, 1.0e-3, 0.35e-3
E, NU = 1e9, 0.3
AREA, I = math.pi * RADIUS**2, math.pi * RADIUS**4 / 4.0
KN, KS, KB = E * AREA / L, 12.0 * E * I / L**3, E * I / L
KT = E / (2.0 * (1.0 + NU)) * 2.0 * I / L
LAW = bd.EulerBernoulli(E=E, nu=NU, radius=RADIUS)
A = C = KS * L**2 / 4.0 + KB - KT
B = KS * L**2 / 4.0 - KB + KT


class Pose(NamedTuple):
    """Of the second sphere relative to the first: x and y over L, and the angles of the module's text [rad]."""

    x: float = 0.0  #: beyond L
    y: float = 0.0
    first: float = 0.0  #: α_i
    second: float = 0.0  #: α_j
    twist: float = 0.0  #: ψ

    def times(self, share: float) -> "Pose":
        return Pose(*(share * one for one in self))

    @property
    def place(self) -> tuple[float, float, float]:
        return L * (1.0 + self.x), L * self.y, 0.0


class Bears(NamedTuple):
    """What the beam bears in a pose, by the closed form."""

    N: float
    Q: float
    M: float
    T: float
    strain: float
    angle: float
    energy: float


def borne(pose: Pose) -> Bears:
    x, y, _ = pose.place
    l, gamma = math.hypot(x, y), math.atan2(y, x)
    p, q = gamma - pose.first, gamma - pose.second
    apart, mean, half = pose.second - pose.first, 0.5 * (pose.first + pose.second), 0.5 * pose.twist
    w = math.cos(0.5 * apart) * math.cos(half)
    spun = KT * math.cos(half) ** 2 * math.sin(apart)
    across = 2.0 * KT * w * math.sin(half) * math.sin(mean - gamma)
    M_i = math.hypot(0.5 * A * math.sin(2 * p) + B * math.cos(p) * math.sin(q) + spun, across)
    M_j = math.hypot(0.5 * C * math.sin(2 * q) + B * math.sin(p) * math.cos(q) - spun, across)
    sideways = 0.5 * A * math.sin(2 * p) + B * math.sin(p + q) + 0.5 * C * math.sin(2 * q)
    energy = 0.5 * KN * (l - L) ** 2 + 0.5 * A * math.sin(p) ** 2 + B * math.sin(p) * math.sin(q)
    return Bears(
        N=KN * (l - L), Q=abs(sideways) / l, M=max(M_i, M_j),
        T=abs(2.0 * KT * w * math.sin(half) * math.cos(mean - gamma)),
        strain=l / L - 1.0, angle=max(abs(p), abs(q)),
        energy=energy + 0.5 * C * math.sin(q) ** 2 + 2.0 * KT * (1.0 - w**2),
    )  # fmt: skip


# Criteria with strengths of the same order, and their indices by the part of the closed form that breaks.
Shares = Callable[[Bears], tuple[float, dict[str, float]]]


def peripheral(b: Bears) -> tuple[float, dict[str, float]]:
    fibre, section = b.N / AREA + 0.5 * b.M * RADIUS / I, b.Q / AREA + b.T * RADIUS / (2.0 * I)
    parts = {"tension": fibre / 4e6, "shear": section / 3e6}
    return max(parts.values()), parts


def coulomb(b: Bears) -> tuple[float, dict[str, float]]:
    parts = {"tension": b.N / AREA / 4e6, "shear": (b.Q / AREA + b.N / AREA * math.tan(0.6)) / 3e6}
    return max(parts.values()), parts


def linear(b: Bears) -> tuple[float, dict[str, float]]:
    parts = {"tension": b.N / 1.5, "shear": b.Q / 0.9, "bending": b.M / 0.5e-3, "twisting": b.T / 0.4e-3}
    return sum(parts.values()), parts


def elliptic(b: Bears) -> tuple[float, dict[str, float]]:
    parts = {"tension": (max(b.strain, 0.0) / 0.01) ** 2, "bending": b.angle / 0.02}
    return sum(parts.values()), parts


CRITERIA: dict[str, tuple[bd.Criterion, Shares]] = {
    "peripheral": (bd.PeripheralStress(tension=4e6, shear=3e6, beta=0.5), peripheral),
    "Mohr-Coulomb": (bd.MohrCoulomb(tension=4e6, cohesion=3e6, friction_angle=0.6), coulomb),
    "linear": (bd.LinearSum(force=1.5, shear=0.9, bending=0.5e-3, twisting=0.4e-3), linear),
    "elliptic": (bd.Elliptic(elongation=0.01, rotation=0.02), elliptic),
}
# Ways to load the pair, each up to far beyond its strength; the first of these an explicit run can drive.
DRIVEN = {
    "tension": Pose(x=0.05),
    "shear": Pose(y=0.15),
    "bending": Pose(second=0.15),
    "torsion": Pose(twist=0.15),
    "tension and shear": Pose(x=0.02, y=0.1),
    "tension and torsion": Pose(x=0.015, twist=0.15),
    "shear and bending": Pose(y=0.03, second=-0.1),
    "tension, shear and bending": Pose(x=0.01, y=0.04, second=0.12),
    "pressure and shear": Pose(x=-0.01, y=0.15),
    "pressure": Pose(x=-0.1),
}
WAYS = DRIVEN | {
    "bending alike": Pose(first=-0.1, second=0.1),
    "all at once": Pose(x=0.012, y=0.05, first=-0.03, second=0.07, twist=0.06),
    "pressure and all": Pose(x=-0.008, y=-0.06, first=0.05, second=-0.05, twist=0.1),
}
# What cannot break: moments alone do not count for tractions, a kept length and straight ends not for the ellipse.
UNBROKEN = {
    ("Mohr-Coulomb", "torsion"), ("Mohr-Coulomb", "bending alike"), ("elliptic", "torsion"),
    ("peripheral", "pressure"), ("Mohr-Coulomb", "pressure"), ("linear", "pressure"), ("elliptic", "pressure"),
}  # fmt: skip


WHOLE = Rotation.from_rotvec([0.5, -0.9, 0.4])


def pair(failure: bd.Criterion, boundary=(), swapped: bool = False) -> bd.Model:
    """Two touching spheres along x."""
    return bd.Model(two_spheres(L, swapped=swapped), LAW, density=1000.0, failure=failure, boundary=boundary)


def turned(z: float, x: float = 0.0) -> np.ndarray:
    """By x about x, then by z about z."""
    c, s, d, t = math.cos(0.5 * z), math.sin(0.5 * z), math.cos(0.5 * x), math.sin(0.5 * x)
    return np.array([c * d, c * t, s * t, s * d])


def index(model: bd.Model, pose: Pose, whole: Rotation | None = None) -> float:
    """What the judging function says, of the pair turned as a whole."""
    whole = Rotation.identity() if whole is None else whole
    state = model.state()
    own = Rotation.from_quat([turned(pose.first), turned(pose.second, pose.twist)], scalar_first=True)
    orientation = (whole * own).as_quat(scalar_first=True)
    state.set_pose(position=whole.apply([[0.0, 0.0, 0.0], pose.place]), orientation=orientation)
    return float(bd.failure_index(model, state)[0])


def strength(criterion: str, way: str) -> float:
    """Share of a way at which the closed form reaches 1."""
    _, shares = CRITERIA[criterion]
    return float(brentq(lambda share: shares(borne(WAYS[way].times(share)))[0] - 1.0, 0.0, 1.0, xtol=1e-15))


@pytest.mark.parametrize("swapped", [False, True])
@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("criterion", CRITERIA)
def test_a_pair_is_as_strong_as_the_closed_form(criterion: str, way: str, swapped: bool, record: Record) -> None:
    failure, shares = CRITERIA[criterion]
    model = pair(failure, swapped=swapped)
    if (criterion, way) in UNBROKEN:
        assert shares(borne(WAYS[way]))[0] < 1e-12
        assert index(model, WAYS[way]) < 1e-12
        return
    at = strength(criterion, way)
    assert 0.01 < at < 0.99
    assert index(model, WAYS[way].times(at)) == pytest.approx(1.0, rel=1e-9)
    # and anywhere else on the way, however the pair is turned
    for share in (0.5 * at, 1.0):
        expected = shares(borne(WAYS[way].times(share)))[0]
        for whole in (None, WHOLE):
            assert index(model, WAYS[way].times(share), whole) == pytest.approx(expected, rel=1e-9)
    record("closed form", True)


def test_strengths_in_numbers() -> None:
    """The simplest of the closed forms, written out: f L / E and the like."""
    assert strength("peripheral", "tension") * 0.05 == pytest.approx(4e6 / E, rel=1e-9)
    assert strength("linear", "tension") * 0.05 == pytest.approx(1.5 / (E * AREA), rel=1e-9)
    assert strength("elliptic", "tension") * 0.05 == pytest.approx(0.01, rel=1e-9)
    cut_off = 3e6 / math.tan(0.6) / E  # beyond c / tan φ = 4.385 MPa; the tensile strength is below
    assert strength("Mohr-Coulomb", "tension") * 0.05 == pytest.approx(4e6 / E, rel=1e-9)
    assert cut_off > 4e6 / E
    twist = math.asin(3e6 * 2.0 * I / RADIUS / KT)
    assert strength("peripheral", "torsion") * 0.15 == pytest.approx(twist, rel=1e-9)
    assert strength("linear", "bending alike") * 0.2 == pytest.approx(math.asin(0.5e-3 / KB), rel=1e-9)
    assert strength("elliptic", "bending alike") * 0.1 == pytest.approx(0.02, rel=1e-9)


STEPS = 400


@pytest.mark.parametrize("way", DRIVEN)
@pytest.mark.parametrize("criterion", CRITERIA)
def test_a_pair_breaks_within_one_increment(criterion: str, way: str, one_thread: None, record: Record) -> None:
    """Driven at constant rates, in the first step that ends beyond its strength, in the mode of the closed form."""
    failure, shares = CRITERIA[criterion]
    dt = time_step(pair(failure), 0.5)
    broken = (criterion, way) not in UNBROKEN
    end = WAYS[way].times(1.2345 * strength(criterion, way) if broken else 1.0)
    rates = {"vx": L * end.x, "vy": L * end.y, "vz": 0.0, "wx": end.twist, "wy": 0.0, "wz": end.second}
    drive = bd.Drive(bd.Index([1]), **{name: rate / (STEPS * dt) for name, rate in rates.items()})
    model = pair(failure, [bd.Fix(bd.Index([0])), drive])
    run = bd.solve_explicit(model, duration=STEPS * dt, dt=dt, every=1)
    assert len(run.events) == broken
    if not broken:
        return
    step = math.ceil(STEPS / 1.2345)
    assert run.events.step[0] == step
    assert run.events.time[0] == pytest.approx(step * dt, rel=1e-12)
    at = end.times(step / STEPS)
    bears, (_, parts) = borne(at), shares(borne(at))
    first, second = sorted(parts.values())[-1:-3:-1]
    assert first > 1.01 * second  # else rounding would say which
    assert run.events.mode[0] == max(parts, key=parts.__getitem__)
    assert run.events.energy[0] == pytest.approx(bears.energy, rel=1e-9)
    assert run.events.gap[0] == pytest.approx(L * bears.strain, rel=1e-9, abs=1e-15 * L)
    np.testing.assert_allclose(run.events.position[0], 0.5 * np.array(at.place), rtol=1e-9, atol=1e-15)
    assert run.state.bond_integrity[0] == 0.0
    stored = sum(run.history.energy[part] for part in ("normal", "shear", "bending", "twisting"))
    assert stored[step] == 0.0
    before = borne(end.times((step - 1) / STEPS)).energy
    assert stored[step - 1] == pytest.approx(before, rel=1e-9)
    assert run.history.energy["fracture"][-1] == run.events.energy[0]
    # work is a trapezoid in steps, of forces that are not quite linear on the way
    assert run.residual < 1e-5
    record("within one increment", True)


@pytest.mark.parametrize("swapped", [False, True])
def test_contact_bonds_of_unequal_spheres_are_judged_where_they_touch(swapped: bool) -> None:
    """Shear has no moment there, where a beam has the largest at its ends; bending has one moment everywhere."""
    law, near, far = bd.ParallelBond(E=E, nu=NU, radius=RADIUS), 0.3e-3, 0.7e-3
    particles = bd.Particles(np.array([[0.0, 0.0, 0.0], [L, 0.0, 0.0]]), np.array([near, far]))
    lattice = bd.Lattice(particles, np.array([[1, 0] if swapped else [0, 1]]))
    failure = bd.PeripheralStress(tension=2e6, shear=1e30)
    model = bd.Model(lattice, law, density=1000.0, failure=failure)
    turn = 0.02
    slipped = Pose(x=math.cos(turn) - 1.0, y=math.sin(turn))
    assert index(model, slipped) == pytest.approx(0.0, abs=1e-12)
    # the moment where they touch: that at the first end less what the shear force has done on the way
    ks, kb, kt = (float(getattr(model.stiffness, name)[0]) for name in ("ks", "kb", "kt"))
    p, q, rest = 0.5 * turn, -1.5 * turn, kb - kt
    A, B, C = ks * near**2 + rest, ks * near * far - rest, ks * far**2 + rest
    sideways = 0.5 * A * math.sin(2 * p) + B * math.sin(p + q) + 0.5 * C * math.sin(2 * q)
    end = 0.5 * A * math.sin(2 * p) + B * math.cos(p) * math.sin(q) + kt * math.sin(p - q)
    moment = abs(end - near / L * sideways)
    assert abs(moment / abs(end) - 1.0) > 0.3
    for whole in (None, WHOLE):
        found = index(model, Pose(first=-p, second=-q), whole)
        assert found == pytest.approx(moment * RADIUS / I / 2e6, rel=1e-9)
