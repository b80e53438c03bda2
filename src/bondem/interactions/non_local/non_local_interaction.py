"""Interaction of elements by the non-local law, for solvers, states and run files.

`core/tables/non_local_tables.hpp` declares types and shapes of its tables.
"""

from dataclasses import replace
from functools import cached_property
from typing import Any, ClassVar, Self

import numpy as np
from scipy.sparse import bsr_array

from bondem._cache_lines import lines
from bondem._core import run_pass
from bondem._passes import calls, steps
from bondem._tables.damage_tables import BeamIntegrity, FailureIndices, Strengths
from bondem._tables.non_local_tables import NonLocalBonds, SmallSprings, SmallSteps
from bondem._tables.step_tables import Beams, LaggedStresses, Poses
from bondem._types import Floats, PerBond, PerBond3, PerElement3, PerElement6
from bondem.errors import InputError
from bondem.interactions.beams.beam_tables import beam_tables
from bondem.interactions.beams.bond_law import BondStiffness
from bondem.interactions.beams.bond_table import keep_columns, with_twins, with_zeros
from bondem.interactions.interaction import Arrays, Boundary, DamageOfRun, LawParts, Run, StateField
from bondem.interactions.lagged_interaction import LaggedInteraction
from bondem.interactions.non_local.local_stiffness import local_stiffness
from bondem.interactions.non_local.non_local_constants import NonLocalConstants
from bondem.interactions.non_local.non_local_law import NonLocal
from bondem.interactions.non_local.non_local_strain import NonLocalStrain
from bondem.interactions.row_sums import rows_of_ends
from bondem.interactions.step_part import Part, Passes
from bondem.interactions.stiffness import Stiffness
from bondem.specimen.lattice import Lattice
from bondem.specimen.ordering import Layout

# Number of rows of the history of bonds, row of the work of extra forces, and number of rows of present loads.
_ROWS, NON_LOCAL_WORK, _OUTPUT_ROWS = 7, 6, 9


