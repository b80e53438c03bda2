"""Softening along present directions of stress: strength and fracture energy whatever the path and the facet."""

import functools
import math

import numpy as np
import pytest

import bondem as bd
from bondem._tables.columns import CrackStatus
from bondem._tables.stress_onset_tables import LoadedFacets
from bondem.damage.crack_columns import CRACK_COLUMNS, FACET, ONSET, STATUS, TOP
from bondem.damage.proportional_onset import softening_along
from bondem.errors import InputError
from bondem.io.older_states import judge_anew
from tests.core.law_samples import left_in_bulk, left_on_plane, softened, softening
from tests.specimens import cube, cubes

E, RHO, F_T, G_F = 40e9, 2500.0, 4e6, 50.0
LAW = bd.CellBond(E=E, nu=0.2)
SOFT = bd.Rankine(tension=F_T, fracture_energy=G_F)
WEAK = bd.Rankine(tension=1e6, fracture_energy=4.0)
# k / A of the facets that are judged alone [Pa/m]; opening where nothing is left of them, as a traction
STIFF = 3e13
LAST = STIFF * 2.0 * G_F / F_T
LINE = {"strength": F_T, "last": LAST}
# least |n·e| by which the strength of a facet is reduced
LEAST_SLOPE = 0.2
ALONG = np.array([1.0, 0.0, 0.0])


def lost(s: np.ndarray) -> np.ndarray:
    """Losses of integrity under loads that grow, which never heals."""
    assert (np.diff(s) <= 0.0).all()
    return -np.diff(s, prepend=1.0)


def directions(rng: np.random.Generator) -> np.ndarray:
    """Three perpendicular unit vectors, in columns."""
    return np.linalg.qr(rng.standard_normal((3, 3)))[0]


@functools.cache
def blocks() -> tuple[bd.Lattice, bd.Index, bd.Index]:
    """Cubic cells, and those on both sides of the plane x = 2 mm."""
    body = cubes((4, 4, 4), 1e-3)
    left = body.centre[:, 0] < 2e-3
    return body, bd.Index(np.flatnonzero(left).tolist()), bd.Index(np.flatnonzero(~left).tolist())


def test_every_facet_begins_at_the_strength_of_the_material() -> None:
    """σ_1 = f_t, whatever the normal, the other principal stresses and the frame; but for facets along the crack."""
    rng = np.random.default_rng(1)
    for _ in range(200):
        v, n = directions(rng), rng.standard_normal(3)
        n /= np.linalg.norm(n)
        if np.abs(n @ v).min() < LEAST_SLOPE:
            continue
        stress = v @ np.diag([1.0, rng.uniform(-8.0, 1.0), rng.uniform(-8.0, 1.0)]) @ v.T
        for size, begins in ((1.0 - 1e-9, False), (1.0 + 1e-6, True)):
            t = tuple(size * F_T * stress @ n)
            left = left_in_bulk(1.0, t, n, stress, **LINE)
            assert (left < 1.0) == begins


def test_pressure_along_other_axes_softens_nothing() -> None:
    """Uniaxial compression has σ_1 = 0, and inclined facets are sheared by it."""
    rng = np.random.default_rng(2)
    for _ in range(100):
        v, n = directions(rng), rng.standard_normal(3)
        n /= np.linalg.norm(n)
        pressed = v @ np.diag([-100.0 * F_T, 0.0, 0.0]) @ v.T
        assert left_in_bulk(1.0, pressed @ n, n, pressed, **LINE) == 1.0


@pytest.mark.parametrize("curve", [None, bd.Bilinear()])
@pytest.mark.parametrize("slope", [0.3, 0.7, 1.0])
def test_a_crack_dissipates_its_projection(slope: float, curve: bd.Bilinear | None) -> None:
    """∫ |t|² (-ds) A / 2k is G_f A |n·e_1| for an opening along e_1: G_f per area projected on the crack."""
    law = bd.Rankine(tension=F_T, fracture_energy=G_F, curve=curve).softening
    last = STIFF * law.last * G_F / F_T
    n, T = (slope, math.sqrt(1.0 - slope**2), 0.0), np.geomspace(0.9 * slope * F_T, 1.001 * last, 20_000)
    s = left_in_bulk(
        1.0, np.outer(T, ALONG), n, np.diag(ALONG), strength=F_T, last=last, kink=law.kink, steep=law.steep
    )  # fmt: skip
    taken = (0.5 * T**2 * lost(s)).sum() / STIFF
    assert s[-1] == 0.0
    assert taken == pytest.approx(G_F * slope, rel=1e-3)


