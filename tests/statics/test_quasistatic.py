"""Fracture by load factors: closed forms of two cells and of a bar that snaps back, energy, cracks that close."""

from dataclasses import replace

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError
from bondem.statics.linear import Elimination, Iteration, System
from bondem.statics.quasistatic.damaged_body import DamagedBody
from bondem.statics.quasistatic.equilibrium import Iterated
from bondem.statics.quasistatic.sawtooth import SofteningLine, Teeth
from tests.models import follow, pulled
from tests.specimens import cells, cubes, spheres, two_cubes, uneven_bar

E, STRENGTH, ENERGY = 40e9, 4e6, 50.0
SIZE = 1e-3


def softened_bar(count: int, energy: float, ripple: float) -> tuple[bd.QuasistaticResult, np.ndarray, np.ndarray]:
    """A bar of cubes, and load and displacement of its events by hand: the first facet cracks and no other."""
    found = follow(pulled(cubes((count, 1, 1), SIZE), nu=0.0, fracture_energy=energy), ripple=ripple, until=0.0)
    area, k = SIZE**2, E * SIZE
    line = Teeth.of(SofteningLine(STRENGTH, k / area * 2.0 * energy / STRENGTH), ripple)
    s, T = np.append(1.0, line.integrity[:-1]), np.append(STRENGTH, line.limit)
    load = area * s * T
    return found, load, load * count * SIZE / (E * area) + (1.0 - s) * T * area / k


@pytest.mark.parametrize("ripple", [0.3, 0.1])
def test_two_cells_soften_as_by_hand(ripple: float) -> None:
    found, load, way = softened_bar(2, ENERGY, ripple)
    assert found.end == "parted"
    np.testing.assert_allclose(found.load, load, rtol=1e-9)
    np.testing.assert_allclose(found.displacement, way, rtol=1e-9)
    assert found.integrity[-1] == 0.0
    assert set(found.bond) == {0}


def test_a_bar_snaps_back_as_by_hand() -> None:
    # 2 E G / f² = 5 mm; the bar is 20 mm long
    found, load, way = softened_bar(20, 1.0, 0.1)
    np.testing.assert_allclose(found.load, load, rtol=1e-9)
    np.testing.assert_allclose(found.displacement, way, rtol=1e-9)
    assert len(set(found.bond)) == 1
    assert found.displacement[-1] < 0.5 * found.displacement[0]
    assert (np.diff(found.displacement[:-1]) < 0.0).mean() > 0.5


def test_the_lowest_of_equal_bonds_fails_first() -> None:
    assert follow(pulled(cubes((5, 1, 1), SIZE), nu=0.0)).bond[0] == 0


@pytest.mark.parametrize("energy", [1.0, 50.0])
def test_the_energy_under_the_line_is_dissipated(energy: float) -> None:
    """Less than the mean of bands above and below: first order in their width."""
    errors = []
    for ripple in (0.2, 0.1, 0.05):
        found, _, _ = softened_bar(2, energy, ripple)
        errors.append(found.work[-1] / (energy * SIZE**2) - 1.0)
    assert abs(errors[2]) < 0.03
    assert abs(errors[2]) < 0.7 * abs(errors[1]) < 0.49 * abs(errors[0]) + 1e-3


@pytest.mark.parametrize(
    ("share", "ripple"), [(0.4, 0.7), pytest.param(0.95, 0.05, marks=pytest.mark.validate)]
)
def test_a_run_ends_where_its_last_events_stay_below(share: float, ripple: float) -> None:
    """A few events far below the others, as coarse steps or a snap-back bring them, are not the end."""
    found = follow(pulled(uneven_bar(60), fracture_energy=20.0), ripple=ripple, until=share)
    below = found.load < share * np.maximum.accumulate(found.load)
    least = 2.0 / ripple  # about as many as one facet softens in
    needed = [int(np.ceil(max(0.05 * e, least))) for e in range(1, len(below) + 1)]
    ended = [e >= n and below[e - n : e].all() for e, n in enumerate(needed, start=1)]
    assert found.end == "unloaded"
    assert ended.index(True) == len(below) - 1
    twentieth = [below[e - int(np.ceil(0.05 * e)) : e].all() for e in range(1, len(below) + 1)]
    if ripple > 0.1:
        assert np.flatnonzero(below)[0] < len(below) - 1  # where a single event would have ended it
    else:
        assert twentieth.index(True) < len(below) - 1  # where a twentieth of them would have


def test_brittle_facets_break_at_once() -> None:
    found = follow(pulled(two_cubes(SIZE), nu=0.0, fracture_energy=None))
    np.testing.assert_allclose(found.load, [STRENGTH * SIZE**2], rtol=1e-9)
    assert found.end == "parted"
    assert found.bond_integrity.tolist() == [0.0]


