"""Interface of a state to its model, and the conditions under which a state may pass to another model."""

from collections.abc import Sequence
from functools import cached_property
from typing import Protocol

import numpy as np

from bondem._types import PerElement
from bondem.boundary.conditions import BoundaryCondition
from bondem.boundary.walls import Wall
from bondem.damage.beam_softening import BeamSoftening
from bondem.damage.softening_table import SlipTable, SofteningTable
from bondem.interactions.contact.contact_assignment import ContactLaws
from bondem.interactions.interaction import Interaction
from bondem.model.constraints import Constraints
from bondem.specimen.lattice import Lattice
from bondem.specimen.ordering import Layout
from bondem.specimen.particles import Particles


class Origin(Protocol):
    """The properties of a model that a state needs."""

    @property
    def lattice(self) -> Lattice: ...
    @cached_property
    def layout(self) -> Layout: ...
    @cached_property
    def mass(self) -> PerElement: ...
    @cached_property
    def inertia(self) -> PerElement: ...
    @cached_property
    def interaction(self) -> Interaction: ...
    @cached_property
    def softening(self) -> SofteningTable | None: ...
    @property
    def yielding(self) -> tuple[SlipTable, ...]: ...
    @cached_property
    def beam_softening(self) -> BeamSoftening | None: ...
    @property
    def boundary(self) -> Sequence[BoundaryCondition]: ...
    @cached_property
    def constraints(self) -> Constraints: ...
    @cached_property
    def contact_laws(self) -> ContactLaws: ...
    @property
    def walls(self) -> Sequence[Wall]: ...


def difference(one: Origin, other: Origin) -> str:
    """Describe the difference between two models that prevents the exchange of states; empty if there is none."""
    if one is other:
        return ""
    a, b = one.lattice.particles, other.lattice.particles
    if one.lattice is not other.lattice:
        if not np.array_equal(a.position, b.position) or not np.array_equal(a.radius, b.radius):
            same = len(a) == len(b) and a.position.any()
            scale = float(np.abs(b.position).sum() / np.abs(a.position).sum()) if same else 1.0
            hint = f": {scale:.4g} times as large" if not 0.9 < scale < 1.1 else ""
            return f"lattice, of other elements{hint}"
        if _edges(a) != _edges(b):
            return "lattice, of another period"
        if not np.array_equal(one.lattice.pairs, other.lattice.pairs):
            return "lattice, of other bonds"
    law, new = one.interaction, other.interaction
    if law.formulation != new.formulation:
        return f"formulation ('{law.formulation}', not '{new.formulation}')"
    if law.fields != new.fields:
        return "bond law, which remembers other things"
    if not np.array_equal(one.lattice.centre, other.lattice.centre):
        return "law: elements of cells are not where spheres are"
    if not np.array_equal(one.mass, other.mass):
        was, now = (each.mass.sum() / each.lattice.element_volume.sum() for each in (one, other))
        return (
            f"density of the elements, {was:.6g} and not {now:.6g} kg/m³ on average; give both the same density="
            " (laboratory tests without one have 2000 kg/m³)"
        )
    names = ("kn", "ks", "kb", "kt", "lever")
    constants = ((getattr(law.bonds, name), getattr(new.bonds, name)) for name in names)
    if law.formulation == "incremental" and not all(np.array_equal(p, q) for p, q in constants):
        return "bond law, whose forces it has stored"
    return ""


def _edges(particles: Particles) -> list[float]:
    return [] if particles.period is None else particles.period.tolist()
