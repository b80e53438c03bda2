"""Targets: final states to which soft spheres are scaled after a method has packed them.

Above jamming the mean overlap grows linearly with ln(scale), and so does (z - z_J)² (O'Hern et al., Phys. Rev. E 68,
2003). Here z_J is the coordination number at jamming. A few scales are therefore sufficient.
"""

import math
from dataclasses import dataclass
from typing import Protocol

from bondem._checks import instance, number
from bondem.errors import InputError, PackingError
from bondem.packing.soft_spheres import Rest, SoftSpheres
from bondem.packing.start import ACROSS, enough

# Rms force over mean contact force at rest, while the search is far from the target and in the final packing.
_ROUGH, _FINE = 3e-2, 5e-3

# Deviation of the coordination number from which relaxation is fine, and that in the final packing, unless a single
# contact is more.
_NEAR, _ACCEPTED = 0.25, 0.01

# First guesses: z at jamming, rattlers included, and d(mean overlap / R̄)/d ln(scale).
_Z_JAMMED, _GROWTH = 5.4, 1.5

# Relative growth of the radii of loose spheres, and their largest shrinkage if the spheres press too hard.
_TIGHTEN, _LOOSEN = 0.005, 0.1

# Largest numbers of steps to rest and in total; a usual packing takes about 2500 in total.
_STEPS, _ALL_STEPS = 10_000, 50_000
# Largest numbers of scales tried for a coordination number (usually 10, seldom 20), and of brackets that end at a
# jump from loose spheres to too many contacts. They end a search below the coordination number at jamming, where
# loose spheres need hardly any steps. A packing that rearranges may also jump.
_SCALES, _JUMPS = 60, 4
# Largest numbers of steps to rest and in total at jamming, where hardly any mode is stiff.
_JAMMED_STEPS, _ALL_JAMMED_STEPS = 20_000, 400_000

# Largest overlap of two spheres, over the smaller radius; `Particles` rejects more than half.
_LARGEST_OVERLAP = 0.49

#: Coordination number of a packing without a target.
USUAL = 6.2
# Largest radius over the smallest from which radii are widely spread.
_WIDE = 3.0

# Largest mean overlap of jammed spheres, which adds 0.05 contacts per sphere to the isostatic 6, and largest overlap.
# Mean overlap of loose spheres, and that below which relaxation must be fine. All are over the mean radius.
_JAMMED_OVERLAP, _JAMMED_WORST = 6e-5, 1e-3
_JAMMED_LOOSE, _DELICATE = 1e-5, 2e-3


class Target(Protocol):
    """A property of the final packing, and the way to reach it."""

    def reach(self, spheres: SoftSpheres) -> None:
        """Scale the radii and bring the spheres to rest until the target is met.

        Raises:
            PackingError: The target was not met.
        """
        ...


@dataclass(frozen=True)
class Contacts:
    """Target coordination number z = 2 contacts / spheres, over all spheres [-]."""

    coordination_number: float

    def reach(self, spheres: SoftSpheres) -> None:
        search = _ScaleSearch(self.coordination_number, math.log(spheres.scale), wide=_spread_of(spheres) >= _WIDE)
        tolerance, first, tried = _ROUGH, spheres.steps, 0
        while True:
            tried += 1
            rest = spheres.relax(search.scale, tolerance=tolerance, steps=_STEPS)
            miss = abs(rest.coordination_number - self.coordination_number)
            if rest.settled and tolerance == _FINE and miss <= max(_ACCEPTED, 2.0 / len(spheres.sphere)):
                break
            if tried >= _SCALES or search.jumps >= _JUMPS or spheres.steps - first > _ALL_STEPS:
                narrow = (
                    "they jam at about 4 to 6; ask for a larger coordination_number=, more spheres or another seed=,"
                    " or for volume_fraction= or jamming=True"
                )
                raise PackingError(
                    f"{spheres} reached a coordination number of {rest.coordination_number:.2f} instead of"
                    f" {self.coordination_number:.2f}; {_advice(spheres, narrow, self)}"
                )
            if rest.settled and tolerance == _ROUGH and miss < _NEAR:
                tolerance = _FINE
                search.forget()
            else:
                search.learn(rest)
        what = f"a coordination number of {self.coordination_number:.2f}"
        _check_overlap(spheres, what, "coordination_number=")


