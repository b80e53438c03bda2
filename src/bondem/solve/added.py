"""Optional terms of a run, gathered for the kernels: body forces, strains, dashpots, mass damping."""

import numpy as np

from bondem._types import Floats
from bondem.kernels.cell_strain import PORTION
from bondem.kernels.strain_tables import Strain, StrainedCells
from bondem.kernels.tables import Added
from bondem.laws.damping import DampingTerms
from bondem.model.bond_table import with_zeros
from bondem.model.model import Model
from bondem.model.state import State


def added(model: Model, terms: DampingTerms, state: State, rows: int) -> Added | None:
    """Return the optional terms of a run except strains and contacts, or None for a plain run.

    Args:
        model: model to run.
        terms: terms of damping.
        state: initial state.
        rows: number of rows of the sums of bond forces.
    """
    held, plain = model.constraints, model.bonds
    damped = terms.eta > 0.0 or terms.beta > 0.0
    viscous = damped or len(held.absorbing) > 0 or terms.alpha > 0.0
    if not viscous and not len(held.body_on):
        return None
    member, group = np.unique(held.body_on.T, axis=0, return_inverse=True)
    body, strain, *_ = held.works
    return Added(
        group=(group.ravel() if len(held.body_on) else np.zeros(0)).astype(np.uint32),
        member=member.astype(float),
        pull=held.body_value,
        schedule=held.body_schedule,
        present=np.zeros((len(member), 3)),
        factor=np.zeros(len(held.body_on)),
        body=state.work[body:strain].reshape(-1, 1),
        absorbing=held.absorbing,
        alpha=terms.alpha,
        dashpot=with_zeros(bond_dashpots(model, terms)) if damped else np.zeros((4, 0)),
        share=with_zeros(plain.lever / plain.length),
        dashed=np.zeros((rows if damped else 0, 8)),
        viscous=viscous,
    )


def changing_strain(model: Model, state: State) -> Strain | None:
    """Return the stress-free strains of the boundary conditions, added to those of the state, or None."""
    held, plain = model.constraints, model.bonds
    if not len(held.strain_part):
        return None
    bond = np.flatnonzero((held.strain_part != 0.0).any(axis=0))
    return Strain(
        schedule=held.strain_schedule,
        bond=bond.astype(np.uint32),
        part=np.ascontiguousarray(held.strain_part[:, bond]),
        still=1.0 + (state.eigenstrain[bond] if state.eigenstrain.size else np.zeros(len(bond))),
        length=plain.length[bond],
        shear=plain.ks[bond],
        lever=plain.lever[bond],
        factor=np.zeros((4, len(held.strain_part))),
        place=held.works[1],
    )


def changing_cells(model: Model, state: State) -> StrainedCells | None:
    """Return the stress-free strains of cells by the boundary conditions, or None."""
    held, cells, layout = model.constraints, model.cells, model.layout
    if cells is None or not len(held.strain_part):
        return None
    count, still = len(held.strain_part), state.eigenstrain if state.eigenstrain.size else np.zeros(len(layout.i))
    wall = cells.grips.cell
    return StrainedCells(
        schedule=held.strain_schedule, base_i=np.ascontiguousarray(cells.lever_i.T),
        base_j=np.ascontiguousarray(cells.lever_j.T), still=1.0 + still, part=held.strain_part,
        wall_base=cells.grips.lever, wall_still=1.0 + layout.of_elements(still)[wall],
        wall_part=np.array([layout.of_elements(part)[wall] for part in held.strain_part]),
        place=held.works[1], factor=np.zeros((4, count)), power=np.zeros((-(-len(still) // PORTION), count)),
        due=np.zeros(1, dtype=np.uint8),
    )  # fmt: skip


def bond_dashpots(model: Model, terms: DampingTerms) -> Floats:
    """Return cn, cs [N·s/m], cb, ct [N·m·s] of each bond, internal order, shape (4, m)."""
    stiffness, inert = _stiffness(model)
    return 2.0 * terms.eta * np.sqrt(stiffness * inert) + terms.beta * stiffness


def bond_delay(model: Model, terms: DampingTerms) -> float:
    """Return the largest c / k of the bonds [s]; with it, C is at most delay times K."""
    stiffness, inert = _stiffness(model)
    there = stiffness > 0.0
    if not there.any():
        return 0.0
    return 2.0 * terms.eta * float(np.sqrt(inert[there] / stiffness[there]).max()) + terms.beta


def _stiffness(model: Model) -> tuple[Floats, Floats]:
    """Return kn, ks, kb, kt and the reduced masses and moments of inertia of bonds, internal order, (4, m) each."""
    layout, bonds = model.layout, model.bonds
    mass, inertia = model.mass[layout.order], model.inertia[layout.order]
    m, I = (1.0 / (1.0 / v[layout.i] + 1.0 / v[layout.j]) for v in (mass, inertia))
    return np.array([bonds.kn, bonds.ks, bonds.kb, bonds.kt]), np.array([m, m, I, I])
