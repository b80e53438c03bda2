"""Quasi-static fracture by load factors: facets fail one by one, each at the load that it requires."""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import numpy as np

from bondem._blas import one_blas_thread
from bondem._checks import count, instance, number
from bondem._drawing import PlottedPath, columns_of
from bondem._names import warn_user
from bondem._progress import staged
from bondem._signals import Halt, noticing, stop_by
from bondem._types import Floats, Ints, Mask, PerBond, PerElement3
from bondem.errors import ConvergenceError, InputError, StrengthWarning
from bondem.model.model import Model
from bondem.model.state import State
from bondem.specimen.regions import Region
from bondem.statics.linear import Iteration, System, prefers_elimination
from bondem.statics.quasistatic.damaged_body import DamagedBody, Loaded
from bondem.statics.quasistatic.equilibrium import Eliminated, Equilibrium, Iterated
from bondem.statics.quasistatic.load_response import PointGauges, Reading
from bondem.statics.quasistatic.onset import FacetOnset, StressOnset, TractionOnset
from bondem.statics.quasistatic.pressed_cracks import LostPressure
from bondem.statics.quasistatic.softening_facets import SofteningFacets

# Relative difference of load factors below which facets fail in the user's order.
_TIE = 1e-9
# A body counts as parted if its stiffness is below this share of the initial one, or if broken facets store this
# share of its energy: the residual stiffness of broken facets matters more in slender bodies.
_PARTED, _RESIDUAL = 1e-5, 0.5
# Share of the events, the last ones, whose loads must be below the final load of a run.
_LAST = 0.05
# Least number of these events times the half-width of the band: about those of one facet that softens completely,
# which may occur at much lower loads than earlier events.
_FEWEST = 2.0
# Largest rotation of small motions [rad], for which cos is 1 to half a per cent, and share of the elements that may
# rotate by more, because loose parts may rotate freely.
_SMALL, _TURNED = 0.1, 0.1
# Largest number of rounds in which halves of facets open and close.
_ROUNDS = 40
# Reasons for ends of paths without an event.
_ENDS = {
    "strong": "nothing fails at any load",
    "folded": "the first facet would fail at {:.3g} times the loads and drives, where a tenth of the elements would"
    f" rotate by more than {_SMALL} rad",
}


@dataclass(frozen=True, eq=False)
class QuasistaticResult(PlottedPath):
    """Path of equilibria, each at the load at which the next facets fail, with e events and f failures of facets.

    Attributes:
        factor: factor of the load at each event [-], (e,); it falls where the path snaps back.
        load: load on the driven region along its motion or load [N], (e,).
        displacement: displacement of the driven region along the same direction [m], (e,).
        work: work of `load` until each event [J], (e,); the total work if nothing else moves under load.
        stored: elastic energy before each event, ½ load · displacement [J], (e,), under the same condition.
        energy: energy dissipated by each event [J], (e,). The sum over earlier events is work - stored. The last
            event has 0, because its dissipation is unknown.
        gauge: displacement between the regions of each gauge [m], (e, 3).
        bond: user's number of each facet that loses integrity, (f,).
        integrity: remaining integrity of the facet, (f,).
        event: event of the failure, (f,).
        position: centroid of the facet in the reference [m], (f, 3).
        bond_integrity: integrity of all facets at the end, user's order, (m,).
        end: reason for the end. "unloaded": the load is below `until`. "parted": the body is in parts. "strong":
            nothing fails at any load. "loose": parts are connected so weakly that no equilibrium is found. "folded":
            before the next event a tenth of the elements would rotate by more than 0.1 rad, so that motions are no
            longer small. "events": `most` events occurred. "interrupted": Ctrl-C was pressed.
        motion: displacements of the elements at the last event [m], (n, 3).
        state: equilibrium at the last event, before its facets fail; for a body that has parted, with the integrities
            after the event. For `bd.fragments`, `bd.cracks` and figures, and to continue in `bd.solve_explicit`.
            Conditions of its `model` are constant at the last factor.
        solutions: number of equilibria that were computed: one per event, and more where cracks close or open.
        iterations: total number of iterations.
    """

    factor: Floats
    load: Floats
    displacement: Floats
    work: Floats
    stored: Floats
    energy: Floats
    gauge: Mapping[str, Floats]
    bond: Ints
    integrity: Floats
    event: Ints
    position: PerElement3
    bond_integrity: PerBond
    end: str
    motion: PerElement3
    state: State
    solutions: int
    iterations: int

    @property
    def peak(self) -> float:
        """Largest load [N]; NaN if the path has no event."""
        return float(self.load.max(initial=0.0)) if len(self.load) else math.nan

    @property
    def table(self) -> dict[str, Floats]:
        """Displacement, load, factor, energies and gauges at each event, by name and unit, (e,) each."""
        found = {
            "displacement [m]": self.displacement, "load [N]": self.load, "factor [-]": self.factor,
            "work [J]": self.work, "stored [J]": self.stored, "dissipated [J]": self.energy,
        }  # fmt: skip
        for name, moved in self.gauge.items():
            found |= columns_of(f"{name} {{}} [m]", "xyz", moved)
        return found


