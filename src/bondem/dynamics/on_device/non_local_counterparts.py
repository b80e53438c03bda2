"""Kernel launches on a device for the passes of the non-local law: forces, stresses of elements, breakage."""

from bondem._device import Launch
from bondem._passes import kernels
from bondem._tables.damage_tables import Candidates, EventLog, Postponed
from bondem._tables.non_local_tables import NonLocalBonds
from bondem._tables.step_tables import Beams, Moving
from bondem.dynamics.on_device import counts
from bondem.dynamics.on_device.breakage_counterparts import MARKS, RANKED, counted, marks_of
from bondem.dynamics.on_device.contact_counterparts import EARLIER, WHERE_PAIRS, WHERE_WALLS
from bondem.dynamics.on_device.translation import Counterpart, Translation, in_order, over


def _break_pairs(
    run: Translation, moving: Moving, beams: Beams, bonds: NonLocalBonds, candidates: Candidates,
    postponed: Postponed, log: EventLog,
) -> list[Launch]:  # fmt: skip
    return [
        (kernels.write_pair_failure(run.span, moving, beams, bonds, candidates, log), run.span.m),
        (kernels.take_pairs_off_element(bonds, run.bonds, marks_of(run), candidates, postponed), run.span.n),
        counted(run, candidates, log),
    ]


# Forces, which also write the loads of bonds on their elements.
_FORCES = in_order(over(kernels.find_force_of_pair, counts.bonds), over(kernels.gather_moments, counts.elements))

COUNTERPARTS: dict[str, Counterpart] = {
    "turn_stresses": over(kernels.turn_stress_of_element, counts.elements),
    "find_non_local_forces": _FORCES,
    "collect_moments": in_order(),  # a device has no elements that domains share
    "add_pair_moments": over(kernels.add_pair_moments_of_element, WHERE_PAIRS, EARLIER),
    "add_wall_moments": over(kernels.add_wall_moments_of_element, WHERE_WALLS),
    "find_stresses": over(kernels.find_stress_of_element, counts.elements),
    "add_non_local_loads": in_order(),  # together with the forces
    "add_lasting_loads": _FORCES,
    "find_stresses_of_block": over(kernels.find_stress_of_element, counts.elements),
    "mark_pairs": in_order(),  # each thread checks whether its bond reaches the bounds
    "judge_pairs": in_order(over(kernels.judge_pair, counts.bonds, MARKS), RANKED),
    "break_pairs": _break_pairs,
    "relieve_pairs": in_order(
        over(kernels.relieve_element, counts.elements, MARKS), over(kernels.end_failing_pair, counts.bonds)
    ),
    "add_new_contacts": over(kernels.add_all_new_contacts, counts.one_thread),
    "sum_non_local_energies": over(kernels.sum_portion_of_springs, counts.portions_of_bonds),
}
