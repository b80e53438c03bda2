"""What is not said means the same in Python, in a study file and on the command line."""

import dataclasses
import inspect

import click
import pytest

import bondem as bd
from bondem.cli import bondem as root
from bondem.packing import METHOD, SEED
from bondem.packing.sizes import SPREAD
from bondem.study.bond_plan import BondPlan
from bondem.study.calibration_step import CalibrationPlan
from bondem.study.specimen_step import SpecimenPlan
from bondem.study.study_file import Study, parse_study
from validation.__main__ import NAMES, study_of
from validation.frame.command import command_of
from validation.studies.abacus import Abacus
from validation.studies.assembly import Assembly
from validation.studies.influence import Influence
from validation.studies.refinement import Refinement
from validation.studies.wave import WaveStudy

NO_DEFAULT = {"out", "processes", "threads", "help", "material", "E", "nu", "rho"}
STUDIES = {name: study for name in NAMES if (study := study_of(name)) is not None}


def test_the_command_and_its_plan_have_the_same_defaults():
    command = root.get_command(click.Context(root), "calibrate")
    given = command.make_context("calibrate", ["--out", "nowhere"]).params
    plan = {item.name: item.default for item in dataclasses.fields(CalibrationPlan)}
    plan |= {"kappa": 100.0 * plan["spread"]}
    compared = {name: value for name, value in given.items() if name not in NO_DEFAULT}
    assert len(compared) >= 3
    assert compared == {name: plan[name] for name in compared}


@pytest.mark.parametrize("name", STUDIES)
def test_the_command_of_a_study_is_made_from_its_fields(name):
    study = STUDIES[name]
    command = command_of(study)
    given = command.make_context(name, ["--out", "nowhere"]).params
    of_all = ("out", "processes", "threads", "address", "help")
    asked = {key: value for key, value in given.items() if key not in of_all}
    assert study(**asked) == study()
    assert len(asked) >= 3
    assert command.name == study.name == name
    assert all(option.help for option in command.params)
    assert "André" in command.help or len(command.help) > 40


def test_packings_have_the_same_defaults_everywhere():
    pack = {name: one.default for name, one in inspect.signature(bd.pack).parameters.items()}
    assert (pack["spread"], pack["method"], pack["seed"]) == (None, METHOD, SEED)
    said = bd.pack(bd.Ball(1e-2), count=150, spread=SPREAD, method=METHOD, seed=SEED)
    unsaid = bd.pack(bd.Ball(1e-2), count=150)
    assert (said.radius == unsaid.radius).all()
    assert (said.position == unsaid.position).all()
    bare = parse_study({"name": "s", "specimen": {"shape": "ball", "radius": 1e-2, "count": 150}})
    assert bare.specimen == SpecimenPlan(shape=bd.Ball(1e-2), count=150)
    assert (bare.specimen.sizes, bare.specimen.method, bare.seed) == (bd.Uniform(SPREAD), METHOD, SEED)
    assert bd.Uniform().spread == SPREAD
    for plan in (CalibrationPlan, Abacus, Assembly, Influence, Refinement):
        assert plan.spread == SPREAD
    assert CalibrationPlan.seed == WaveStudy.seed == Study.seed == SEED
    assert Refinement.method == METHOD


def test_bonds_have_the_same_defaults_everywhere():
    calibrate = {name: one.default for name, one in inspect.signature(bd.calibrate).parameters.items()}
    bare = parse_study({"name": "s", "specimen": {"shape": "ball", "radius": 1e-2, "count": 150}})
    assert bare.bond == BondPlan()
    assert (calibrate["law"], calibrate["nu_mu"]) == (BondPlan.law, BondPlan.nu_mu)
    assert (CalibrationPlan.law, CalibrationPlan.nu_mu) == (BondPlan.law, BondPlan.nu_mu)
    law = {item.name: item.default for item in dataclasses.fields(bd.EulerBernoulli)}
    assert BondPlan.radius_rule == law["radius_rule"]
    particles = bd.pack(bd.Ball(1e-2), count=150)
    planned = bd.connect(particles, tolerance=BondPlan.tolerance, reach=BondPlan.reach)
    assert (planned.pairs == bd.connect(particles).pairs).all()
