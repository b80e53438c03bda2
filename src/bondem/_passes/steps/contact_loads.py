"""Passes that steps are composed of, of `core/passes/contacts/contact_loads.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.contact_tables import ContactConstants, ContactPairs, ContactSums, FacePairs, NearPairs, Travel
from bondem._tables.step_tables import Ledger, Moving, StepBlocks


def add_contact_loads(moving: Moving, step_blocks: StepBlocks, contact_sums: ContactSums) -> StepEntry:
    """Adds forces and losses of contacts to those of the elements, and sets those of contacts to zero.

    Over elements of a block, then shared ones. Changes `ContactSums.sums`, `StepBlocks.sums`, `loss` of an
    element.
    """
    return StepEntry("add_contact_loads", (moving, step_blocks, contact_sums))


def add_pair_loads(
    contact_constants: ContactConstants, contact_pairs: ContactPairs, near_pairs: NearPairs, contact_sums:
    ContactSums
) -> StepEntry:
    """Adds forces of pairs to the elements of a range, in the order of the pairs.

    Over elements, one range per thread. Adds `sums` to elements.
    """
    return StepEntry("add_pair_loads", (contact_constants, contact_pairs, near_pairs, contact_sums))


def press_pairs(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, near_pairs: NearPairs,
    travel: Travel
) -> StepEntry:
    """Finds forces and memory of the pairs of a portion of elements; renews the list of near pairs after large
    motions.

    Over elements, in portions. Reads `motion`, `pose` at both ends; writes `measured` of an element.
    """
    return StepEntry("press_pairs", (moving, contact_constants, contact_pairs, near_pairs, travel))


def press_pairs_and_faces(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, near_pairs: NearPairs,
    travel: Travel, face_pairs: FacePairs
) -> StepEntry:
    """Finds forces and memory of the pairs of a portion of cells with cracks, which touch by faces too.

    Over elements, in portions. Reads `faced`, `motion`, `pose` at both ends; writes `measured` of an element.
    """
    return StepEntry("press_pairs_and_faces", (
        moving, contact_constants, contact_pairs, near_pairs, travel, face_pairs
    ))


def sum_pair_energies(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, ledger: Ledger
) -> StepEntry:
    """Sums the elastic energy of the pairs of a portion [J].

    Over elements, in portions.
    """
    return StepEntry("sum_pair_energies", (moving, contact_constants, contact_pairs, ledger))
