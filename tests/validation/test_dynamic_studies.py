"""Dynamic studies of the cylinder: their tests against closed forms of chains, and what the commands leave."""

import json
import math

import numpy as np
import pytest
from click.testing import CliRunner

import bondem as bd
from bondem.errors import InputError
from bondem.labtests.beam_tests import Bar, CrossSection
from bondem.labtests.cantilever import mass_gyration
from bondem.labtests.wave import first_passage, strike
from tests.specimens import chain, loose, spheres
from validation.__main__ import validation
from validation.frame.files import plain, thinned
from validation.measures.effective_section import SectionRadii, implied_radius, section_profile
from validation.measures.explicit_tension import explicit_tension
from validation.measures.inertia import inertia_excess, stiffness_effect
from validation.measures.ramped_vibration import ramped_vibration
from validation.studies.wave import WaveStudy

R = 0.5e-3  # m, of the spheres of chains

E, NU, RHO = 70e9, 0.2, 2200.0
LAW = bd.EulerBernoulli(E=E, nu=NU, radius_ratio=1.0)
# what a chain of touching spheres needs to weigh as much as the cylinder around it
DENSITY = 1.5 * RHO


@pytest.fixture(scope="module")
def specimen() -> bd.Lattice:
    return spheres(bd.Cylinder(radius=2.5e-3, length=15e-3), 900, seed=3)


# --- slow tension -----------------------------------------------------------------------------------------


def test_a_slow_explicit_test_comes_to_the_static_modulus():
    lattice = chain(30)
    run = explicit_tension(lattice, LAW, density=DENSITY, steps=40_000)
    assert run.steps == 40_000
    assert abs(run.E / E - 1.0) < 1e-4
    assert run.nu == pytest.approx(0.0, abs=1e-9)
    # F² / 2k of 29 bonds in a row
    force = run.stress * math.pi * R**2
    assert run.elastic[-1] == pytest.approx(0.5 * force**2 * 29 * 2.0 * R / (E * math.pi * R**2), rel=1e-3)
    # stretched evenly, a bar has ρ S L³ ε̇² / 24; the spheres reach half a step less far at both ends
    length, speed = 29 * 2.0 * R, math.sqrt(E / RHO)
    growing = (run.time > 0.2 * run.ramp) & (run.time < run.ramp)
    share = (length / (speed * run.ramp)) ** 2 / 12.0
    assert run.kinetic[growing].mean() / run.elastic[-1] == pytest.approx(share, rel=0.15)
    assert run.kinetic[-1] < 1e-2 * run.kinetic[growing].mean()


def test_a_slow_test_refuses_what_is_not_slow():
    with pytest.raises(InputError, match="steps = 10"):
        explicit_tension(chain(30), LAW, density=DENSITY, steps=10)
    with pytest.raises(InputError, match=r"ramp = 1\.0"):
        explicit_tension(chain(30), LAW, density=DENSITY, ramp=1.0)
    with pytest.raises(InputError, match="ramp"):
        ramped_vibration(chain(10), LAW, density=DENSITY, ramp=0.0)


# --- vibration and inertia --------------------------------------------------------------------------------


def test_a_bar_let_go_swings_at_its_frequencies_and_keeps_its_energy():
    lattice = chain(12)
    run = ramped_vibration(lattice, LAW, density=DENSITY, steps=12_000)
    modes = bd.labtests.natural_frequencies(lattice, LAW, density=DENSITY, count=20)
    for kind in ("tension", "bending", "torsion"):
        assert run.frequency(kind) == pytest.approx(getattr(modes, kind), rel=2e-3), kind
    energy, free = run.energy, run.free
    assert run.time[free][0] == pytest.approx(run.released)
    total = sum(energy[name] for name in ("translation", "rotation", "normal", "shear", "bending", "twisting"))
    # what the loads did is what is there, and work ends with them
    assert np.ptp(energy["work"][free]) == 0.0
    assert total[free].mean() == pytest.approx(energy["work"][-1], rel=0.02)
    assert (np.diff(run.time) > 0.0).all()
    assert run.energy_error < 0.05
    # twisting a chain turns its spheres and moves none, so all of that motion is rotation
    assert 0.0 < energy["rotation"][free].sum() < energy["translation"][free].sum()