@pytest.mark.parametrize("angle", [0.0, 0.6])
def test_facets_break_by_their_own_traction(angle: float) -> None:
    """Two cubes pulled or sheared: MohrCoulomb's tension and cohesion, whichever is less."""
    for tension, cohesion in ((4e6, 9e6), (9e6, 2e6)):
        failure = bd.MohrCoulomb(tension=tension, cohesion=cohesion, friction_angle=angle)
        way = pulled(two_cubes(SIZE), nu=0.0)
        model = bd.Model(two_cubes(SIZE), way.bond, 2500.0, failure=failure, boundary=way.boundary)
        found = follow(model)
        least = min(tension, cohesion / np.tan(angle) if angle > 0.0 else np.inf)
        np.testing.assert_allclose(found.load, [least * SIZE**2], rtol=1e-9)
        assert found.end == "parted"


@pytest.mark.parametrize("nu", [0.2, *(pytest.param(nu, marks=pytest.mark.validate) for nu in (-0.2, 0.45))])
def test_work_is_stored_or_dissipated(nu: float) -> None:
    found = follow(pulled(uneven_bar(100), nu=nu), ripple=0.3, most=60)
    assert found.end == "events"
    assert len(set(found.bond)) > 10
    spent = np.append(0.0, np.cumsum(found.energy)[:-1])
    np.testing.assert_allclose(found.work - found.stored, spent, atol=1e-5 * found.work[-1])
    assert (found.energy[:-1] > 0.0).all()


def damaged(model: bd.Model) -> DamagedBody:
    system = System.of(bd.Model(model.lattice, model.bond, 2500.0, boundary=model.boundary))
    return DamagedBody(model, system, np.tile(np.eye(6), (len(system.free), 1, 1)))


def solved(body: DamagedBody) -> np.ndarray:
    return Elimination(body.system).solve(body.right)[0]


@pytest.mark.parametrize("nu", [-0.2, 0.2, 0.45])
def test_the_matrix_changed_in_place_is_that_of_the_forces(nu: float) -> None:
    """With open, closed and broken facets, some in one direction; K u - right is what they and walls do on cells."""
    body = damaged(pulled(uneven_bar(200), nu=nu))
    rng, n = np.random.default_rng(0), 200
    for k in rng.choice(len(body.integrity), 300, replace=False).tolist():
        shut = rng.random(2) < 0.3
        across = rng.standard_normal(3) if rng.random() < 0.3 else np.zeros(3)
        across /= max(np.linalg.norm(across), 1.0e-300)
        body.weaken(np.array([k]), float(rng.choice([0.0, 0.3, 0.8])), (bool(shut[0]), bool(shut[1])), across)
    motion = 1e-6 * rng.standard_normal(6 * n)
    found, c, supports = body.loaded(motion), body.constants, body.model.cell_constants.supports
    force = found.traction * body.area[:, None]
    phi = motion.reshape(-1, 6)[:, 3:]
    load = np.zeros((n, 6))
    bent = body.integrity[:, None] * np.einsum("mab,mb->ma", c.H, phi[body.j] - phi[body.i])
    for end, lever, sign in ((body.i, c.lever_i, 1.0), (body.j, c.lever_j, -1.0)):
        np.add.at(load, end, sign * np.hstack([force, np.cross(lever, force) + bent]))
    held = body.model.layout.rank[supports.cell]
    turned = -np.einsum("gab,gb->ga", supports.H, phi[held])
    np.add.at(load, held, np.hstack([found.wall, np.cross(supports.lever, found.wall) + turned]))
    off = body.system.matrix @ motion - body.right + load.ravel()
    assert np.abs(off).max() < 1e-10 * np.abs(load).max()
    root = Iteration(body.system).root
    body.matrix.rescale(root)
    x = rng.standard_normal(6 * n)
    scaled = np.einsum(
        "nab,nb->na",
        np.swapaxes(root, 1, 2),
        (body.system.matrix @ np.einsum("nab,nb->na", root, x.reshape(-1, 6)).ravel()).reshape(-1, 6),
    )
    np.testing.assert_allclose(body.matrix.scaled @ x, scaled.ravel(), atol=1e-9 * np.abs(scaled).max())