@pytest.mark.parametrize("slope", [0.6, 1.0])
@pytest.mark.parametrize("share", [0.0, 0.3, 1.0, 3.0, math.inf])
def test_a_bent_facet_begins_by_its_edge_and_dissipates_the_same(share: float, slope: float) -> None:
    """p + b = f_t c at onset, for b / p = share; G_f A c whatever the share, without a tangential traction."""
    n, size = (slope, math.sqrt(1.0 - slope**2), 0.0), np.geomspace(0.1 * F_T, 4.0 * LAST, 40_000)
    pulled, bent = (0.0, 1.0) if share == math.inf else (1.0, share)
    t, b = size * pulled, size * bent
    s = left_in_bulk(1.0, np.outer(t, ALONG), n, np.diag(ALONG), bent=b, **LINE)
    here = b * slope / max(abs(one) for one in n)  # the part of the bending that opens along e_1
    begun = (t + here)[np.argmax(s < 1.0)]
    taken = (0.5 * (t**2 + here**2) * lost(s)).sum() / STIFF
    assert s[-1] == 0.0
    if slope == 1.0:  # inclined facets may begin along their second direction, which bending opens too
        assert begun == pytest.approx(F_T, rel=1e-3)
        # the middle of a facet that is bent a little opens by `last` before the rms of its points does
        assert taken == pytest.approx(G_F, rel=3e-2 if share == 0.3 else 5e-3)
    else:
        assert begun <= F_T * slope * (1.0 + 1e-3)
        assert taken <= G_F * slope * (1.0 + 5e-3)


def test_pressure_closes_the_bending_of_a_plane() -> None:
    """What pressure on a plane takes off its bending does not open it."""
    for bent, whole in ((2.9e6 + F_T, True), (3.1e6 + F_T, False)):
        pressed, n = (-3e6, 0.0, 0.0), (1.0, 0.0, 0.0)
        left = left_on_plane(1.0, pressed, n, bent=bent, **LINE)
        assert (left == 1.0) == whole


@pytest.mark.parametrize("angle", [0.0, 0.5, 1.0])
def test_a_plane_dissipates_its_own_area(angle: float) -> None:
    """G_f per area of the facet, whatever the angle between opening and normal; from t_n = f_w on."""
    T = np.geomspace(0.5 * F_T, 4.0 * LAST, 20_000)
    t = np.outer(T, [math.cos(angle), math.sin(angle), 0.0])
    s = left_on_plane(1.0, t, ALONG, **LINE)
    begun = t[np.argmax(s < 1.0), 0]
    taken = (0.5 * T**2 * lost(s)).sum() / STIFF
    assert s[-1] == 0.0
    assert begun == pytest.approx(F_T, rel=1e-3)
    assert taken == pytest.approx(G_F, rel=2e-3)


def test_a_plane_under_pressure_loses_its_cohesion_and_keeps_its_friction() -> None:
    """s (|t_s| - μ p) follows the curve from c on: with the friction of closed cracks the plane bears the rest."""
    cohesion, mu, pressure, last = 2e6, 0.5, 3e6, 40e6
    for slip in np.linspace(1e6, 60e6, 200):
        t = (-pressure, 0.0, float(slip))
        n = 1.0, 0.0, 0.0
        s = left_on_plane(1.0, t, n, cohesion=cohesion, last_slip=last, friction=mu, **LINE)
        over = slip - mu * pressure
        curve = over if over <= cohesion else max(0.0, cohesion * (1.0 - over / last) / (1.0 - cohesion / last))
        assert s * over == pytest.approx(curve, rel=1e-12, abs=1e-6) or over < 0.0
        assert s == 1.0 or over > cohesion


@pytest.mark.parametrize(("kink", "steep"), [(0.0, 1.0), (1.0 / 3.0, bd.Bilinear().steep)])
def test_the_curve_and_its_inverse_agree(kink: float, steep: float) -> None:
    for s in (1.0, 0.7, 0.2, 0.01):
        T = softening(
            s, np.zeros(3), ALONG, np.diag(ALONG), strength=F_T, last=LAST, kink=kink, steep=steep
        )[4]  # fmt: skip
        assert softened(s, T * (1.0 - 1e-9), F_T, LAST, kink, steep) == s
        assert softened(s, T * (1.0 + 1e-6), F_T, LAST, kink, steep) < s


