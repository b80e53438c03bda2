"""`bd.explain_step` names the passes that a run composes, in their order, and calls none."""

import pytest

import bondem as bd
from bondem._core import _library
from bondem.dynamics.core_loop import CoreLoop
from bondem.dynamics.explained_step import explain_step
from bondem.dynamics.plan import Plan
from bondem.interactions.step_part import FORCES, composed

ENDS = [bd.Fix(bd.Face("x_min")), bd.Drive(bd.Face("x_max"), vx=bd.Ramp(0.0, 2.0, 1e-4))]
TOUCH = bd.LinearContact(E=1e9, friction=0.4)
SOFT = bd.MohrCoulomb(tension=1e6, cohesion=3e6, friction_angle=0.6, fracture_energy=3e2)
WEAK = bd.Elliptic(elongation=1e-3, rotation=3e-3)
KINDS = {
    "beams": {},
    "breaking beams": {"failure": WEAK, "contact": TOUCH},
    "cells": {},
    "cracking cells": {"failure": SOFT, "contact": TOUCH},
    "non-local": {"failure": bd.Rankine(tension=1e6)},
}


@pytest.fixture(scope="module")
def models() -> dict[str, bd.Model]:
    packed = bd.pack(bd.Box(size=(1.0, 1.0, 1.0)), count=200, spread=0.3, seed=2)
    beams, cells = bd.connect(packed), bd.connect(packed, method="laguerre")
    laws = {
        "beams": (beams, bd.Timoshenko(E=1e9, nu=0.3, radius_ratio=0.7)),
        "cells": (cells, bd.CellBond(E=1e9, nu=0.3)),
        "non-local": (cells, bd.NonLocal(E=1e9, nu=0.2)),
    }
    return {
        kind: bd.Model(*laws[kind.split()[-1]], 2500.0, boundary=ENDS, **more) for kind, more in KINDS.items()
    }


@pytest.mark.parametrize("damping", [None, bd.BondDamping(1e-5)])
@pytest.mark.parametrize("kind", KINDS)
def test_passes_are_those_that_a_run_composes(models, kind, damping):
    if kind == "non-local" and damping is not None:
        damping = bd.LocalDamping(0.1)
    model = models[kind]
    names = {address: name for name, ((address, _), _) in _library().step_passes.items()}
    loop = CoreLoop(model, Plan(duration=1e-6, damping=damping), model.state(), 1e-9)
    explained = explain_step(model, damping=damping).passes
    for stages, entries in {
        ("opening",): loop._lists.opening, ("travel",): loop._lists.travel, ("present",): loop._lists.present,
        tuple(FORCES): loop._lists.forces, ("resume",): loop._lists.resume,
        ("reopening",): loop._lists.reopening, ("guard",): loop._lists.guard,
    }.items():  # fmt: skip
        assert [one.name for one in explained if one.stage in stages] == [names[entry[0]] for entry in entries]
    begins = [one.name for one in composed(loop._parts, "begin")]
    assert [one.name for one in explained if one.stage == "begin"] == begins
    # the order of `take_steps`
    order = ["begin", "opening", "travel", "present", *FORCES, "resume", "reopening", "guard", "record"]
    stages = [one.stage for one in explained]
    assert stages == sorted(stages, key=order.index)
    assert "record" in stages


def test_a_step_has_no_pass_of_what_the_model_lacks(models):
    passes = {kind: {one.name for one in explain_step(model).passes} for kind, model in models.items()}
    assert not [name for kind in ("cells", "cracking cells") for name in passes[kind] if "beam" in name]
    assert not [name for kind in ("beams", "breaking beams") for name in passes[kind] if "facet" in name]
    assert passes["breaking beams"] >= {"press_pairs", "break_beams", "begin_contacts"}
    assert not [name for name in passes["beams"] if "pair" in name or "break" in name]


def test_nothing_is_run_and_no_state_changes(models):
    model, state = models["cracking cells"], models["cracking cells"].state()
    state.velocity = (1.0, 0.0, 0.0)
    before = state.pose.copy(), state.motion.copy(), state.integrity.copy(), state.stale, state.step
    explain_step(model, state=state)
    now = state.pose, state.motion, state.integrity, state.stale, state.step
    assert all((a == b) if isinstance(a, int) else (a == b).all() for a, b in zip(before, now, strict=True))


def test_every_pass_of_the_core_is_explained_and_printed(models):
    step = explain_step(models["beams"])
    assert all(one.purpose[0].isupper() and one.purpose.endswith(".") for one in step.passes)
    text = str(step)
    assert all(one.name in text and one.over in text and one.purpose in text for one in step.passes)
    with pytest.raises(bd.errors.InputError, match="explain_step: model"):
        explain_step(3)