@pytest.mark.parametrize("rotation", ["bending", "full"])
def test_platens_let_a_body_turn_and_slide_on_them(rotation: str) -> None:
    """No force and torque where it moves as its supports permit."""
    model = pulled(uneven_bar(200))
    law = bd.CellBond(E=E, nu=0.2, facet_rotation=rotation)
    system = System.of(bd.Model(model.lattice, law, 2500.0, boundary=model.boundary))
    assert system.loose.shape[1] == 3
    assert np.abs(system.matrix @ system.loose).max() < 1e-10 * np.abs(system.matrix.bonds.data).max()


@pytest.mark.parametrize("nu", [-0.2, 0.2, 0.45])
def test_open_cracks_are_free_surface(nu: float) -> None:
    """λ / V of their cells is that of the law."""
    model = pulled(uneven_bar(200), nu=nu)
    body, rng = damaged(model), np.random.default_rng(1)
    for k in rng.choice(len(body.integrity), 300, replace=False).tolist():
        body.weaken(np.array([k]), float(rng.choice([0.3, 0.8])), (False, False))
    expected = model.cell_law.constants.damaged(body.integrity, body.i, body.j).weight
    np.testing.assert_allclose(body.system.matrix.weight, expected, rtol=1e-9)


def test_iteration_finds_what_elimination_does() -> None:
    model = pulled(uneven_bar(200))
    system = System.of(bd.Model(model.lattice, model.bond, 2500.0, boundary=model.boundary))
    begun = Iteration(system)
    body = DamagedBody(model, system, begun.root)
    search, u = Iterated(body.system, body.matrix, begun, body.integrity), np.zeros(1200)
    for k in np.random.default_rng(1).choice(len(body.integrity), 60, replace=False).tolist():
        body.weaken(np.array([k]), 0.0, (False, False))
        u = search.solve(body.right, u)
    exact = Elimination(body.system).solve(body.right)[0]
    assert np.abs(u - exact).max() < 1e-4 * np.abs(exact).max()


@pytest.mark.parametrize("way", [(1e-6, 0.0), (-1e-6, 4e-6)])
def test_the_first_event_is_where_the_criterion_is_reached(way: tuple[float, float]) -> None:
    """Pulled, and pressed while it is sheared: no facet is beyond the criterion then, and one is at it."""

    def model(factor: float) -> bd.Model:
        drive = bd.Drive(bd.Face("x_max"), x=factor * way[0], y=factor * way[1])
        like = pulled(uneven_bar(100))
        ends = [bd.Fix(bd.Face("x_min")), drive]
        return bd.Model(like.lattice, like.bond, 2500.0, failure=bd.Rankine(tension=STRENGTH), boundary=ends)

    found = bd.solve_quasistatic(model(1.0), bd.Face("x_max"), most=1, together=0.0)
    there = model(found.factor[0])
    state = there.state()
    state.set_pose(position=found.state.position, orientation=found.state.orientation)
    index = bd.failure_index(there, state)
    assert index.argmax() == found.bond[0]
    assert index.max() == pytest.approx(1.0, abs=2e-3)  # the state turns by some 1e-4


def test_a_pressed_facet_cracks_by_its_own_shear() -> None:
    """Two cubes pressed and sheared: t_s² = f (f - t_n)."""
    law = bd.CellBond(E=E, nu=0.0, facet_rotation="full")
    ends = [bd.Fix(bd.Face("x_min")), bd.Drive(bd.Face("x_max"), x=-1e-7, y=1e-6)]
    model = bd.Model(two_cubes(SIZE), law, 2500.0, failure=bd.Rankine(tension=STRENGTH), boundary=ends)
    found = bd.solve_quasistatic(model, bd.Face("x_max"), together=0.0)
    body = damaged(model)
    t = found.factor[0] * body.loaded(solved(body)).traction[0]
    across = t @ body.constants.normal[0]
    assert across < -0.1 * STRENGTH
    assert t @ t - across**2 == pytest.approx(STRENGTH * (STRENGTH - across), rel=1e-9)


def hinge(strain: float, turn: float) -> tuple[bd.Model, bd.Region]:
    """Two cubes turned against each other about the middle of their facet, and pulled."""
    law, last = bd.CellBond(E=E, nu=0.0, facet_rotation="full"), bd.Index([1])
    failure = bd.Rankine(tension=STRENGTH, fracture_energy=ENERGY)
    drive = bd.Drive(last, x=SIZE * strain, y=0.5 * SIZE * turn, z=0.0, rx=0.0, ry=0.0, rz=turn)
    return bd.Model(two_cubes(SIZE), law, 2500.0, failure=failure, boundary=[bd.Fix(bd.Index([0])), drive]), last


