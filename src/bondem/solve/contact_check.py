"""Contacts of a run, checked for what their law and the time step do not describe."""

import warnings

import numpy as np

from bondem._types import Floats
from bondem.errors import ContactWarning
from bondem.kernels.tables import ContactTable
from bondem.kernels.walls import RATE
from bondem.model.contacts import ContactModel

# Relative displacement per step over the smaller radius from which a contact is not resolved.
_FAST = 0.1


class ContactCheck:
    """Gives one warning for overlaps beyond the law, and one for motion beyond the step.

    It is asked when the list of contacts is made anew, which fast elements bring about every few steps, and at the
    end of each compiled call.
    """

    def __init__(self, contacts: ContactModel, dt: float) -> None:
        self._radius, self._dt = contacts.radius, dt
        self._deepest = contacts.law.deepest
        self._law = type(contacts.law).__name__
        self._deep = self._fast = False

    def look(self, c: ContactTable, motion: Floats, time: float) -> None:
        """Look at the contacts of a list.

        Args:
            c: the list.
            motion: of the elements, velocities in the first three columns.
            time: present time [s].

        Warns:
            ContactWarning: an overlap is beyond the law, or a motion beyond the step; each once.
        """
        if not self._deep and c.far[2] > self._deepest:
            self._deep = True
            warnings.warn(
                f"a contact overlaps by {c.far[2]:.2g} of the smaller radius at t = {time:.6g} s, beyond the"
                f" {self._deepest:.2g} up to which {self._law} describes it; use a stiffer law, a lower speed or load, or"
                " a smaller dt",
                ContactWarning, stacklevel=5,
            )  # fmt: skip
        if not self._fast:
            share = self._dt * self._fastest(c, motion[:, :3])
            if share > _FAST:
                self._fast = True
                warnings.warn(
                    f"an element moves by {share:.2g} of its radius per step against others at t = {time:.6g} s, and"
                    f" may pass through them; give dt= at most {_FAST / share * self._dt:.2g} s",
                    ContactWarning, stacklevel=5,
                )  # fmt: skip

    def _fastest(self, c: ContactTable, velocity: Floats) -> float:
        """Largest relative velocity over the smaller radius, of listed pairs, of elements and their walls, and of
        each element against the mean of all [1/s].
        """
        speed = [np.linalg.norm(velocity - velocity.mean(axis=0), axis=1) / self._radius]
        free = (c.bond < 0) | (c.joined[np.maximum(c.bond, 0)] <= 0.0) if len(c.joined) else c.bond < 0
        a, b = c.first[free], c.second[free]
        speed.append(np.linalg.norm(velocity[b] - velocity[a], axis=1) / np.minimum(self._radius[a], self._radius[b]))
        p = np.repeat(np.arange(len(self._radius)), np.diff(c.wall_start))
        speed.append(np.linalg.norm(velocity[p] - c.walls[c.wall, RATE : RATE + 3], axis=1) / self._radius[p])
        return max(float(values.max(initial=0.0)) for values in speed)
