"""Contact law of fragments and platens in laboratory tests of bonded spheres and of balls."""

import math

import numpy as np

from bondem._types import Floats
from bondem.interactions.contact.contact_law import ContactLaw, LinearContact

# Coefficient of friction between fragments if no contact law is given [-].
_FRICTION = 0.4


def fragment_contact(stiffness: float, radius: Floats) -> ContactLaw:
    """Return a contact law with a friction of 0.4, by which contacts with walls are as stiff as the median bond.

    Args:
        stiffness: median normal stiffness k_n of the bonds or facets [N/m].
        radius: contact radii of the elements [m], (n,).
    """
    return LinearContact(E=stiffness / (math.pi * float(np.median(radius))), friction=_FRICTION)