@pytest.mark.parametrize("strain", [0.0, 3e-5, -1e-5])
def test_a_facet_that_is_bent_begins_at_its_traction_with_that_of_bending(strain: float) -> None:
    """t + T_b = f in tension; T_b = f + p/2 under a pressure p, of which cells held in the middle have half."""
    turn = 1e-4
    model, last = hinge(strain, turn)
    found = bd.solve_quasistatic(model, last, most=1, together=0.0)
    t, bent = E * strain, E * turn / np.sqrt(12.0)
    wanted = STRENGTH / (bent + t if strain >= 0.0 else bent + 0.5 * t)
    assert found.factor[0] == pytest.approx(wanted, rel=1e-7)  # H is of single precision
    state = model.state()
    # the state turns by some 1e-4
    state.set_pose(position=found.state.position, orientation=found.state.orientation)
    assert bd.failure_index(model, state)[0] == pytest.approx(1.0, rel=1e-3)


@pytest.mark.parametrize("strain", [1e-6, 3e-5])
def test_a_facet_that_is_bent_softens_by_the_rms_of_its_tractions(strain: float) -> None:
    """From √(t² + T_b²) at t + T_b = f on, so that the fracture energy is that of the facet."""
    model, last = hinge(strain, 1e-4)
    found = bd.solve_quasistatic(model, last, together=0.0, until=0.0, ripple=0.2)
    assert found.bond_integrity[0] == 0.0
    assert found.energy.sum() == pytest.approx(ENERGY * SIZE**2, rel=1e-4)


def test_whole_facets_have_the_matrix_of_the_body() -> None:
    model = pulled(uneven_bar(200))
    body = damaged(model)
    for k in range(0, 200, 3):
        body.weaken(np.array([k]), 0.5, (False, True))
    for k in range(0, 200, 3):
        body.weaken(np.array([k]), 1.0, (False, False))
    found, whole = body.system.matrix, model.interaction.stiffness()
    assert abs(found.bonds - whole.bonds).max() < 1e-12 * abs(whole.bonds).max()
    np.testing.assert_allclose(found.weight, whole.weight, rtol=1e-12)


@pytest.mark.parametrize("nu", [0.0, 0.2, 0.45])
def test_a_cut_that_is_pressed_bears_as_whole_material(nu: float) -> None:
    """All facets across the middle of a bar of cubes broken and closed: the load of the whole bar."""
    model = pulled(cubes((6, 1, 1), SIZE), way=-1e-6, nu=nu)
    body = damaged(model)
    body.weaken(np.array([2]), 0.0, (True, True))
    found = body.loaded(solved(body))
    assert not found.turned.any()
    pressing = found.wall[:, 0].sum(where=found.wall[:, 0] < 0.0)
    np.testing.assert_allclose(pressing, -E * SIZE**2 * 1e-6 / 6e-3, rtol=1e-6)


def test_cracks_close_where_they_are_pressed() -> None:
    """A block bent by walls: what is cut off on the pressed side bears; on the other it does not."""
    body = uneven_bar(200)
    facets = body.facets
    cut = np.flatnonzero(np.abs(facets.centroid[:, 0] - 8e-3) < 1e-3)
    model = pulled(body, way=-1e-6)
    state = damaged(model)
    rank = np.empty(len(state.integrity), dtype=np.int64)
    rank[model.layout.bond_order] = np.arange(len(rank))
    for k in rank[cut].tolist():
        state.weaken(np.array([k]), 0.0, (False, False))
    found = state.loaded(solved(state))
    assert found.turned.any()


BAD = {
    "no cells": ("needs cells", lambda: bd.Model(spheres(bd.Box((4e-3,) * 3), 300),
        bd.EulerBernoulli(E=E, nu=0.3, radius_ratio=0.7), 2500.0)),
    "nothing fails": ("failure=bd.Rankine", lambda: bd.Model(two_cubes(SIZE), bd.CellBond(E=E, nu=0.2), 2500.0)),
    "cells that yield": ("cells that yield", lambda: bd.Model(two_cubes(SIZE), bd.CellBond(E=E, nu=0.2), 2500.0,
        failure=bd.MohrCoulomb(tension=4e6, cohesion=14e6, friction_angle=0.6, fracture_energy=50.0))),
    "nothing is driven": ("neither driven nor loaded", lambda: bd.Model(
        two_cubes(SIZE), bd.CellBond(E=E, nu=0.2), 2500.0, failure=bd.Rankine(tension=4e6),
        boundary=[bd.Fix(bd.Face("x_min"))])),
    "it swells": ("drives and loads only", lambda: bd.Model(two_cubes(SIZE), bd.CellBond(E=E, nu=0.2), 2500.0,
        failure=bd.Rankine(tension=4e6), boundary=[bd.Fix(bd.Face("x_min")), bd.Eigenstrain(1e-4)])),
}  # fmt: skip


