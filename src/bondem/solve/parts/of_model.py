"""Parts of the step of a model."""

from bondem.kernels.tables import Gauges, StepCut
from bondem.laws.damping import DampingTerms
from bondem.model.model import Model
from bondem.model.state import State
from bondem.solve.added import added
from bondem.solve.cracks import joints
from bondem.solve.parts.beams import beams
from bondem.solve.parts.body_forces import body_forces
from bondem.solve.parts.boundary import boundary
from bondem.solve.parts.contacts import ContactTables
from bondem.solve.parts.history import history
from bondem.solve.parts.motion import dashpots_of, motion, resistance_of
from bondem.solve.parts.part import Part
from bondem.solve.parts.shared_tables import SharedTables


def parts_of(
    model: Model, terms: DampingTerms, state: State, cut: StepCut, gauges: Gauges, dt: float
) -> tuple[SharedTables, list[Part]]:
    """Return the tables and the parts of a run from a state, whose arrays they share."""
    shared = SharedTables.of(model, state, cut)
    more = added(model, terms, state, len(cut.sums))
    dashpots = dashpots_of(more)
    parts = [boundary(shared)]
    if more is not None and len(more.group):
        parts.append(body_forces(shared, more))
    contacts: list[Part] = []
    if model.contacts is not None:
        joined = joints(model, state, state.integrity)
        contacts = ContactTables(model, model.contacts, state, shared, gauges, joined, dt).parts()
    parts += [
        *contacts[:1],
        beams(model, state, shared, dashpots),
        motion(shared, dashpots, resistance_of(terms, more)),
        history(shared, gauges),
        *contacts[1:],
    ]
    return shared, parts
