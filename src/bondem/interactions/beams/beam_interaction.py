"""Interactions of beams: of the total formulation, and of the incremental one, whose loads the state stores."""

from collections.abc import Mapping
from typing import Any, ClassVar

import numpy as np
from scipy.sparse import bsr_array

from bondem._core import run_pass
from bondem._passes import calls, steps
from bondem._plausibility import question_bond_radius
from bondem._tables.incremental_tables import LoadsOfEach, StoredLoads
from bondem._tables.step_tables import Beams, Poses
from bondem._tables.stiffness_tables import BeamRows
from bondem._threads import current_threads
from bondem._types import Floats, PerBond, PerBond3, PerElement3
from bondem.errors import InputError
from bondem.interactions.beams.assignment import bond_stiffness
from bondem.interactions.beams.beam_tables import loads_of_each
from bondem.interactions.beams.bond_law import BondLaw, BondStiffness
from bondem.interactions.beams.bond_strain import BondStrain
from bondem.interactions.beams.bond_table import keep_columns, with_zeros
from bondem.interactions.interaction import (
    Arrays,
    Boundary,
    Interaction,
    LawParts,
    Run,
    StateField,
    SteppingInteraction,
)
from bondem.interactions.step_part import Part, Passes
from bondem.interactions.stiffness import Stiffness, new_block_rows
from bondem.specimen.lattice import Lattice
from bondem.specimen.ordering import Layout


class BeamInteraction(Interaction):
    """Beams of the total formulation, whose forces follow from the present pose without memory."""

    law: ClassVar[type] = BondLaw

    def __init__(self, lattice: Lattice, layout: Layout, bond: Any, bonds: BondStiffness) -> None:
        super().__init__(lattice, layout)
        self._bond, self._bonds = bond, bonds

    @classmethod
    def join(
        cls, lattice: Lattice, layout: Layout, bond: Any, boundary: Boundary, may_fail: bool
    ) -> "BeamInteraction":
        bonds, formulation = bond_stiffness(lattice, bond)
        kind = BeamInteraction if formulation == "total" else StoredBeamInteraction
        return kind(lattice, layout, bond, bonds)

    def question(self) -> None:
        if isinstance(self._bond, BondLaw) and self._bond.radius is not None:
            question_bond_radius(self._bond.radius, self.lattice.particles.mean_radius)

    @property
    def moments_at_contact(self) -> bool:
        laws = self._bond.values() if isinstance(self._bond, Mapping) else (self._bond,)
        places = {law.moments_at_contact for law in laws if isinstance(law, BondLaw)}
        if len(places) > 1:
            raise InputError(
                "failure= counts moments either at the ends or at contact points; give bonds of one kind"
            )
        return True in places

    @property
    def bonds(self) -> BondStiffness:
        return self._bonds

    def stiffness(self) -> Stiffness:
        layout, b = self.layout, self.table
        rows, size = new_block_rows(layout), 6 * len(layout.order)
        columns = b.direction, b.length, b.lever, b.kn, b.ks, b.kb, b.kt
        beams = BeamRows(layout.i, layout.j, *map(np.ascontiguousarray, columns))
        run_pass(calls.assemble_beams(beams, rows), threads=current_threads())
        return Stiffness(bsr_array((rows.data, rows.indices, rows.indptr), shape=(size, size)))

    def loads(self, pose: Floats, arrays: Arrays) -> Floats:
        beams = self._beams(arrays["rest_strain"], arrays["integrity"])
        on_i, on_j = loads_of_each(pose, beams, len(arrays["integrity"]))
        return np.hstack([on_j[:, :3], on_i[:, 4:7], on_j[:, 4:7]])

    def small_loads(self, displacement: PerElement3, rotation: PerElement3, strain: PerBond) -> Floats:
        length, k = self.lattice.length, self.bonds
        found = BondStrain.of(self.lattice, k.lever, displacement, rotation)
        pull = found.forces(k) - (k.kn * length * strain)[:, None] * found.direction
        moment = k.kb[:, None] * found.bend + (k.kt * found.twist)[:, None] * found.direction
        arm = np.cross(found.direction, pull)
        near, far = k.lever[:, None], (length - k.lever)[:, None]
        return np.hstack([-pull, near * arm + moment, far * arm - moment])

    def joints(self) -> tuple[PerBond, PerBond, PerBond3]:
        lattice = self.lattice
        middle = lattice.centre[lattice.pairs[:, 0]] + 0.5 * lattice.branch
        return (np.pi * self.bonds.radius**2, lattice.length, middle)

    def modulus(self, volume: float) -> float:
        length, bonds = self.lattice.length, self.bonds
        normal = float((length**2 * bonds.kn).sum()) / volume
        across = float((length**2 * bonds.ks).sum()) / volume
        bulk, shear = normal / 9.0, normal / 15.0 + across / 10.0
        return 9.0 * bulk * shear / (3.0 * bulk + shear)


class StoredBeamInteraction(BeamInteraction, SteppingInteraction):
    """Beams of the incremental formulation, which store force and moment from step to step."""

    formulation: ClassVar[str] = "incremental"
    fields: ClassVar[tuple[StateField, ...]] = (StateField("history", (6, "m")),)

    def tables(self, arrays: Arrays) -> tuple[Beams, StoredLoads]:
        """Return the beams and their stored loads, whose array is that of the state.

        If there are fewer beams than a pass computes at once, this array is a longer copy, made by `with_zeros`.
        """
        beams = self._beams(np.zeros(0), arrays["integrity"])
        return beams, StoredLoads(np.ascontiguousarray(with_zeros(self.table.kb)), with_zeros(arrays["history"]))

    def loads(self, pose: Floats, arrays: Arrays) -> Floats:
        beams, stored = self.tables(arrays)
        loads = LoadsOfEach(np.empty((9, len(beams.i))))
        run_pass(calls.load_stored_beams(Poses(pose), beams, stored, loads))
        return loads.found[:, : len(arrays["integrity"])].T

    def parts(self, run: Run) -> LawParts:
        moving, blocks, ledger = run.moving, run.blocks, run.ledger
        beams, stored = self.tables(run.arrays)
        loads: Passes = [steps.add_stored_loads(moving, beams, stored, blocks)]
        if run.dashpots is not None:
            loads.append(steps.add_dashpot_loads(moving, beams, run.dashpots, blocks))
        part = Part(
            {"loads": loads, "guard": [steps.check_beams(moving, beams, ledger)]},
            record=lambda _: [steps.sum_stored_energies(moving, beams, stored, ledger)],
            keep=lambda: keep_columns(run.arrays["history"], stored.history),
        )
        return LawParts([part], run.arrays["integrity"])