@pytest.mark.parametrize("bad", BAD)
def test_what_has_no_path_is_refused(bad: str) -> None:
    message, model = BAD[bad]
    with pytest.raises(InputError, match=message):
        bd.solve_quasistatic(model(), bd.Face("x_max"))


def test_a_region_is_a_region() -> None:
    with pytest.raises(InputError, match="a region"):
        bd.solve_quasistatic(pulled(two_cubes(SIZE)), "x_max")
    with pytest.raises(InputError, match="two regions"):
        bd.solve_quasistatic(pulled(two_cubes(SIZE)), bd.Face("x_max"), gauges={"CMOD": bd.Face("x_max")})


@pytest.mark.validate
def test_elements_that_are_driven_themselves_feel_the_same_load() -> None:
    """A bar of cubes pulled by the middle of its last cube, half a cube nearer than its face."""
    model = pulled(cubes((4, 1, 1), SIZE), nu=0.0)
    held, last = bd.Fix(bd.Face("x_min")), bd.Index([3])
    ends = [held, bd.Drive(last, x=1e-6, ry=0.0, rz=0.0)]
    inner = bd.Model(model.lattice, model.bond, 2500.0, failure=model.failure, boundary=ends)
    found = bd.solve_quasistatic(inner, last, together=0.0, until=0.5)
    np.testing.assert_allclose(found.load[0], STRENGTH * SIZE**2, rtol=1e-9)
    np.testing.assert_allclose(found.displacement[0], STRENGTH / E * 3.5 * SIZE, rtol=1e-9)


def test_a_load_pulls_as_walls_do() -> None:
    body = cubes((4, 1, 1), SIZE)
    law = bd.CellBond(E=E, nu=0.0, facet_rotation="full")
    loaded = bd.Model(body, law, 2500.0, failure=bd.Rankine(tension=STRENGTH, fracture_energy=ENERGY), boundary=[
        bd.Fix(bd.Face("x_min")), bd.Load(bd.Face("x_max"), force=(2.0, 0.0, 0.0))])  # fmt: skip
    found = bd.solve_quasistatic(loaded, bd.Face("x_max"), together=0.0, until=0.5)
    np.testing.assert_allclose(found.load[0], STRENGTH * SIZE**2, rtol=1e-9)
    np.testing.assert_allclose(found.factor[0], 0.5 * STRENGTH * SIZE**2, rtol=1e-9)
    np.testing.assert_allclose(found.displacement[0], STRENGTH / E * 3.5 * SIZE, rtol=1e-9)


def test_gauges_tell_how_far_regions_have_parted() -> None:
    ends = {"ends": (bd.Index([0]), bd.Index([3]))}
    found = bd.solve_quasistatic(
        pulled(cubes((4, 1, 1), SIZE), nu=0.0), bd.Face("x_max"), gauges=ends, most=3, together=0.0
    )
    np.testing.assert_allclose(found.gauge["ends"][0], [STRENGTH / E * 3.0 * SIZE, 0.0, 0.0], rtol=1e-9, atol=1e-13)
    assert found.gauge["ends"].shape == (3, 3)


def test_pieces_and_cracks_of_the_end() -> None:
    found = follow(pulled(cubes((4, 1, 1), SIZE), nu=0.0, fracture_energy=None))
    assert len(bd.fragments(cubes((4, 1, 1), SIZE), found.state)) == 2
    np.testing.assert_allclose(bd.cracks(cubes((4, 1, 1), SIZE), found.state).area, SIZE**2, rtol=1e-6)
    assert found.bond_integrity.tolist().count(0.0) == 1


@pytest.mark.validate
def test_a_notched_bar_has_the_peak_of_a_slow_explicit_run() -> None:
    slot = bd.Box((3e-3, 10e-3, 60e-3)).moved((28.5e-3, -1e-6, -15e-3))
    shape = bd.Box((60e-3, 30e-3, 30e-3)).cut(slot, name="notch")
    body = cells(shape, 300)
    failure = bd.Rankine(tension=STRENGTH, fracture_energy=20.0)
    slow = bd.labtests.direct_tension(body, bd.CellBond(E=E, nu=0.2), failure, traverses=240.0)
    model = replace(pulled(body, fracture_energy=20.0), bond=bd.CellBond(E=E, nu=0.2))
    found = bd.solve_quasistatic(model, bd.Face("x_max"))
    assert found.peak / 6e-4 == pytest.approx(slow.peak, rel=0.02)
    assert found.work[-1] / 6e-4 == pytest.approx(slow.work, rel=0.06)
