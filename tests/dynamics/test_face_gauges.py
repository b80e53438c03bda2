"""Force gauges on faces of cells: the forces on that face, also where cells have facets on several faces."""

import numpy as np
import pytest

import bondem as bd
from bondem._tables.columns import HistoryColumn
from bondem.dynamics.face_gauges import FaceGauges
from bondem.dynamics.plan import Plan

EDGE = 10e-3
BLOCK = bd.connect(bd.pack(bd.Box((EDGE,) * 3), count=200, method="even", seed=1), method="laguerre")
LAW = bd.CellBond(E=1e9, nu=0.2)
FLOOR, SIDE, TOP = bd.Face("z_min"), bd.Face("x_max"), bd.Face("z_max")
FACES = ("x_min", "x_max", "y_min", "y_max", "z_min", "z_max")
RISE = bd.Ramp(0.0, 1.0, 1e-4)


def forces(*boundary, gauges, body=BLOCK, duration=2e-3, **options):
    """Return the last record of each gauge [N], and the run."""
    model = bd.Model(body, LAW, density=2400.0, boundary=boundary, **options)
    run = bd.solve_explicit(
        model, duration=duration, every=500, damping=bd.MassDamping(2e4),
        gauges={name: bd.Gauge(region, "force") for name, region in gauges.items()},
    )  # fmt: skip
    return {name: run.history[name][-1] for name in gauges}, run


def test_a_block_under_side_pressure_passes_its_force_to_the_floor():
    found, run = forces(
        bd.Fix(FLOOR), bd.Pressure(SIDE, 1e6, schedule=RISE), gauges={"side": SIDE, "floor": FLOOR, "top": TOP},
    )  # fmt: skip
    np.testing.assert_allclose(found["side"], (-100.0, 0.0, 0.0), atol=1e-9)  # 1 MPa on (10 mm)²
    np.testing.assert_allclose(found["floor"], (100.0, 0.0, 0.0), atol=1e-3)
    np.testing.assert_array_equal(found["top"], 0.0)
    assert run.quasistatic is None or run.quasistatic.difference is None or run.quasistatic.difference < 1e-4


def test_the_reaction_of_a_driven_side_is_that_of_the_floor_and_of_the_energy():
    fixed, way = bd.Fix(FLOOR), -1e-6
    found, _ = forces(fixed, bd.Drive(SIDE, x=bd.Ramp(0.0, way, 1e-4)), gauges={"side": SIDE, "floor": FLOOR})
    static = bd.solve_static(bd.Model(BLOCK, LAW, 2400.0, boundary=[fixed, bd.Drive(SIDE, x=way)]))
    assert found["side"][0] == pytest.approx(2.0 * static.energy.total / way, rel=1e-3)
    np.testing.assert_allclose(found["side"] + found["floor"], 0.0, atol=1e-4 * abs(found["side"][0]))


def test_the_gauges_of_all_faces_add_up_to_zero_in_equilibrium_and_to_that_of_everything_always():
    regions = {name: bd.Face(name) for name in FACES} | {"all": bd.Everything()}
    pressed = [bd.Pressure(bd.Face(name), p, schedule=RISE) for name, p in (("y_min", 2e6), ("y_max", 1e6))]
    conditions = [
        bd.Fix(FLOOR), *pressed, bd.Load(TOP, force=(5.0, 3.0, -40.0), moment=(0.0, 0.05, 0.0), schedule=RISE),
        bd.Drive(SIDE & bd.Within(bd.Box((EDGE, EDGE / 2, EDGE))), x=bd.Ramp(0.0, -1e-6, 1e-4)),
    ]  # fmt: skip
    found, run = forces(*conditions, gauges=regions)
    np.testing.assert_allclose(found["all"], 0.0, atol=1e-2)
    every = sum(run.history[name] for name in FACES)
    np.testing.assert_allclose(every, run.history["all"], atol=1e-9)  # at every record, in motion too
    np.testing.assert_allclose(found["y_max"], (0.0, -100.0, 0.0), atol=1e-9)
    np.testing.assert_allclose(found["z_max"], (5.0, 3.0, -40.0), atol=1e-9)


def test_a_union_of_faces_reads_the_forces_of_both():
    found, _ = forces(
        bd.Fix(FLOOR), bd.Pressure(SIDE, 1e6, schedule=RISE), bd.Pressure(TOP, 2e6, schedule=RISE),
        gauges={"both": SIDE | TOP, "half": TOP & bd.Within(bd.Box((EDGE / 2, EDGE, EDGE))), "top": TOP - FLOOR},
        duration=2e-4,
    )  # fmt: skip
    np.testing.assert_allclose(found["both"], (-100.0, 0.0, -200.0), atol=1e-9)
    np.testing.assert_allclose(found["top"], (0.0, 0.0, -200.0), atol=1e-9)
    assert -190.0 < found["half"][2] < -60.0


