"""Contacts and walls on a device."""

from typing import Any

import numpy as np

from bondem._device import Launch
from bondem._passes import kernels
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
from bondem._tables.device_tables import BegunFaces, EarlierPairs
from bondem._tables.step_tables import Gauges, HistoryRows, Moving, Portions, StepCut
from bondem.boundary.wall_rows import no_rows
from bondem.dynamics.on_device.breakage_counterparts import marks_of
from bondem.dynamics.on_device.device_tables import new_row_order
from bondem.dynamics.on_device.translation import Counterpart, KernelOf, Translation
from bondem.interactions.step_part import Passes

_PAIRS = ContactConstants, ContactPairs, NearPairs, EventLog


def earlier_pairs(run: Translation, pairs: ContactPairs) -> EarlierPairs:
    """Return the pairs of each element in which it is the earlier one."""

    def make() -> EarlierPairs:
        counts = np.bincount(pairs.first, minlength=run.span.n)
        start = np.concatenate([[0], np.cumsum(counts)]).astype(np.int32)
        return EarlierPairs(start, np.argsort(pairs.first, kind="stable").astype(np.uint32))

    return run.once(pairs, make)


def _move(run: Translation, motions: WallMotions, walls: Walls) -> list[Launch]:
    return [(kernels.move_all_walls(run.span, motions, walls), 1)]


def _check(run: Translation, travel: Travel, walls: Walls, _: Portions) -> list[Launch]:
    return [(kernels.check_travel_of_wall(run.span, travel, walls), len(walls.body))]


def _measure(run: Translation, moving: Moving, travel: Travel) -> list[Launch]:
    return [(kernels.check_travel_of_element(run.span, moving, travel), run.span.n)]


def _press(
    run: Translation, moving: Moving, law: ContactConstants, pairs: ContactPairs, near: NearPairs, _: Travel
) -> list[Launch]:
    return [(kernels.press_pair(run.span, moving, law, pairs, near), len(pairs.first))]


def _add(
    run: Translation, law: ContactConstants, pairs: ContactPairs, near: NearPairs, sums: ContactSums
) -> list[Launch]:
    if len(pairs.first) == 0:
        return []
    return [(kernels.add_pairs_of_element(law, pairs, earlier_pairs(run, pairs), near, sums), run.span.n)]


def _roll(
    run: Translation, moving: Moving, law: ContactConstants, pairs: ContactPairs, near: NearPairs, of: RolledPairs
) -> list[Launch]:
    return [(kernels.roll_one_pair(run.span, moving, law, pairs, near, of), len(pairs.first))]


def _add_rolled(
    run: Translation, pairs: ContactPairs, _: NearPairs, of: RolledPairs, sums: ContactSums
) -> list[Launch]:
    if len(pairs.first) == 0:
        return []
    return [(kernels.add_rolling_of_element(pairs, earlier_pairs(run, pairs), of, sums), run.span.n)]


def _roll_walls(
    run: Translation, moving: Moving, law: ContactConstants, contacts: WallContacts, walls: Walls, of: RolledWalls,
    sums: ContactSums,
) -> list[Launch]:  # fmt: skip
    count = run.span.n if len(contacts.wall) else 0
    return [(kernels.roll_element_at_walls(run.span, moving, law, contacts, walls, of, sums), count)]


def _rolling_energies(
    run: Translation, law: ContactConstants, pairs: ContactPairs, of: RolledPairs, energies: ContactEnergies
) -> list[Launch]:
    return [(kernels.sum_portion_of_rolling(run.span, law, pairs, of, energies), len(energies.energy))]


def _rolling_energies_at_walls(
    run: Translation, law: ContactConstants, contacts: WallContacts, of: RolledWalls, energies: ContactEnergies
) -> list[Launch]:
    return [(kernels.sum_portion_of_rolling_at_walls(run.span, law, contacts, of, energies), len(energies.energy))]


def _adhere(
    _: Translation, moving: Moving, law: ContactConstants, pairs: ContactPairs, __: NearPairs, of: AdheringPairs
) -> list[Launch]:
    return [(kernels.adhere_one_pair(moving, law, pairs, of), len(pairs.first))]


def _add_adhering(
    run: Translation, pairs: ContactPairs, _: NearPairs, of: AdheringPairs, sums: ContactSums
) -> list[Launch]:
    if len(pairs.first) == 0:
        return []
    return [(kernels.add_adhesion_of_element(pairs, earlier_pairs(run, pairs), of, sums), run.span.n)]


def _press_with_faces(
    run: Translation,
    moving: Moving,
    law: ContactConstants,
    pairs: ContactPairs,
    near: NearPairs,
    _: Travel,
    faces: FacePairs,
) -> list[Launch]:
    return [(kernels.press_pair_or_faces(run.span, moving, law, pairs, near, faces), len(pairs.first))]


