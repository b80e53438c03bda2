"""Counterparts on a device that follow from the tables of their pass: each launch finds every table it needs."""

from inspect import get_annotations, isfunction

import pytest

from bondem._passes import kernels, steps
from bondem.dynamics.on_device.counterparts import COUNTERPARTS
from bondem.dynamics.on_device.translation import _OF_RUN, Launches, over, tables_of

FOLLOWING = {name: one for name, one in COUNTERPARTS.items() if isinstance(one, Launches) and one.parts}
STEPS = {name: one for name, one in vars(steps).items() if isfunction(one)}


def lacking(name: str, launches: Launches) -> list[str]:
    """Return the tables that launches need, and neither the pass nor the device has."""
    given = {kind for argument, kind in get_annotations(STEPS[name]).items() if argument != "return"}
    return [
        f"{one.__name__}: {kind.__name__}"
        for one, _, made in launches.parts
        for kind in tables_of(one)
        if kind not in given | set(made) | set(_OF_RUN)
    ]


def test_each_launch_finds_its_tables() -> None:
    assert len(FOLLOWING) > 150
    assert [row for name, launches in FOLLOWING.items() for row in lacking(name, launches)] == []


def test_a_launch_without_one_of_its_tables_is_found() -> None:
    assert lacking("load_cracks", over(kernels.load_crack, lambda *_: 1)) == ["load_crack: FallenCracks"]


@pytest.mark.parametrize("passes", [steps, kernels], ids=["steps", "kernels"])
def test_no_pass_has_two_tables_of_one_class(passes: object) -> None:
    """Launches find tables by their class."""
    doubled = [
        name
        for name, one in vars(passes).items()
        if isfunction(one) and len(set(tables_of(one))) < len(tables_of(one))
    ]
    assert doubled == []
