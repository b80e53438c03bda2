"""Moments of shapes against closed forms and trimesh; densities with which elements have the body's inertia."""

import math

import numpy as np
import pytest
import trimesh

import bondem as bd
from bondem.calibration.density import balanced_density, element_density
from bondem.errors import InputError
from bondem.geometry.moments import moments
from bondem.labtests.beam_tests import CrossSection
from bondem.labtests.cantilever import mass_gyration
from tests.specimens import spheres
from validation.studies.mass_moments import examine

RHO = 2201.0
TURNED = bd.Cylinder(radius=1.0, length=4.0).rotated("y", 0.4).rotated("z", -1.1).moved((0.3, 2.0, -1.0))


def of_mesh(mesh: trimesh.Trimesh) -> bd.Surface:
    return bd.Surface(vertices=mesh.vertices, triangles=mesh.faces)


@pytest.mark.parametrize(
    ("shape", "mesh"),
    [
        (bd.Box(size=(1.0, 2.0, 3.0)), trimesh.creation.box(bounds=[[0, 0, 0], [1, 2, 3]])),
        (bd.Ball(radius=1.5), trimesh.creation.icosphere(subdivisions=5, radius=1.5)),
        (
            bd.Cylinder(radius=1.0, length=4.0),
            trimesh.creation.cylinder(radius=1.0, segment=[[0, 0, 0], [4, 0, 0]], sections=400),
        ),
    ],
)
def test_plain_shapes_have_the_moments_of_their_meshes(shape, mesh):
    # trimesh integrates over the surface; the mesh itself is flat between its corners, to 2e-3 at worst here
    found = moments(shape)
    assert found.volume == pytest.approx(shape.volume, rel=1e-14)
    np.testing.assert_allclose(found.centre, mesh.center_mass, atol=1e-6)
    np.testing.assert_allclose(found.inertia, mesh.moment_inertia, rtol=2e-3, atol=1e-6)


def test_surfaces_are_exact_wherever_they_lie():
    profile = [[0, 0], [30, 0], [30, 8], [8, 8], [8, 20], [0, 20]]
    side = np.column_stack([np.zeros(6), profile])
    ring = np.concatenate([side, side + np.array([5.0, 0.0, 0.0])])
    caps = np.array([[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]])
    k = np.arange(6)
    after = (k + 1) % 6
    walls = np.concatenate([np.stack([k, after, 6 + k], axis=1), np.stack([after, 6 + after, 6 + k], axis=1)])
    mesh = trimesh.Trimesh(ring, np.concatenate([caps[:, ::-1], caps + 6, walls]))
    mesh.fix_normals()
    mesh.apply_transform(trimesh.transformations.euler_matrix(0.3, 0.7, -0.2))
    mesh.apply_translation([100.0, -30.0, 7.0])
    found = moments(of_mesh(mesh))
    assert found.volume == pytest.approx(5.0 * (240 + 96), rel=1e-12)
    np.testing.assert_allclose(found.centre, mesh.center_mass, rtol=1e-10)
    np.testing.assert_allclose(found.inertia, mesh.moment_inertia, rtol=1e-8, atol=1e-6)


def test_turned_shapes_take_their_moments_along():
    points = np.random.default_rng(3).uniform(*TURNED.bounds, (400_000, 3))
    inside = points[TURNED.contains(points)]
    found = moments(TURNED)
    np.testing.assert_allclose(found.centre, inside.mean(axis=0), atol=0.02)
    np.testing.assert_allclose(found.second / found.volume, np.cov(inside.T), atol=0.02)
    values = np.linalg.eigvalsh(found.second) / found.volume
    np.testing.assert_allclose(values, [0.25, 0.25, 16.0 / 12.0], rtol=1e-12)


