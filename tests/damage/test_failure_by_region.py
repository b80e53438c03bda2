"""Strengths by region: each bond, facet and cell fails by the criterion of where it is."""

import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import bondem as bd
from bondem.damage.failure_table import FailureTable
from bondem.damage.softening_table import SofteningTable
from bondem.errors import InputError
from tests.specimens import bar, row

LENGTH, WIDTH = 24e-3, 6e-3
BAR = 250, LENGTH, WIDTH
E, RHO = 30e9, 2400.0
STRONG = bd.Rankine(tension=4e6, fracture_energy=60.0)
WEAK = bd.Rankine(tension=2e6, fracture_energy=30.0, friction=0.3)
BRITTLE = bd.MohrCoulomb(tension=2e6, cohesion=1e6, friction_angle=0.5)
SOFT = bd.MohrCoulomb(tension=4e6, cohesion=9e6, friction_angle=0.5, fracture_energy=60.0)
OPEN = bd.MohrCoulomb(tension=0.0, cohesion=0.0, friction_angle=0.5)
MIDDLE = bd.Within(bd.Box((6e-3, 2 * WIDTH, 2 * WIDTH)).moved((9e-3, -0.5 * WIDTH, -0.5 * WIDTH)))
BETWEEN = (MIDDLE, bd.Everything() - MIDDLE)


def model(failure: object, **others) -> bd.Model:
    return bd.Model(bar(*BAR), bd.CellBond(E=E, nu=0.0), density=RHO, failure=failure, **others)


def ends(speed: float) -> list[bd.BoundaryCondition]:
    return [bd.Fix(bd.Face("x_min"), translation="x", rotation=""), bd.Drive(bd.Face("x_max"), vx=speed)]


def peak_of(failure: object, speed: float) -> tuple[float, bd.ExplicitResult]:
    """Largest stress of a bar between smooth platens [Pa]."""
    run = bd.solve_explicit(
        model(failure, boundary=ends(speed)), duration=1.6e-4 * LENGTH / abs(speed), every=5,
        damping=bd.MassDamping(2e4), gauges={"end": bd.Gauge(bd.Face("x_max"), "force")},
    )  # fmt: skip
    return float(np.abs(run.history["end"][:, 0]).max()) / WIDTH**2, run


def softening(one: bd.Model) -> SofteningTable:
    assert one.softening is not None
    return one.softening


def breaking(one: bd.Model) -> FailureTable:
    assert one.breaking is not None
    return one.breaking


def test_one_criterion_under_many_names_is_one_criterion() -> None:
    """Tables of a mapping whose criteria are equal have the bits of the criterion alone, scattered strengths too."""
    scattered = bd.Rankine(tension=4e6, fracture_energy=60.0, scatter=bd.Weibull(modulus=6.0, volume=1e-9))
    alone, mapped = (softening(model(f)) for f in (scattered, {bd.Everything(): scattered, MIDDLE: scattered}))
    for name in ("strength", "last", "friction"):
        assert np.array_equal(getattr(alone, name), getattr(mapped, name))
    assert np.ptp(alone.strength) > 0.0
    brittle = bd.MohrCoulomb(tension=4e6, cohesion=9e6, friction_angle=0.5, scatter=scattered.scatter)
    one, other = (breaking(model(f)) for f in (brittle, {bd.Everything(): brittle, MIDDLE: brittle}))
    assert np.array_equal(one.coefficient, other.coefficient)
    assert np.array_equal(one.limit, other.limit)


@pytest.mark.filterwarnings("ignore::bondem.errors.RaggedInterfaceWarning")
def test_facets_have_the_strength_of_their_region_and_of_its_border() -> None:
    border = bd.Rankine(tension=1e6, fracture_energy=30.0)
    rest = bd.Everything() - MIDDLE
    one = model({rest: STRONG, MIDDLE: WEAK, (rest, MIDDLE): border})
    table, body = softening(one), one.lattice
    inside = MIDDLE.mask(body)[body.pairs].sum(axis=1)[one.layout.bond_order]
    assert table.strength.tolist() == np.array([4e6, 1e6, 2e6])[inside].tolist()
    assert table.friction.tolist() == np.array([0.0, 0.0, 0.3])[inside].tolist()
    # the opening where nothing is left is 2 G_f / f_t, of a whole facet the traction k u / A
    opening = table.last * table.area / one.cell_law.constants.k
    assert opening == pytest.approx(2.0 * np.array([60.0 / 4e6, 30.0 / 1e6, 30.0 / 2e6])[inside], rel=1e-12)