@one_blas_thread
@staged("quasi-static run")
def solve_quasistatic(
    model: Model,
    drive: Region,
    *,
    ripple: float = 0.02,
    together: float = 0.005,
    until: float = 0.02,
    most: int = 100_000,
    gauges: Mapping[str, tuple[Region, Region]] | None = None,
    progress: Callable[[float], None] | None = None,
) -> QuasistaticResult:
    """Follow a body of cells as it fails without inertia, with all drives and loads scaled by one factor.

    Between two events the body is elastic and everything is proportional to the factor. Each event is the failure of
    the next facet, at whatever factor it requires. Snap-back is therefore followed, and nothing depends on speeds or
    damping. A facet softens in steps within a band around its softening line, and absorbs its fracture energy. Closed
    cracks carry pressure, without friction. Rotations are small; the path ends where they are not.

    Args:
        model: cells with `bd.Rankine`, or brittle facets with `bd.MohrCoulomb`. Its drives and loads are used at the
            end of their schedules, which is a factor of 1.
        drive: region that is driven or loaded by a `bd.Drive`, `bd.Load` or `bd.Pressure` of the model on the same
            region. Load and displacement are measured there.
        ripple: half-width of the band around the softening line, as a share of the traction; a smaller value gives
            more events.
        together: facets whose load factors are within this share of the least fail in one event, at the middle of
            the range. With 0 they fail one by one, equal ones in the order of their numbers.
        until: share of the peak load at which the path ends. All of the last twentieth of the events, at least
            2 / `ripple`, must stay below it, because single events occur at much lower loads than others.
        most: largest number of events.
        gauges: pairs of regions whose relative displacement is recorded, by name, or None.
        progress: function called with the completed share, 0 … 1, which never falls: how far the highest load of the
            last events is below the peak.

    Raises:
        InputError: The model has no cells, another criterion, cells that yield, planes with cohesion, contacts,
            eigenstrains or body forces; nothing is driven at `drive`; or an option is out of range.
        ConvergenceError: The body does not resist the load, for example without sufficient supports.
        RunInterrupted: Ctrl-C was pressed. The `.result` of the error is the path so far.

    Warns:
        FractureEnergyWarning: The pressure along cracks that began without it grows to a fifth of the strength.
        StrengthWarning: No facet fails before the path ends.

    Reference: sequentially linear analysis, Rots (2001); DeJong, Hendriks and Rots (2008).
    """
    instance("solve_quasistatic", "drive", drive, Region, "a region, such as bd.Face('x_max')")
    band = number("solve_quasistatic", "ripple", ripple, above=0.0, below=1.0)
    close = number("solve_quasistatic", "together", together, least=0.0, below=1.0)
    limit = count("solve_quasistatic", "most", most)
    share = number("solve_quasistatic", "until", until, least=0.0, below=1.0)
    pairs = {} if gauges is None else instance(
        "solve_quasistatic", "gauges", gauges, Mapping, "a mapping of names to pairs of regions"
    )  # fmt: skip
    with noticing() as halt:
        found = _followed(model, drive, pairs, (band, close, share, limit), progress, halt)
        stopped = halt()
    if stopped is not None and found.end == "interrupted":
        stop_by(stopped, f"interrupted after {len(found.factor)} events", found)
    return found