def _add_by_faces(run: Translation, pairs: ContactPairs, faces: FacePairs, sums: ContactSums) -> list[Launch]:
    return [(kernels.add_faces_of_element(pairs, faces, sums), run.span.n if len(pairs.first) else 0)]


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
        (kernels.open_face(pairs, faces, lists), run.span.m),
        (kernels.begin_faces_of_pair(moving, pairs, faces), len(pairs.first)),
        (kernels.sum_portion_of_begun(run.span, pairs, faces, begun), portions),
        (kernels.settle_face(faces), run.span.m),
        (kernels.settle_faces_of_cell(faces), run.span.n),
        (kernels.take_over_from_cracks(begun, log), 1),
    ]


def _at_walls(by: KernelOf) -> Counterpart:
    """Return the launches that add contacts with walls to the sums of the elements, by one pass."""

    def launch(
        run: Translation, moving: Moving, law: ContactConstants, contacts: WallContacts, walls: Walls,
        sums: ContactSums,
    ) -> list[Launch]:  # fmt: skip
        count = run.span.n if len(contacts.wall) else 0
        return [(by(run.span, moving, law, contacts, walls, sums), count)]

    return launch


def _load(run: Translation, contacts: WallContacts, motions: WallMotions, walls: Walls) -> list[Launch]:
    run.walls = walls.body
    order = run.once(contacts, lambda: new_row_order(contacts.wall, len(walls.body)))
    return [
        (kernels.load_wall(run.span, contacts, order, walls), len(walls.body)),
        (kernels.kick_free_wall(run.span, motions, walls), len(motions.free_wall)),
    ]


def _contact_loads(run: Translation, moving: Moving, cut: StepCut, sums: ContactSums) -> list[Launch]:
    return [(kernels.add_contact_load(run.span, moving, cut, sums), run.span.n)]


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
        (kernels.begin_contact_of_event(moving, *begun), run.span.m),
        (kernels.add_begun_contacts_of_element(run.bonds, marks_of(run), *begun, postponed), run.span.n),
        (kernels.take_over_energies(*begun[1:]), 1),
    ]


def _pair_energies(by: KernelOf) -> Counterpart:
    """Return the launches that add the energy of pairs to each portion, by one pass."""

    def launch(
        run: Translation, moving: Moving, law: ContactConstants, pairs: ContactPairs, energies: ContactEnergies
    ) -> list[Launch]:
        return [(by(run.span, moving, law, pairs, energies), len(energies.energy))]

    return launch


def _face_energies(
    run: Translation,
    moving: Moving,
    law: ContactConstants,
    pairs: ContactPairs,
    faces: FacePairs,
    energies: ContactEnergies,
) -> list[Launch]:
    return [(kernels.sum_portion_of_faces(run.span, moving, law, pairs, faces, energies), len(energies.energy))]


def _wall_energies(by: KernelOf) -> Counterpart:
    """Return the launches that add the energy of contacts with walls to each portion, by one pass."""

    def launch(
        run: Translation, moving: Moving, law: ContactConstants, contacts: WallContacts, walls: Walls,
        energies: ContactEnergies,
    ) -> list[Launch]:  # fmt: skip
        return [(by(run.span, moving, law, contacts, walls, energies), len(energies.energy))]

    return launch


def _energy(run: Translation, energies: ContactEnergies, history: HistoryRows) -> list[Launch]:
    return [(kernels.write_energy_of_contacts(run.span, energies, history), 1)]


def _walls(run: Translation, walls: Walls, gauges: Gauges, history: HistoryRows) -> list[Launch]:
    return [
        (kernels.write_work_of_walls(run.span, walls, history), 1),
        (kernels.write_gauge_of_wall(run.span, walls, gauges, history), len(gauges.quantity)),
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
    "adhere_at_walls": _at_walls(kernels.adhere_element_at_walls),
    "sum_adhesion_energies": _pair_energies(kernels.sum_portion_of_adhesion),
    "sum_adhesion_at_walls": _wall_energies(kernels.sum_portion_of_adhesion_at_walls),
    "press_walls": _at_walls(kernels.press_walls_on_element),
    "measure_wall_overlaps": lambda *_: [],  # with the overlaps of pairs, at the guard
    "keep_measures": lambda *_: [],
    "load_walls": _load,
    "add_contact_loads": _contact_loads,
    "begin_contacts": _begin,
    "sum_pair_energies": _pair_energies(kernels.sum_portion_of_pairs),
    "sum_wall_energies": _wall_energies(kernels.sum_portion_at_walls),
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
    return [(kernels.measure_overlaps(run.span, moving, law, pairs, contacts, walls, travel), len(travel.portion))]


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