@dataclass(frozen=True)
class Fraction:
    """Target volume of the spheres over that of the shape [-]; overlaps count twice."""

    volume_fraction: float

    def reach(self, spheres: SoftSpheres) -> None:
        rest = spheres.relax(spheres.scale_for(self.volume_fraction), tolerance=_FINE, steps=_ALL_STEPS)
        if not (rest.settled or rest.loose):
            narrow = "ask for jamming=True, another seed= or another volume_fraction="
            raise PackingError(
                f"{spheres} did not come to rest at a volume fraction of {self.volume_fraction:.4f}, too near to"
                f" jamming; {_advice(spheres, narrow, self)}"
            )
        _check_overlap(spheres, f"a volume fraction of {self.volume_fraction:.4f}", "volume_fraction=")


@dataclass(frozen=True)
class Jammed:
    """Target state in which the spheres just begin to carry load, approached from above."""

    def reach(self, spheres: SoftSpheres) -> None:
        size, step, first = math.log(spheres.scale), _TIGHTEN, spheres.steps
        tolerance = _ROUGH
        while spheres.steps - first <= _ALL_JAMMED_STEPS:
            rest = spheres.relax(math.exp(size), tolerance=tolerance, steps=_JAMMED_STEPS, loose=_JAMMED_LOOSE)
            fine, tolerance = tolerance == _FINE, _FINE
            if rest.settled and rest.mean_overlap <= _JAMMED_OVERLAP and _barely_touch(spheres, rest):
                if fine:
                    return
            elif rest.settled:
                # Aim at a fifth of the overlap, a step that keeps most contacts.
                wanted = max(0.7 * _JAMMED_OVERLAP, 0.2 * rest.mean_overlap)
                if rest.mean_overlap <= _JAMMED_OVERLAP:  # one deep pair
                    wanted = 0.7 * rest.mean_overlap
                step = (rest.mean_overlap - wanted) / _GROWTH
                size -= step
                step *= 0.4
                tolerance = _ROUGH if wanted > _DELICATE else _FINE
            elif rest.loose or rest.mean_overlap < _JAMMED_OVERLAP:  # spheres too soft to come to rest count as loose
                size += max(step, 0.5 * _JAMMED_OVERLAP / _GROWTH)
                step *= 1.5
        narrow = "ask for another seed=, more spheres or a coordination_number="
        raise PackingError(f"{spheres} did not come to rest at jamming; {_advice(spheres, narrow, self)}")


def _barely_touch(spheres: SoftSpheres, rest: Rest) -> bool:
    """Return True if overlaps are at most 1e-3 mean radii or, if masses grow with size, of the smaller radius."""
    if rest.largest_overlap <= _JAMMED_WORST:
        return True
    return spheres.weighed and spheres.deepest() <= _JAMMED_WORST


def _advice(spheres: SoftSpheres, narrow: str, target: Target) -> str:
    """Return the advice `narrow` on another target or, for widely spread radii, advice on number and sizes."""
    spread = _spread_of(spheres)
    if spread < _WIDE:
        return narrow
    usual = isinstance(target, Contacts) and target.coordination_number == USUAL
    return (
        f"their radii differ by a factor of {spread:.1f} and the largest diameter is"
        f" {2.0 * spheres.sphere[:, 3].max():.3g} m;"
        f" ask for more spheres{'' if usual else f', the coordination_number={USUAL} of packings without a target'}"
        " or sizes that differ less"
    )


def _spread_of(spheres: SoftSpheres) -> float:
    """Return the largest radius over the smallest [-]."""
    radius = spheres.sphere[:, 3]
    return float(radius.max() / radius.min())