@pytest.mark.parametrize("reduction", ["mean", "max_abs"])
def test_reductions_are_over_the_cells_of_the_face(reduction):
    model = bd.Model(BLOCK, LAW, 2400.0, boundary=[bd.Fix(FLOOR), bd.Pressure(SIDE, 1e6)])
    gauge = bd.Gauge(SIDE, "force", reduction)
    found = bd.solve_explicit(model, duration=1e-6, every=100, gauges={"side": gauge}).history["side"][-1]
    cell = BLOCK.cells.free.cell[BLOCK.on_face("x_max")]
    each = -1e6 * np.bincount(cell, weights=BLOCK.cells.free.area[BLOCK.on_face("x_max")])[np.unique(cell)]
    np.testing.assert_allclose(found[0], each.mean() if reduction == "mean" else np.abs(each).max(), rtol=1e-12)


STRETCHED = [bd.Fix(bd.Face("x_min")), bd.Drive(bd.Face("x_max"), vx=bd.Ramp(0.0, 2.0, 1e-5))]
CASES = {
    "elastic": (STRETCHED, {}),
    "cracks": (STRETCHED, {"failure": bd.Rankine(tension=1e5, fracture_energy=1.0)}),
    "breaks": (STRETCHED, {"failure": bd.Rankine(tension=1e5)}),
    "yields": (
        STRETCHED,
        {"failure": bd.MohrCoulomb(cohesion=2e5, friction_angle=0.3, tension=1e6, fracture_energy=50.0)},
    ),
    "grows": ([*STRETCHED, bd.Eigenstrain(1e-4, schedule=bd.Ramp(0.0, 1.0, 1e-4))], {}),
    "slides": (
        [bd.Fix(bd.Face("x_min"), "x", "", friction=0.1), bd.Drive(bd.Face("x_max"), x=bd.Ramp(0, -1e-5, 1e-4))], {},
    ),
    "follows": (
        [bd.Fix(bd.Face("x_min")), bd.Pressure(bd.Face("x_max"), 1e6, follows=True)], {},
    ),
    "bends": ([bd.Fix(bd.Face("x_min")), bd.Load(bd.Face("x_max"), (1.0, 0.0, 2.0), (0.0, 0.1, 0.0))], {}),
    "centres": ([bd.Fix(bd.Index(bd.Face("x_min").select(BLOCK))), bd.Load(bd.Index([3]), (1.0, 0.0, 2.0))], {}),
}  # fmt: skip


@pytest.mark.parametrize("case", list(CASES))
def test_forces_from_the_state_are_those_of_the_core_where_cells_have_one_constrained_face(case):
    boundary, options = CASES[case]
    gauges = {name: bd.Gauge(bd.Face(name), "force") for name in ("x_min", "x_max")}
    if case == "centres":
        del gauges["x_max"]
    model = bd.Model(BLOCK, LAW, 2400.0, boundary=boundary, **options)
    run = bd.solve_explicit(model, duration=1e-4, every=50, gauges=gauges)
    plan = Plan(duration=0.0, gauges=gauges)
    gauge = FaceGauges(model, plan)
    assert not gauge  # the sums of the core are used, bit by bit
    surface = BLOCK.cells.free
    gauge._gauges = [
        (HistoryColumn.COUNT + 3 * g, "sum", BLOCK.on_face(name), np.unique(surface.cell[BLOCK.on_face(name)]))
        for g, name in enumerate(gauges)
    ]
    records = np.zeros((1, HistoryColumn.COUNT + 6))
    gauge.fill(records, run.state)
    for g, name in enumerate(gauges):
        of_core = run.history[name][-1]
        own = records[0, HistoryColumn.COUNT + 3 * g :][:3]
        near = 1e-7 if case == "bends" else 1e-9  # the core regularises the inertia of the points of a moment
        np.testing.assert_allclose(own, of_core, rtol=near, atol=near * np.abs(of_core).max() + 1e-12)
        assert of_core.any()


def test_gauges_that_are_read_from_the_state_leave_the_bits_of_a_run_unchanged():
    boundary = [bd.Fix(FLOOR), bd.Drive(SIDE, vx=bd.Ramp(0.0, -2.0, 1e-5))]
    model = bd.Model(BLOCK, LAW, 2400.0, boundary=boundary, failure=bd.Rankine(tension=1e5, fracture_energy=1.0))
    one, two = (
        bd.solve_explicit(model, duration=1e-4, every=7, gauges=gauges).state
        for gauges in ({}, {"side": bd.Gauge(SIDE, "force")})
    )
    np.testing.assert_array_equal(one.pose, two.pose)
    np.testing.assert_array_equal(one.facet_force, two.facet_force)
