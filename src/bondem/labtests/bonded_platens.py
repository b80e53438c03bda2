"""Bonded spheres between rigid platens: contact, elastic response, and slow loading to failure."""

import math
import warnings
from collections.abc import Callable, Mapping
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
from bondem.labtests.quasi_static_rig import Rig, RunOptions, StrengthTest, load_rig
from bondem.model.model import Model
from bondem.observables.breakage import failure_index
from bondem.specimen.lattice import Lattice
from bondem.specimen.regions import Index
from bondem.statics.static import StaticResult, solve_static

# Local damping of tests of bonded spheres, that of Potyondy and Cundall (2004).
_DAMPING = 0.7
# Passes of sound until the expected peak, one attempt after another, and the root mean square of the difference of
# the forces of both ends, over the peak, up to which an attempt is quasi-static.
_TRAVERSES, _BALANCE = (50.0, 100.0, 200.0), 0.02
# Share of the bonds that have reached their strength in the elastic solution at the expected peak.
_REACHED = 0.05
# Motion of an elastic solution over the length [-], largest multiple of it, and halvings in the search of a load.
_MOTION, _FARTHEST, _HALVINGS = 1e-5, 1e6, 12
# A peak after this share of the records is none: the load still rises.
_LATE = 0.98
#: A peak above this share of the expected one may be that of the specimen; limit of the motion over that at the
# expected peak, and number of records until then.
LEAST, REACH, RECORDS = 0.2, 20.0, 4000


def is_cells(body: Lattice, law: object) -> bool:
    """Return True for a specimen of cells, and for invalid arguments, which tests of cells reject."""
    kind = kind_of(next(iter(law.values()), None) if isinstance(law, Mapping) else law)
    if kind.on_facets or not isinstance(body, Lattice):
        return True
    return body.cells is not None and kind.evaluated == "force"


