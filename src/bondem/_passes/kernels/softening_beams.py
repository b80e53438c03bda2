"""Passes over an index, for devices, of `core/gpu/softening_beams.hpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import Kernel
from bondem._tables.beam_softening_tables import SofteningBeams, SofteningBounds
from bondem._tables.contact_tables import ContactConstants, ContactPairs, ContactSums, NearPairs
from bondem._tables.damage_tables import Candidates, EventLog
from bondem._tables.device_tables import BondMarks, DeviceSpan, LoadsOfBonds
from bondem._tables.step_tables import Beams, HistoryRows, Ledger, Moving, UniformBeams


def begin_all_softened_contacts(
    device_span: DeviceSpan, moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs,
    near_pairs: NearPairs, event_log: EventLog, contact_sums: ContactSums
) -> Kernel:
    """Begins contact where softening beams have broken at the beginning of this step.

    Over one index.
    """
    return Kernel("begin_all_softened_contacts", (
        device_span, moving, contact_constants, contact_pairs, near_pairs, event_log, contact_sums
    ))


def begin_all_softening(
    device_span: DeviceSpan, candidates: Candidates, softening_bounds: SofteningBounds, softening_beams:
    SofteningBeams, event_log: EventLog
) -> Kernel:
    """Writes the rows of beams that have begun to soften in this step, and adds up their dissipation.

    Over one index.
    """
    return Kernel("begin_all_softening", (device_span, candidates, softening_bounds, softening_beams, event_log))


def begin_beam_by_mohr_coulomb(
    device_span: DeviceSpan, moving: Moving, beams: Beams, loads_of_bonds: LoadsOfBonds, softening_bounds:
    SofteningBounds, bond_marks: BondMarks, candidates: Candidates
) -> Kernel:
    """Pass of one index, defined in `core/gpu/softening_beams.hpp`."""
    return Kernel("begin_beam_by_mohr_coulomb", (
        device_span, moving, beams, loads_of_bonds, softening_bounds, bond_marks, candidates
    ))


def begin_beam_by_peripheral_stress(
    device_span: DeviceSpan, moving: Moving, beams: Beams, loads_of_bonds: LoadsOfBonds, softening_bounds:
    SofteningBounds, bond_marks: BondMarks, candidates: Candidates
) -> Kernel:
    """Pass of one index, defined in `core/gpu/softening_beams.hpp`."""
    return Kernel("begin_beam_by_peripheral_stress", (
        device_span, moving, beams, loads_of_bonds, softening_bounds, bond_marks, candidates
    ))


def end_portion_of_softening(softening_bounds: SofteningBounds, softening_beams: SofteningBeams) -> Kernel:
    """Launched for `soften_beams`: lowers the integrity of the softening beams of a portion, before forces are
    computed.

    Over one index.
    """
    return Kernel("end_portion_of_softening", (softening_bounds, softening_beams))


def load_softening_beam(
    moving: Moving, beams: Beams, loads_of_bonds: LoadsOfBonds, softening_bounds: SofteningBounds, bond_marks:
    BondMarks
) -> Kernel:
    """Pass of one index, defined in `core/gpu/softening_beams.hpp`."""
    return Kernel("load_softening_beam", (moving, beams, loads_of_bonds, softening_bounds, bond_marks))


def load_softening_uniform_beam(
    moving: Moving, beams: Beams, uniform_beams: UniformBeams, loads_of_bonds: LoadsOfBonds, softening_bounds:
    SofteningBounds, bond_marks: BondMarks
) -> Kernel:
    """Pass of one index, defined in `core/gpu/softening_beams.hpp`."""
    return Kernel("load_softening_uniform_beam", (
        moving, beams, uniform_beams, loads_of_bonds, softening_bounds, bond_marks
    ))


def log_all_softened(
    device_span: DeviceSpan, moving: Moving, beams: Beams, softening_beams: SofteningBeams, event_log: EventLog
) -> Kernel:
    """Adds up the dissipation of all portions, and logs broken beams.

    Over one index.
    """
    return Kernel("log_all_softened", (device_span, moving, beams, softening_beams, event_log))


def release_all_pressure(device_span: DeviceSpan, event_log: EventLog, softening_bounds: SofteningBounds) -> Kernel:
    """Ends the pressure on softening beams that have broken at the beginning of this step.

    Over one index.
    """
    return Kernel("release_all_pressure", (device_span, event_log, softening_bounds))


def soften_listed(
    device_span: DeviceSpan, moving: Moving, beams: Beams, softening_bounds: SofteningBounds, softening_beams:
    SofteningBeams
) -> Kernel:
    """Softens the beam of the row at place e of the lists."""
    return Kernel("soften_listed", (device_span, moving, beams, softening_bounds, softening_beams))


def sum_portion_of_pressure(
    device_span: DeviceSpan, moving: Moving, beams: Beams, softening_bounds: SofteningBounds, ledger: Ledger
) -> Kernel:
    """Adds the energy of the pressure on softened beams of a portion to their normal energy.

    Over one index.
    """
    return Kernel("sum_portion_of_pressure", (device_span, moving, beams, softening_bounds, ledger))


def write_all_crushing_of_beams(
    device_span: DeviceSpan, softening_bounds: SofteningBounds, softening_beams: SofteningBeams, event_log:
    EventLog, history_rows: HistoryRows
) -> Kernel:
    """Writes the energy that beams have released beyond their fracture energy in this run [J].

    Over one index.
    """
    return Kernel("write_all_crushing_of_beams", (
        device_span, softening_bounds, softening_beams, event_log, history_rows
    ))


#: Passes `begin_beam_by_…` by the name of their criterion.
BEGIN_BEAM_BY = {
    "mohr_coulomb": begin_beam_by_mohr_coulomb,
    "peripheral_stress": begin_beam_by_peripheral_stress,
}