class NonLocalInteraction(LaggedInteraction):
    """Bonds of the non-local law on the elements of a specimen.

    Attributes:
        by_user: constants of the bonds, user's order.
    """

    law: ClassVar[type] = NonLocal
    title: ClassVar[str] = NonLocal.title
    name: ClassVar[str] = NonLocal.__name__
    formulation: ClassVar[str] = NonLocal.formulation
    fields: ClassVar[tuple[StateField, ...]] = (
        StateField("history", (_ROWS, "m"), fresh=(NON_LOCAL_WORK,)), StateField("stress", ("n", 6)),
    )  # fmt: skip
    evaluated = "stress"

    def __init__(self, lattice: Lattice, layout: Layout, law: NonLocal) -> None:
        super().__init__(lattice, layout)
        self.by_user = NonLocalConstants.of(lattice, law)
        self.settles, self.normal_over_shear = law.limited, law.E / law.G

    @classmethod
    def join(cls, lattice: Lattice, layout: Layout, bond: Any, boundary: Boundary, may_fail: bool) -> Self:
        if not isinstance(bond, cls.law):
            raise InputError("bond= maps a region to NonLocal, a law for the whole model; give bond=bd.NonLocal(...)")
        return cls(lattice, layout, bond)

    @cached_property
    def constants(self) -> NonLocalConstants:
        """Constants of the bonds, internal order."""
        return self.by_user.ordered(self.layout)

    @cached_property
    def bonds(self) -> BondStiffness:
        return self.by_user.as_bonds(self.lattice)

    # ---- outside a step

    def stiffness(self) -> Stiffness:
        return Stiffness(local_stiffness(self.constants, self.layout))

    def springs(self, kn: PerBond, kt: PerBond) -> bsr_array:
        return local_stiffness(replace(self.constants, kn=kn, kt=kt), self.layout)

    def at_rest(self) -> NonLocalStrain:
        still = np.zeros((len(self.lattice.pairs), 3))
        return NonLocalStrain(self.lattice, self.by_user, still, still)

    def small_steps(
        self, speed: PerElement6, weight: PerElement6, along: PerBond, across: PerBond, dt: float, gamma: float,
        steps: int,
    ) -> Floats:  # fmt: skip
        c, (motion, load, moment, stress) = self.by_user, np.zeros((4, *speed.shape))
        gap, size = np.zeros((len(along), 3)), np.full(steps, np.inf)
        lever_i, lever_j = np.ascontiguousarray(c.lever_i), np.ascontiguousarray(c.lever_j)
        springs = SmallSprings(c.kn, lever_i, lever_j, along, across)
        walk = SmallSteps(dt, gamma, weight, c.volume, motion, speed.copy(), load, moment, stress, gap, size)
        run_pass(calls.take_small_steps(c.small_pairs(self.lattice.pairs, stress, gap), springs, walk))
        return size

    def joints(self) -> tuple[PerBond, PerBond, PerBond3]:
        place = self.lattice.centre[self.lattice.pairs[:, 0]] + self.by_user.lever_i
        return (self.by_user.area, self.lattice.length, place)

    def modulus(self, volume: float) -> float:
        return float(np.median(self.by_user.kn * self.lattice.length / self.by_user.area))

    def loads(self, pose: Floats, arrays: Arrays) -> Floats:
        beams, bonds = self._tables(arrays)
        run_pass(calls.load_non_local_bonds(Poses(pose), beams, bonds))
        own = bonds.output[:, : len(arrays["integrity"])].T
        return np.hstack([-own[:, :3], own[:, 3:6], -own[:, 6:]])

    def small_loads(self, displacement: PerElement3, rotation: PerElement3, strain: PerBond) -> Floats:
        raise InputError(
            "bond_forces: a static solution of the non-local law does not store the stresses; give the state of a run"
        )

    def indices(self, pose: Floats, arrays: Arrays, kind: str, strengths: Strengths) -> PerBond:
        beams, _ = self._tables(arrays)
        stresses = self._stresses(arrays["stress"], self.layout.i, 0)
        run_pass(calls.turn_all_stresses(Poses(pose), stresses))
        found = FailureIndices(np.zeros(len(beams.i)))
        run_pass(calls.index_pairs(beams, stresses, strengths, found))
        return found.index[: len(arrays["integrity"])]

    # ---- a step

    def parts(self, run: Run) -> LawParts:
        moving, blocks, ledger, dashpots = run.moving, run.blocks, run.ledger, run.dashpots
        beams, bonds = self._tables(run.arrays)
        stresses = self._stresses(run.arrays["stress"], rows_of_ends(blocks, self.layout), int(blocks.part[-1]))
        dashes: Passes = [] if dashpots is None else [steps.add_dashpot_loads(moving, beams, dashpots, blocks)]
        stages: dict[str, Passes] = {"prepare": [steps.turn_stresses(moving, stresses)]}
        if run.damage is None and not run.touches:  # no pass needs the present stresses before the elements move
            stages["loads"] = [steps.add_lasting_loads(moving, beams, bonds, stresses, blocks), *dashes]
            stages["gather"] = [steps.collect_moments(blocks, stresses)]
            stages["add"] = [steps.find_stresses_of_block(moving, stresses)]
        else:
            stages["prepare"].append(steps.find_non_local_forces(moving, beams, bonds, stresses))
            stages["prepare"].append(steps.collect_moments(blocks, stresses))
            stages["stress"] = [steps.find_stresses(moving, stresses)]
            stages["loads"] = [steps.add_non_local_loads(bonds, blocks), *dashes]
        stages["guard"] = [steps.check_beams(moving, beams, ledger)]
        energies: Passes = [steps.sum_non_local_energies(moving, beams, bonds, ledger)]
        parts = [Part(stages, lambda _: energies, lambda: keep_columns(run.arrays["history"], bonds.history))]
        if run.damage is not None:
            parts.append(_breakage(run, run.damage, beams, bonds, stresses))
        return LawParts(parts, beams.integrity, stresses)

    def _tables(self, arrays: Arrays) -> tuple[Beams, NonLocalBonds]:
        """Return the tables of bonds, whose history is the array of the state, or a longer copy by `with_zeros`."""
        c = self.constants
        beams, _ = beam_tables(self.table, self.layout, self.period, arrays["integrity"], may_share=False)

        def columns(each: Floats) -> Floats:
            return np.ascontiguousarray(with_zeros(each.T))

        return beams, NonLocalBonds(
            area=with_zeros(c.area), kn=with_zeros(c.kn), kt=with_zeros(c.kt), normal=columns(c.normal),
            lever_i=columns(c.lever_i), lever_j=columns(c.lever_j), nu=c.nu, limited=c.limited,
            history=with_zeros(arrays["history"]), output=with_zeros(np.zeros((_OUTPUT_ROWS, len(c.area)))),
        )  # fmt: skip

    def _stresses(self, stress: Floats, to_i: np.ndarray, more: int) -> LaggedStresses:
        """Return the table of stresses of the elements, which shares the array of the state.

        Args:
            stress: stresses in the frames of the elements [Pa], (n, 6).
            to_i: row of the moment that each bond adds to for its element i, uint32, (m,).
            more: number of rows of moments after those of the elements.
        """
        n = len(stress)
        return LaggedStresses(1.0 / self.constants.volume, stress, lines(n), lines(n + more), with_twins(to_i))


def _breakage(run: Run, damage: DamageOfRun, beams: Beams, bonds: NonLocalBonds, stresses: LaggedStresses) -> Part:
    """Return the part by which bonds break."""
    moving, candidates, postponed, strengths = run.moving, damage.candidates, damage.postponed, damage.strengths
    remove: Passes = []
    if run.dashpots is not None:
        remove.append(steps.withdraw_dashpots(moving, beams, run.dashpots, candidates, postponed))
    integrity = BeamIntegrity(beams.integrity, np.zeros(0))
    remove += [
        steps.break_pairs(moving, beams, bonds, candidates, postponed, damage.log),
        steps.relieve_pairs(moving, beams, bonds, stresses, integrity, candidates),
    ]
    judge: Passes = [steps.judge_pairs(beams, stresses, strengths, candidates, postponed)]
    part = run.failing(judge, remove, beams.integrity)
    return replace(part, stages={**part.stages, "loads": [steps.mark_pairs(beams, stresses, strengths, candidates)]})
