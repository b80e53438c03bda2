"""Tests of specimens against closed forms: chains of elements are beams whose every number is known."""

import math

import numpy as np
import pytest
from scipy.linalg import eigh

import bondem as bd
from bondem.errors import EmptyRegionError, InputError, ShortSpecimenWarning
from bondem.labtests.beam_tests import Bar, CrossSection
from bondem.labtests.cantilever import Cantilever, mass_gyration
from bondem.labtests.faces import specimen_faces
from bondem.labtests.frequency import dominant_frequency
from bondem.labtests.gauge_length import AffineField, curvature, profile, rigid_motion, twist_rate
from bondem.labtests.tension import static_bond_forces
from bondem.statics.linear import Iteration, System
from tests.specimens import chain, spheres

E, NU, RHO = 70e9, 0.2, 2200.0
R = 0.5e-3


@pytest.fixture(scope="module")
def specimen() -> bd.Lattice:
    return spheres(bd.Cylinder(radius=2.5e-3, length=15e-3), 1200, seed=3)


LAW = bd.EulerBernoulli(E=E, nu=0.3, radius_ratio=0.7)


# --- least-squares measures -------------------------------------------------------------------------------


def test_affine_fit_is_exact_on_an_affine_field():
    rng = np.random.default_rng(0)
    x = rng.normal(size=(40, 3))
    gradient = rng.normal(size=(3, 3))
    u = 3.0 + x @ gradient.T
    field = AffineField.fit(x, u)
    np.testing.assert_allclose(field.gradient, gradient, atol=1e-12)
    strained = (x - x.mean(axis=0)) @ field.strain.T
    np.testing.assert_allclose(field.without_rigid_motion(x, u), strained, atol=1e-12)


def test_curvature_and_twist_rate_are_exact_on_saint_venant_fields():
    rng = np.random.default_rng(1)
    x, y, z = position = rng.uniform(-1.0, 1.0, size=(3, 200))
    # u_x = -y θ with θ = 0.3 + 0.2 x - 0.1 x², so θ' = 0.2 - 0.2 x
    bent = np.stack([-y * (0.3 + 0.2 * x - 0.1 * x**2), 0 * x, 0 * x], axis=1)
    assert curvature(position.T, bent, 0.4) == pytest.approx(0.2 - 0.2 * 0.4, abs=1e-12)
    turn = 0.7 + 0.25 * x
    twisted = np.stack([0 * x, 2.0 - turn * z, -1.0 + turn * y], axis=1)
    assert twist_rate(position.T, twisted) == pytest.approx(0.25, abs=1e-12)


def test_rigid_motion_is_found_and_follows_the_sections():
    rng = np.random.default_rng(2)
    position = rng.uniform(size=(400, 3))
    turn = np.array([0.1, -0.2, 0.3])
    u = np.array([1.0, 2.0, 3.0]) + np.cross(turn, position - position.mean(axis=0))
    np.testing.assert_allclose(rigid_motion(position, u), [1.0, 2.0, 3.0, *turn], atol=1e-12)
    x, motion = profile(position, u, slices=5)
    assert x.shape == (5,)
    np.testing.assert_allclose(motion[:, 3:], np.tile(turn, (5, 1)), atol=1e-12)


# --- tension of a free specimen ---------------------------------------------------------------------------


def test_tension_of_a_chain_is_the_modulus_of_its_bonds():
    lattice = chain(40)
    tension = bd.labtests.static_tension(lattice, bd.EulerBernoulli(E=E, nu=NU, radius_ratio=0.6))
    # the bonds fill 0.36 of the section
    assert pytest.approx(0.36 * E, rel=1e-9) == tension.E
    # eqs (12), (14): L_M counts two half spheres that do not stretch, R_M = R̄ + 0
    assert pytest.approx(0.36 * E * 40 / 39, rel=1e-9) == tension.E_paper
    assert specimen_faces(lattice).paper_length == pytest.approx(lattice.particles.shape.length)


def test_tension_is_linear_in_the_bond_modulus_and_blind_to_the_load(specimen):
    first = bd.labtests.static_tension(specimen, LAW)
    other = bd.labtests.static_tension(specimen, bd.EulerBernoulli(E=3 * E, nu=0.3, radius_ratio=0.7), stress=5e4)
    assert pytest.approx(3 * first.E, rel=1e-7) == other.E
    assert other.nu == pytest.approx(first.nu, rel=1e-6)
    assert other.nu_paper == pytest.approx(first.nu_paper, rel=1e-6)
    assert 0.0 < first.nu < 0.3
    assert first.nu_paper < first.nu  # eq (15) is biased low, see physics.md