def _followed(
    model: Model, drive: Region, pairs: Mapping[str, tuple[Region, Region]], limits: tuple[float, float, float, int],
    progress: Callable[[float], None] | None, halt: Halt,
) -> QuasistaticResult:  # fmt: skip
    """Follow a path to its end or an interrupt; `limits`: `ripple`, `together`, `until`, `most` of the caller."""
    band, close, share, limit = limits
    body, equilibrium, onset = _begin(model)
    reading, gauge = Reading(body, drive), PointGauges(model, pairs)
    path, lost, softening = _Path(model), LostPressure(body, onset.strength), SofteningFacets(body, onset, band)
    motion, before = body.motion.copy(), (body.integrity, body.closed)
    first, size, reported, factor, end = 0.0, 0.0, 0.0, 0.0, "events"
    report = progress or (lambda share: None)
    report(0.0)
    for event in range(limit):
        if halt() is not None:
            end = "interrupted"
            break
        try:
            motion, found = _balance(body, equilibrium, motion, size)
        except ConvergenceError:
            if not event:
                raise
            end = "loose"
            break
        load, displacement = reading.read(found, motion)
        path.settle(body.potential(motion), load, displacement)
        stiffness, size = load / displacement, body.size(found)
        first = first or stiffness
        if stiffness < _PARTED * first or _is_residual(body, found, motion, load * displacement):
            end = "parted"
            break
        failing, factor = _next(body, onset, softening, found, close)
        if not len(failing):
            end = "strong"
            break
        if _folds(motion, factor):
            end = "folded"
            break
        left, across = softening.fail(found, failing, factor)
        for k, integrity in zip(failing.tolist(), left.tolist(), strict=True):
            path.add(k, integrity)
        before = body.integrity.copy(), body.closed.copy()
        body.weaken(failing, left, body.closed[failing], across)
        lost.add(found, factor, failing)
        path.add_event(factor, gauge.read(motion), motion)
        borne = path.borne(math.ceil(max(_LAST * (event + 1), _FEWEST / band)))
        if borne < share:
            end = "unloaded"
            break
        reported = max(reported, (1.0 - borne) / (1.0 - share))
        report(reported)
    report(1.0)
    lost.warn()
    result = path.result(body, before, end, equilibrium)
    if end in _ENDS and not len(result.factor):
        warn_user(
            f"solve_quasistatic: the path ends before its first event and has no peak: {_ENDS[end].format(factor)};"
            " check the signs of the loads and drives (bd.Rankine limits tension only) and the strengths, or use"
            " solve_explicit", StrengthWarning,
        )  # fmt: skip
    return result


def _balance(body: DamagedBody, equilibrium: Equilibrium, motion: Floats, size: float) -> tuple[Floats, Loaded]:
    """Return motion, (6 n,), and loads in equilibrium, once no crack opens or closes; `size`: last `body.size`."""
    def rest() -> tuple[Floats, Loaded]:
        found = body.motion + equilibrium.solve(body.right - body.pull, motion - body.motion, size)
        return found, body.loaded(found)

    motion, found = rest()
    for _ in range(_ROUNDS):
        turning = np.flatnonzero(found.turned.any(axis=1))
        if not len(turning):
            break
        facets = found.cracked[turning]
        body.weaken(facets, body.integrity[facets], body.closed[facets] ^ found.turned[turning])
        motion, found = rest()
    return motion, found


def _is_residual(body: DamagedBody, found: Loaded, motion: Floats, worked: float) -> bool:
    """Return True if broken facets store more than half of the energy; `worked` is load · displacement [J]."""
    return body.residual_energy(found) > _RESIDUAL * 0.5 * max(abs(worked), abs(float(body.right @ motion)))


def _folds(motion: Floats, factor: float) -> bool:
    """Return True if more than a tenth of the elements rotate beyond small motions at a load factor."""
    turn = factor * np.linalg.norm(motion.reshape(-1, 6)[:, 3:], axis=1)
    return float((turn > _SMALL).mean()) > _TURNED


def _next(
    body: DamagedBody, onset: FacetOnset, softening: SofteningFacets, found: Loaded, close: float
) -> tuple[Ints, float]:
    """Return the facets that fail next, in the user's order, and the load factor; none if nothing fails."""
    limit = softening.limits(found)
    tie = max(close, _TIE)
    least = float(limit.min(initial=np.inf)) * (1.0 + tie)
    whole, factor = onset.factors(found, np.flatnonzero(body.integrity == 1.0), least, tie)
    facet, factor = np.concatenate([found.cracked, whole]), np.concatenate([limit, factor])
    least = float(factor.min(initial=np.inf))
    if not np.isfinite(least):
        return facet[:0], least
    failing = facet[factor <= least * (1.0 + tie)]
    failing = failing[np.argsort(body.model.layout.bond_order[failing])]
    return failing if close > 0.0 else failing[:1], least * (1.0 + 0.5 * close)


