"""Contacts and walls on a device."""

from typing import Any

import numpy as np

from bondem._device import IndexPass, Launch
from bondem._tables.contact_tables import (
    AdheringPairs,
    ContactConstants,
    ContactEnergies,
    ContactPairs,
    ContactSums,
    FacePairs,
    NearPairs,
    RolledPairs,
    RolledWalls,
    Travel,
    WallContacts,
    WallMotions,
    Walls,
)
from bondem._tables.crack_tables import CrackLists
from bondem._tables.damage_tables import EventLog, Postponed
from bondem._tables.device_tables import BegunFaces, BondMarks, BondsOfElements, DeviceSpan, EarlierPairs, RowOrder
from bondem._tables.step_tables import Gauges, HistoryRows, Moving, Portions, StepCut
from bondem.boundary.wall_rows import no_rows
from bondem.dynamics.on_device.breakage_counterparts import marks_of
from bondem.dynamics.on_device.device_tables import new_row_order
from bondem.dynamics.on_device.translation import Counterpart, Translation
from bondem.interactions.step_part import Passes

_move_walls = IndexPass("move_all_walls", DeviceSpan, WallMotions, Walls)
_check_element = IndexPass("check_travel_of_element", DeviceSpan, Moving, Travel)
_check_wall = IndexPass("check_travel_of_wall", DeviceSpan, Travel, Walls)
_press_pair = IndexPass("press_pair", DeviceSpan, Moving, ContactConstants, ContactPairs, NearPairs)
_add_pairs = IndexPass(
    "add_pairs_of_element", ContactConstants, ContactPairs, EarlierPairs, NearPairs, ContactSums
)
_press_pair_or_faces = IndexPass(
    "press_pair_or_faces", DeviceSpan, Moving, ContactConstants, ContactPairs, NearPairs, FacePairs
)
_add_faces = IndexPass("add_faces_of_element", ContactPairs, FacePairs, ContactSums)
_sum_faces = IndexPass(
    "sum_portion_of_faces", DeviceSpan, Moving, ContactConstants, ContactPairs, FacePairs, ContactEnergies
)
_open_face = IndexPass("open_face", ContactPairs, FacePairs, CrackLists)
_begin_faces = IndexPass("begin_faces_of_pair", Moving, ContactPairs, FacePairs)
_sum_begun = IndexPass("sum_portion_of_begun", DeviceSpan, ContactPairs, FacePairs, BegunFaces)
_settle_face = IndexPass("settle_face", FacePairs)
_settle_cell = IndexPass("settle_faces_of_cell", FacePairs)
_take_over_from_cracks = IndexPass("take_over_from_cracks", BegunFaces, EventLog)
_press_walls = IndexPass(
    "press_walls_on_element", DeviceSpan, Moving, ContactConstants, WallContacts, Walls, ContactSums
)
_add_contact_load = IndexPass("add_contact_load", DeviceSpan, Moving, StepCut, ContactSums)
_load_wall = IndexPass("load_wall", DeviceSpan, WallContacts, RowOrder, Walls)
_kick_free_wall = IndexPass("kick_free_wall", DeviceSpan, WallMotions, Walls)
_PAIRS = ContactConstants, ContactPairs, NearPairs, EventLog
_begin_contact = IndexPass("begin_contact_of_event", Moving, *_PAIRS)
_add_begun = IndexPass("add_begun_contacts_of_element", BondsOfElements, BondMarks, *_PAIRS, Postponed)
_take_over = IndexPass("take_over_energies", *_PAIRS[1:])
_measure_overlaps = IndexPass(
    "measure_overlaps", DeviceSpan, Moving, ContactConstants, ContactPairs, WallContacts, Walls, Travel
)
_sum_pairs = IndexPass("sum_portion_of_pairs", DeviceSpan, Moving, ContactConstants, ContactPairs, ContactEnergies)
_sum_at_walls = IndexPass(
    "sum_portion_at_walls", DeviceSpan, Moving, ContactConstants, WallContacts, Walls, ContactEnergies
)
_roll_pair = IndexPass("roll_one_pair", DeviceSpan, Moving, ContactConstants, ContactPairs, NearPairs, RolledPairs)
_add_rolling = IndexPass("add_rolling_of_element", ContactPairs, EarlierPairs, RolledPairs, ContactSums)
_roll_at_walls = IndexPass(
    "roll_element_at_walls", DeviceSpan, Moving, ContactConstants, WallContacts, Walls, RolledWalls, ContactSums
)
_sum_rolling = IndexPass(
    "sum_portion_of_rolling", DeviceSpan, ContactConstants, ContactPairs, RolledPairs, ContactEnergies
)
_sum_rolling_at_walls = IndexPass(
    "sum_portion_of_rolling_at_walls", DeviceSpan, ContactConstants, WallContacts, RolledWalls, ContactEnergies
)
_adhere_pair = IndexPass("adhere_one_pair", Moving, ContactConstants, ContactPairs, AdheringPairs)
_add_adhesion = IndexPass("add_adhesion_of_element", ContactPairs, EarlierPairs, AdheringPairs, ContactSums)
_adhere_at_walls = IndexPass(
    "adhere_element_at_walls", DeviceSpan, Moving, ContactConstants, WallContacts, Walls, ContactSums
)
_sum_adhesion = IndexPass(
    "sum_portion_of_adhesion", DeviceSpan, Moving, ContactConstants, ContactPairs, ContactEnergies
)
_sum_adhesion_at_walls = IndexPass(
    "sum_portion_of_adhesion_at_walls", DeviceSpan, Moving, ContactConstants, WallContacts, Walls, ContactEnergies
)
_write_energy = IndexPass("write_energy_of_contacts", DeviceSpan, ContactEnergies, HistoryRows)
_write_work = IndexPass("write_work_of_walls", DeviceSpan, Walls, HistoryRows)
_write_gauge = IndexPass("write_gauge_of_wall", DeviceSpan, Walls, Gauges, HistoryRows)