def test_what_the_ledger_misses_when_loads_go_is_of_second_order(specimen):
    law = bd.EulerBernoulli(E=E, nu=0.3, radius_ratio=0.7)
    coarse, fine = (
        ramped_vibration(specimen, law, density=3000.0, steps=round(1800 / safety), safety=safety)
        for safety in (0.9, 0.45)
    )
    assert coarse.time[-1] == pytest.approx(fine.time[-1], rel=1e-3)
    assert coarse.energy_error < 2e-3
    assert coarse.energy_error / fine.energy_error == pytest.approx(4.0, rel=0.15)


def test_moments_of_a_chain():
    n = 20
    found = inertia_excess(chain(n), density=DENSITY, rho=RHO)
    whole = RHO * math.pi * R**2 * 2.0 * R * n
    assert found.mass == pytest.approx(whole)
    assert found.mass_excess == pytest.approx(0.0, abs=1e-12)
    # 2/5 against 1/2
    assert found.axial_excess == pytest.approx(-0.2)
    assert found.own_share == pytest.approx(1.0)
    assert found.frequency["torsion"] == pytest.approx(0.1, rel=1e-5)
    # midpoints sum sin² exactly
    assert found.frequency["tension"] == pytest.approx(0.0, abs=1e-6)
    length = 2.0 * R * n
    lateral = (2.0 * R) ** 2 * (n * n - 1) / 12.0 + 0.4 * R * R
    assert found.lateral_excess == pytest.approx(lateral / ((3.0 * R * R + length**2) / 12.0) - 1.0)
    # and in the mode of bending to second order in the step
    assert abs(found.frequency["bending"]) < 2e-3
    lone = loose(np.zeros((1, 3)), R)
    with pytest.raises(InputError, match="Cylinder"):
        inertia_excess(lone, density=1.0, rho=1.0)


# --- waves ------------------------------------------------------------------------------------------------


def test_a_strike_that_is_let_be_keeps_its_momentum(specimen):
    law = bd.EulerBernoulli(E=E, nu=0.3, radius_ratio=0.7)
    found = strike(specimen, law, density=3000.0, duration=5e-6, velocity=0.2, held=False, slices=10,
                   moments=(0.0, 2e-6, 4e-6))  # fmt: skip
    mass = specimen.particles.volume
    begun, *later = (mass @ velocity for _, velocity in found.snapshots)
    struck = bd.Face("x_max").select(specimen)
    assert begun[0] == pytest.approx(-0.2 * mass[struck].sum())
    for momentum in later:
        np.testing.assert_allclose(momentum, begun, atol=1e-9 * abs(begun[0]))
    step = found.time[1]
    for (moment, _), wanted in zip(found.snapshots, (0.0, 2e-6, 4e-6), strict=True):
        assert moment == pytest.approx(wanted, abs=0.51 * step)
    assert found.sections.shape == (len(found.time), 10)
    assert found.near[0] == pytest.approx(0.2)
    # the wave has not been everywhere: it is where it can have been
    assert np.nanmax(np.abs(found.sections[10, :5])) < 1e-3 * np.nanmax(found.sections[10])


def test_a_face_that_is_held_keeps_its_velocity_and_first_passage_is_between_samples():
    found = strike(chain(20), LAW, density=DENSITY, duration=1e-5, velocity=0.1)
    np.testing.assert_allclose(found.near, 0.1)
    assert found.sections.shape == (len(found.time), 0)
    assert found.snapshots == ()
    time, signal = np.arange(5.0), np.array([0.0, 0.0, 1.0, 3.0, 2.0])
    assert first_passage(time, signal, 2.0) == pytest.approx(2.5)
    with pytest.raises(InputError, match="largest value 3 is below"):
        first_passage(time, signal, 4.0)


