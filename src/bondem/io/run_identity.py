"""Identity of a run: a digest of model, plan and initial state, by which the same call continues its own run file."""

import json
from dataclasses import fields
from typing import Any

from bondem.dynamics.plan import Plan
from bondem.io.codec import encode
from bondem.io.digest import digest_of
from bondem.model.model import Model
from bondem.model.state import State

#: Attribute of a run file that contains its identity.
IDENTITY = "identity"


def text_of_model(model: Model) -> str:
    """Encode laws, conditions and shape of a model as JSON; types unknown to bondem raise RunFileError."""
    names = ("bond", "boundary", "contact", "walls", "failure", "mass_matrix")
    return json.dumps({name: encode(getattr(model, name)) for name in names}
                      | {"shape": encode(model.lattice.particles.shape)})  # fmt: skip


def identity_of(model: Model, plan: Plan, initial: State) -> str:
    """Compute the digest that identifies a run, as 64 hexadecimal digits; errors as for `text_of_model`.

    Args:
        model: model of the run.
        plan: options of the run with the resolved time step.
        initial: initial state.
    """
    lattice = model.lattice
    items: list[tuple[str, Any]] = [
        ("plan", json.dumps(encode(plan))), ("model", text_of_model(model)),
        ("position", lattice.particles.position), ("radius", lattice.particles.radius),
        ("density", model.density), ("pairs", lattice.pairs), ("time", initial.time),
    ]  # fmt: skip
    items += [(name, getattr(initial, name)) for name in initial.arrays]
    if len(lattice.names) > 1:
        items += [("body", lattice.body), ("bodies", json.dumps([lattice.names, encode(lattice.bodies.shapes)]))]
    tables = lattice.elements.tables.values()
    named = [(table, item.name) for table in tables for item in fields(table) if item.name != "free"]
    items += [(name, getattr(table, name)) for table, name in named]
    return digest_of(items)