def _check_overlap(spheres: SoftSpheres, what: str, option: str) -> None:
    deepest = spheres.deepest()
    if deepest > _LARGEST_OVERLAP:
        # a number is advised only if the walls are too near to each other
        needed, _ = enough(spheres.shape, spheres.sphere[:, 3], ACROSS)
        more = f"count={needed} or more" if needed > 2 * len(spheres.sphere) else "more spheres"
        raise PackingError(
            f"{spheres} reach {what} only with overlaps of {deepest:.2f} of the smaller radius of a pair; ask for"
            f" {more} or a smaller {option}"
        )


def chosen(count: int, coordination_number: float | None, volume_fraction: float | None, *, jamming: bool) -> Target:
    """Return the target of a request, a coordination number of 6.2 if the request names no target.

    Raises:
        InputError: The request names more than one target, or a target out of range.
    """
    instance("pack", "jamming", jamming, bool, "True or False")
    if (coordination_number is not None) + (volume_fraction is not None) + jamming > 1:
        raise InputError("give one target only: coordination_number=, volume_fraction= or jamming=True")
    if jamming:
        return Jammed()
    if volume_fraction is not None:
        wanted = "the volume of spheres over that of the shape, above 0 up to 0.8 (random packings jam near 0.64)"
        phi = number("", "volume_fraction", volume_fraction, above=0.0, advice=wanted)
        if phi > 0.8:
            raise InputError(f"volume_fraction = {phi}; give {wanted}")
        return Fraction(phi)
    z = USUAL if coordination_number is None else number("pack", "coordination_number", coordination_number)
    if not 0.0 < z < count:
        raise InputError(
            f"{count} spheres cannot touch {z} others each; give a positive coordination_number= and more spheres"
        )
    return Contacts(float(z))


class _ScaleSearch:
    """Search for the scale of the radii at which the coordination number is on target.

    Spheres that have not come to rest in time count as loose. Widely spread radii (`wide`) come to rest slowly, so
    that such spheres do not count as loose if they carry load.
    """

    def __init__(self, coordination_number: float, size: float, *, wide: bool) -> None:
        self._wanted = _excess(coordination_number)
        self._wide = wide
        self._size = size  # ln(scale)
        self.jumps = 0  # number of brackets that ended between loose spheres and too many contacts
        self.forget()

    @property
    def scale(self) -> float:
        """Factor on the initial radii to try next [-]."""
        return math.exp(self._size)

    def forget(self) -> None:
        """Discard all results, because finer relaxation changes the contacts."""
        self._below: tuple[float, float] | None = None
        self._above: tuple[float, float] | None = None

    def learn(self, rest: Rest) -> None:
        """Add the result of the present scale, and choose the next scale."""
        excess = _excess(rest.coordination_number) if rest.settled else 0.0
        if self._wide and not (rest.settled or rest.loose):
            excess = max(_excess(rest.coordination_number), 0.0)
        if excess > self._wanted:
            self._above = (self._size, excess)
        else:
            self._below = (self._size, excess)
        if self._below is not None and self._above is not None:
            (s0, e0), (s1, e1) = self._below, self._above
            self._size = s0 + min(max((self._wanted - e0) / (e1 - e0), 0.1), 0.9) * (s1 - s0)
            if s1 - s0 < 1e-4:  # the packing has rearranged, so that the bracket is no longer valid
                self.jumps += e0 == 0.0
                self.forget()
        elif excess <= 0.0:
            self._size += _TIGHTEN
        else:
            # just above jamming the guess may be far too high, or without bound too low
            step = rest.mean_overlap * (self._wanted / excess - 1.0) / _GROWTH
            self._size += min(max(step, -_LOOSEN), 2.0 * _TIGHTEN)


def _excess(coordination_number: float) -> float:
    above = coordination_number - _Z_JAMMED
    return math.copysign(above * above, above)