def test_equilibria_and_runs_judge_alike() -> None:
    """Load factors of equilibria are those at which the law of cracks begins to change an integrity."""
    rng = np.random.default_rng(3)
    body, left, right = blocks()
    model = bd.Model(body, LAW, density=RHO, failure={bd.Everything(): SOFT, (left, right): WEAK})
    table = model.softening
    assert table is not None
    facets = np.concatenate([np.flatnonzero(table.plane)[:5], np.flatnonzero(~table.plane)[:15]])
    normal = rng.standard_normal((20, 3))
    normal /= np.linalg.norm(normal, axis=1)[:, None]
    traction, mean = 1e6 * rng.standard_normal((20, 3)), 1e6 * rng.standard_normal((20, 6))
    traction[(traction * normal).sum(axis=1) < 0.0] *= -1.0
    full = mean[:, [[0, 3, 4], [3, 1, 5], [4, 5, 2]]]
    m, own = len(table.strength), np.arange(len(table.strength))  # each facet between two cells of its own stress
    columns, stress = np.zeros((2, m, 3)), np.zeros((m, 6))
    columns[:, facets], stress[facets] = (normal, traction), mean
    loaded = LoadedFacets(own, own, *columns, np.zeros(m), stress)
    for s in (1.0,):  # a run keeps the directions of cracks, equilibria follow those of the stress
        opened = softening_along(loaded, table.strengths(), facets, traction, np.full(20, s))
        for e, factor in enumerate(opened.factor.min(axis=1)):
            k, n = facets[e], tuple(normal[e])
            for near, falls in ((1.0 - 1e-6, False), (1.0 + 1e-6, True)):
                now = softening(
                    s, near * factor * traction[e], n, full[e], strength=table.strength[k], last=table.last[k],
                    plane=bool(table.plane[k]),
                )[: 1 if table.plane[k] else 3].min()  # fmt: skip
                assert (now < s) == falls


@pytest.mark.parametrize("seed", [1, 2])
def test_a_first_load_leaves_the_strength_across(seed: int) -> None:
    """A cube pulled along x to 1.02 f_t/E and unloaded has its strength and stiffness along y (was 0.61 and 0.64)."""
    body, size = cube(300, 30e-3, seed=seed), 30e-3
    stretch = F_T / E * size
    period = 2.0 * size / math.sqrt(E / RHO)
    damping = bd.MassDamping(alpha=0.6 / period)
    rise, speed = 12.0 * period, stretch / (12.0 * period)
    first = bd.Table([0.0, rise, 2.0 * rise], [0.0, 1.02 * stretch, 0.0])
    state, ended = None, 0.0
    for axis, long in (("x", 2.0 * rise), ("y", 1.3 * rise)):
        begin = 0.0 if state is None else state.time
        motion = {"x": first} if axis == "x" else {"vy": bd.Ramp(0.0, speed, 0.2 * rise, begin=begin)}
        model = bd.Model(body, LAW, density=RHO, failure=SOFT, boundary=[
            bd.Fix(bd.Face(f"{axis}_min"), translation=axis, rotation=""), bd.Drive(bd.Face(f"{axis}_max"), **motion),
        ])  # fmt: skip
        run = bd.solve_explicit(
            model, duration=long, state=state, damping=damping, every=20,
            gauges={side: bd.Gauge(bd.Face(f"{axis}_{side}"), "force") for side in ("min", "max")},
        )  # fmt: skip
        assert (np.diff(run.history.released) >= 0.0).all()
        state, ended = run.state, state.time if state is not None else 0.0
    time = run.history.time - ended
    stress = 0.5 * (run.history["max"] - run.history["min"])[:, 1] / size**2
    strain = speed / size * np.where(time < 0.2 * rise, 2.5 * time**2 / rise, time - 0.1 * rise)
    straight = (stress > 0.2 * F_T) & (stress < 0.5 * F_T) & (np.arange(len(stress)) < stress.argmax())
    assert stress.max() == pytest.approx(F_T, rel=0.05)
    assert np.polyfit(strain[straight], stress[straight], 1)[0] == pytest.approx(E, rel=0.05)