# --- section ----------------------------------------------------------------------------------------------


def test_the_profile_of_stress_holds_the_whole_force_and_its_gyration(specimen):
    law = bd.EulerBernoulli(E=E, nu=0.3, radius_ratio=0.7)
    tension = bd.labtests.static_tension(specimen, law)
    profile = section_profile(bd.Model(specimen, law, 1000.0), tension.solution, annuli=50)
    assert profile.carried[-1] == pytest.approx(1.0)
    area = np.diff(profile.edge**2)
    second = (profile.stress * area * profile.middle**2).sum() / area.sum()
    assert second == pytest.approx(tension.gyration.sum(), rel=0.03)
    solid = (profile.solid * area).sum() / area.sum()
    # away from the ends it is a little denser than the whole
    assert solid == pytest.approx(bd.fabric(specimen).volume_fraction, rel=0.08)
    radii = SectionRadii.of(specimen, force=tension.gyration, mass=mass_gyration(specimen))
    assert radii.centres < radii.force < radii.mass < radii.walls
    assert radii.paper == pytest.approx(radii.walls, rel=0.02)


def test_a_chain_carries_everything_on_its_axis():
    lattice = chain(40)
    tension = bd.labtests.static_tension(lattice, LAW)
    profile = section_profile(bd.Model(lattice, LAW, 1000.0), tension.solution, annuli=10)
    np.testing.assert_allclose(profile.carried[1:], 1.0)
    assert profile.stress[0] == pytest.approx(100.0)


def test_the_effective_section_of_the_paper_is_what_its_two_errors_ask_for():
    # f ∝ R: the radius that was found takes the one printed error to the other
    for sign, side in ((-1.0, "below"), (1.0, "above")):
        ratio = implied_radius(0.0663, 0.018)[side]
        assert 0.9 < ratio < 1.0
        assert (1.0 - 0.0663) / ratio == pytest.approx(1.0 + sign * 0.018)


# --- commands ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("study", "options", "figures"),
    [
        pytest.param("quasistatic", ("--steps", "3000"), 3, marks=pytest.mark.validate),
        pytest.param("vibration", ("--steps", "3000", "--packings", "2"), 3, marks=pytest.mark.validate),
        pytest.param("wave", ("--packings", "2"), 4, marks=pytest.mark.validate),
        pytest.param("section", ("--packings", "2"), 2, marks=pytest.mark.validate),
    ],
)
def test_commands_leave_results_tables_figures_and_a_page(study, options, figures, tmp_path):
    out = tmp_path / "out"
    done = CliRunner().invoke(validation, [study, "--out", str(out), "--count", "1000", *options])
    assert done.exit_code == 0, done.output
    results = json.loads((out / "results.json").read_text())
    assert results["study"] == study
    assert results["macro"]["E"] == pytest.approx(72.5e9, rel=2e-3)
    assert results["specimen"]["elements"] == 1000
    assert len(list((out / "figures").glob("*.png"))) == figures
    assert "nan" not in (out / "table.md").read_text()
    _CHECKS[study](results)


def _quasistatic(results):
    assert [one["steps"] for one in results["explicit"]] == [3000]
    for shares in (results["energy"]["shares"], results["energy"]["shares_static"]):
        assert shares["paper_tension"] + shares["paper_bending"] + shares["paper_torsion"] == pytest.approx(1.0)
    # a run this short swings, but every part with the whole
    for part, share in results["energy"]["shares_static"].items():
        assert results["energy"]["shares"][part] == pytest.approx(share, abs=0.02)
    assert results["energy"]["shares_static"]["paper_torsion"] < 0.03


def _vibration(results):
    assert results["run"]["energy_error"] < 0.01
    assert results["rows"][0]["mass_excess"] == pytest.approx(0.0, abs=1e-9)
    one = results["summary"]
    assert one["axial_excess"]["mean"] < -0.03
    assert one["frequency"]["torsion"]["mass"]["mean"] > 0.01
    assert abs(one["frequency"]["tension"]["mass"]["mean"]) < 0.005
    shares = [one["frequency"][kind]["rotational_share"]["mean"] for kind in ("tension", "bending", "torsion")]
    assert shares[0] < shares[1] < shares[2] < 0.05