def test_a_bar_bears_what_its_weakest_part_does() -> None:
    """ν = 0: the traction of every facet is σ n, so that the peak is f_t of the weak part, and it cracks there."""
    peak, run = peak_of({bd.Everything(): STRONG, MIDDLE: WEAK}, 1e-3)
    assert peak == pytest.approx(2e6, rel=0.01)
    hurt = run.state.bond_integrity < 1.0
    assert hurt.any()
    assert MIDDLE.mask(bar(*BAR))[bar(*BAR).pairs[hurt]].any(axis=1).all()


@pytest.mark.validate
def test_a_part_that_a_later_entry_overrules_is_as_strong_as_the_rest() -> None:
    whole, _ = peak_of({MIDDLE: WEAK, bd.Everything(): STRONG}, 1e-3)
    assert whole == pytest.approx(4e6, rel=0.01)


def test_cells_yield_by_the_cohesion_and_the_friction_of_their_region() -> None:
    """(σ1 - σ3)/2 + (σ1 + σ3)/2 sin φ is c cos φ in soft cells, and more than that in their stiff neighbours."""
    (c, angle), (other, steep) = (1e6, math.radians(30.0)), (5e6, math.radians(40.0))
    hard, soft = (
        bd.MohrCoulomb(tension=4e6, cohesion=one, friction_angle=phi, fracture_energy=60.0,
                       fracture_energy_shear=math.inf)
        for one, phi in ((other, steep), (c, angle))
    )  # fmt: skip
    (slip,), inside = model({bd.Everything(): hard, MIDDLE: soft}).yielding, MIDDLE.mask(bar(*BAR))
    own = inside[model(STRONG).layout.order]
    assert slip.strength == pytest.approx(np.where(own, c * math.cos(angle), other * math.cos(steep)))
    assert slip.slope == pytest.approx(np.where(own, math.sin(angle), math.sin(steep)))
    peak, run = peak_of({bd.Everything(): hard, MIDDLE: soft}, -1e-3)
    # soft cells between stiff ones bear more than they would alone, but far less than those
    alone, stiff = (2.0 * k * math.cos(phi) / (1.0 - math.sin(phi)) for k, phi in ((c, angle), (other, steep)))
    assert alone < peak < 0.5 * stiff
    principal = np.linalg.eigvalsh(bd.cell_stress(run.state.model, run.state))
    low, high = principal[:, 0], principal[:, 2]
    reached = (0.5 * (high - low) + 0.5 * (high + low) * math.sin(angle)) / (c * math.cos(angle))
    slipped = run.state.slipped > 0.0
    assert slipped[inside].sum() > 10
    assert not slipped[~inside].any()
    assert reached[slipped] == pytest.approx(1.0, abs=0.02)
    assert reached[~inside].max() > 1.05


def test_cells_by_rankine_do_not_yield_beside_those_that_do() -> None:
    soft = bd.MohrCoulomb(tension=2e6, cohesion=1e6, friction_angle=0.5, fracture_energy=30.0)
    one = model({bd.Everything(): STRONG, MIDDLE: soft})
    (slip,) = one.yielding
    assert (np.isinf(slip.strength) == ~MIDDLE.mask(bar(*BAR))[one.layout.order]).all()
    run = bd.solve_explicit(
        bd.Model(bar(*BAR), bd.CellBond(E=E, nu=0.2), RHO, boundary=ends(-0.02), failure=one.failure),
        duration=2e-5,
    )
    assert np.isfinite(run.state.position).all()


def test_beams_break_by_the_criterion_of_their_region() -> None:
    """A row of equal bonds pulled apart: the third bond is weaker, and breaks first, at its own strength."""
    law = bd.EulerBernoulli(E=1e9, nu=0.3, radius_ratio=0.5)
    strong, weak = (bd.PeripheralStress(tension=s, shear=s) for s in (3e6, 2e6))
    failure = {bd.Everything(): strong, (bd.Index([2]), bd.Index([3])): weak}
    one = bd.Model(row(6), law, 1000.0, failure=failure, boundary=[
        bd.Fix(bd.Index([0])), bd.Drive(bd.Index([5]), vx=1e-3)])  # fmt: skip
    run = bd.solve_explicit(one, duration=1.5e-2, every=10, damping=bd.LocalDamping(0.7), imbalance=None)
    assert run.events.bond.tolist() == [2]
    # five bonds in series under the strength of one: 5 L σ / E
    assert 1e-3 * run.events.time[0] == pytest.approx(5 * 1e-3 * 2e6 / 1e9, rel=0.01)


