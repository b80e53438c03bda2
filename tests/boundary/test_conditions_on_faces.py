"""Conditions on faces of bodies of cells: contradictions, rotations beside translations, and unions of faces."""

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError
from bondem.io.codec import decode, encode

E, H, LENGTH = 10e9, 10e-3, 60e-3
NEAR, FAR = bd.Face("x_min"), bd.Face("x_max")
HALF = bd.Within(bd.Box((LENGTH, H / 2, H)))
BAR = bd.connect(bd.pack(bd.Box((LENGTH, H, H)), count=300, method="even", seed=1), method="laguerre")
LAW = bd.CellBond(E=E, nu=0.0)


def model(*boundary: bd.BoundaryCondition, body: bd.Lattice = BAR) -> bd.Model:
    return bd.Model(body, LAW, density=2400.0, boundary=boundary)


# ---- contradictions


@pytest.mark.parametrize("given", [
    (bd.Drive(NEAR, x=1e-6), bd.Drive(NEAR, x=2e-6)),
    (bd.Drive(NEAR, vx=1.0), bd.Drive(NEAR, vx=2.0)),
    (bd.Drive(NEAR, x=1e-6), bd.Drive(NEAR & HALF, x=1e-6)),
])  # fmt: skip
def test_a_face_that_is_driven_twice_along_an_axis_is_refused(given):
    with pytest.raises(InputError, match="driven twice in one component; remove one Drive"):
        model(*given)


@pytest.mark.parametrize("order", [1, -1])
@pytest.mark.parametrize("part", [NEAR, NEAR & HALF])
def test_facets_that_are_both_fixed_and_driven_are_refused(order, part):
    with pytest.raises(InputError, match="both fixed and driven in one component; subtract the regions"):
        model(*(bd.Fix(NEAR), bd.Drive(part, x=1e-6))[::order])


def test_two_platens_of_different_friction_on_one_face_are_refused():
    with pytest.raises(InputError, match="two platens with friction; remove one"):
        model(bd.Fix(NEAR, "x", "", friction=0.1), bd.Drive(NEAR, x=1e-6, friction=0.2))


def test_conditions_along_different_axes_on_different_facets_or_twice_fixed_are_accepted():
    model(bd.Fix(NEAR, "yz"), bd.Drive(NEAR, x=1e-6))
    model(bd.Fix(NEAR - HALF), bd.Drive(bd.Face("y_max"), x=1e-6))  # cells of the edge, but other facets
    model(bd.Fix(NEAR), bd.Fix(NEAR & HALF))


# ---- rotations


TOGETHER = {
    "a drive": ([bd.Drive(FAR, x=0.0, rx=1e-3)], [bd.Drive(FAR, x=0.0), bd.Drive(FAR, rx=1e-3)]),
    "a bent drive": (
        [bd.Drive(FAR, x=1e-6, y=0.0, z=0.0, ry=1e-3)], [bd.Drive(FAR, x=1e-6, y=0.0, z=0.0), bd.Drive(FAR, ry=1e-3)],
    ),
    "a support": ([bd.Fix(FAR, "y", "xz")], [bd.Fix(FAR, "y", ""), bd.Fix(FAR, "", "xz")]),
}  # fmt: skip


@pytest.mark.parametrize("case", list(TOGETHER))
def test_translations_and_rotations_of_one_condition_act_as_two_conditions_do(case):
    load = bd.Load(FAR, force=(0.0, 0.0, 1.0))
    one, two = (bd.solve_static(model(bd.Fix(NEAR), *given, load)) for given in TOGETHER[case])
    np.testing.assert_array_equal(one.displacement, two.displacement)
    np.testing.assert_array_equal(one.rotation, two.rotation)
    assert one.rotation.any()


def test_an_explicit_run_turns_a_face_whose_translation_is_prescribed_too():
    turn, still = bd.Ramp(0.0, 1e-3, 1e-5), bd.Constant(0.0)
    one, two = (
        bd.solve_explicit(model(bd.Fix(NEAR), *given), duration=2e-5).state
        for given in ([bd.Drive(FAR, x=still, rx=turn)], [bd.Drive(FAR, x=still), bd.Drive(FAR, rx=turn)])
    )
    np.testing.assert_array_equal(one.pose, two.pose)
    assert 2.0 * np.abs(one.orientation[FAR.select(BAR), 1]) == pytest.approx(1e-3, rel=1e-4)


def test_a_quasistatic_solution_turns_a_driven_face_and_returns_its_force():
    paths = []
    for given in ([bd.Drive(FAR, x=1e-6, rx=1e-3)], [bd.Drive(FAR, x=1e-6), bd.Drive(FAR, rx=1e-3)]):
        brittle = bd.Model(BAR, LAW, 2400.0, boundary=[bd.Fix(NEAR), *given], failure=bd.Rankine(tension=5e6))
        paths.append(bd.solve_quasistatic(brittle, FAR, most=1))
    np.testing.assert_array_equal(paths[0].load, paths[1].load)
    assert paths[0].load.max() > 0.0


