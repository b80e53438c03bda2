"""Parts of the step of a model."""

from bondem.laws.damping import DampingTerms
from bondem.model.blocks import StepCut
from bondem.model.model import Model
from bondem.model.state import State
from bondem.solve.cracks import joints
from bondem.solve.gauge_tables import Gauges
from bondem.solve.parts.beams import beams
from bondem.solve.parts.body_forces import body_forces
from bondem.solve.parts.boundary import boundary
from bondem.solve.parts.cohesive_cracks import CrackingBody
from bondem.solve.parts.contacts import ContactTables
from bondem.solve.parts.damage import BondParts, Joints
from bondem.solve.parts.facet_breakage import body_of_cells
from bondem.solve.parts.history import history
from bondem.solve.parts.motion import dashpots_of, motion, resistance_of
from bondem.solve.parts.non_local import non_local
from bondem.solve.parts.part import Part
from bondem.solve.parts.shared_tables import SharedTables
from bondem.solve.parts.stored_beams import stored_beams
from bondem.solve.step_tables import Dashpots


def parts_of(
    model: Model, terms: DampingTerms, state: State, cut: StepCut, gauges: Gauges, dt: float
) -> tuple[SharedTables, list[Part]]:
    """Return the tables and the parts of a run from a state, whose arrays they share."""
    shared = SharedTables.of(model, state, cut)
    dashpots = dashpots_of(model, terms, cut)
    bonds = _bonds(model, state, shared, dashpots, dt)
    contacts, moments = [], []
    if model.contacts is not None:
        touching = ContactTables(model, model.contacts, state, shared, gauges, bonds.joints, dt)
        contacts = [touching.part()]
        moments = [] if bonds.stresses is None else [touching.moments(bonds.stresses)]
    parts = [
        boundary(shared),
        *contacts,
        *bonds.parts,
        *moments,
        motion(shared, dashpots, resistance_of(model, terms, dashpots)),
    ]
    pulled = body_forces(model, state, shared)
    if pulled is not None:
        parts.append(pulled)  # its work is that at the velocities after the kick
    return shared, [*parts, history(shared, gauges)]


def _bonds(
    model: Model, state: State, shared: SharedTables, dashpots: Dashpots | None, dt: float
) -> BondParts:
    """Return the parts of the bonds."""
    if model.softening is not None:
        body = CrackingBody(model, state, shared, dt)
        joined, apart = joints(model, state, state.integrity)
        return BondParts(body.parts(model, dashpots), Joints(joined, apart, None, cracks=(body.cracks, body.lists)))
    if model.cells is not None:
        return body_of_cells(model, state, shared, dashpots)
    if model.non_local is not None:
        return non_local(model, state, shared, dashpots)
    if model.formulation == "incremental":
        parts = [stored_beams(model, state, shared, dashpots)]
        return BondParts(parts, Joints.of(model, state, state.integrity, None))
    return beams(model, state, shared, dashpots)