def test_combined_shapes_add_and_take_away():
    # a box with a round hole, and two boxes that overlap: both known in closed form
    hole = bd.Cylinder(radius=0.5, length=3.0).moved((-1.0, 1.0, 1.0))
    drilled = moments(bd.Box(size=(1.0, 2.0, 2.0)) - hole)
    volume = 4.0 - 0.25 * math.pi
    assert drilled.volume == pytest.approx(volume, rel=1e-3)
    np.testing.assert_allclose(drilled.centre, [0.5, 1.0, 1.0], atol=1e-3)
    across = 4.0 * 4.0 / 12.0 - 0.25 * math.pi * 0.25**2
    np.testing.assert_allclose(np.diag(drilled.second), [volume / 12.0, across, across], rtol=2e-3)
    joined = moments(bd.Box(size=(2.0, 1.0, 1.0)) | bd.Box(size=(2.0, 1.0, 1.0)).moved((1.0, 0.0, 0.0)))
    whole = moments(bd.Box(size=(3.0, 1.0, 1.0)))
    np.testing.assert_allclose(joined.centre, whole.centre, atol=1e-6)
    np.testing.assert_allclose(joined.second, whole.second, rtol=2e-3, atol=1e-6)
    with pytest.raises(InputError, match="no centre"):
        moments(bd.Cell(size=(1.0, 1.0, 1.0)))


@pytest.fixture(scope="module")
def lattice() -> bd.Lattice:
    return spheres(bd.Cylinder(radius=5e-3, length=40e-3), 1500, seed=2)


def body_of(lattice, law_density):
    """Mass, centre and inertia about that centre of what moves, from the masses that the model uses."""
    model = bd.Model(lattice, bd.EulerBernoulli(E=1e9, nu=0.3, radius_ratio=0.7), density=law_density)
    on = lattice.connected
    m, x, own = model.mass[on], lattice.particles.position[on], model.inertia[on]
    centre = m @ x / m.sum()
    x = x - centre
    inertia = np.einsum("n,nij->ij", m, (x**2).sum(1)[:, None, None] * np.eye(3) - x[:, :, None] * x[:, None])
    return m.sum(), centre, inertia + own.sum() * np.eye(3)


@pytest.mark.parametrize("place", ["plain", "turned"])
def test_balanced_elements_have_the_inertia_of_the_body(lattice, place):
    shape = lattice.particles.shape
    if place == "turned":
        shape = shape.rotated("z", 0.7).rotated("x", 0.2).moved((0.01, 0.5, -0.2))
        turn = np.array(shape.turn)
        position = lattice.particles.position @ turn.T + shape.by
        lattice = bd.Lattice(bd.Particles(position, lattice.particles.radius, shape=shape), lattice.pairs)
    density = balanced_density(lattice, RHO)
    mass, centre, inertia = body_of(lattice, density)
    wanted = moments(shape)
    assert mass == pytest.approx(RHO * wanted.volume, rel=1e-12)
    np.testing.assert_allclose(centre, wanted.centre, atol=1e-14)
    np.testing.assert_allclose(inertia, RHO * wanted.inertia, atol=1e-11 * RHO * np.trace(wanted.inertia))
    # with one density the moment about the axis is percents off: this is not won by chance
    uniform = element_density([lattice], RHO)
    _, _, plain = body_of(lattice, uniform)
    least = np.linalg.eigvalsh(plain)[0] / (RHO * np.linalg.eigvalsh(wanted.inertia)[0])
    assert abs(least - 1.0) > 0.01
    assert (density > 0.5 * uniform).all()
    assert density.max() < 1.5 * uniform
    assert (density[~lattice.connected] == uniform).all()


