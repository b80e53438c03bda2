"""What public objects show of themselves: at most twelve lines, with units, and a table in notebooks."""

import inspect
import re
import typing
from dataclasses import fields, is_dataclass
from functools import cache

import numpy as np
import pytest

import bondem as bd
from bondem.labtests.cracking import Cracking
from tests.specimens import bar, spheres

LINES, WIDTH = 12, 118


def public_classes() -> dict[str, type]:
    found = {}
    for owner in (bd, bd.labtests):
        for name in dir(owner):
            thing = getattr(owner, name)
            if isinstance(thing, type) and not getattr(thing, "_is_protocol", False):
                found[name] = thing
    return found


CLASSES = public_classes()


@cache
def objects() -> list[object]:
    """Objects as their users get them, of small models."""
    lattice = spheres(bd.Box((3.0, 2.0, 2.0)), 120, spread=0.2, seed=3, reach=1.1)
    particles = lattice.particles
    ends = [bd.Fix(bd.Face("x_min", depth=0.2)), bd.Load(bd.Face("x_max", depth=0.2), (1.0, 0.0, 0.0))]
    beams = bd.Model(lattice, bd.EulerBernoulli(E=1e9, nu=0.25, radius_ratio=0.7), 1000.0, boundary=ends)
    static = bd.solve_static(beams)
    run = bd.solve_explicit(beams, duration=2e-3, every=1)
    body = bar(60, 3.0, 1.0)
    cells = bd.Model(body, bd.CellBond(E=1e9, nu=0.2), 1000.0, boundary=[bd.Fix(bd.Face("x_min"))])
    return [
        particles, lattice, body, body.cells, body.cells.free, body.facets, beams, cells, static, run, run.state,
        run.history, bd.solve_modes(beams, count=3, prestress=False), bd.bond_forces(beams, static),
        bd.element_stress(beams, static), bd.fabric(lattice), bd.fragments(lattice, run.state),
        beams.bond, *ends, particles.shape, bd.materials.granite, run.events,
        bd.labtests.static_tension(lattice, beams.bond),
        bd.MohrCoulomb(tension=1.0, cohesion=1.0, friction_angle=0.5),
        bd.Eigenstrain(np.linspace(0.0, 1e-3, 120)), bd.Table((0.0, 1.0), (0.0, 2.0)),
        bd.Box((1.0, 1.0, 1.0)).moved((1.0, 0.0, 0.0)), bd.HertzMindlin(E=1e9, nu=0.2), bd.Index(range(1000)),
        bd.PlaneWall((0.0, 0.0, 0.0), (0.0, 0.0, 1.0)), bd.Gauge(bd.Everything(), "force"), run.status,
    ]  # fmt: skip


def check(thing: object) -> None:
    lines = repr(thing).split("\n")
    assert len(lines) <= LINES, repr(thing)
    assert max(map(len, lines)) <= WIDTH, repr(thing)
    assert type(thing).__name__ in lines[0]
    table = thing._repr_html_()
    assert table.startswith("<table>")
    assert table.count("<tr>") == table.count("</tr>")
    assert type(thing).__name__ in table


def test_objects_are_shown_in_twelve_lines():
    for thing in objects():
        check(thing)


@pytest.mark.parametrize("name", CLASSES)
def test_every_public_class_is_shown_in_twelve_lines(name):
    """Also where all of its attributes are large: an instance that is made without its constructor."""
    kind = CLASSES[name]
    assert hasattr(kind, "_repr_html_")
    if inspect.isabstract(kind) or typing.get_origin(kind) is not None or not is_dataclass(kind):
        return
    thing = object.__new__(kind)
    for one in fields(kind):
        object.__setattr__(thing, one.name, np.linspace(-1.0, 1.0, 3000).reshape(1000, 3))
    check(thing)


@pytest.mark.parametrize(
    ("thing", "words"),
    [
        (lambda: bd.Box((1e-2, 2e-2, 3e-2)), ["Box(size=(0.01, 0.02, 0.03) m)"]),
        (lambda: bd.EulerBernoulli(E=1e9, nu=0.2, radius_ratio=0.5), ["E=1e+09 Pa", "radius_ratio=0.5"]),
        (lambda: bd.materials.steel, ["E: 2.1e+11 Pa", "rho: 7850 kg/m³"]),
        (lambda: objects()[0], ["Particles: 120 spheres of mean radius", "position: shape (120, 3), ", " m"]),
        (lambda: objects()[1], ["Lattice: 120 elements", "bonds, coordination number"]),
        (lambda: objects()[2], ["Lattice: 60 cells", "facets"]),
        (lambda: objects()[6], ["Model: 120 elements", "bond: EulerBernoulli(E=1e+09 Pa", "boundary: 1 Fix, 1 Load"]),
        (lambda: objects()[8], ["displacement: shape (120, 3), ", " m\n", " rad"]),
        (lambda: objects()[10], ["State: 120 elements", "(0 broken) at t = ", "velocity: shape (120, 3), ", " m/s"]),
    ],
)  # fmt: skip
def test_what_an_object_is_stands_there_with_units(thing, words):
    shown = repr(thing())
    for one in words:
        assert one in shown


def test_results_of_tests_begin_with_what_they_measure():
    """Strengths, moduli and the failure; numbers of several units, and what is no number, have no unit."""
    body = bar(60, 20e-3)
    state = bd.Model(body, bd.CellBond(E=1e9, nu=0.2), 1000.0).state()
    cracking = Cracking(body, state, 0.1, 0.0, 0.0, 1.0, 100.0)
    inner = bd.labtests.StrengthTest(4e6, 4e9, np.ones((9, 2)), 1.0, 0.0, 0.0, 0.0, 0.0, cracking, objects()[9])
    split, pressed = bd.labtests.BrazilianTest(inner, 0.95, 0.5, 0.1), bd.labtests.TriaxialTest(inner, 1e6)
    first = repr(split).split("\n")[1:4]
    assert first == ["  peak: 4e+06 Pa", "  tension: 2e+06 Pa", "  E: 4e+09 Pa"]
    assert "cracking: Cracking: does not split: 1 piece" in repr(split)
    assert "deviator: 3e+06 Pa" in repr(pressed)
    assert "curve: shape (9, 2), 1 … 1\n" in repr(inner)
    history = repr(objects()[11])
    assert re.search(r"records: shape \(\d+, 15\), \S+ … \S+\n", history)
    assert "servo=none," in repr(objects()[9])


def test_a_table_says_what_the_quantities_are():
    table = objects()[8]._repr_html_()
    for words in ("<caption", "displacement", "of the centres [m], shape (n, 3)", "rotation"):
        assert words in table
