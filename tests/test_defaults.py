"""What is not said means the same in Python, in a study file and on the command line."""

import dataclasses
import inspect

import click
import pytest

import bondem as bd
from bondem.cli import bondem as root
from bondem.packing import METHOD, SEED
from bondem.packing.sizes import SPREAD
from bondem.study.abacus import Abacus
from bondem.study.assembly import Assembly
from bondem.study.calibrated_bar import BarRequest
from bondem.study.calibration import CalibrationPlan
from bondem.study.coverage import Coverage
from bondem.study.dispersion import Dispersion
from bondem.study.effective_section import SectionStudy
from bondem.study.influence import Influence
from bondem.study.packing_rows import TARGETS
from bondem.study.quasistatic import QuasiStatic
from bondem.study.refinement import Refinement
from bondem.study.specimen import SpecimenPlan
from bondem.study.study import BondPlan, Study, parse_study
from bondem.study.surface_study import SurfaceStudy
from bondem.study.vibration import Vibration
from bondem.study.wave import WaveStudy

# What of a command is of another name or form in Python.
PERCENT = {"kappa": "spread", "ramp": "ramp"}
NAMES = {"unseen": "held_out"}
NO_DEFAULT = {"out", "processes", "threads", "help", "material", "E", "nu", "rho"}
COMMANDS = {
    "calibrate": CalibrationPlan, "abacus": Abacus, "assembly": Assembly, "coverage": Coverage,
    "dispersion": Dispersion, "influence": Influence, "quasistatic": QuasiStatic, "refinement": Refinement,
    "section": SectionStudy, "surface": SurfaceStudy, "vibration": Vibration, "wave": WaveStudy,
}  # fmt: skip


def of_python(plan, name):
    """The default of an option of a plan; those of its bar are its bar's."""
    fields = {item.name: item.default for item in dataclasses.fields(plan)}
    bar = fields.get("bar")
    return getattr(bar, name) if bar is not None and name not in fields else fields[name]


def leaf(name):
    command = root.get_command(click.Context(root), "calibrate" if name == "calibrate" else "study")
    return command if name == "calibrate" else command.get_command(click.Context(command), name)


@pytest.mark.parametrize("name", COMMANDS)
def test_a_command_and_its_plan_have_the_same_defaults(name):
    plan, command, compared = COMMANDS[name], leaf(name), 0
    for option, given in command.make_context(name, ["--out", "nowhere"]).params.items():
        if option in NO_DEFAULT:
            continue
        key = NAMES.get(option, option)
        if key in PERCENT:
            given, key = given / 100.0, PERCENT[key]
        if key == "laws":
            given = given or Abacus.laws
        if key == "target" and plan is not Dispersion:
            given, key = TARGETS if given == "both" else (given,), "targets"
        assert given == of_python(plan, key), option
        compared += 1
    assert compared >= 3


def test_all_studies_are_compared():
    study = root.get_command(click.Context(root), "study")
    assert {*study.list_commands(click.Context(study)), "calibrate"} == set(COMMANDS)


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
    assert CalibrationPlan.seed == BarRequest.seed == Study.seed == SEED
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
