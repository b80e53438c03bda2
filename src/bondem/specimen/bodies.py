"""Bodies: groups of elements of a lattice, with their names and the shapes that they fill."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from bondem._names import meant
from bondem._types import Ints, Mask
from bondem.errors import InputError
from bondem.geometry.elementary_shapes import BoundingBox, Shape
from bondem.specimen.particles import Particles, freeze

#: A body by its name or its number.
Which = str | int


@dataclass(frozen=True, eq=False)
class Bodies:
    """The bodies of a lattice, b of them.

    Attributes:
        label: number of the body of each element, 0 … b - 1, shape (n,).
        names: name of each body; "grains/3" belongs to the group "grains".
        shapes: shape that each body fills; None for a body without a shape.
    """

    label: Ints
    names: tuple[str, ...]
    shapes: tuple[Shape | None, ...]

    @cached_property
    def count(self) -> Ints:
        """Number of elements of each body, shape (b,)."""
        return freeze(np.bincount(self.label, minlength=len(self.names)))

    def require_one(self, owner: str) -> None:
        """Raise InputError for a scene of several bodies."""
        if len(self.names) > 1:
            several = len(self.names)
            raise InputError(f"{owner} takes one body, not a scene of {several}; give the body before bd.join")

    def numbers(self, owner: str, which: Which) -> Ints:
        """Return the numbers of the bodies with a name, in a group of names, or with one number, ascending, (k,).

        Raises:
            InputError: There is no such body.
        """
        if isinstance(which, str):
            found = [k for k, name in enumerate(self.names) if name == which or name.startswith(f"{which}/")]
            if found:
                return np.array(found)
            raise InputError(f"{owner}: no body is called {which!r}{meant(which, self.names)}")
        if not -len(self.names) <= which < len(self.names):
            raise InputError(f"{owner}: body {which} does not exist; give a number from 0 to {len(self.names) - 1}")
        return np.array([which % len(self.names)])

    def mask(self, owner: str, which: Which) -> Mask:
        """Return a mask of the elements of the bodies with a name, in a group, or with one number, shape (n,).

        Raises:
            InputError: There is no such body.
        """
        return np.isin(self.label, self.numbers(owner, which))

    def shape_of(self, owner: str, which: Which | None, particles: Particles) -> tuple[int, Shape]:
        """Return the number and shape of a body; None selects the only body of a scene.

        For a body without a shape, the shape is the box around its spheres.

        Raises:
            InputError: There is no such body, there are several, or `which` is None in a scene of several bodies.
        """
        if which is None and len(self.names) == 1:
            return 0, particles.envelope
        if which is None:
            first = self.names[0]
            raise InputError(f"{owner}: the scene has {len(self.names)} bodies; name one, such as body={first!r}")
        found = self.numbers(owner, which)
        if len(found) > 1:
            one = self.names[found[0]]
            raise InputError(f"{owner}: {len(found)} bodies are called {which!r}; name one, such as {one!r}")
        one = int(found[0])
        own = self.label == one
        shape = self.shapes[one]
        return one, BoundingBox.of(particles.position[own], particles.radius[own]) if shape is None else shape
