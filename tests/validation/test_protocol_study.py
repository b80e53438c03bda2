"""The paper's own protocol: slow explicit loads against closed forms of chains, its measures, and the command."""

import json
import math

import pytest
from click.testing import CliRunner

import bondem as bd
from bondem.labtests.beam_tests import Bar, CrossSection
from bondem.labtests.faces import specimen_faces
from tests.specimens import chain, spheres
from validation.__main__ import validation
from validation.measures.ramped_loads import KINDS, ramped_load
from validation.rows.protocol import moduli, own_bonds

R = 0.5e-3  # m, of the spheres of chains

E, NU, RHO = 70e9, 0.2, 2200.0
LAW = bd.EulerBernoulli(E=E, nu=NU, radius_ratio=1.0)


@pytest.mark.parametrize("kind", KINDS[:2])
def test_a_slow_load_comes_to_the_closed_form_of_a_chain(kind):
    lattice = chain(9)
    bar = Bar(8 * 2.0 * R, CrossSection.of(lattice.particles.envelope), E, NU, RHO)
    run = ramped_load(lattice, LAW, bar, kind, density=1.5 * RHO, steps=20_000, ramp=0.5, phi=1.3)
    # the force acts at the face, a radius beyond the centre whose motion is told
    arm = bar.deflection(1.0, overhang=R) / bar.deflection(1.0) if kind == "bending" else 1.0
    assert run.held / run.theory == pytest.approx(arm, rel=1e-3)
    assert run.swing < 0.2
    assert run.error == pytest.approx(arm - 1.0, abs=1e-3)


def test_a_slow_moment_comes_to_the_static_solution():
    lattice = spheres(bd.Cylinder(radius=2.5e-3, length=10e-3), 500, seed=3)
    static = bd.labtests.static_torsion(lattice, LAW, E=E, nu=NU)
    bar = bd.labtests.cantilever.Cantilever.of(lattice, E=E, nu=NU).paper
    run = ramped_load(lattice, LAW, bar, "torsion", density=3000.0, steps=8_000, ramp=0.5, phi=1.3)
    assert run.error == pytest.approx(static.error, abs=2e-3)


def test_bonds_calibrated_by_a_measure_give_the_data_sheet_by_it():
    lattice = spheres(bd.Cylinder(radius=5e-3, length=40e-3), 700, seed=2)
    silica = bd.materials.fused_silica
    found = {}
    for measure in ("paper", "affine"):
        ratio, E_mu = found[measure] = own_bonds(lattice, measure)
        response = bd.calibration.response.Response(
            lattice, bd.EulerBernoulli(E=E_mu, nu=0.3, radius_ratio=ratio)
        )  # fmt: skip
        assert moduli(response, measure) == (pytest.approx(silica.E, rel=1e-4), pytest.approx(silica.nu, abs=1e-4))
    # two measures are two calibrations
    assert abs(found["paper"][0] - found["affine"][0]) > 0.005
    # the wall less the room between it and the outermost spheres, whose mean radius is not quite R̄
    assert specimen_faces(lattice).paper_radius == pytest.approx(5e-3, rel=0.02)


@pytest.mark.validate
def test_the_command_leaves_numbers_and_a_figure(tmp_path):
    out = tmp_path / "out"
    size = ["--count", "500", "--packings", "1", "--steps", "1500", "--methods", "quench"]  # shear takes minutes
    options = ["protocol", "--out", str(out), *size, "--processes", "1"]
    done = CliRunner().invoke(validation, options, catch_exceptions=False)
    assert done.exit_code == 0, done.output
    results = json.loads((out / "results.json").read_text())
    found = results["summary"]["quench"]
    assert all(math.isfinite(error["mean"]) for error in found["errors"].values())
    assert 0.3 < found["r_mu_ratio_paper"]["mean"] < 1.0
    assert (out / "figures" / "protocol_errors.png").stat().st_size > 10_000
