"""Kernel launches on a device for the passes of contacts and walls."""

from typing import Any

import numpy as np

from bondem._cache_lines import exact_sums
from bondem._device import Launch
from bondem._passes import kernels
from bondem._tables.contact_tables import (
    AdheringPairs,
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
from bondem._tables.device_tables import EarlierPairs, RowOrder
from bondem.boundary.wall_rows import no_rows
from bondem.dynamics.on_device import counts
from bondem.dynamics.on_device.breakage_counterparts import MARKS
from bondem.dynamics.on_device.translation import Counterpart, Made, Translation, in_order, new_row_order, over
from bondem.interactions.step_part import Passes


def earlier_pairs(run: Translation, pairs: ContactPairs) -> EarlierPairs:
    """Return, for each element, the pairs of the neighbour list of which this element is the first."""

    def make() -> EarlierPairs:
        order = new_row_order(pairs.first, run.span.n)
        return EarlierPairs(order.start.astype(np.int32), order.load.astype(np.uint32))

    return run.once(pairs, make)


EARLIER: Made = {EarlierPairs: lambda run, given: earlier_pairs(run, given[ContactPairs])}
#: Numbers of elements for launches, 0 without contacts of pairs or with walls.
WHERE_PAIRS = counts.elements_where(ContactPairs, lambda pairs: pairs.first)
WHERE_WALLS = counts.elements_where(WallContacts, lambda contacts: contacts.wall)
_BY_WALL: Made = {
    RowOrder: lambda run, given: run.once(
        given[WallContacts], lambda: new_row_order(given[WallContacts].wall, len(given[Walls].body))
    )
}
_PAIRS = counts.length_of(ContactPairs, lambda pairs: pairs.first)

COUNTERPARTS: dict[str, Counterpart] = {
    "move_walls": over(kernels.move_all_walls, counts.one_thread),
    "measure_travel": over(kernels.check_travel_of_element, counts.elements),
    "check_travel": over(kernels.check_travel_of_wall, counts.length_of(Walls, lambda walls: walls.body)),
    "press_pairs": over(kernels.press_pair, _PAIRS),
    "add_pair_loads": over(kernels.add_pairs_of_element, WHERE_PAIRS, EARLIER),
    "roll_pairs": over(kernels.roll_one_pair, _PAIRS),
    "add_rolling_loads": over(kernels.add_rolling_of_element, WHERE_PAIRS, EARLIER),
    "roll_at_walls": over(kernels.roll_element_at_walls, WHERE_WALLS),
    "sum_rolling_energies": over(kernels.sum_portion_of_rolling, counts.portions_of_elements),
    "sum_rolling_at_walls": over(kernels.sum_portion_of_rolling_at_walls, counts.portions_of_elements),
    "press_pairs_and_faces": over(kernels.press_pair_or_faces, _PAIRS),
    "add_face_loads": over(kernels.add_faces_of_element, WHERE_PAIRS),
    "sum_face_energies": over(kernels.sum_portion_of_faces, counts.portions_of_elements),
    "begin_face_contacts": in_order(
        over(kernels.open_face, counts.bonds),
        over(kernels.begin_faces_of_pair, _PAIRS),
        over(kernels.settle_face, counts.bonds),
        over(kernels.settle_faces_of_cell, counts.elements),
        over(kernels.take_over_from_cracks, counts.one_thread),
    ),
    "adhere_pairs": over(kernels.adhere_one_pair, _PAIRS),
    "add_adhesion_loads": over(kernels.add_adhesion_of_element, WHERE_PAIRS, EARLIER),
    "adhere_at_walls": over(kernels.adhere_element_at_walls, WHERE_WALLS),
    "sum_adhesion_energies": over(kernels.sum_portion_of_adhesion, counts.portions_of_elements),
    "sum_adhesion_at_walls": over(kernels.sum_portion_of_adhesion_at_walls, counts.portions_of_elements),
    "press_walls": over(kernels.press_walls_on_element, WHERE_WALLS),
    "measure_wall_overlaps": in_order(),  # with the overlaps of pairs, at the guard
    "keep_measures": in_order(),
    "load_walls": in_order(
        over(kernels.load_wall, counts.length_of(Walls, lambda walls: walls.body), _BY_WALL),
        over(kernels.kick_free_wall, counts.length_of(WallMotions, lambda motions: motions.free_wall)),
    ),
    "add_contact_loads": over(kernels.add_contact_load, counts.elements),
    "begin_contacts": in_order(
        over(kernels.begin_contact_of_event, counts.bonds),
        over(kernels.add_new_contacts_of_element, counts.elements, MARKS),
        over(kernels.take_over_energies, counts.one_thread),
    ),
    "sum_pair_energies": over(kernels.sum_portion_of_pairs, counts.portions_of_elements),
    "sum_wall_energies": over(kernels.sum_portion_at_walls, counts.portions_of_elements),
    "write_walls": over(kernels.write_all_walls, counts.one_thread),
    "count_wall_work": over(kernels.count_work_of_walls, counts.one_thread),
}


def deepest_overlaps(run: Translation, passes: Passes) -> list[Launch]:
    """Return the launch that measures the deepest overlap of each portion of elements; no launch without contacts."""
    named = dict(passes)
    pressed = named.get("press_pairs", named.get("press_pairs_and_faces"))
    if pressed is None:
        return []
    moving, law, pairs, _, travel = pressed[:5]
    _, walls, _ = named["check_travel"]
    contacts = named["press_walls"][2] if "press_walls" in named else run.once(walls, lambda: _none(run.span.n))
    threads = counts.portions_of_elements(run, {})
    return [(kernels.measure_overlaps(run.span, moving, law, pairs, contacts, walls, travel), threads)]


def _none(n: int) -> WallContacts:
    """Return an empty table of contacts of n elements with walls."""
    short = np.zeros(0, dtype=np.uint32)
    return WallContacts(
        np.zeros(n + 1, dtype=np.int64), short, short, np.zeros(0), np.zeros((0, 6)), np.zeros(0, dtype=np.uint8),
        no_rows("WallLoad", 0), exact_sums(0),
    )  # fmt: skip


def lists_of_contacts(passes: Passes) -> list[Any]:
    """Return the tables of the passes of a step that each new list of contacts replaces."""
    kinds = AdheringPairs, ContactPairs, FacePairs, NearPairs, RolledPairs, RolledWalls, Travel, WallContacts
    return list({id(table): table for _, tables in passes for table in tables if isinstance(table, kinds)}.values())


def walls_listed(passes: Passes) -> list[np.ndarray]:
    """Return the positions of walls at which the list was made, which each new list changes."""
    return [tables[1].listed for name, tables in passes if name == "check_travel"]
