"""Boundary conditions as arrays, internal order, with rows of elements under supports, drives, loads and dashpots."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from bondem._checks import shown
from bondem._tables.step_tables import Drives, RowLoads, Rows, Timeline
from bondem._types import Floats, PerBond, PerElement
from bondem.boundary.conditions import DRIVEN_TWICE, FIXED_AND_DRIVEN, BoundaryCondition, Drive, Fix, Load
from bondem.boundary.couples import Couple
from bondem.boundary.loads import Absorbing, BodyForce, Eigenstrain, Pressure
from bondem.boundary.schedules import Schedule, joined_tables
from bondem.errors import InputError
from bondem.interactions.interaction import Interaction
from bondem.specimen.lattice import Lattice
from bondem.specimen.ordering import Layout


@dataclass(frozen=True, eq=False)
class Constraints:
    """Boundary conditions as arrays: rows of constrained and loaded elements, schedules, drives and loads.

    Attributes:
        element: internal element of each row, shape (r,).
        row_of: row of each element or -1, shape (n,).
        fixed: mask of degrees of freedom that are fixed or driven, uint8, shape (r, 6).
        timeline: times [s] and values of all schedules.
        drives: one entry per driven degree of freedom of an element.
        loads: one entry per loaded element and load.
        couples: moments of loads, whose forces rotate with their regions.
        absorbing: dashpots of each row, xx, yy, zz, xy, xz, yz [N·s/m], zero where motion is prescribed,
            shape (r, 6), or (0, 6) without any.
        body_on: factor of each body force for each element [-], shape (b, n).
        body_value: acceleration of each body force [m/s²], shape (b, 3).
        strain_part: strain of each bond by each `Eigenstrain` at factor 1 [-], shape (g, m).
        press_value: volume change V θ of each cell by each load of free facets [m³], shape (l, n).
        body_schedule, strain_schedule, press_schedule: number of the schedule of each, shapes (b,), (g,), (l,).
        weight: mass of each connected element, 0 for rattlers [kg], shape (n,).
        supported: True if walls constrain facets of cells.
        wall_rate: True if velocities of such walls are prescribed.
    """

    element: np.ndarray
    row_of: np.ndarray
    fixed: np.ndarray
    timeline: Timeline
    drives: Drives
    loads: RowLoads
    couples: tuple[Couple, ...]
    absorbing: Floats
    body_on: np.ndarray
    body_value: Floats
    body_schedule: np.ndarray
    strain_part: Floats
    strain_schedule: np.ndarray
    weight: PerElement
    press_value: Floats
    press_schedule: np.ndarray
    supported: bool
    wall_rate: bool

    @classmethod
    def of(
        cls, lattice: Lattice, layout: Layout, boundary: Sequence[BoundaryCondition], mass: PerElement,
        law: Interaction,
    ) -> "Constraints":  # fmt: skip
        """Resolve the boundary conditions of a model whose elements have masses `mass` [kg], (n,), user's order.

        `boundary` excludes conditions on facets (`bondem.boundary.wall_constraints`), which the law resolves. The
        cells of these facets have rows nevertheless.

        Raises:
            InputError: A degree of freedom is driven twice, or both fixed and driven; or a condition does not fit the
                lattice, such as a pressure that follows spheres.
            EmptyRegionError: A region selects no element.
        """
        n, m = len(lattice.particles), len(lattice.pairs)
        fixed = np.zeros((n, 6), dtype=np.uint8)
        driven = np.zeros((n, 6), dtype=bool)
        owns = np.zeros(n, dtype=bool)
        schedules: list[Schedule] = []
        drives: list[tuple[np.ndarray, int, int, bool]] = []
        loads: list[tuple[np.ndarray, int, Floats, bool]] = []
        couples: list[Couple] = []
        presses: list[tuple[PerElement, int]] = []
        dashpots = np.zeros((n, 6))
        bodies: list[tuple[np.ndarray, tuple[float, float, float], int]] = []
        strains: list[tuple[PerBond, int]] = []
        for condition in boundary:
            chosen = np.zeros(0, dtype=np.int64)
            match condition:
                case Fix():
                    chosen = layout.rank[condition.region.select(lattice)]
                    fixed[chosen[:, None], list(condition.components)] = 1
                case Drive():
                    chosen = layout.rank[condition.region.select(lattice)]
                    for dof, schedule, rate in condition.motion:
                        if driven[chosen, dof].any():
                            raise InputError(DRIVEN_TWICE.format(shown(condition.region)))
                        driven[chosen, dof] = True
                        drives.append((chosen, dof, len(schedules), rate))
                        schedules.append(schedule)
                case Load() | Pressure():
                    couple = couple_of(condition, lattice, layout, len(schedules))
                    if couple is not None:
                        couples.append(couple)
                    turns = couple is not None and isinstance(condition, Load)
                    straight = replace(condition, moment=(0.0, 0.0, 0.0)) if turns else condition
                    chosen, nodal = straight.nodal(lattice)
                    chosen = layout.rank[chosen]
                    loads.append((chosen, len(schedules), nodal, _follows(condition, lattice)))
                    facet, force = law.facet_forces(condition)
                    if len(facet):
                        presses.append((law.pressed(facet, force)[layout.order], len(schedules)))
                    schedules.append(condition.schedule)
                case Absorbing():
                    chosen, viscous = condition.dashpots(lattice)
                    chosen = layout.rank[chosen]
                    dashpots[chosen] += viscous
                case BodyForce():
                    for on, pull in condition.parts(lattice):
                        bodies.append((on[layout.order], pull, len(schedules)))
                    schedules.append(condition.schedule)
                case Eigenstrain():
                    strains.append((condition.parts(lattice)[layout.bond_order], len(schedules)))
                    schedules.append(condition.schedule)
                case _:
                    raise AssertionError(f"unreachable: a model refuses {condition!r}")
            owns[chosen] = True
        if (fixed.astype(bool) & driven).any():
            raise InputError(FIXED_AND_DRIVEN)
        fixed |= driven.astype(np.uint8)
        owns[layout.rank[law.supports.cell]] = True
        element = np.flatnonzero(owns)
        row_of = np.full(n, -1, dtype=np.int64)
        row_of[element] = np.arange(len(element))
        for d, (a, b) in enumerate(((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))):
            dashpots[(fixed[:, a] | fixed[:, b]) > 0, d] = 0.0
        return cls(
            element=element,
            row_of=row_of,
            fixed=fixed[element],
            timeline=Timeline(**joined_tables(schedules)),
            drives=Drives(
                row=_joined_rows([row_of[chosen] for chosen, *_ in drives]),
                dof=_joined_rows([np.full(len(c), dof) for c, dof, _, _ in drives]),
                schedule=_joined_rows([np.full(len(c), s) for c, _, s, _ in drives]),
                rate=_joined_rows([np.full(len(c), rate) for c, _, _, rate in drives]).astype(np.uint8),
            ),
            loads=RowLoads(
                row=_joined_rows([row_of[chosen] for chosen, *_ in loads]),
                schedule=_joined_rows([np.full(len(c), s) for c, s, *_ in loads]),
                value=np.concatenate([nodal for _, _, nodal, _ in loads]) if loads else np.zeros((0, 6)),
                turns=_joined_rows([np.where(turns, chosen, -1) for chosen, *_, turns in loads]),
            ),
            couples=tuple(couples),
            absorbing=dashpots[element] if dashpots.any() else np.zeros((0, 6)),
            body_on=np.array([on for on, *_ in bodies], dtype=float).reshape(len(bodies), n),
            body_value=np.array([value for _, value, _ in bodies], dtype=float).reshape(-1, 3),
            body_schedule=np.array([s for *_, s in bodies], dtype=np.int64),
            strain_part=np.array([part for part, _ in strains], dtype=float).reshape(len(strains), m),
            strain_schedule=np.array([s for _, s in strains], dtype=np.int64),
            weight=np.where(lattice.connected, mass, 0.0)[layout.order],
            press_value=np.array([value for value, _ in presses], dtype=float).reshape(len(presses), n),
            press_schedule=np.array([s for _, s in presses], dtype=np.int64),
            supported=len(law.supports.cell) > 0,
            wall_rate=any(law.supports.fixed.rate),
        )

    def rows(self, reaction: Floats, work: Floats) -> Rows:
        """Return the rows as the table of the core, with the reactions (r, 6) and works of a state."""
        still = np.zeros((3, len(self.element), 6))
        return Rows(
            of=self.row_of, fixed=self.fixed, force=still[0], half=still[1], full=still[2], reaction=reaction,
            support=np.zeros((len(self.element) if self.supported else 0, 6)), work=work,
        )  # fmt: skip

    def final_load(self, n: int, pose: Floats | None = None) -> Floats:
        """Return forces and torques at the end of all schedules [N, N·m], internal order, shape (n, 6).

        Forces that make up moments are those in `pose`, (n, 8), or in the reference if it is None.
        """
        load = np.zeros((n, 6))
        last = self._final(self.loads.schedule)
        np.add.at(load, self.element[self.loads.row], last[:, None] * self.loads.value)
        pull = self._final(self.body_schedule)[:, None] * self.body_value
        load[:, :3] += self.weight[:, None] * (self.body_on.T @ pull)
        for couple, factor in self.final_couples():
            couple.add_to(load, pose, factor)
        return load

    @property
    def applied_force(self) -> float:
        """Norm of the forces of all `Load` and `Pressure` at the end of schedules [N], before sums per element."""
        return float(np.linalg.norm(self._final(self.loads.schedule)[:, None] * self.loads.value[:, :3]))

    def final_couples(self) -> list[tuple[Couple, float]]:
        """Return moments of loads, and their factors at the end of all schedules."""
        return [(couple, float(self._final(couple.schedule))) for couple in self.couples]

    def final_strain(self) -> PerBond:
        """Return the stress-free strain of each bond at the end of all schedules [-], internal order, shape (m,)."""
        return self._final(self.strain_schedule) @ self.strain_part

    def final_press(self) -> PerElement:
        """Return volume changes V θ of cells by tractions at the end of all schedules [m³], internal order, (n,)."""
        return self._final(self.press_schedule) @ self.press_value

    def _final(self, schedules: np.ndarray | int) -> Floats:
        return self.timeline.values[self.timeline.start[schedules + 1] - 1]

    @property
    def works(self) -> tuple[int, int, int]:
        """Offsets of the works of body forces and of strains in the list of works, and the length of this list."""
        body = len(self.element)
        strain = body + (len(self.row_of) if len(self.body_on) else 0)
        # one entry more where walls or tractions do work: earlier versions summed it there, and run files keep it
        return body, strain, strain + bool(len(self.strain_part)) + bool(self.supported or len(self.press_schedule))

    def final_motion(self, n: int) -> Floats:
        """Return prescribed displacements and rotations at the end of all schedules [m, rad], internal order, (n, 6).

        Raises:
            InputError: A velocity is prescribed, which has no static meaning.
        """
        if self.drives.rate.any() or self.wall_rate:
            raise InputError("a static solution needs displacements; replace vx= … wz= of Drive by x= … rz=")
        motion = np.zeros((n, 6))
        motion[self.element[self.drives.row], self.drives.dof] = self._final(self.drives.schedule)
        return motion

    def prescribed(self, n: int) -> np.ndarray:
        """Return a mask of the degrees of freedom that are fixed or driven, internal order, shape (n, 6)."""
        found = np.zeros((n, 6), dtype=bool)
        found[self.element] = self.fixed.astype(bool)
        return found


def couple_of(condition: Load | Pressure, lattice: Lattice, layout: Layout, schedule: int) -> Couple | None:
    """Return the moment of a load as forces at its points; None without a moment, or if all points coincide."""
    if not isinstance(condition, Load) or not any(condition.moment):
        return None
    chosen, arm, share = condition.points(lattice)
    place = lattice.centre[chosen] + arm
    if np.ptp(place, axis=0).max() <= 1e-12 * (1.0 + np.abs(place).max()):
        return None
    return Couple(layout.rank[chosen], lattice.centre[chosen], arm, share, np.array(condition.moment), schedule)


def _follows(condition: Load | Pressure, body: Lattice) -> bool:
    if not isinstance(condition, Pressure) or not condition.follows:
        return False
    body.elements.require_cells(
        "Pressure(follows=True) rotates with facets, which bonded spheres lack; connect them with"
        " method='laguerre', or leave out follows="
    )
    return True


def _joined_rows(parts: list[np.ndarray]) -> np.ndarray:
    return np.concatenate(parts).astype(np.int64) if parts else np.zeros(0, dtype=np.int64)