@pytest.mark.filterwarnings("ignore::bondem.errors.RaggedInterfaceWarning")
def test_a_run_file_keeps_them(tmp_path: Path) -> None:
    failure = {bd.Everything(): STRONG, MIDDLE: WEAK, (MIDDLE, bd.Everything() - MIDDLE): STRONG}
    one = model(failure, boundary=ends(0.02))
    bd.solve_explicit(one, duration=2e-6, out=tmp_path / "run.h5")
    again = bd.read_run(tmp_path / "run.h5").model
    assert again.failure == failure
    assert np.array_equal(softening(again).strength, softening(one).strength)


def test_the_implied_fracture_is_that_of_most_facets() -> None:
    found = model({bd.Everything(): STRONG, MIDDLE: WEAK}).implied_fracture
    assert found is not None
    assert (found.strength, found.fracture_energy, found.softens) == (4e6, 60.0, True)


@pytest.mark.filterwarnings("ignore::bondem.errors.RaggedInterfaceWarning")
@pytest.mark.parametrize("rock", [SOFT, BRITTLE, replace(SOFT, curve=bd.Bilinear()), STRONG])
def test_a_joint_without_cohesion_parts_under_the_least_pull(rock: Any, tmp_path: Path) -> None:
    """Only facets of the joint break, all of them, and no warning or message doubts their energy."""
    joined = model({bd.Everything(): rock, BETWEEN: OPEN}, boundary=ends(1e-2))
    run = bd.solve_explicit(joined, duration=2e-5, every=10, out=tmp_path / "run.h5")
    inside = np.isin(joined.lattice.pairs, MIDDLE.select(joined.lattice)).sum(axis=1) == 1
    assert np.array_equal(np.sort(run.events.bond), np.flatnonzero(inside))
    assert run.events.energy.sum() < 1e-3 * 60.0 * run.fracture_area
    assert "G_f" not in run.message
    assert bd.read_run(tmp_path / "run.h5").model.failure == joined.failure


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"cohesion": 1e6}, "tension = 0.*0 for both tension and cohesion"),
        ({"cohesion": 0.0, "fracture_energy": 1.0}, "has no fracture_energy"),
        ({"cohesion": 0.0, "dilatancy": 0.1}, "has no dilatancy"),
        ({"cohesion": 0.0, "friction_angle": 35.0}, r"write math.radians\(35\)"),
    ],
)
def test_a_joint_has_both_strengths_or_none(options: dict[str, float], message: str) -> None:
    with pytest.raises(InputError, match=message):
        bd.MohrCoulomb(**{"tension": 0.0, "friction_angle": 0.5} | options)


@pytest.mark.parametrize(
    ("failure", "message"),
    [
        ({}, "has no region"),
        ({MIDDLE: STRONG}, "bonds have no strength"),
        ({bd.Everything(): STRONG, MIDDLE: None}, "failure"),
        ({bd.Everything(): STRONG, MIDDLE: bd.Rankine(tension=2e6)}, "with brittle ones"),
        ({bd.Everything(): STRONG, (MIDDLE, MIDDLE, MIDDLE): WEAK}, "names 3 regions"),
        ({bd.Everything(): STRONG, "middle": WEAK}, "failure="),
        ({bd.Everything(): STRONG, MIDDLE: BRITTLE}, "single bonds"),
        (OPEN, "describe a joint; give them to a pair of regions"),
        ({bd.Everything(): SOFT, MIDDLE: OPEN}, "describe a joint; give them to a pair of regions"),
        ({BETWEEN: OPEN}, "describe a joint; give them to a pair of regions"),
        ({bd.Everything(): SOFT, BETWEEN: replace(SOFT, dilatancy=0.2)}, "leave out dilatancy= and band_width="),
        ({bd.Everything(): SOFT, BETWEEN: replace(SOFT, band_width=2e-3)}, "leave out dilatancy= and band_width="),
        ({bd.Everything(): STRONG, MIDDLE: replace(WEAK, curve=bd.Bilinear())}, "curve"),
        ({bd.Everything(): STRONG, MIDDLE: bd.Hydrostatic(tension=2e6, fracture_energy=30.0)}, "may differ"),
        ({bd.Everything(): bd.PeripheralStress(tension=1e6, shear=1e6)}, "applies to beams"),
        ({bd.Everything(): bd.Rankine(tension=4e6, fracture_energy=1e-4)}, "snap back"),
    ],
)  # fmt: skip
def test_what_cannot_be_is_refused(failure: object, message: str) -> None:
    with pytest.raises(InputError, match=message):
        model(failure)
