"""Bonds of the non-local law on a device: forces, stresses of elements, and breakage."""

from bondem._device import Launch
from bondem._passes import kernels
from bondem._tables.contact_tables import ContactConstants, ContactPairs, NearPairs, WallContacts, Walls
from bondem._tables.damage_tables import BeamIntegrity, Candidates, EventLog, Postponed, Strengths
from bondem._tables.device_tables import DeviceSpan
from bondem._tables.non_local_tables import NonLocalBonds, NonLocalWork
from bondem._tables.step_tables import Beams, LaggedStresses, Moving, Portions, StepCut
from bondem.dynamics.on_device.breakage_counterparts import counted, marks_of, ranked
from bondem.dynamics.on_device.contact_counterparts import earlier_pairs
from bondem.dynamics.on_device.translation import Counterpart, Translation, elements, over

_OF_PAIRS = DeviceSpan, Moving, Beams, NonLocalBonds


# ---- forces and stresses


def _forces(
    run: Translation, moving: Moving, beams: Beams, bonds: NonLocalBonds, stresses: LaggedStresses
) -> list[Launch]:
    """Return the launches of forces, which also write the loads of bonds on their elements."""
    return [
        (kernels.find_force_of_pair(run.span, moving, beams, bonds, stresses, run.loads), run.span.m),
        (kernels.gather_moments(moving, bonds, run.bonds, stresses), run.span.n),
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
    earlier = earlier_pairs(run, pairs)
    return [(kernels.add_pair_moments_of_element(moving, law, pairs, earlier, near, stresses), run.span.n)]


def _wall_moments(
    run: Translation,
    moving: Moving,
    law: ContactConstants,
    contacts: WallContacts,
    walls: Walls,
    stresses: LaggedStresses,
) -> list[Launch]:
    count = run.span.n if len(contacts.wall) else 0
    return [(kernels.add_wall_moments_of_element(run.span, moving, law, contacts, walls, stresses), count)]


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
    return [(kernels.judge_pair(*tables), run.span.m), ranked(run, candidates)]


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
        (kernels.write_pair_failure(run.span, moving, beams, bonds, candidates, log), run.span.m),
        (kernels.take_pairs_off_element(bonds, run.bonds, marks_of(run), candidates, postponed), run.span.n),
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
        (kernels.relieve_element(moving, bonds, run.bonds, marks_of(run), stresses, candidates), run.span.n),
        (kernels.end_failing_pair(bonds, integrity, candidates), run.span.m),
    ]


def _energies(
    run: Translation, moving: Moving, beams: Beams, bonds: NonLocalBonds, portions: Portions, work: NonLocalWork
) -> list[Launch]:
    return [(kernels.sum_portion_of_springs(run.span, moving, beams, bonds, portions, work), len(portions.bonds))]


def _one_thread(_: Translation) -> int:
    return 1


COUNTERPARTS: dict[str, Counterpart] = {
    "turn_stresses": over(kernels.turn_stress_of_element, elements, spans=False),
    "find_non_local_forces": _forces,
    "collect_moments": lambda *_: [],  # a device has no elements that domains share
    "add_pair_moments": _pair_moments,
    "add_wall_moments": _wall_moments,
    "find_stresses": over(kernels.find_stress_of_element, elements, spans=False),
    "add_non_local_loads": lambda *_: [],  # together with the forces
    "add_lasting_loads": _lasting,
    "find_stresses_of_block": over(kernels.find_stress_of_element, elements, spans=False),
    "mark_pairs": lambda *_: [],  # each thread asks whether its bond reaches the bounds
    "judge_pairs": _judge,
    "break_pairs": _break_pairs,
    "relieve_pairs": _relieve_pairs,
    "add_begun_contacts": over(kernels.add_all_begun_contacts, _one_thread),
    "sum_non_local_energies": _energies,
    "write_non_local_work": over(kernels.write_work_of_extra_forces, _one_thread),
}