def test_tension_equals_the_energy_of_a_uniform_bar(specimen):
    # Clapeyron: F ΔL / 2 is the stored energy, and ΔL is what eq (14) divides by
    tension = bd.labtests.static_tension(specimen, LAW)
    force = tension.stress * specimen.particles.shape.section()
    radius = 2.5e-3  # R_M of eq (13), to a percent
    stretch = force / (math.pi * radius**2) / tension.E_paper * specimen_faces(specimen).paper_length
    assert tension.solution.energy.total == pytest.approx(0.5 * force * stretch, rel=0.02)


def test_bond_forces_carry_the_load_through_every_section(specimen):
    tension = bd.labtests.static_tension(specimen, LAW)
    force = tension.stress * specimen.particles.shape.section()
    f = static_bond_forces(bd.Model(specimen, LAW, 1000.0), tension.solution)
    x = specimen.particles.position[:, 0]
    i, j = specimen.pairs.T
    for cut in (4e-3, 7.5e-3, 11e-3):
        crossing = (x[i] < cut) != (x[j] < cut)
        through = f[crossing] * np.sign(x[j] - x[i])[crossing, None]
        np.testing.assert_allclose(through.sum(axis=0), [force, 0.0, 0.0], atol=1e-6 * force)


def test_a_free_specimen_is_solved_far_below_the_tolerance(specimen):
    # rigid motion that rounding leaves in a residual must not grow: at 1e-10 it once stopped one solve in fifty
    model = bd.Model(
        specimen,
        LAW,
        1000.0,
        boundary=[bd.Load(bd.Face("x_max"), force=(1, 0, 0)), bd.Load(bd.Face("x_min"), force=(-1, 0, 0))],
    )
    system = System.of(model)
    load = model.constraints.final_load(len(specimen.particles)).ravel()
    u = Iteration(system).solve(load, rtol=1e-12)[0]
    rest = load - system.matrix @ u
    assert np.linalg.norm(rest) <= 1e-9 * np.linalg.norm(load)


def test_a_rattler_changes_nothing(specimen):
    particles = specimen.particles
    tension = bd.labtests.static_tension(specimen, LAW)
    # a loose small sphere in mid-air beside the face, where there is no bond to it
    radius = particles.radius.mean()
    more = bd.Particles(
        np.vstack([particles.position, [[7.5e-3, 20e-3, 0.0]]]), np.append(particles.radius, radius),
        shape=particles.shape,
    )  # fmt: skip
    again = bd.labtests.static_tension(bd.Lattice(more, specimen.pairs), LAW)
    assert pytest.approx(tension.E, rel=1e-6) == again.E
    assert again.nu == pytest.approx(tension.nu, rel=1e-6)


def test_a_box_has_no_side_and_a_ball_no_faces():
    box = spheres(bd.Box(size=(12e-3, 4e-3, 5e-3)), 600, seed=1)
    tension = bd.labtests.static_tension(box, LAW)
    assert tension.nu_paper is None
    assert tension.E > 0.0
    ball = spheres(bd.Ball(radius=3e-3), 300, seed=1)
    with pytest.raises((InputError, EmptyRegionError)):
        bd.labtests.static_tension(ball, LAW)
    with pytest.raises(InputError, match="not a bar along x"):
        CrossSection.of(bd.Ball(radius=3e-3))


def test_a_specimen_too_short_to_measure_says_so():
    with pytest.raises(InputError, match="each end has all elements"):
        bd.labtests.static_tension(chain(40), LAW, depth=100.0)
    with pytest.raises(InputError, match="middle half"):
        bd.labtests.static_tension(chain(6), LAW)


def test_a_tension_test_of_a_disc_gives_a_warning():
    disc = spheres(bd.Cylinder(radius=3e-3, length=3e-3), 400, seed=1)
    with pytest.warns(ShortSpecimenWarning, match=r"0\.003 m long along x and 0\.006 m wide.*bd\.bulk_moduli"):
        bd.labtests.static_tension(disc, LAW)


# --- clamped specimens ------------------------------------------------------------------------------------


def test_a_clamped_chain_is_the_refined_bar():
    # ν near ½ makes Cowper's shear coefficient that of the bond, 9/10
    law = bd.Timoshenko(E=E, nu=0.49, radius_ratio=1.0)
    lattice = chain(40)
    tension = bd.labtests.clamped_tension(lattice, law, E=E, nu=0.49)
    assert tension.error_refined == pytest.approx(0.0, abs=1e-9)
    # wall to wall is 40 diameters, centre to centre 39
    assert tension.error == pytest.approx(39 / 40 - 1, abs=1e-9)
    assert tension.curves["gauge_error"] == pytest.approx(0.0, abs=1e-9)
    bending = bd.labtests.static_bending(lattice, law, E=E, nu=0.49)
    assert bending.error_refined == pytest.approx(0.0, abs=1e-6)
    assert bending.error_timoshenko < -0.02


