"""The finite-element reference of the studies against closed forms and against finer meshes."""

import math

import numpy as np
import pytest

from bondem.geometry.elementary_shapes import Box
from bondem.labtests.beam_tests import Bar, CrossSection
from validation.measures.continuum import Continuum

E, NU, RHO = 72.5e9, 0.17, 2201.0
BEAM = (40e-3, 5e-3, 5e-3)


def bar(nu: float = NU) -> Bar:
    return Bar(BEAM[0], CrossSection.of(Box(BEAM)), E, nu, RHO)


@pytest.fixture(scope="module")
def beam():
    return Continuum.box(BEAM, cell=1.67e-3)


@pytest.mark.validate
def test_a_cube_has_its_lame_modes():
    # u = (cos πx/a sin πy/a, -sin πx/a cos πy/a, 0) has no dilation and no traction on any face, whatever ν
    edge = 10e-3
    exact = math.sqrt(E / (2 * (1 + NU)) / RHO) * math.sqrt(2.0) / (2.0 * edge)
    error = []
    for cells in (2, 4):
        cube = Continuum.of([((0, 0, 0), (edge, edge, edge))], cell=edge / cells)
        distance = np.sort(np.abs(cube.vibration(E, NU, RHO, count=20).frequency / exact - 1))
        error.append(distance[:3].max())  # one for each pair of axes
    # quadratic elements: (k h)⁴/1440 along each of two axes, k = π/a
    assert error[1] == pytest.approx(2 * (math.pi / 4) ** 4 / 1440, rel=1.0)
    assert error[0] / error[1] > 8.0


@pytest.mark.validate
def test_a_free_beam_swings_as_thin_bars_do(beam):
    found = beam.vibration(E, NU, RHO, count=6).frequency
    theory = bar()
    section = theory.section
    assert found[0] == pytest.approx(found[1], rel=1e-6)
    assert found[0] == pytest.approx(_free_bending(theory), rel=2e-3)
    torsion = math.sqrt(theory.G * section.torsion_constant / (RHO * section.polar_moment)) / (2 * theory.length)
    # warping inertia lowers it by some (π b/L)²/100
    assert found[2] == pytest.approx(torsion, rel=3e-3)
    # Rayleigh: lateral inertia lowers it by ν² π² I_p / (2 S L²) = 0.04 %
    axial = theory.wave_speed / (2 * theory.length)
    assert found[5] == pytest.approx(axial, rel=1e-3)
    assert found[5] < axial


def _free_bending(theory: Bar) -> float:
    """First bending frequency of Timoshenko's free bar [Hz]: between two free ends M = Q = 0."""
    from scipy.linalg import expm
    from scipy.optimize import brentq

    section, length = theory.section, theory.length
    shear = theory.EI / (theory.kGS * length**2)
    rotary = section.rotary_moment / (section.area * length**2)

    def ends(beta: float) -> float:
        w = beta**4
        A = np.array([[0, 1, 0, shear], [0, 0, 1, 0], [0, -rotary * w, 0, -1], [-w, 0, 0, 0]])
        return float(np.linalg.det(expm(A)[2:, :2]))

    beta = brentq(ends, 4.0, 4.75)
    return beta**2 / (2 * math.pi * length**2) * math.sqrt(theory.EI / (RHO * section.area))


@pytest.mark.validate
def test_without_lateral_strain_a_clamped_bar_is_exact():
    beam = Continuum.box(BEAM, cell=2.5e-3)
    theory = bar(0.0)
    loads = [((1e3, 0, 0), (0, 0, 0)), ((0, 1e3, 0), (0, 0, 0)), ((0, 0, 0), (0, 0, 1.0))]
    pulled, bent, turned = beam.response(E, 0.0, held="x_min", loaded="x_max", loads=loads)
    # tension and pure bending are in the space of the elements
    assert pulled[0] == pytest.approx(theory.extension(1e3), rel=1e-9)
    assert turned[5] == pytest.approx(theory.length / theory.EI, rel=1e-9)
    assert turned[1] == pytest.approx(theory.length**2 / (2 * theory.EI), rel=1e-9)
    # shear is 1 % of the deflection, and the ends change it by a few percent of that
    assert bent[1] == pytest.approx(theory.deflection(1e3, shear=True), rel=1e-3)
    # Maxwell and Betti: what a force does to the rotation, a moment does to the displacement
    assert bent[5] / 1e3 == pytest.approx(turned[1], rel=1e-9)


