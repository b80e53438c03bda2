"""Kernel launches on a device for the passes by which beams break."""

import numpy as np

from bondem._device import Launch
from bondem._passes import kernels
from bondem._tables.damage_tables import BeamIntegrity, Candidates, EventLog, Postponed
from bondem._tables.device_tables import BondMarks
from bondem._tables.step_tables import Beams, Moving
from bondem.dynamics.on_device import counts
from bondem.dynamics.on_device.beam_counterparts import DASHED
from bondem.dynamics.on_device.translation import Counterpart, Made, Translation, gathered_or_summed, in_order, over


def marks_of(run: Translation) -> BondMarks:
    """Return the table of the bonds that are near to failure or fail, the same one for all launches of a run."""

    def make() -> BondMarks:
        m = run.span.m
        made = BondMarks(np.zeros(m, dtype=np.uint8), np.zeros(m, dtype=np.uint32), np.zeros(m, dtype=np.uint8))
        run.scratch += made
        return made

    return run.once(run.loads, make)


#: Marks of bonds.
MARKS: Made = {BondMarks: lambda run, _: marks_of(run)}
#: Launch that sorts the failing bonds of a step.
RANKED = over(kernels.rank_failing, counts.bonds, MARKS)


def counted(run: Translation, candidates: Candidates, log: EventLog) -> Launch:
    """Return the launch that counts the events written in a step and adds up their energies."""
    run.keep_log(log)
    return kernels.count_failures(candidates, log), 1


def _break(
    run: Translation, moving: Moving, beams: Beams, integrity: BeamIntegrity, candidates: Candidates,
    postponed: Postponed, log: EventLog,
) -> list[Launch]:  # fmt: skip
    return [
        (kernels.remove_failing_beam(run.span, moving, beams, integrity, candidates, log, run.loads), run.span.m),
        (kernels.take_beams_off_element(run.bonds, marks_of(run), run.loads, candidates, postponed), run.span.n),
        counted(run, candidates, log),
    ]


#: Tables of the bonds that fail in a step, and of the elements whose motion this postpones.
Postponement = tuple[Candidates, Postponed]


def resuming(late: Postponement) -> dict[str, Counterpart]:
    """Return the counterparts for elements whose motion a failure has postponed, by the names of the passes."""
    _, postponed = late
    late_ones: Made = {Postponed: lambda *_: postponed}
    return {
        "list_postponed": in_order(),  # each thread checks whether its element is postponed
        "move_elements": over(kernels.resume_free, counts.free, late_ones),
        "move_resisted": over(kernels.resume_resisted, counts.free, late_ones),
        "move_rows": over(kernels.resume_row, counts.owners, late_ones),
        "move_resisted_rows": over(kernels.resume_resisted_row, counts.owners, late_ones),
        "reopen_elements": in_order(),  # together with their acceleration
        "reopen_rows": in_order(),
        "add_body_work": over(kernels.reopen_work_of_body, counts.elements, late_ones),
    }


def end(run: Translation, late: Postponement) -> list[Launch]:
    """Return the launches that end the failures of a step."""
    candidates, postponed = late
    return [(kernels.release_element(candidates, postponed), run.span.n), (kernels.end_all_failures(candidates), 1)]


COUNTERPARTS: dict[str, Counterpart] = {
    "add_marked_beam_loads": over(kernels.load_marked_beam, counts.bonds, MARKS),
    "add_marked_uniform_beam_loads": over(kernels.load_marked_uniform_beam, counts.bonds, MARKS),
    **{
        f"judge_beams_by_{name}": in_order(over(one, counts.bonds, MARKS), RANKED)
        for name, one in kernels.JUDGE_BEAM_BY.items()
    },
    "postpone_elements": in_order(),
    "keep_sums": gathered_or_summed(kernels.keep_gathered_sum, kernels.keep_sum, counts.elements),
    "keep_dashpots": over(kernels.keep_dashed_sum, counts.elements),
    "withdraw_dashpots": in_order(
        over(kernels.load_failing_dashpot, counts.bonds, DASHED),
        over(kernels.take_dashpots_off_element, counts.elements, {**MARKS, **DASHED}),
    ),
    "break_beams": _break,
    "write_released": over(kernels.write_released_energy, counts.one_thread),
}
