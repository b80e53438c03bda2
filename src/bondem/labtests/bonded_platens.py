"""Bonded spheres between rigid platens: contact, elastic response, and slow loading to failure."""

import math
import warnings
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any, cast

import numpy as np

from bondem._names import users_line
from bondem._types import Floats, Ints, Mask
from bondem.boundary.conditions import BoundaryCondition, Drive, Fix
from bondem.boundary.gauges import AnyGauge, Gauge, WallGauge
from bondem.boundary.schedules import Ramp
from bondem.boundary.wall_motions import Driven
from bondem.boundary.walls import PlaneWall, Wall
from bondem.damage.failure_assignment import FailureAssignment
from bondem.damage.implied_fracture import ImpliedFracture
from bondem.dynamics.damping import LocalDamping
from bondem.dynamics.plan import Status
from bondem.errors import InputError, NotQuasistaticWarning, StrengthWarning
from bondem.interactions.cells.cell_constants import CellAssignment
from bondem.interactions.contact.contact_law import ContactLaw
from bondem.interactions.law_catalogue import AnyLaw, kind_of
from bondem.labtests.arguments import check
from bondem.labtests.fragment_contact import fragment_contact
from bondem.labtests.quasi_static_rig import Rig, RunOptions, StrengthTest, load_rig, matrix_of
from bondem.model.model import Model
from bondem.observables.breakage import failure_index
from bondem.specimen.lattice import Lattice
from bondem.specimen.regions import Index
from bondem.statics.static import StaticResult, solve_static

# Local damping of tests of bonded spheres, that of Potyondy and Cundall (2004).
_DAMPING = 0.7
# Passes of sound until the expected peak in successive attempts. An attempt is quasi-static if the difference of the
# forces of both ends has at most this root mean square over the peak.
_TRAVERSES, _BALANCE = (50.0, 100.0, 200.0), 0.02
# Share of the bonds that have reached their strength in the elastic solution at the expected peak.
_REACHED = 0.05
# Motion of the elastic solution over the length [-]; largest factor on it and bisections in the search of the load.
_MOTION, _FARTHEST, _HALVINGS = 1e-5, 1e6, 12
# A maximum after this share of the records is not a peak, as the load still rises.
_LATE = 0.98
#: A peak above this share of the expected one may be that of the specimen; limit of the motion over that at the
# expected peak, and number of records until that limit.
LEAST, REACH, RECORDS = 0.2, 20.0, 4000


def is_cells(body: Lattice, law: object) -> bool:
    """Return True for a body of cells with a cell law, False for bonded spheres and for the non-local law.

    The result is also True for arguments that later checks reject: spheres with a cell law, cells with a beam law,
    or an object that is not a lattice.
    """
    kind = kind_of(matrix_of(law))
    if kind.on_facets or not isinstance(body, Lattice):
        return True
    return body.cells is not None and kind.evaluated == "force"


def as_cells(test: str, law: AnyLaw, contact: ContactLaw | None) -> CellAssignment:
    """Return the law of a specimen of cells, after a check that no contact law of bonded spheres is given.

    Raises:
        InputError: a contact law is given.
    """
    if contact is not None:
        raise InputError(
            f"labtests.{test}: contact = {type(contact).__name__}: applies to bonded spheres; leave it out for cells,"
            " whose facets stay in contact by the criterion"
        )
    return cast(CellAssignment, law)


@dataclass(frozen=True, eq=False)
class Side:
    """Platen or roller of a test.

    Attributes:
        elements: indices of the elements that it loads, (k,).
        share: velocity of this platen over the speed of the test [-].
        wall: function that returns the wall from its velocity [m/s] and the rise time of the velocity [s].
    """

    elements: Ints
    share: float
    wall: Callable[[float, float], Wall]