@pytest.mark.validate
def test_poissons_ratio_and_the_ends_change_little_of_a_long_beam(beam):
    theory = bar()
    loads = [((1e3, 0, 0), (0, 0, 0)), ((0, 1e3, 0), (0, 0, 0)), ((0, 0, 0), (1.0, 0, 0))]
    pulled, bent, twisted = beam.response(E, NU, held="x_min", loaded="x_max", loads=loads)
    # a held end acts over about a width: ν² b/L of the extension, a share of b/L of the rest
    assert pulled[0] == pytest.approx(theory.extension(1e3), rel=NU**2 * BEAM[1] / BEAM[0])
    assert bent[1] == pytest.approx(theory.deflection(1e3, shear=True), rel=6e-3)
    assert twisted[3] == pytest.approx(theory.twist(1.0), rel=0.02)


def test_a_lever_is_a_rigid_end():
    short, lever = Continuum.box((30e-3, 5e-3, 5e-3), cell=2.5e-3), 10e-3
    (moved,) = short.response(
        E, 0.0, held="x_min", loaded="x_max", loads=[((0, 1e3, 0), (0, 0, 0))], lever=(lever, 0, 0)
    )
    L, theory = 30e-3, Bar(30e-3, bar().section, E, 0.0)
    turn = 1e3 * (L**2 / 2 + lever * L) / theory.EI
    assert moved[5] == pytest.approx(turn, rel=2e-3)
    assert moved[1] == pytest.approx(theory.deflection(1e3, overhang=lever, shear=True) + lever * turn, rel=2e-3)


@pytest.mark.validate
def test_the_bracket_converges():
    coarse, fine = (Continuum.bracket(cell=cell) for cell in (4e-3, 2.67e-3))
    assert coarse.volume == pytest.approx(12e-3 * 8e-3 * (40e-3 + 22e-3), rel=1e-12)
    assert len(coarse.basis.mesh.boundary_facets()) > 0
    f = [body.vibration(E, NU, RHO, count=3).frequency for body in (coarse, fine)]
    assert f[0] == pytest.approx(f[1], rel=2e-3)
    assert (f[0] >= f[1]).all()  # Rayleigh: a coarser mesh is stiffer
    mass = fine.mass.sum() / 3.0 * RHO
    assert mass == pytest.approx(5952e-9 * RHO, rel=1e-12)


@pytest.mark.validate
def test_modes_are_read_at_points(beam):
    modes = beam.vibration(E, NU, RHO, count=6)
    points = np.random.default_rng(0).random((400, 3)) * BEAM
    at = beam.sampler(points)(modes.shape)
    assert at.shape == (6, 400, 3)
    # the axial mode is cos(πx/L) along x
    wave = np.cos(np.pi * points[:, 0] / BEAM[0])
    assert abs(np.corrcoef(at[5, :, 0], wave)[0, 1]) > 0.9999
    assert np.abs(at[5, :, 1:]).max() < 0.1 * np.abs(at[5, :, 0]).max()
    # unit modal mass for ρ = 1: ⟨|φ|²⟩ V = 1, to the scatter of 400 points
    assert (at**2).sum(axis=2).mean(axis=1) * np.prod(BEAM) == pytest.approx(np.ones(6), rel=0.15)


@pytest.mark.validate
def test_a_body_between_planes_is_the_part_of_it():
    inside, units = 0.5e-3, [((1.0, 0.0, 0.0), (0.0, 0.0, 0.0)), ((0.0, 1.0, 0.0), (0.0, 0.0, 0.0))]
    whole = Continuum.box(BEAM, cell=2.5e-3)
    part = whole.between(inside, "x_min", "x_max")
    plain = Continuum.of([((inside, 0, 0), (BEAM[0] - inside, *BEAM[1:]))], cell=2.5e-3,
                         refined=((inside, BEAM[0] - inside), (), ()))  # fmt: skip
    assert part.volume == pytest.approx(plain.volume, rel=1e-12)
    one, other = (body.response(E, NU, held="x_min", loaded="x_max", loads=units) for body in (part, plain))
    # the meshes differ a little
    assert np.diag(one) == pytest.approx(np.diag(other), rel=1e-3)
    # and nothing moves but the ends
    middle = np.abs(whole.basis.mesh.p[0] - 0.5 * BEAM[0]) <= 0.25 * BEAM[0]
    np.testing.assert_array_equal(whole.basis.mesh.p[:, middle], part.basis.mesh.p[:, middle])
