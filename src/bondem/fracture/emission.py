"""Acoustic emission: breakages close in space and time form one event, with an energy and a magnitude."""

from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import KDTree

from bondem._checks import instance, number
from bondem._types import Floats, Ints
from bondem.damage.criteria.criterion import MODES
from bondem.errors import InputError
from bondem.fracture.magnitudes import BValue, b_value_of, magnitude_of
from bondem.model.model import Model
from bondem.observables.breakage import BrokenBonds

# Default distance within which breakages belong to one emission, in mean lengths of the bonds.
_REACH = 2.0


@dataclass(frozen=True, eq=False)
class AcousticEmission:
    """Emissions, c clusters of breakages, in the order in which they begin.

    The energy is all the energy released by breakage; the share that would reach a sensor is unknown. A share equal
    for all emissions shifts all magnitudes by the same amount and does not change b.

    Attributes:
        time: beginning of each emission [s], shape (c,).
        duration: time from its first to its last breakage [s], shape (c,).
        position: energy-weighted mean position [m], shape (c, 3); in a periodic cell, the image near its beginning.
        energy: energy released [J], shape (c,).
        magnitude: 2/3 log10(E / J) - 3.2, from log10(E / J) = 1.5 M + 4.8; -inf for zero energy, shape (c,).
        count: number of breakages, shape (c,).
        mode: failure mode in which most energy was released, shape (c,).
        label: emission of each row of the events, shape (e,).

    Reference: Gutenberg and Richter (1956), log10(E / erg) = 1.5 M + 11.8.
    """

    time: Floats
    duration: Floats
    position: Floats
    energy: Floats
    magnitude: Floats
    count: Ints
    mode: np.ndarray
    label: Ints

    def __len__(self) -> int:
        return len(self.time)

    def b_value(self, *, completeness: float | None = None, width: float = 0.1) -> BValue:
        """Estimate the slope b of log10 N(≥ M) = a - b M by maximum likelihood.

        The estimate is b = log10(e) / (mean(M) - M_c) over all M ≥ M_c. Magnitudes here are not rounded to bins, so
        that M_c needs no correction for a bin width. Cracks through the whole specimen, and single breakages of about
        one energy, do not follow a power law: inspect the magnitudes before you trust a slope.

        Args:
            completeness: M_c, above which no emission is missing. The default is the middle of the fullest bin, the
                point of maximum curvature, which is often a little low.
            width: width of these bins [-].

        Raises:
            InputError: There are fewer than 10 emissions above M_c, all of one magnitude, or the width is too small.

        Reference: Aki (1965); Utsu (1965); error by Shi and Bolt (1982); M_c by Wiemer and Wyss (2000).
        """
        return b_value_of(self.magnitude, completeness, width)


def acoustic_emission(
    events: BrokenBonds, *, time: float | None = None, distance: float | None = None, model: Model | None = None
) -> AcousticEmission:
    """Group breakages that are near each other in space and time into emissions.

    Two breakages are linked if they are at most `distance` and at most `time` apart. All breakages joined by links
    form one emission, much as Hazzard and Young (2002) group broken bonds. Both numbers define what an emission is:
    vary them.

    Args:
        events: broken bonds, `run.events`.
        time: largest time between linked breakages [s]. The default is the time in which a wave in a thin rod,
            √(E/ρ), travels `distance`.
        distance: largest distance between linked breakages [m]. The default is twice the mean length of the bonds, or
            spacing of the cells.
        model: model from which the defaults are computed; without it give both numbers. In a periodic model distances
            cross the edges of its cell. For beams the wave is that of a chain, L √(k_n / m), median of all bonds.

    Raises:
        InputError: Neither a model nor both numbers are given, or a number is not positive.
    """
    instance("acoustic_emission", "events", events, BrokenBonds, "run.events")
    if model is not None:
        instance("acoustic_emission", "model", model, Model, "bd.Model(...) or None")
    if model is None and (time is None or distance is None):
        raise InputError("acoustic_emission: time or distance is missing; give time= [s], distance= [m], or model=")
    if distance is None:
        assert model is not None
        distance = _REACH * float(model.lattice.length.mean())
    reach = number("acoustic_emission", "distance", distance, unit="m", above=0.0)
    if time is None:
        assert model is not None
        time = reach / model.interaction.wave_speed(model.mass)
    span = number("acoustic_emission", "time", time, unit="s", above=0.0)
    period = None if model is None else model.lattice.particles.period
    label = _clusters(events, reach, span, period)
    return _emissions(events, label, period)


def _clusters(events: BrokenBonds, reach: float, span: float, period: Floats | None) -> Ints:
    """Return the cluster of each breakage, numbered in the order in which clusters begin, (e,)."""
    e = len(events)
    near = np.zeros((0, 2), dtype=np.int64)
    if e:
        place, box = events.position / reach, None
        if period is not None:
            edge = period / reach
            place = np.mod(place, edge)
            place, box = np.where(place >= edge, 0.0, place), np.append(edge, 0.0)
        # pairs near in time and in each coordinate, then those among them within the distance
        tree = KDTree(np.column_stack([place, (events.time - events.time.min()) / span]), boxsize=box)
        near = tree.query_pairs(1.0, p=np.inf, output_type="ndarray")
        apart = place[near[:, 1]] - place[near[:, 0]]
        if period is not None:
            apart -= period / reach * np.rint(apart * reach / period)
        near = near[(apart**2).sum(axis=1) <= 1.0]
    links = coo_array((np.ones(len(near), dtype=bool), (near[:, 0], near[:, 1])), shape=(e, e))
    many, found = connected_components(links, directed=False)
    begin = np.full(many, np.inf)
    np.minimum.at(begin, found, events.time)
    return np.argsort(np.argsort(begin, kind="stable"))[found]


def _emissions(events: BrokenBonds, label: Ints, period: Floats | None) -> AcousticEmission:
    c = int(label.max(initial=-1)) + 1
    order = np.lexsort((events.time, label))
    first = order[np.searchsorted(label[order], np.arange(c))]
    last = np.full(c, -np.inf)
    np.maximum.at(last, label, events.time)
    energy = np.bincount(label, events.energy, c).astype(float)
    # breakages of an emission without released energy have equal weights
    weight = np.where(energy[label] > 0.0, events.energy, 1.0)
    origin = events.position[first]
    way = events.position - origin[label]
    if period is not None:
        way -= period * np.rint(way / period)
    moment = np.zeros((c, 3))
    np.add.at(moment, label, weight[:, None] * way)
    share = np.column_stack([np.bincount(label, weight * (events.mode == mode), c) for mode in MODES])
    return AcousticEmission(
        time=events.time[first], duration=last - events.time[first],
        position=origin + moment / np.bincount(label, weight, c)[:, None], energy=energy,
        magnitude=magnitude_of(energy), count=np.bincount(label, minlength=c),
        mode=np.array(MODES)[share.argmax(axis=1)], label=label,
    )  # fmt: skip