def test_a_packed_specimen_bends_and_twists_as_its_section_says(specimen):
    tension = bd.labtests.static_tension(specimen, LAW)
    options = {"E": tension.E, "nu": tension.nu, "gyration": tension.gyration}
    for test in (bd.labtests.clamped_tension, bd.labtests.static_bending, bd.labtests.static_torsion):
        outcome = test(specimen, LAW, **options)
        assert abs(outcome.error_refined) < 0.08, outcome.name
        assert abs(outcome.error) < 0.25, outcome.name
        assert outcome.curves["x"].shape == outcome.curves["profile"].shape


@pytest.mark.validate
def test_the_axial_force_leaves_the_skin():
    # walls leave gaps beside them, so force and mass sit nearer to the axis than in a full disc, R²/4
    full = 0.25 * 2.5e-3**2
    ratio = []
    for seed in range(4):
        shape = bd.Cylinder(radius=2.5e-3, length=15e-3)
        packed = bd.connect(bd.pack(shape, count=1200, spread=0.25, seed=seed))
        force, mass = bd.labtests.static_tension(packed, LAW).gyration, mass_gyration(packed)
        assert (force > 0.7 * full).all()
        assert (force < full).all()
        assert (mass < full).all()
        ratio.append(force / mass)
    # one packing of 1200 may differ by 3 %, the mean over four and both axes by 1 %
    assert 0.9 < np.mean(ratio) < 0.99


# --- strength of materials --------------------------------------------------------------------------------


def cantilever(length: float, radius: float = 1.0) -> Bar:
    section = CrossSection.of(bd.Cylinder(radius=radius, length=length))
    return Bar(length, section, 70e9, 0.2, 2500.0)


@pytest.mark.parametrize("slenderness", [2.0, 8.0, 30.0])
def test_timoshenko_frequency_against_ritz(slenderness):
    # Rayleigh quotient of v = Σ a ξ^k, θ = Σ b ξ^k: an upper bound that converges exponentially
    bar = cantilever(slenderness)
    L, count = bar.length, 9
    xi, weight = np.polynomial.legendre.leggauss(40)
    xi, weight = 0.5 * (xi + 1.0), 0.5 * weight * L
    power = np.arange(1, count + 1)
    f, df = xi[:, None] ** power, power * xi[:, None] ** (power - 1) / L
    zero = np.zeros_like(f)
    bend, slide = np.hstack([zero, df]), np.hstack([df, -f])
    K = bend.T @ (weight[:, None] * bend) * bar.EI + slide.T @ (weight[:, None] * slide) * bar.kGS
    v, turn = np.hstack([f, zero]), np.hstack([zero, f])
    M = bar.rho * (
        v.T @ (weight[:, None] * v) * bar.section.area + turn.T @ (weight[:, None] * turn) * bar.section.rotary_moment
    )
    exact = math.sqrt(eigh(K, M, eigvals_only=True)[0]) / (2.0 * math.pi)
    assert bar.bending_frequency_timoshenko == pytest.approx(exact, rel=1e-6)


def test_slender_bars_need_no_shear():
    bar = cantilever(5000.0)
    assert bar.bending_frequency_timoshenko == pytest.approx(bar.bending_frequency, rel=1e-5)
    assert bar.deflection(1.0, shear=True) == pytest.approx(bar.deflection(1.0), rel=1e-5)


def test_sections():
    # J of a square is 0.1406 a⁴, of a long strip b t³ / 3 (1 - 0.63 t/b): Timoshenko and Goodier §109
    square = CrossSection.of(bd.Box(size=(9.0, 1.0, 1.0)))
    assert square.torsion_constant == pytest.approx(0.140577, rel=1e-5)
    strip = CrossSection.of(bd.Box(size=(9.0, 10.0, 1.0)))
    assert strip.torsion_constant == pytest.approx(10.0 / 3.0 * (1.0 - 0.0630), rel=1e-4)
    assert strip.second_moment == pytest.approx(1000.0 / 12.0)
    assert strip.polar_moment == pytest.approx(1010.0 / 12.0)


# --- vibration --------------------------------------------------------------------------------------------


@pytest.mark.parametrize("periods", [1.7, 3.0, 7.3])
def test_a_pure_tone_is_found_in_a_few_periods(periods):
    time = np.linspace(0.0, periods / 1234.0, 400)
    signal = 3.0 + 0.1 * np.cos(2.0 * np.pi * 1234.0 * time + 0.4)
    assert dominant_frequency(time, signal) == pytest.approx(1234.0, rel=1e-5)