def test_it_is_the_nearest_to_one_density(lattice):
    """Moving away along anything that keeps the ten numbers only makes the sum of squares larger."""
    density, uniform = balanced_density(lattice, RHO), element_density([lattice], RHO)
    on = lattice.connected
    x, v = lattice.particles.position[on] * 100.0, lattice.particles.volume[on]
    own = 0.4 * (lattice.particles.radius[on] * 100.0) ** 2
    kinds = [np.ones(len(x)), *x.T, x[:, 0] ** 2 + own / 2, x[:, 1] ** 2 + own / 2, x[:, 2] ** 2 + own / 2,
             x[:, 0] * x[:, 1], x[:, 1] * x[:, 2], x[:, 0] * x[:, 2]]  # fmt: skip
    rows = np.stack(kinds) * v / v.mean()
    step = np.random.default_rng(5).standard_normal(len(x))
    step -= rows.T @ np.linalg.lstsq(rows @ rows.T, rows @ step, rcond=None)[0]
    off = density[on] / uniform - 1.0
    assert abs(off @ step) < 1e-8 * np.linalg.norm(off) * np.linalg.norm(step)


def test_refined_theory_has_the_mass_of_the_densities_it_is_given(lattice):
    """Balanced elements fill the section of the body, those of one density less, and theory goes with the mass."""
    balanced, uniform = balanced_density(lattice, RHO), element_density([lattice], RHO)
    section = CrossSection.of(lattice.particles.shape)
    exact = [section.rotary_moment / section.area, (section.polar_moment - section.rotary_moment) / section.area]
    np.testing.assert_allclose(mass_gyration(lattice, balanced), exact, rtol=1e-10)
    np.testing.assert_allclose(mass_gyration(lattice, uniform), mass_gyration(lattice), rtol=1e-12)
    assert (mass_gyration(lattice) < 0.99 * np.array(exact)).all()

    law = bd.EulerBernoulli(E=1e9, nu=0.3, radius_ratio=0.7)
    modes = bd.labtests.natural_frequencies(lattice, law, density=uniform)  # any: theory is looked at, not the error
    own = {"E": 1e9, "nu": 0.2, "rho": RHO, "modes": modes, "gyration": 0.95 * np.array(exact)}
    torsion, bending = (
        [test(lattice, law, density=density, **own).theory_refined for density in (uniform, balanced)]
        for test in (bd.labtests.dynamic_torsion, bd.labtests.dynamic_bending)
    )
    share = mass_gyration(lattice, uniform).sum() / sum(exact)
    assert torsion[1] / torsion[0] == pytest.approx(math.sqrt(share), rel=1e-10)
    assert bending[1] < bending[0]  # by rotary inertia
    for wrong in (balanced[:-1], -balanced, np.full(len(balanced), math.nan)):
        with pytest.raises(InputError, match="density"):
            bd.labtests.dynamic_torsion(lattice, law, density=wrong, **own)
        with pytest.raises(InputError, match="density"):
            bd.labtests.natural_frequencies(lattice, law, density=wrong)


def test_the_benchmark_compares_each_specimen_with_its_own_mass():
    """Theories of both specimens, found back from frequencies and errors, differ by the moments of their masses."""
    row = examine(800, 2)

    def theory(way, error):
        return np.array(row[way]["frequency"]) / (1.0 + np.array(row[way][error]))

    np.testing.assert_allclose(theory("one", "error"), theory("balanced", "error"), rtol=1e-12)
    axial, _, torsion = theory("balanced", "error_refined") / theory("one", "error_refined")
    about_axis, _ = row["one"]["inertia_error"]
    assert about_axis < -0.03
    assert axial == pytest.approx(1.0, rel=1e-12)
    assert torsion == pytest.approx(math.sqrt(1.0 + about_axis), rel=1e-9)
    # stiffness and mass are both accounted for, so that what remains is the same with either mass
    found = [row[way]["error_refined"][2] for way in ("one", "balanced")]
    assert found[1] == pytest.approx(found[0], abs=0.003)


def test_what_elements_cannot_do_is_an_error():
    line = np.column_stack([np.arange(1.0, 12.0, 2.0), np.zeros(6), np.zeros(6)])
    chain = bd.Lattice(
        bd.Particles(line, 1.0, shape=bd.Cylinder(radius=3.0, length=12.0)), [(k, k + 1) for k in range(5)]
    )
    with pytest.raises(InputError, match="pack more elements"):
        balanced_density(chain, RHO)