def test_a_cantilever_whose_end_cells_do_not_turn_deflects_as_a_guided_beam():
    force, second = 10.0, H**4 / 12.0
    sheared = force * LENGTH / (5.0 / 6.0 * 0.5 * E * H * H)
    guided = force * LENGTH**3 / (12.0 * E * second) + sheared
    free = force * LENGTH**3 / (3.0 * E * second) + sheared
    load = bd.Load(FAR, force=(0.0, 0.0, force))
    end = FAR.select(BAR)
    for support, exact, tolerance in (
        (bd.Fix(FAR, "y", "xyz"), guided, 0.1), (bd.Fix(FAR, "x"), guided, 0.01), (bd.Fix(FAR, "y"), free, 0.04),
    ):  # fmt: skip
        found = bd.solve_static(model(bd.Fix(NEAR), support, load)).displacement[end, 2].mean()
        assert found == pytest.approx(exact, rel=tolerance)


def test_supports_without_named_rotations_hold_facets_only():
    one, two = (
        bd.solve_static(model(bd.Fix(NEAR, "xyz", *turns), bd.Load(FAR, moment=(0.0, 1.0, 0.0))))
        for turns in ((), ("",))
    )
    np.testing.assert_array_equal(one.displacement, two.displacement)
    assert one.rotation[NEAR.select(BAR)].any()


@pytest.mark.parametrize("rotation", [None, "xyz", "", "x"])
def test_files_keep_whether_rotations_were_named(rotation):
    support = bd.Fix(NEAR, "x", rotation)
    assert decode(encode(support)) == support
    assert encode(bd.Fix(NEAR))["rotation"] == "xyz"  # as earlier versions wrote it


# ---- unions of faces


LOW, HIGH = bd.Face("z_min"), bd.Face("z_max")
EDGE = NEAR & HALF


def stretched(*boundary: bd.BoundaryCondition) -> float:
    """Return the force of a bar that is stretched by u over E A u / L [-]."""
    u = 1e-5
    energy = bd.solve_static(model(*boundary)).energy.total
    return 2.0 * energy / u / (E * H * H * u / LENGTH)


@pytest.mark.parametrize(
    "near", [NEAR | EDGE, NEAR | NEAR, (NEAR | HIGH) - HIGH | NEAR, (NEAR | EDGE) & bd.Everything()]
)
@pytest.mark.parametrize("far", [FAR, FAR | FAR])
def test_a_bar_whose_ends_are_unions_of_parts_of_faces_is_as_stiff_as_theory(near, far):
    assert stretched(bd.Fix(near), bd.Drive(far, x=1e-5)) == pytest.approx(1.0, rel=1e-6)


def test_a_union_of_faces_acts_as_one_condition_for_each():
    ends = bd.Fix(NEAR, "x"), bd.Fix(bd.Face("y_min"), "y"), bd.Drive(FAR, x=1e-5)
    law = bd.CellBond(E=E, nu=0.3)
    found = [
        bd.solve_static(bd.Model(BAR, law, 2400.0, boundary=[*ends, *sides])).displacement
        for sides in ([bd.Fix(LOW | HIGH, "z")], [bd.Fix(LOW, "z"), bd.Fix(HIGH, "z")])
    ]
    np.testing.assert_array_equal(*found)


def test_a_load_on_two_faces_is_a_traction_on_their_facets():
    load = bd.Load(NEAR | FAR, force=(0.0, 0.0, 6.0), moment=(0.0, 0.5, 0.0))
    one = model(bd.Fix(LOW), load)
    facet, force = load.on_facets(BAR)
    free = BAR.cells.free
    assert set(facet) == {*BAR.on_face("x_min"), *BAR.on_face("x_max")}
    np.testing.assert_allclose(force.sum(axis=0), (0.0, 0.0, 6.0), atol=1e-12)
    arm = free.centroid[facet] - (NEAR | FAR).anchor(BAR)
    np.testing.assert_allclose(np.cross(arm, force).sum(axis=0), (0.0, 0.5, 0.0), atol=1e-12)
    np.testing.assert_allclose(bd.solve_static(one).reaction[:, :3].sum(axis=0), (0.0, 0.0, -6.0), atol=1e-6)


@pytest.mark.parametrize("condition", [bd.Fix, lambda region: bd.Drive(region, x=1e-6)])
@pytest.mark.parametrize("region", [NEAR | bd.Index([7]), (bd.Within(bd.Box((20e-3, H, H))) | NEAR) - bd.Index([7])])
def test_a_union_of_a_face_and_other_cells_is_refused_where_cells_are_constrained(condition, region):
    with pytest.raises(InputError, match="joins a face, held by its facets, with other cells; give one"):
        model(condition(region))


def test_platens_with_friction_and_pressures_are_on_one_face():
    with pytest.raises(InputError, match="friction is that of a platen"):
        bd.Fix(NEAR | FAR, "x", "", friction=0.3)
    with pytest.raises(InputError, match="one Pressure for each face"):
        bd.Pressure(NEAR | FAR, 1e6)


def test_spheres_accept_any_union():
    spheres = bd.connect(bd.pack(bd.Box((LENGTH, H, H)), count=400, seed=1))
    law = bd.Timoshenko(E=E, nu=0.2, radius_ratio=0.6)
    bd.solve_static(bd.Model(spheres, law, 2400.0, boundary=[bd.Fix(NEAR | bd.Index([7])), bd.Load(FAR | FAR)]))