@dataclass(frozen=True, eq=False)
class BondedSpecimen:
    """Specimen of bonded spheres, or of the non-local law, for tests between rigid platens.

    Attributes:
        test: name of the test.
        lattice: the elements and their bonds.
        law: bond law, bond laws by region, or the non-local law.
        failure: failure criterion, or criteria by region.
        rho: density of the elements [kg/m³].
        given: contact law of fragments and platens; None for `fragment_contact`.
    """

    test: str
    lattice: Lattice
    law: AnyLaw
    failure: FailureAssignment
    rho: float
    given: ContactLaw | None

    @classmethod
    def of(
        cls, test: str, lattice: Lattice, law: AnyLaw, failure: FailureAssignment, *, density: float,
        contact: ContactLaw | None,
    ) -> "BondedSpecimen":  # fmt: skip
        """Check the arguments of a test, and create its specimen.

        Raises:
            InputError: no criterion, no face x_min, turned ends, an invalid density, no bonds, or several bodies.
        """
        check(test, lattice, density=density)
        if failure is None:
            raise InputError(
                f"labtests.{test}: failure = None; give a criterion such as bd.PeripheralStress(tension=...,"
                " shear=...)"
            )
        return cls(test, lattice, law, failure, density, contact)

    @cached_property
    def bare(self) -> Model:
        """Model without platens."""
        return Model(self.lattice, self.law, self.rho, failure=self.failure)

    @cached_property
    def implied(self) -> ImpliedFracture:
        """Macroscopic strength, modulus, density and fracture energy estimated from the bonds."""
        found = self.bare.implied_fracture
        assert found is not None
        return found

    @cached_property
    def contact(self) -> ContactLaw:
        """Contact law of fragments and platens, as given or from `fragment_contact`."""
        if self.given is not None:
            return self.given
        return fragment_contact(float(np.median(self.bare.stiffness.kn)), self.bare.contact_radius)

    @property
    def G(self) -> float:
        """Fracture energy of bonds that soften [J/m²]; NaN for brittle bonds."""
        return self.implied.fracture_energy if self.implied.softens else math.nan

    @property
    def bounds(self) -> tuple[Floats, Floats]:
        """Lower and upper corner of the shape [m], (3,) each."""
        return self.lattice.particles.envelope.bounds

    @property
    def cast(self) -> bool:
        """True for the non-local law on cells: driven layers replace walls, which touch cells as spheres only."""
        return self.lattice.cells is not None

    def require_smooth(self, friction: float) -> None:
        """Raise InputError if platens of the non-local law on cells have a friction coefficient above 0 [-]."""
        if friction > 0.0 and self.cast:
            raise InputError(
                f"labtests.{self.test}: friction of platens = {friction:g}: platens of the non-local law on cells are"
                " smooth; give 0, or bonded spheres"
            )

    def sides(
        self, axis: int, near: tuple[Side, ...], far: tuple[Side, ...],
        around: Callable[[float, float], tuple[Wall, ...]] = lambda speed, begin: (),
    ) -> tuple[tuple[AnyGauge, ...], tuple[AnyGauge, ...], Callable[[float, float], Model]]:  # fmt: skip
        """Create the gauges of the forces on both sides, and a function that creates the model.

        Args:
            axis: axis of the load, 0, 1 or 2.
            near, far: platens of both sides.
            around: function that returns further walls from the speed [m/s] and its rise time [s].

        Returns:
            Gauges of the near side, gauges of the far side, and the model as a function of speed and rise time.
        """
        both = near + far
        if self.cast:
            gauges: list[AnyGauge] = [Gauge(Index(side.elements), "force") for side in both]
        else:
            gauges = [WallGauge(k, "force") for k in range(len(both))]

        def model(speed: float, begin: float) -> Model:
            further = around(speed, begin)
            if self.cast:
                return self.driven(axis, tuple((side.elements, side.share * speed) for side in both), begin, further)
            return self._between((*(side.wall(side.share * speed, begin) for side in both), *further))

        return tuple(gauges[: len(near)]), tuple(gauges[len(near) :]), model

    def driven(
        self, axis: int, ends: tuple[tuple[Ints, float], ...], begin: float, walls: tuple[Wall, ...] = ()
    ) -> Model:
        """Create a model in which sets of elements move along an axis.

        `ends` are pairs of indices, (k,), and velocity [m/s]. Velocities rise from zero until the time `begin` [s].
        """
        drives: list[BoundaryCondition] = []
        for chosen, speed in ends:
            motion: dict[str, Any] = {"v" + "xyz"[axis]: Ramp(0.0, speed, begin)}
            drives.append(Drive(Index(chosen), **motion))
        return self._between(walls, tuple(drives))

    def extent(self, axis: int, sign: float) -> Floats:
        """Return the largest coordinate of each element's surface along sign · axis [m], (n,); -inf for rattlers."""
        reach = sign * self.lattice.centre[:, axis] + self.bare.contact_radius
        return np.where(self.lattice.connected, reach, -np.inf)

    def layer(self, axis: int, sign: float, *, depth: float = 1.0, where: Mask | None = None) -> Ints:
        """Select the elements of a mask (n,) up to `depth` mean radii behind the outermost one along sign · axis.

        Returns indices, (k,). Without a mask, all connected elements are considered.
        """
        reach = self.extent(axis, sign)
        reach = reach if where is None else np.where(where, reach, -np.inf)
        return np.flatnonzero(reach >= reach.max() - depth * float(self.bare.contact_radius.mean()))

    def platen(
        self, axis: int, sign: float, friction: float, speed: float, begin: float, *, where: Mask | None = None,
        outer: float | None = None, inner: float = 0.0,
    ) -> PlaneWall:  # fmt: skip
        """Create a platen that touches the outermost element along sign · axis and moves along the axis.

        Args:
            axis, sign: axis 0, 1 or 2, and the side of the specimen.
            friction: coefficient of friction [-].
            speed: velocity along the axis [m/s]; 0 for a fixed platen.
            begin: rise time of the velocity [s].
            where: mask of the elements that the platen may touch first, (n,); None for all.
            outer, inner: radius of the platen and of its hole [m]; None for an infinite plane, 0 without a hole.
        """
        reach = self.extent(axis, sign)
        at = float((reach if where is None else reach[where]).max())
        point = 0.5 * (self.bounds[0] + self.bounds[1])
        point[axis] = sign * at
        along: dict[str, Any] = {"v" + "xyz"[axis]: Ramp(0.0, speed, begin)}
        motion = Driven(**along) if speed else None
        x, y, z = point.tolist()
        a, b, c = (-sign * np.eye(3)[axis]).tolist()
        return PlaneWall((x, y, z), (a, b, c), motion, friction, outer, inner)

    def _between(self, walls: tuple[Wall, ...] = (), boundary: tuple[BoundaryCondition, ...] = ()) -> Model:
        """Create the model of the specimen with its contact law, walls and boundary conditions."""
        return Model(
            self.lattice, self.law, self.rho, failure=self.failure, contact=self.contact, walls=walls,
            boundary=boundary,
        )  # fmt: skip

    def pressed(self, axis: int, near: Ints, far: Ints) -> StaticResult:
        """Solve for the equilibrium with elements `far` moved towards `near`, (k,) each, by 1e-5 of the extent."""
        lower, upper = self.bounds
        from_middle = np.linalg.norm(self.lattice.centre - 0.5 * (lower + upper), axis=1)
        inmost = Index([int(np.argmin(np.where(self.lattice.connected, from_middle, np.inf)))])
        along = "xyz"[axis]
        motion = -_MOTION * float(upper[axis] - lower[axis])
        return solve_static(Model(self.lattice, self.law, self.rho, boundary=[
            Fix(Index(near), translation=along, rotation=""), Drive(Index(far), **{along: motion}),
            Fix(inmost, translation="xyz".replace(along, ""), rotation=along),
        ]))  # fmt: skip

    def response(
        self, axis: int, near: Ints, far: Ints, section: float, largest: float, least: float
    ) -> tuple[float, float]:
        """Estimate the elastic compliance between both ends [m/N] and the largest force [N].

        At this force a twentieth of the bonds reach their strength in the elastic solution. For the non-local law a
        uniform stress reaches the criterion. If the criterion does not limit the load, the force is the weakest bond
        strength times the section. Both numbers only set the speed and the limits of the test.

        Args:
            axis: axis of the load, 0, 1 or 2.
            near, far: indices of the elements of both ends, (k,).
            section: nominal section, the ratio of force and stress [m²].
            largest, least: largest and least principal stress at the place of failure, over the nominal stress [-].

        Raises:
            InputError: no bonds join both ends.
        """
        static = self.pressed(axis, near, far)
        force = abs(float(static.reaction[far, axis].sum()))
        if not force > 0.0:
            raise InputError(f"labtests.{self.test}: its ends are not joined by bonds; use a denser packing")
        compliance = _MOTION * float((self.bounds[1] - self.bounds[0])[axis]) / force
        if not self.bare.interaction.has_potential:
            return compliance, section / self._uniform_index(largest, least)
        sign = 1.0 if least < 0.0 else -1.0
        factor = 1.0
        while self._reached(static, sign * factor) < 1.0:
            factor *= 2.0
            if factor > _FARTHEST:  # a criterion that this load does not reach
                return compliance, self.implied.weakest * section
        low, high = 0.5 * factor, factor
        for _ in range(_HALVINGS):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if self._reached(static, sign * middle) < 1.0 else (low, middle)
        return compliance, high * force

    def _reached(self, static: StaticResult, factor: float) -> float:
        """Return the failure index that a twentieth of the bonds exceeds at a factor on the displacements [-]."""
        scaled = replace(static, displacement=factor * static.displacement, rotation=factor * static.rotation)
        return float(np.quantile(failure_index(self.bare, scaled), 1.0 - _REACHED))

    def _uniform_index(self, largest: float, least: float) -> float:
        """Return the largest failure index of all criteria under the non-local law, over the nominal stress [1/Pa].

        `largest` and `least` are principal stresses over the nominal one [-]. If no criterion limits them, the result
        is 1 over the weakest strength.
        """
        parts = [part for part in self.bare.failure_parts if not part.open]
        limits = [limit for part in parts if (limit := part.criterion.principal) is not None]
        found = max(max(a * largest, b * largest - c * least) for a, b, c in limits)
        return found if found > 0.0 else 1.0 / self.implied.weakest

    def load(self, rig: Rig, options: RunOptions) -> StrengthTest:
        """Load the specimen to failure, and repeat more slowly until the forces of both ends balance.

        Forces balance if the root mean square of their difference is at most 0.02 of the peak. Without
        `options.traverses`, the attempts take 50, 100 and 200 passes of sound until the expected peak. A further
        attempt writes a file of its own, "NAME-100.h5" next to "NAME.h5".

        Raises:
            UnstableRunError: the run became unstable or lost its energy balance.
            RunInterrupted: Ctrl-C was pressed. The `.result` of the error has the test so far, None for a short run.

        Warns:
            NotQuasistaticWarning: the forces of both ends do not balance.
            StrengthWarning: the load still rises at the limit of the motion.
        """
        sound = math.sqrt(self.implied.E / self.implied.density)
        attempts = _TRAVERSES if options.traverses is None else (options.traverses,)
        found = None
        for k, slow in enumerate(attempts):
            file = None if options.out is None else Path(options.out)
            if file is not None and k:
                file = file.with_stem(f"{file.stem}-{slow:g}")
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", NotQuasistaticWarning)  # the balance of the ends decides here
                found = load_rig(
                    self.test, self.lattice, replace(rig, traverses=slow), sound=sound,
                    damping=LocalDamping(_DAMPING), G=self.G, options=replace(options, out=file),
                )  # fmt: skip
            if found.unbalance <= _BALANCE:
                break
        assert found is not None
        late = int(np.argmax(found.curve[:, 1])) > _LATE * (len(found.curve) - 1)
        if late and found.run.status is Status.COMPLETED:
            warnings.warn(
                f"labtests.{self.test}: the load still rises at the end, so that the peak is no strength; give a"
                " larger reach=, or a criterion that this load reaches",
                StrengthWarning, stacklevel=users_line(),
            )  # fmt: skip
        if found.unbalance <= _BALANCE:
            return found
        warnings.warn(
            f"labtests.{self.test}: the forces of both ends differ by {found.unbalance:.2g} of the peak in the root"
            f" mean square (limit {_BALANCE:g}) at traverses = {attempts[-1]:g}; give more traverses",
            NotQuasistaticWarning, stacklevel=users_line(),
        )  # fmt: skip
        return found