def earlier_pairs(run: Translation, pairs: ContactPairs) -> EarlierPairs:
    """Return the pairs whose earlier element each element is."""

    def make() -> EarlierPairs:
        counts = np.bincount(pairs.first, minlength=run.span.n)
        start = np.concatenate([[0], np.cumsum(counts)]).astype(np.int32)
        return EarlierPairs(start, np.argsort(pairs.first, kind="stable").astype(np.uint32))

    return run.once(pairs, make)


def _move(run: Translation, motions: WallMotions, walls: Walls) -> list[Launch]:
    return [(_move_walls, 1, (run.span, motions, walls))]


def _check(run: Translation, travel: Travel, walls: Walls, _: Portions) -> list[Launch]:
    return [(_check_wall, len(walls.body), (run.span, travel, walls))]


def _measure(run: Translation, moving: Moving, travel: Travel) -> list[Launch]:
    return [(_check_element, run.span.n, (run.span, moving, travel))]


def _press(
    run: Translation, moving: Moving, law: ContactConstants, pairs: ContactPairs, near: NearPairs, _: Travel
) -> list[Launch]:
    return [(_press_pair, len(pairs.first), (run.span, moving, law, pairs, near))]


def _add(
    run: Translation, law: ContactConstants, pairs: ContactPairs, near: NearPairs, sums: ContactSums
) -> list[Launch]:
    if len(pairs.first) == 0:
        return []
    return [(_add_pairs, run.span.n, (law, pairs, earlier_pairs(run, pairs), near, sums))]


def _roll(
    run: Translation, moving: Moving, law: ContactConstants, pairs: ContactPairs, near: NearPairs, of: RolledPairs
) -> list[Launch]:
    return [(_roll_pair, len(pairs.first), (run.span, moving, law, pairs, near, of))]


def _add_rolled(
    run: Translation, pairs: ContactPairs, _: NearPairs, of: RolledPairs, sums: ContactSums
) -> list[Launch]:
    if len(pairs.first) == 0:
        return []
    return [(_add_rolling, run.span.n, (pairs, earlier_pairs(run, pairs), of, sums))]


def _roll_walls(
    run: Translation, moving: Moving, law: ContactConstants, contacts: WallContacts, walls: Walls, of: RolledWalls,
    sums: ContactSums,
) -> list[Launch]:  # fmt: skip
    count = run.span.n if len(contacts.wall) else 0
    return [(_roll_at_walls, count, (run.span, moving, law, contacts, walls, of, sums))]


def _rolling_energies(
    run: Translation, law: ContactConstants, pairs: ContactPairs, of: RolledPairs, energies: ContactEnergies
) -> list[Launch]:
    return [(_sum_rolling, len(energies.energy), (run.span, law, pairs, of, energies))]