def _wave(results):
    for way in ("held", "free"):
        celerity = [one["mean"] for one in results["summary"][way]["celerity"]]
        assert celerity == sorted(celerity, reverse=True)
    assert abs(results["summary"]["error"]["mean"]) < 0.06
    assert results["rows"][0]["held"]["reference"] == pytest.approx(0.2, rel=0.05)


def _section(results):
    one = results["summary"]
    radius = {name: value["mean"] for name, value in one["radius"].items()}
    assert radius["centres"] < radius["force"] < radius["walls"]
    # a smaller section swings slower in theory: the error goes up by the ratio of the radii, but that bending is
    # about one axis and the radius the mean of two, which differ in so coarse a section
    before, after = (one["error"][name]["bending_frequency"]["mean"] for name in ("walls", "force"))
    assert (1.0 + after) / (1.0 + before) == pytest.approx(radius["walls"] / radius["force"], rel=2e-2)
    assert radius["walls"] / radius["force"] > 1.03
    # the hull of the centres in place of the walls, E and ρ kept: f ∝ R, deflections and twists 1/R⁴, torsional
    # frequencies not at all
    smaller = radius["centres"] / radius["walls"]
    assert smaller < 0.9
    for row in results["rows"]:
        hull = row["radius"]["centres"] / row["radius"]["walls"]
        walls, effective, gyration = (row["errors"][name] for name in ("walls", "effective", "centres"))
        for test, power in (("bending_frequency", -1), ("static_bending", 4), ("static_torsion", 4),
                            ("torsional_frequency", 0)):  # fmt: skip
            assert (1.0 + effective[test]) / (1.0 + walls[test]) == pytest.approx(hull**power), test
        # as measured, E S stays: one square less in statics, and the same bending frequency
        assert (1.0 + gyration["static_bending"]) / (1.0 + walls["static_bending"]) == pytest.approx(hull**2)
        assert gyration["bending_frequency"] == pytest.approx(effective["bending_frequency"])
    assert results["paper"]["bending_frequency"] == {"walls": 0.0663, "effective": 0.018, "force": 0.018}


_CHECKS = {"quasistatic": _quasistatic, "vibration": _vibration, "wave": _wave, "section": _section}


def test_results_are_plain():
    value = {"a": np.array([1.23456789, np.nan]), "b": (np.float64(2.0), np.int64(3)), "c": None, "d": "text"}
    assert plain(value) == {"a": [1.23456789, None], "b": [2.0, 3], "c": None, "d": "text"}
    assert len(thinned(np.arange(1001))) <= 300
    np.testing.assert_array_equal(thinned(np.arange(10)), np.arange(10))


def test_a_study_says_what_is_too_small():
    with pytest.raises(InputError, match="500"):
        WaveStudy(count=100)
    with pytest.raises(InputError, match="packings"):
        WaveStudy(packings=0)


def test_a_soft_skin_lowers_the_frequencies_as_the_bar_says():
    section = CrossSection.of(bd.Cylinder(5e-3, 0.4))
    bar = Bar(0.4, section, E=70e9, nu=0.2, rho=2500.0)
    gyration = np.full(2, section.second_moment / section.area)
    soft = Bar(0.4, section.filled(0.98 * gyration, gyration), E=70e9, nu=0.2, rho=2500.0)
    shift = stiffness_effect(bar, soft)
    # to first order in 2 %
    assert shift["bending"] == pytest.approx(soft.bending_frequency / bar.bending_frequency - 1.0, rel=0.02)
    assert shift["torsion"] == pytest.approx(soft.torsional_frequency / bar.torsional_frequency - 1.0, rel=0.02)
    assert shift["bending"] == pytest.approx(-0.01)
    assert shift["tension"] == 0.0