def test_overtones_do_not_hide_the_tone():
    time = np.linspace(0.0, 3.0, 600)
    signal = np.cos(2.0 * np.pi * time) + 0.03 * np.cos(2.0 * np.pi * 6.27 * time)
    assert dominant_frequency(time, signal) == pytest.approx(1.0, rel=1e-4)
    with pytest.raises(InputError, match="samples"):
        dominant_frequency(time, np.ones_like(time))


def chain_frequency(stiffness: float, inertia: float, count: int) -> float:
    """First frequency of `count` equal moving masses behind a fixed one: ω = 2 √(k/m) sin(π / (4 N + 2))."""
    return 2.0 * math.sqrt(stiffness / inertia) * math.sin(math.pi / (4.0 * count + 2.0)) / (2.0 * math.pi)


def test_modes_and_free_vibration_of_a_chain():
    law = bd.EulerBernoulli(E=E, nu=NU, radius_ratio=1.0)
    lattice = chain(10)
    density = 1.5 * RHO  # a sphere has 2/3 of its cylinder
    mass = density * 4.0 / 3.0 * math.pi * R**3
    area, step = math.pi * R**2, 2.0 * R
    axial = chain_frequency(E * area / step, mass, 9)
    torsional = chain_frequency(law.G * 0.5 * math.pi * R**4 / step, 0.4 * mass * R**2, 9)
    modes = bd.labtests.natural_frequencies(lattice, law, density=density, count=30)
    assert modes.tension == pytest.approx(axial, rel=1e-6)
    assert modes.torsion == pytest.approx(torsional, rel=1e-6)
    # effective masses of all modes along an axis add up to the share of mass that moves
    assert (modes.mass_share.sum(axis=0) <= 1.0 + 1e-9).all()
    assert modes.mass_share[:, :3].sum(axis=0).min() > 0.8
    vibration = bd.labtests.free_vibration(lattice, law, density=density, E=E, nu=NU, rho=RHO)
    for kind in ("tension", "bending", "torsion"):
        # velocity Verlet shifts frequencies by (ω dt)²/24
        assert vibration.frequency(kind) == pytest.approx(getattr(modes, kind), rel=1e-3), kind
    # the energy error of Verlet at 0.9 of the critical step, bounded
    assert vibration.energy_error < 0.05
    options = {"density": density, "E": E, "nu": NU, "rho": RHO, "modes": modes, "vibration": vibration}
    tension = bd.labtests.dynamic_tension(lattice, law, **options)
    # the refined bar ends half a step behind the last mass: the chain to second order
    assert tension.error_refined == pytest.approx(0.0, abs=2e-3)
    assert tension.curves["free_vibration"] == pytest.approx(axial, rel=1e-3)
    bending = bd.labtests.dynamic_bending(lattice, law, **options)
    assert bending.theory_timoshenko < bending.theory
    assert abs(bending.error_refined) < 0.03


def test_a_wave_runs_down_a_chain():
    law = bd.EulerBernoulli(E=E, nu=NU, radius_ratio=1.0)
    lattice = chain(150)
    outcome = bd.labtests.impact(lattice, law, density=1.5 * RHO, E=E, nu=NU, rho=RHO)
    assert outcome.theory == pytest.approx(math.sqrt(E / RHO))
    assert outcome.curves["plateau"] == pytest.approx(0.2, rel=0.02)
    # dispersion of the lattice delays the half of the front by about 0.5 (L / a)^(1/3) steps, 2 %
    assert outcome.error_refined == pytest.approx(0.0, abs=0.02)
    with pytest.raises(InputError, match="far face moves"):
        bd.labtests.impact(lattice, law, density=1.5 * RHO, E=100 * E, nu=NU, rho=RHO)


def test_the_lengths_of_a_cantilever():
    bar = Cantilever.of(chain(10), E=E, nu=NU)
    step = 2.0 * R
    assert bar.paper.length == pytest.approx(10 * step)
    assert bar.refined.length == pytest.approx(9 * step)
    assert bar.moving.length == pytest.approx(9.5 * step)
    assert bar.overhang == pytest.approx(0.5 * step)


def test_cells_give_back_the_moduli_that_were_entered():
    packed = bd.pack(bd.Cylinder(radius=5e-3, length=40e-3), count=400, spread=0.25, seed=1)
    body = bd.connect(packed, method="laguerre")
    pulled = bd.labtests.static_tension(body, bd.CellBond(E=72.5e9, nu=0.17))
    assert (pulled.E, pulled.E_paper) == pytest.approx((72.5e9, 72.5e9), rel=1e-7)
    assert (pulled.nu, pulled.nu_paper) == pytest.approx((0.17, 0.17), rel=1e-7)
    anywhere = bd.labtests.uniform_stress(body, bd.CellBond(E=72.5e9, nu=0.17))
    assert (anywhere.E, anywhere.nu) == pytest.approx((72.5e9, 0.17), rel=1e-7)