def _rolling_energies_at_walls(
    run: Translation, law: ContactConstants, contacts: WallContacts, of: RolledWalls, energies: ContactEnergies
) -> list[Launch]:
    return [(_sum_rolling_at_walls, len(energies.energy), (run.span, law, contacts, of, energies))]


def _adhere(
    _: Translation, moving: Moving, law: ContactConstants, pairs: ContactPairs, __: NearPairs, of: AdheringPairs
) -> list[Launch]:
    return [(_adhere_pair, len(pairs.first), (moving, law, pairs, of))]


def _add_adhering(
    run: Translation, pairs: ContactPairs, _: NearPairs, of: AdheringPairs, sums: ContactSums
) -> list[Launch]:
    if len(pairs.first) == 0:
        return []
    return [(_add_adhesion, run.span.n, (pairs, earlier_pairs(run, pairs), of, sums))]


def _press_with_faces(
    run: Translation,
    moving: Moving,
    law: ContactConstants,
    pairs: ContactPairs,
    near: NearPairs,
    _: Travel,
    faces: FacePairs,
) -> list[Launch]:
    return [(_press_pair_or_faces, len(pairs.first), (run.span, moving, law, pairs, near, faces))]


def _add_by_faces(run: Translation, pairs: ContactPairs, faces: FacePairs, sums: ContactSums) -> list[Launch]:
    return [(_add_faces, run.span.n if len(pairs.first) else 0, (pairs, faces, sums))]


def _begin_by_faces(
    run: Translation,
    moving: Moving,
    pairs: ContactPairs,
    _: NearPairs,
    faces: FacePairs,
    lists: CrackLists,
    log: EventLog,
) -> list[Launch]:
    portions = len(faces.count)
    begun = run.once(faces, lambda: BegunFaces(np.zeros(portions)))
    return [
        (_open_face, run.span.m, (pairs, faces, lists)),
        (_begin_faces, len(pairs.first), (moving, pairs, faces)),
        (_sum_begun, portions, (run.span, pairs, faces, begun)),
        (_settle_face, run.span.m, (faces,)),
        (_settle_cell, run.span.n, (faces,)),
        (_take_over_from_cracks, 1, (begun, log)),
    ]


def _at_walls(by: IndexPass) -> Counterpart:
    """Return what contacts of elements with walls add to the sums of the elements, by one pass."""

    def launch(
        run: Translation, moving: Moving, law: ContactConstants, contacts: WallContacts, walls: Walls,
        sums: ContactSums,
    ) -> list[Launch]:  # fmt: skip
        count = run.span.n if len(contacts.wall) else 0
        return [(by, count, (run.span, moving, law, contacts, walls, sums))]

    return launch


def _load(run: Translation, contacts: WallContacts, motions: WallMotions, walls: Walls) -> list[Launch]:
    run.walls = walls.body
    order = run.once(contacts, lambda: new_row_order(contacts.wall, len(walls.body)))
    return [
        (_load_wall, len(walls.body), (run.span, contacts, order, walls)),
        (_kick_free_wall, len(motions.free_wall), (run.span, motions, walls)),
    ]


def _contact_loads(run: Translation, moving: Moving, cut: StepCut, sums: ContactSums) -> list[Launch]:
    return [(_add_contact_load, run.span.n, (run.span, moving, cut, sums))]


def _begin(
    run: Translation,
    moving: Moving,
    law: ContactConstants,
    pairs: ContactPairs,
    near: NearPairs,
    log: EventLog,
    postponed: Postponed,
) -> list[Launch]:
    begun = law, pairs, near, log
    return [
        (_begin_contact, run.span.m, (moving, *begun)),
        (_add_begun, run.span.n, (run.bonds, marks_of(run), *begun, postponed)),
        (_take_over, 1, begun[1:]),
    ]


def _pair_energies(by: IndexPass) -> Counterpart:
    """Return what pairs add to the energy of each portion, by one pass."""

    def launch(
        run: Translation, moving: Moving, law: ContactConstants, pairs: ContactPairs, energies: ContactEnergies
    ) -> list[Launch]:
        return [(by, len(energies.energy), (run.span, moving, law, pairs, energies))]

    return launch


