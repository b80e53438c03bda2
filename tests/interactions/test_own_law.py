"""A law that no room of bondem knows: it stores a number for each bond, and breaks its bonds by itself."""

import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

import h5py
import numpy as np
import pytest

import bondem as bd
from bondem._passes import steps
from bondem._tables.damage_tables import BeamIntegrity, FailureBounds, Strengths
from bondem._types import Floats, PerBond
from bondem.errors import InputError
from bondem.interactions.beams.beam_interaction import BeamInteraction
from bondem.interactions.beams.beam_tables import beam_tables
from bondem.interactions.beams.bond_law import BondStiffness
from bondem.interactions.interaction import Arrays, LawParts, Run, StateField, SteppingInteraction
from bondem.interactions.step_part import Part
from bondem.io import codec
from bondem.model import model as rooms

K, STRENGTH, MASS = 1e6, 50.0, 1000.0 * math.pi / 6.0  # [N/m], [N], [kg]


@dataclass(frozen=True)
class Spring:
    """A spring between two centres that breaks at a force [N]."""

    strength: float


class Springs(BeamInteraction, SteppingInteraction):
    """These springs. They store how often the core was called with the bond unbroken."""

    law: ClassVar[type] = Spring
    name: ClassVar[str] = "Spring"
    fields: ClassVar[tuple[StateField, ...]] = (StateField("calls", (1, "m")),)

    @classmethod
    def join(cls, lattice: Any, layout: Any, bond: Any, boundary: Any, may_fail: bool) -> "Springs":
        none, length = np.zeros(len(lattice.pairs)), lattice.length
        return cls(lattice, layout, bond, BondStiffness(none + K, none, none, none, 0.5 * length, none + 0.1))

    def own_strength(self) -> PerBond:
        return np.full(len(self.lattice.pairs), self._bond.strength)

    def indices(self, pose: Floats, arrays: Arrays, kind: str, strengths: Strengths) -> PerBond:
        assert kind == "law"
        return super().indices(pose, arrays, "mohr_coulomb", self._strengths)

    @property
    def _strengths(self) -> Strengths:
        table = np.zeros((len(self.layout.i), 4))
        table[:, 0] = 1.0 / self._bond.strength
        return Strengths(table, np.full(len(table), -1.0))

    def parts(self, run: Run) -> LawParts:
        moving, blocks, damage, calls = run.moving, run.blocks, run.damage, run.arrays["calls"]
        beams, _ = beam_tables(self.table, self.layout, self.period, run.arrays["integrity"], may_share=False)
        assert damage is not None
        bounds = FailureBounds(np.full(len(beams.i), 0.99 * self._bond.strength**2, dtype=np.float32), 1.0, 0.0)
        marked = steps.add_marked_beam_loads(moving, beams, blocks, bounds, damage.candidates)
        failing = damage.candidates, damage.postponed
        judge = steps.JUDGE_BEAMS_BY["mohr_coulomb"](moving, beams, self._strengths, *failing)
        remove = steps.break_beams(moving, beams, BeamIntegrity(beams.integrity, np.zeros(0)), *failing, damage.log)

        def keep() -> None:
            calls[:] += beams.integrity[: calls.shape[1]] > 0.0

        forces = Part(
            {"loads": [marked]}, record=lambda _: [steps.sum_beam_energies(moving, beams, run.ledger)], keep=keep
        )
        return LawParts([forces, run.failing([judge], [remove], beams.integrity)], beams.integrity)


@pytest.fixture(autouse=True)
def known(monkeypatch: pytest.MonkeyPatch) -> None:
    """Enter the law into the catalogue and among what run files store."""
    kind_of = rooms.kind_of
    monkeypatch.setattr(rooms, "kind_of", lambda bond: Springs if isinstance(bond, Spring) else kind_of(bond))
    monkeypatch.setitem(codec._TYPES, "Spring", Spring)


def chain(**options: Any) -> bd.Model:
    """Three spheres in a row, the first of which is held."""
    lattice = bd.Lattice(bd.Particles([[0.0, 0, 0], [1, 0, 0], [2, 0, 0]], 0.5), [[0, 1], [1, 2]])
    return bd.Model(lattice, Spring(STRENGTH), 1000.0, **{"boundary": [bd.Fix(bd.Index([0]))]} | options)


def thrown(model: bd.Model) -> bd.State:
    """The last sphere moves away with twice the energy at which its spring breaks."""
    state, energy = model.state(), STRENGTH**2 / K
    state.set_motion(velocity=np.array([[0.0] * 3, [0.0] * 3, [math.sqrt(2.0 * energy / MASS), 0.0, 0.0]]))
    return state


def test_its_bonds_break_at_their_own_strength() -> None:
    model = chain()
    run = bd.solve_explicit(model, duration=0.1, dt=1e-4, every=5, state=thrown(model))
    assert run.events.bond.tolist() == [1]
    assert run.events.energy[0] == pytest.approx(0.5 * STRENGTH**2 / K, rel=0.02)  # it exceeds 50 N within a step
    assert run.history.imbalance < 2e-3
    held = model.state()
    held.displacement = np.array([[0.0] * 3, [0.5 * STRENGTH / K, 0.0, 0.0], [1.25 * STRENGTH / K, 0.0, 0.0]])
    assert bd.failure_index(model, held) == pytest.approx([0.5, 0.75])
    assert bd.failure_index(model, run.state)[1] == 0.0
    assert "Fracture of 3 elements with 2 bonds by Spring" in str(bd.explain(model, run.state))
    assert model.implied_fracture is not None
    assert model.implied_fracture.strength == pytest.approx(STRENGTH / (math.pi * 0.1**2))


def test_its_memory_is_in_the_state_and_in_run_files(tmp_path: Path) -> None:
    model, file = chain(), tmp_path / "run.h5"
    options: dict[str, Any] = {"duration": 0.1, "dt": 1e-4, "every": 5, "save_every": 100, "out": file}
    whole = bd.solve_explicit(model, state=thrown(model), **options)
    assert whole.state.calls[0, 0] > whole.state.calls[0, 1] > 0.0
    read = bd.read_run(file).state
    assert np.array_equal(read.calls, whole.state.calls)
    twin = whole.state.copy()
    twin.calls[:] = 0.0
    assert whole.state.calls.any()
    begun = bd.solve_explicit(model, duration=1e-3, dt=1e-4, state=whole.state)
    assert (begun.state.calls >= read.calls).all()
    with h5py.File(file) as opened:
        assert opened["state/calls"].shape == (1, 2)


@pytest.mark.parametrize(("message", "options"), [
    ("Spring break by a strength of their own", {"failure": bd.PeripheralStress(tension=1e5, shear=1e5)}),
    ("Eigenstrain needs stored rest lengths", {"boundary": [bd.Eigenstrain(1e-3)]}),
])  # fmt: skip
def test_what_it_lacks_is_refused(message: str, options: dict[str, Any]) -> None:
    with pytest.raises(InputError, match=message):
        chain(**options)
