"""Bonds of the non-local law on a device: forces, stresses of elements, and breakage."""

from bondem._device import IndexPass, Launch
from bondem._tables.contact_tables import ContactConstants, ContactPairs, NearPairs, WallContacts, Walls
from bondem._tables.damage_tables import BeamIntegrity, Candidates, EventLog, Postponed, Strengths
from bondem._tables.device_tables import BondMarks, BondsOfElements, DeviceSpan, EarlierPairs, LoadsOfBonds
from bondem._tables.non_local_tables import LaggedStresses, NonLocalBonds, NonLocalWork
from bondem._tables.step_tables import Beams, HistoryRows, Moving, Portions, StepCut
from bondem.dynamics.on_device.breakage_counterparts import counted, marks_of, ranked
from bondem.dynamics.on_device.contact_counterparts import earlier_pairs
from bondem.dynamics.on_device.translation import Counterpart, Translation, elements, over

_OF_PAIRS = DeviceSpan, Moving, Beams, NonLocalBonds
_turn_stress = IndexPass("turn_stress_of_element", Moving, LaggedStresses)
_find_force = IndexPass("find_force_of_pair", *_OF_PAIRS, LaggedStresses, LoadsOfBonds)
_gather_moments = IndexPass("gather_moments", Moving, NonLocalBonds, BondsOfElements, LaggedStresses)
_add_pair_moments = IndexPass(
    "add_pair_moments_of_element", Moving, ContactConstants, ContactPairs, EarlierPairs, NearPairs, LaggedStresses
)
_add_wall_moments = IndexPass(
    "add_wall_moments_of_element", DeviceSpan, Moving, ContactConstants, WallContacts, Walls, LaggedStresses
)
_find_stress = IndexPass("find_stress_of_element", Moving, LaggedStresses)
_judge_pair = IndexPass("judge_pair", DeviceSpan, Beams, LaggedStresses, Strengths, BondMarks, Candidates, Postponed)
_write_failure = IndexPass("write_pair_failure", *_OF_PAIRS, Candidates, EventLog)
_take_pairs_off = IndexPass(
    "take_pairs_off_element", NonLocalBonds, BondsOfElements, BondMarks, Candidates, Postponed
)
_relieve = IndexPass("relieve_element", Moving, NonLocalBonds, BondsOfElements, BondMarks, LaggedStresses, Candidates)
_end_pair = IndexPass("end_failing_pair", NonLocalBonds, BeamIntegrity, Candidates)
_add_begun = IndexPass(
    "add_all_begun_contacts", DeviceSpan, Moving, ContactConstants, ContactPairs, LaggedStresses, EventLog
)
_sum_springs = IndexPass("sum_portion_of_springs", *_OF_PAIRS, Portions, NonLocalWork)
_write_work = IndexPass("write_work_of_extra_forces", DeviceSpan, NonLocalWork, HistoryRows)


# ---- forces and stresses


def _forces(
    run: Translation, moving: Moving, beams: Beams, bonds: NonLocalBonds, stresses: LaggedStresses
) -> list[Launch]:
    """Loads of the bonds on their elements are written at once."""
    return [
        (_find_force, run.span.m, (run.span, moving, beams, bonds, stresses, run.loads)),
        (_gather_moments, run.span.n, (moving, bonds, run.bonds, stresses)),
    ]


def _lasting(
    run: Translation, moving: Moving, beams: Beams, bonds: NonLocalBonds, stresses: LaggedStresses, _: StepCut
) -> list[Launch]:
    return _forces(run, moving, beams, bonds, stresses)


def _pair_moments(
    run: Translation,
    moving: Moving,
    law: ContactConstants,
    pairs: ContactPairs,
    near: NearPairs,
    stresses: LaggedStresses,
) -> list[Launch]:
    if len(pairs.first) == 0:
        return []
    return [(_add_pair_moments, run.span.n, (moving, law, pairs, earlier_pairs(run, pairs), near, stresses))]


def _wall_moments(
    run: Translation,
    moving: Moving,
    law: ContactConstants,
    contacts: WallContacts,
    walls: Walls,
    stresses: LaggedStresses,
) -> list[Launch]:
    count = run.span.n if len(contacts.wall) else 0
    return [(_add_wall_moments, count, (run.span, moving, law, contacts, walls, stresses))]


# ---- failure


def _judge(
    run: Translation,
    beams: Beams,
    stresses: LaggedStresses,
    strengths: Strengths,
    candidates: Candidates,
    postponed: Postponed,
) -> list[Launch]:
    tables = run.span, beams, stresses, strengths, marks_of(run), candidates, postponed
    return [(_judge_pair, run.span.m, tables), ranked(run, candidates)]


def _break_pairs(
    run: Translation,
    moving: Moving,
    beams: Beams,
    bonds: NonLocalBonds,
    candidates: Candidates,
    postponed: Postponed,
    log: EventLog,
) -> list[Launch]:
    return [
        (_write_failure, run.span.m, (run.span, moving, beams, bonds, candidates, log)),
        (_take_pairs_off, run.span.n, (bonds, run.bonds, marks_of(run), candidates, postponed)),
        counted(run, candidates, log),
    ]


def _relieve_pairs(
    run: Translation,
    moving: Moving,
    _: Beams,
    bonds: NonLocalBonds,
    stresses: LaggedStresses,
    integrity: BeamIntegrity,
    candidates: Candidates,
) -> list[Launch]:
    return [
        (_relieve, run.span.n, (moving, bonds, run.bonds, marks_of(run), stresses, candidates)),
        (_end_pair, run.span.m, (bonds, integrity, candidates)),
    ]


def _energies(
    run: Translation, moving: Moving, beams: Beams, bonds: NonLocalBonds, portions: Portions, work: NonLocalWork
) -> list[Launch]:
    return [(_sum_springs, len(portions.bonds), (run.span, moving, beams, bonds, portions, work))]


def _one_thread(_: Translation) -> int:
    return 1


COUNTERPARTS: dict[str, Counterpart] = {
    "turn_stresses": over(_turn_stress, elements, spans=False),
    "find_non_local_forces": _forces,
    "collect_moments": lambda *_: [],  # a device has no elements that domains share
    "add_pair_moments": _pair_moments,
    "add_wall_moments": _wall_moments,
    "find_stresses": over(_find_stress, elements, spans=False),
    "add_non_local_loads": lambda *_: [],  # together with the forces
    "add_lasting_loads": _lasting,
    "find_stresses_of_block": over(_find_stress, elements, spans=False),
    "mark_pairs": lambda *_: [],  # each thread asks whether its bond reaches the bounds
    "judge_pairs": _judge,
    "break_pairs": _break_pairs,
    "relieve_pairs": _relieve_pairs,
    "add_begun_contacts": over(_add_begun, _one_thread),
    "sum_non_local_energies": _energies,
    "write_non_local_work": over(_write_work, _one_thread),
}