def as_cells(test: str, law: AnyLaw, contact: ContactLaw | None) -> CellAssignment:
    """Return the law of a specimen of cells, which has no options of bonded spheres.

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
    """One of the platens or rollers of a test.

    Attributes:
        elements: elements that it presses or holds, user's order.
        share: velocity over that of the far side relative to the near one [-].
        wall: function of its velocity [m/s] and the rise time [s] that returns the wall.
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
        contact: ContactLaw | None, faces: tuple[str, ...] = ("x_min", "x_max"),
    ) -> "BondedSpecimen":  # fmt: skip
        """Check the arguments of a test and create its specimen.

        Raises:
            InputError: no criterion, a shape without the faces of the test, or arguments that a model rejects.
        """
        check(test, lattice, density=density)
        shape = lattice.particles.envelope
        missing = [name for name in faces if name not in shape.faces]
        if missing:
            raise InputError(
                f"labtests.{test}: a {type(shape).__name__} has no face '{missing[0]}'; pack a bd.Box or"
                " a bd.Cylinder"
            )
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
        """Strength, modulus and density that the bonds imply."""
        found = self.bare.implied_fracture
        assert found is not None
        return found

    @cached_property
    def contact(self) -> ContactLaw:
        """Contact law of fragments and platens."""
        if self.given is not None:
            return self.given
        return fragment_contact(float(np.median(self.bare.stiffness.kn)), self.bare.contact_radius)

    @property
    def G(self) -> float:
        """Fracture energy of bonds that soften [J/m²]; NaN for brittle ones, which have none."""
        return self.implied.fracture_energy if self.implied.softens else math.nan

    @cached_property
    def bounds(self) -> tuple[Floats, Floats]:
        """Lower and upper corner of the shape [m], (3,) each."""
        lower, upper = self.lattice.particles.envelope.bounds
        return np.asarray(lower, dtype=float), np.asarray(upper, dtype=float)

    @property
    def cast(self) -> bool:
        """True if platens hold their elements along the axis, as for cells, whose flat walls spheres do not fill."""
        return self.lattice.cells is not None

    def require_smooth(self, friction: float) -> None:
        """Raise InputError for friction of platens that hold their elements along the axis only."""
        if friction > 0.0 and self.cast:
            raise InputError(
                f"labtests.{self.test}: friction of platens = {friction:g}: platens of the non-local law on cells are"
                " smooth; give 0, or bonded spheres"
            )

    def sides(
        self, axis: int, near: tuple[Side, ...], far: tuple[Side, ...],
        around: Callable[[float, float], tuple[Wall, ...]] = lambda speed, begin: (),
    ) -> tuple[tuple[AnyGauge, ...], tuple[AnyGauge, ...], Callable[[float, float], Model]]:  # fmt: skip
        """Gauges of the forces on both sides, and the function of speed and rise time that returns the model.

        Args:
            axis: axis of the load.
            near, far: platens of both sides.
            around: function of speed and rise time that returns further walls.
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
        """Model in which sets of elements move along an axis at given velocities [m/s], reached in `begin` [s]."""
        drives: list[BoundaryCondition] = []
        for chosen, speed in ends:
            motion: dict[str, Any] = {"v" + "xyz"[axis]: Ramp(0.0, speed, begin)}
            drives.append(Drive(Index(chosen), **motion))
        return self._between(walls, tuple(drives))

    def extent(self, axis: int, sign: float) -> Floats:
        """Outermost coordinate of each connected element along ±axis [m], -inf for rattlers, (n,)."""
        reach = sign * self.lattice.centre[:, axis] + self.bare.contact_radius
        return np.where(self.lattice.connected, reach, -np.inf)

    def layer(self, axis: int, sign: float, *, depth: float = 1.0, where: Mask | None = None) -> Ints:
        """Elements that reach within `depth` mean radii of the outermost one along ±axis, out of those of a mask."""
        reach = self.extent(axis, sign)
        reach = reach if where is None else np.where(where, reach, -np.inf)
        return np.flatnonzero(reach >= reach.max() - depth * float(self.bare.contact_radius.mean()))

    def platen(
        self, axis: int, sign: float, friction: float, speed: float, begin: float, *, where: Mask | None = None,
        outer: float | None = None, inner: float = 0.0,
    ) -> PlaneWall:  # fmt: skip
        """Platen at the outermost element along ±axis, out of those of a mask, which moves along the axis.

        Args:
            axis, sign: axis 0, 1 or 2, and the side of the specimen.
            friction: coefficient of friction [-].
            speed: velocity along the axis [m/s].
            begin: time in which the velocity rises [s].
            where: mask of the elements that it presses, (n,).
            outer, inner: radius of a disc and of its hole [m].
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
        """Model of the specimen between walls."""
        return Model(
            self.lattice, self.law, self.rho, failure=self.failure, contact=self.contact, walls=walls,
            boundary=boundary,
        )  # fmt: skip

    def pressed(self, axis: int, near: Ints, far: Ints) -> StaticResult:
        """Elastic equilibrium in which the elements of both ends are held and moved along an axis only."""
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
        """Elastic compliance between both ends [m/N], and the expected largest force [N].

        The force is that at which a twentieth of the bonds would have reached their strength in the elastic solution.
        For the non-local law it is that at which a uniform stress reaches the criterion. Both set the speed of the
        test only.

        Args:
            axis: axis of the load.
            near, far: elements of both ends.
            section: area over which the force is a stress [m²].
            largest, least: largest and least principal stress over that stress, where the specimen fails [-].

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
        """Failure index that a twentieth of the bonds exceed in a scaled equilibrium [-]."""
        scaled = replace(static, displacement=factor * static.displacement, rotation=factor * static.rotation)
        return float(np.quantile(failure_index(self.bare, scaled), 1.0 - _REACHED))

    def _uniform_index(self, largest: float, least: float) -> float:
        """Index of a uniform stress with given principal stresses, of the weakest criterion of the non-local law."""
        limits = [limit for part in self.bare.failure_parts if (limit := part.criterion.principal) is not None]
        found = max(max(a * largest, b * largest - c * least) for a, b, c in limits)
        return found if found > 0.0 else 1.0 / self.implied.weakest

    def load(self, rig: Rig, options: RunOptions) -> StrengthTest:
        """Load the specimen to failure, more slowly until the forces of both ends balance.

        Args:
            rig: loading of the specimen.
            options: options of the test. Without `traverses` these are 50, or 100 or 200 where the forces of both
                ends do not balance: their difference has a root mean square above 0.02 of the peak. A second attempt
                writes a file "NAME-100.h5" next to "NAME.h5".

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