def _face_energies(
    run: Translation,
    moving: Moving,
    law: ContactConstants,
    pairs: ContactPairs,
    faces: FacePairs,
    energies: ContactEnergies,
) -> list[Launch]:
    return [(_sum_faces, len(energies.energy), (run.span, moving, law, pairs, faces, energies))]


def _wall_energies(by: IndexPass) -> Counterpart:
    """Return what contacts with walls add to the energy of each portion, by one pass."""

    def launch(
        run: Translation, moving: Moving, law: ContactConstants, contacts: WallContacts, walls: Walls,
        energies: ContactEnergies,
    ) -> list[Launch]:  # fmt: skip
        return [(by, len(energies.energy), (run.span, moving, law, contacts, walls, energies))]

    return launch


def _energy(run: Translation, energies: ContactEnergies, history: HistoryRows) -> list[Launch]:
    return [(_write_energy, 1, (run.span, energies, history))]


def _walls(run: Translation, walls: Walls, gauges: Gauges, history: HistoryRows) -> list[Launch]:
    return [
        (_write_work, 1, (run.span, walls, history)),
        (_write_gauge, len(gauges.quantity), (run.span, walls, gauges, history)),
    ]


COUNTERPARTS: dict[str, Counterpart] = {
    "move_walls": _move,
    "measure_travel": _measure,
    "check_travel": _check,
    "press_pairs": _press,
    "add_pair_loads": _add,
    "roll_pairs": _roll,
    "add_rolling_loads": _add_rolled,
    "roll_at_walls": _roll_walls,
    "sum_rolling_energies": _rolling_energies,
    "sum_rolling_at_walls": _rolling_energies_at_walls,
    "press_pairs_and_faces": _press_with_faces,
    "add_face_loads": _add_by_faces,
    "sum_face_energies": _face_energies,
    "begin_face_contacts": _begin_by_faces,
    "adhere_pairs": _adhere,
    "add_adhesion_loads": _add_adhering,
    "adhere_at_walls": _at_walls(_adhere_at_walls),
    "sum_adhesion_energies": _pair_energies(_sum_adhesion),
    "sum_adhesion_at_walls": _wall_energies(_sum_adhesion_at_walls),
    "press_walls": _at_walls(_press_walls),
    "measure_wall_overlaps": lambda *_: [],  # with the overlaps of pairs, at the guard
    "keep_measures": lambda *_: [],
    "load_walls": _load,
    "add_contact_loads": _contact_loads,
    "begin_contacts": _begin,
    "sum_pair_energies": _pair_energies(_sum_pairs),
    "sum_wall_energies": _wall_energies(_sum_at_walls),
    "write_contact_energy": _energy,
    "write_walls": _walls,
    "count_wall_work": lambda *_: [],  # the CPU adds it
}


def deepest_overlaps(run: Translation, passes: Passes) -> list[Launch]:
    """Return the launches that measure the deepest overlap of each portion, of the passes of a step."""
    named = dict(passes)
    pressed = named.get("press_pairs", named.get("press_pairs_and_faces"))
    if pressed is None:
        return []
    moving, law, pairs, _, travel = pressed[:5]
    _, walls, _ = named["check_travel"]
    contacts = named["press_walls"][2] if "press_walls" in named else run.once(walls, lambda: _none(run.span.n))
    return [(_measure_overlaps, len(travel.portion), (run.span, moving, law, pairs, contacts, walls, travel))]


def _none(n: int) -> WallContacts:
    """Return no contacts of n elements with walls."""
    short = np.zeros(0, dtype=np.uint32)
    return WallContacts(
        np.zeros(n + 1, dtype=np.int64), short, short, np.zeros(0), np.zeros((0, 6)), np.zeros(0, dtype=np.uint8),
        no_rows("WallLoad", 0),
    )  # fmt: skip


def lists_of_contacts(passes: Passes) -> list[Any]:
    """Return the tables of the passes of a step that are made anew with a list of contacts."""
    kinds = AdheringPairs, ContactPairs, FacePairs, NearPairs, RolledPairs, RolledWalls, Travel, WallContacts
    return list({id(table): table for _, tables in passes for table in tables if isinstance(table, kinds)}.values())


def walls_listed(passes: Passes) -> list[np.ndarray]:
    """Return the places of walls when the list was made, which change with it."""
    return [tables[1].listed for name, tables in passes if name == "check_travel"]