class _Path:
    """Record of the events of a path."""

    def __init__(self, model: Model) -> None:
        self._model = model
        self._facets: list[tuple[int, float, int]] = []
        self._rows: list[tuple[float, float, float, float, float]] = []
        self._gauge: list[dict[str, Floats]] = []
        self._energy: list[float] = []
        self._potential = self._load = self._way = self._work = self._peak = 0.0
        self._motion, self._factor = np.zeros(6 * len(model.layout.order)), 0.0

    def settle(self, potential: float, load: float, displacement: float) -> None:
        """Record the equilibrium after the last event at a factor of 1, and the energy that the event dissipated.

        Args:
            potential: energy of the body less the work of its loads [J], which falls by the dissipated energy.
            load: load on the driven region [N].
            displacement: displacement of this region [m].
        """
        if self._rows:
            square = self._rows[-1][0] ** 2
            self._energy.append(square * (self._potential - potential))
            self._work += 0.5 * square * (self._load + load) * (displacement - self._way)
        self._potential, self._load, self._way = potential, load, displacement

    def add(self, k: int, integrity: float) -> None:
        """Record a facet that fails in the coming event."""
        self._facets.append((k, integrity, len(self._rows)))

    def add_event(self, factor: float, gauge: dict[str, Floats], motion: Floats) -> None:
        """Record an event, with the gauges at a factor of 1."""
        before = self._rows[-1][0] if self._rows else 0.0
        self._work += 0.5 * self._load * self._way * (factor**2 - before**2)
        load, displacement = factor * self._load, factor * self._way
        self._rows.append((factor, load, displacement, self._work, 0.5 * load * displacement))
        self._gauge.append({name: factor * moved for name, moved in gauge.items()})
        self._motion, self._factor = motion, factor

    def borne(self, last: int) -> float:
        """Return the highest load of the last events over the peak of all, 1 if there are fewer events [-]."""
        self._peak = max(self._peak, self._rows[-1][1])
        if len(self._rows) < last or self._peak <= 0.0:
            return 1.0
        return max(load for _, load, *_ in self._rows[-last:]) / self._peak

    def result(
        self, body: DamagedBody, before: tuple[Floats, Mask], end: str, equilibrium: Equilibrium
    ) -> QuasistaticResult:
        """Return the whole path; `before` are the integrities and closed halves before the last event."""
        model, layout = self._model, self._model.layout
        rows = np.array(self._rows).reshape(-1, 5)
        facet = np.array([k for k, *_ in self._facets], dtype=np.int64)
        bond: Ints = layout.bond_order[facet]
        own = body.left[layout.reversed.bond_order]
        if end != "parted":
            body.restore(*before)
        state = body.state(self._motion, self._factor, balanced=end != "parted")
        energy = np.array(self._energy + [0.0] * (len(rows) - len(self._energy)))
        gauge = {name: np.array([one[name] for one in self._gauge]) for name in (self._gauge[0] if len(rows) else {})}
        return QuasistaticResult(
            factor=rows[:, 0], load=rows[:, 1], displacement=rows[:, 2], work=rows[:, 3], stored=rows[:, 4],
            energy=energy, gauge=gauge, bond=bond,
            integrity=np.array([left for _, left, _ in self._facets]),
            event=np.array([number for *_, number in self._facets], dtype=np.int64),
            position=model.lattice.elements.bond_middle[bond], bond_integrity=own, end=end,
            motion=self._factor * self._motion.reshape(-1, 6)[layout.rank, :3], state=state,
            solutions=equilibrium.solutions, iterations=equilibrium.rounds,
        )  # fmt: skip


def _begin(model: Model) -> tuple[DamagedBody, Equilibrium, FacetOnset]:
    """Return the uncracked body, its solver of equilibria, and the onset of failure of its facets.

    Raises:
        InputError: The model has no quasi-static path.
    """
    instance("solve_quasistatic", "model", model, Model, "bd.Model(...)")
    model.interaction.require_facets(
        "solve_quasistatic needs cells; use bd.connect(..., method='laguerre') and bd.CellBond"
    )
    soft, brittle = model.softening, model.breaking
    if brittle is None and (soft is None or soft.judge is not None or soft.yielding):
        raise InputError(
            "solve_quasistatic: cells that yield and other criteria are not supported; give the model"
            " failure=bd.Rankine(tension=..., fracture_energy=...) or bd.MohrCoulomb without a fracture energy, or"
            " use solve_explicit"
        )
    if model.constraints.strain_part.size or model.constraints.body_on.size:
        raise InputError("solve_quasistatic scales drives and loads only; leave out bd.Eigenstrain and bd.BodyForce")
    if soft is not None and np.isfinite(soft.cohesion).any():
        raise InputError(
            "solve_quasistatic: facets of a plane with cohesion slip with friction, which has no path of load"
            " factors; give planes bd.Rankine(tension=..., fracture_energy=...), or use solve_explicit"
        )
    # cells whose facets may fail have no gradients of the dilatation, unlike those of the model without failure
    system = replace(System.of(replace(model, failure=None)), matrix=model.interaction.stiffness())
    equilibrium: Equilibrium
    if prefers_elimination(system):
        body = DamagedBody(model, system, np.tile(np.eye(6), (len(system.free), 1, 1)))
        equilibrium = Eliminated(body.system)
    else:
        iteration = Iteration(system)
        body = DamagedBody(model, system, iteration.root)
        equilibrium = Iterated(body.system, body.matrix, iteration, body.integrity)
    if soft is not None:
        return body, equilibrium, StressOnset(body, soft)
    assert brittle is not None
    return body, equilibrium, TractionOnset(body, brittle)