def test_stress_along_a_plane_has_no_influence() -> None:
    """A plane across the load under a dead tension of 1.1 f_w beside it: f_w and G_w (were 0.19 and 0.02 of them)."""
    body, left, right = blocks()
    failure = {bd.Everything(): bd.Rankine(tension=2e7, fracture_energy=1000.0), (left, right): WEAK}
    size, period = 4e-3, 8e-3 / math.sqrt(E / RHO)
    begin, end = 20.0 * period, 2.2 * WEAK.fracture_energy / WEAK.tension + 2.0 * WEAK.tension / E * size
    sides = bd.Ramp(0.0, 1.0, 0.5 * begin)
    model = bd.Model(body, LAW, density=RHO, failure=failure, boundary=[
        *(bd.Pressure(bd.Face(name), -1.1 * WEAK.tension, schedule=sides) for name in ("y_min", "y_max")),
        bd.Fix(bd.Face("x_min"), translation="x", rotation=""),
        bd.Drive(bd.Face("x_max"), vx=bd.Ramp(0.0, end / (1000.0 * period), begin, begin=begin)),
    ])  # fmt: skip
    run = bd.solve_explicit(
        model, duration=1040.0 * period, damping=bd.MassDamping(alpha=0.6 / period), every=20,
        gauges={side: bd.Gauge(bd.Face(f"x_{side}"), "force") for side in ("min", "max")},
    )  # fmt: skip
    peak = float(0.5 * (run.history["max"] - run.history["min"])[:, 0].max()) / size**2
    assert peak == pytest.approx(WEAK.tension, rel=0.01)
    assert float(run.history.released[-1]) / size**2 == pytest.approx(WEAK.fracture_energy, rel=0.02)


def test_a_criterion_may_say_what_it_judges() -> None:
    body, left, right = blocks()
    for on, planes in ((None, 16), ("traction", 16), ("stress", 0)):
        weak = bd.Rankine(tension=1e6, fracture_energy=4.0, on=on)
        table = bd.Model(body, LAW, density=RHO, failure={bd.Everything(): SOFT, (left, right): weak}).softening
        assert table is not None
        assert table.plane.sum() == planes


def test_a_plane_along_the_load_stays_whole() -> None:
    """At four times its strength it bears no traction (it kept 0.25 of its integrity)."""
    body, left, right = blocks()
    failure = {bd.Everything(): bd.Rankine(tension=2e7, fracture_energy=1000.0), (left, right): WEAK}
    period, size = 8e-3 / math.sqrt(E / RHO), 4e-3
    model = bd.Model(body, LAW, density=RHO, failure=failure, boundary=[
        bd.Fix(bd.Face("y_min"), translation="y", rotation=""),
        bd.Drive(bd.Face("y_max"), y=bd.Ramp(0.0, 4.0 * WEAK.tension / E * size, 20.0 * period)),
    ])  # fmt: skip
    run = bd.solve_explicit(model, duration=20.0 * period, damping=bd.MassDamping(alpha=0.6 / period), every=100)
    assert run.state.bond_integrity.min() == 1.0


def test_what_decides_is_checked() -> None:
    body, _, _ = blocks()
    with pytest.raises(InputError, match=r"on = .tension.; choose from stress, traction"):
        bd.Rankine(tension=F_T, on="tension")  # type: ignore[arg-type]
    cone = bd.DruckerPrager(tension=F_T, compression=1e7, fracture_energy=G_F, on="traction")
    with pytest.raises(InputError, match=r"DruckerPrager: on = .traction. applies to bd\.Rankine"):
        _ = bd.Model(body, LAW, density=RHO, failure=cone).softening


def test_cracks_of_older_files_get_the_strength_of_their_facet() -> None:
    """They had the traction at which they began, and the largest force so far, by which they slept."""
    body, _, _ = blocks()
    model = bd.Model(body, LAW, density=RHO, failure=SOFT)
    state = model.state()
    state.cracks = np.zeros((3, CRACK_COLUMNS))
    state.cracks[:, FACET], state.cracks[:, ONSET] = [0, 1, 2], [1e6, 0.0, 3e6]
    state.cracks[:, STATUS], state.cracks[:, TOP] = CrackStatus.RESTING, [2.0, 3.0, math.inf]
    judge_anew(model, state)
    np.testing.assert_array_equal(state.cracks[:, ONSET], [F_T, 0.0, F_T])
    np.testing.assert_array_equal(state.cracks[:, TOP], [0.0, 0.0, math.inf])
