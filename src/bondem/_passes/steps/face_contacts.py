"""Passes that steps are composed of, of `core/passes/contacts/face_contacts.cpp`.

Written by `python -m tests.core.passes`.
"""

from bondem._passes import StepEntry
from bondem._tables.contact_tables import ContactConstants, ContactPairs, ContactSums, FacePairs
from bondem._tables.step_tables import Ledger, Moving


def add_face_loads(contact_pairs: ContactPairs, face_pairs: FacePairs, contact_sums: ContactSums) -> StepEntry:
    """Adds forces of faces to the elements of a range.

    Over elements, one range per thread. Adds `sums` to elements.
    """
    return StepEntry("add_face_loads", (contact_pairs, face_pairs, contact_sums))


def sum_face_energies(
    moving: Moving, contact_constants: ContactConstants, contact_pairs: ContactPairs, face_pairs: FacePairs,
    ledger: Ledger
) -> StepEntry:
    """Adds the elastic energy of the pairs of a portion that touch by faces [J].

    Over elements, in portions.
    """
    return StepEntry("sum_face_energies", (moving, contact_constants, contact_pairs, face_pairs, ledger))
