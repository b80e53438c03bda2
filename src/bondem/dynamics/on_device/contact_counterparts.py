"""Contacts and walls on a device."""

from typing import Any

import numpy as np

from bondem._device import Launch
from bondem._passes import kernels
from bondem._tables.contact_tables import (
    AdheringPairs,
    ContactEnergies,
    ContactPairs,
    FacePairs,
    NearPairs,
    RolledPairs,
    RolledWalls,
    Travel,
    WallContacts,
    WallMotions,
    Walls,
)
from bondem._tables.device_tables import BegunFaces, EarlierPairs
from bondem._tables.step_tables import Gauges
from bondem.boundary.wall_rows import no_rows
from bondem.dynamics.on_device.breakage_counterparts import MARKS
from bondem.dynamics.on_device.device_tables import new_row_order
from bondem.dynamics.on_device.translation import (
    Counterpart,
    Made,
    Translation,
    bonds,
    elements,
    elements_where,
    in_order,
    length_of,
    one_thread,
    over,
)
from bondem.interactions.step_part import Passes


def earlier_pairs(run: Translation, pairs: ContactPairs) -> EarlierPairs:
    """Return the pairs of each element in which it is the earlier one."""

    def make() -> EarlierPairs:
        counts = np.bincount(pairs.first, minlength=run.span.n)
        start = np.concatenate([[0], np.cumsum(counts)]).astype(np.int32)
        return EarlierPairs(start, np.argsort(pairs.first, kind="stable").astype(np.uint32))

    return run.once(pairs, make)


def _load(run: Translation, contacts: WallContacts, motions: WallMotions, walls: Walls) -> list[Launch]:
    run.walls = (walls.body,)
    order = run.once(contacts, lambda: new_row_order(contacts.wall, len(walls.body)))
    return [
        (kernels.load_wall(run.span, contacts, order, walls), len(walls.body)),
        (kernels.kick_free_wall(run.span, motions, walls), len(motions.free_wall)),
    ]


EARLIER: Made = {EarlierPairs: lambda run, given: earlier_pairs(run, given[ContactPairs])}
#: Elements, where there are contacts of pairs or of walls.
WHERE_PAIRS = elements_where(ContactPairs, lambda pairs: pairs.first)
WHERE_WALLS = elements_where(WallContacts, lambda contacts: contacts.wall)
_PAIRS = length_of(ContactPairs, lambda pairs: pairs.first)
_PORTIONS = length_of(ContactEnergies, lambda energies: energies.energy)
_BEGUN: Made = {
    BegunFaces: lambda run, given: run.once(
        given[FacePairs], lambda: BegunFaces(np.zeros(len(given[FacePairs].count)))
    )
}

COUNTERPARTS: dict[str, Counterpart] = {
    "move_walls": over(kernels.move_all_walls, one_thread),
    "measure_travel": over(kernels.check_travel_of_element, elements),
    "check_travel": over(kernels.check_travel_of_wall, length_of(Walls, lambda walls: walls.body)),
    "press_pairs": over(kernels.press_pair, _PAIRS),
    "add_pair_loads": over(kernels.add_pairs_of_element, WHERE_PAIRS, EARLIER),
    "roll_pairs": over(kernels.roll_one_pair, _PAIRS),
    "add_rolling_loads": over(kernels.add_rolling_of_element, WHERE_PAIRS, EARLIER),
    "roll_at_walls": over(kernels.roll_element_at_walls, WHERE_WALLS),
    "sum_rolling_energies": over(kernels.sum_portion_of_rolling, _PORTIONS),
    "sum_rolling_at_walls": over(kernels.sum_portion_of_rolling_at_walls, _PORTIONS),
    "press_pairs_and_faces": over(kernels.press_pair_or_faces, _PAIRS),
    "add_face_loads": over(kernels.add_faces_of_element, WHERE_PAIRS),
    "sum_face_energies": over(kernels.sum_portion_of_faces, _PORTIONS),
    "begin_face_contacts": in_order(
        over(kernels.open_face, bonds),
        over(kernels.begin_faces_of_pair, _PAIRS),
        over(kernels.sum_portion_of_begun, length_of(FacePairs, lambda faces: faces.count), _BEGUN),
        over(kernels.settle_face, bonds),
        over(kernels.settle_faces_of_cell, elements),
        over(kernels.take_over_from_cracks, one_thread, _BEGUN),
    ),
    "adhere_pairs": over(kernels.adhere_one_pair, _PAIRS),
    "add_adhesion_loads": over(kernels.add_adhesion_of_element, WHERE_PAIRS, EARLIER),
    "adhere_at_walls": over(kernels.adhere_element_at_walls, WHERE_WALLS),
    "sum_adhesion_energies": over(kernels.sum_portion_of_adhesion, _PORTIONS),
    "sum_adhesion_at_walls": over(kernels.sum_portion_of_adhesion_at_walls, _PORTIONS),
    "press_walls": over(kernels.press_walls_on_element, WHERE_WALLS),
    "measure_wall_overlaps": in_order(),  # with the overlaps of pairs, at the guard
    "keep_measures": in_order(),
    "load_walls": _load,
    "add_contact_loads": over(kernels.add_contact_load, elements),
    "begin_contacts": in_order(
        over(kernels.begin_contact_of_event, bonds),
        over(kernels.add_begun_contacts_of_element, elements, MARKS),
        over(kernels.take_over_energies, one_thread),
    ),
    "sum_pair_energies": over(kernels.sum_portion_of_pairs, _PORTIONS),
    "sum_wall_energies": over(kernels.sum_portion_at_walls, _PORTIONS),
    "write_contact_energy": over(kernels.write_energy_of_contacts, one_thread),
    "write_walls": in_order(
        over(kernels.write_work_of_walls, one_thread),
        over(kernels.write_gauge_of_wall, length_of(Gauges, lambda gauges: gauges.quantity)),
    ),
    "count_wall_work": in_order(),  # the CPU adds it
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
