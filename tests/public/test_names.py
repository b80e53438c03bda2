"""Wrong names of arguments and attributes get a suggestion, and modules list what users need."""

import inspect
import os
import pickle
import subprocess
import sys
import warnings

import pytest

import bondem as bd
from bondem._threads import current_threads, most_threads
from bondem.errors import ArgumentError, BondemError, InputError, UnitWarning

BOX = bd.Box((1e-3, 1e-3, 1e-3))
ARGUMENTS = {
    "a class": ("Cylinder: there is no argument 'height'; did you mean 'length'", lambda: bd.Cylinder(height=1.0)),
    "a function": ("pack: there is no argument 'n'; did you mean 'count'", lambda: bd.pack(BOX, n=10)),
    "misspelt": ("did you mean 'spread'", lambda: bd.pack(BOX, count=10, spreed=0.1)),
    "of capitals": ("did you mean 'E'", lambda: bd.Material("m", e=1.0)),
    "a law": ("Timoshenko: .* did you mean 'nu'", lambda: bd.Timoshenko(E=1.0, poisson=0.2)),
    "a model": ("Model: .* did you mean 'density'", lambda: bd.Model(None, None, rho=1.0)),
    "a test": ("brazilian: there is no argument 'xyz'; it takes body, law", lambda: bd.labtests.brazilian(xyz=1)),
    "edges one by one": (r"give one tuple: Box\(\(1, 2, 3\)\)", lambda: bd.Box(1, 2, 3)),
    "options without a name": (r"at most 1 \(shape\), and by name count=, size=", lambda: bd.pack(BOX, 100)),
}  # fmt: skip


@pytest.mark.parametrize(("words", "call"), ARGUMENTS.values(), ids=ARGUMENTS)
def test_a_wrong_argument_gets_a_suggestion_in_one_line(words, call):
    with pytest.raises(ArgumentError, match=words) as caught:
        call()
    assert isinstance(caught.value, BondemError)
    assert isinstance(caught.value, TypeError)
    assert "\n" not in str(caught.value)


def public_callables():
    for owner in (bd, bd.labtests):
        for name in dir(owner):
            thing = getattr(owner, name)
            own = isinstance(thing, type) and "__init__" in vars(thing) and not inspect.isabstract(thing)
            if (own and not getattr(thing, "_is_protocol", False)) or inspect.isfunction(thing):
                yield name, thing


def test_every_public_function_and_class_refuses_an_unknown_argument():
    for name, thing in public_callables():
        kinds = {one.kind for one in inspect.signature(thing).parameters.values()}
        if inspect.Parameter.VAR_KEYWORD in kinds or (issubclass(type(thing), type) and issubclass(thing, Exception)):
            continue
        with pytest.raises(ArgumentError, match=f"{name}: there is no argument 'flurb'"):
            thing(flurb=1)


def test_errors_within_a_call_stay_what_they_are():
    with pytest.raises(TypeError, match="missing 1 required positional argument") as caught:
        bd.Cylinder(1.0)
    assert not isinstance(caught.value, BondemError)


ATTRIBUTES = {
    "misspelt": ("did you mean 'solve_explicit'", lambda: bd.solve_explict),
    "of another package": ("use bd.solve_explicit", lambda: bd.solve_dynamic),
    "a material": ("did you mean 'granite'", lambda: bd.materials.granit),
    "a test": ("did you mean 'three_point_bending'", lambda: bd.labtests.three_point),
    "an error": ("did you mean 'InputError'", lambda: bd.errors.InputEror),
    "unlike anything": (r"dir\(bondem\) lists", lambda: bd.xyzzy),
}  # fmt: skip


@pytest.mark.parametrize(("words", "call"), ATTRIBUTES.values(), ids=ATTRIBUTES)
def test_a_wrong_attribute_of_a_module_gets_a_suggestion(words, call):
    with pytest.raises(AttributeError, match=words):
        call()


def test_advice_for_tables_is_that_of_the_object():
    lattice = bd.Lattice(bd.Particles([(0.0, 0.0, 0.0), (2e-3, 0.0, 0.0)], 1e-3), [(0, 1)])
    model = bd.Model(lattice, bd.Timoshenko(E=1e9, nu=0.2, radius_ratio=0.5), density=2000.0)
    run = bd.solve_explicit(model, duration=0.0)
    with pytest.raises(AttributeError, match=r"use \.to_pandas\(\)\.to_csv\(file\)"):
        run.history.to_csv  # noqa: B018
    for one in (run.events, run.state, lattice, model):
        with pytest.raises(AttributeError, match=r"bd\.export") as caught:
            one.to_csv  # noqa: B018
        assert "to_pandas" not in str(caught.value)


def test_modules_list_what_users_need_and_nothing_else():
    assert dir(bd.labtests) == sorted(bd.labtests.__all__)
    assert {"brazilian", "three_point_bending"} <= set(dir(bd.labtests))
    assert not {"tension", "rig", "splitting"} & set(dir(bd.labtests))
    assert set(dir(bd.materials)) == {*bd.materials.names(), "get", "names"}
    assert all(issubclass(getattr(bd.errors, name), BaseException) for name in dir(bd.errors))


def test_public_functions_can_be_pickled():
    for function in (bd.pack, bd.connect, bd.labtests.brazilian, bd.solve_static):
        assert pickle.loads(pickle.dumps(function)) is function


def test_warnings_name_the_line_of_the_user():
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        bd.Material("steel", E=210.0, nu=0.3, rho=7850.0)
    assert [one.filename for one in caught] == [__file__]


@pytest.mark.parametrize("shape", [lambda: bd.Box((10, 10, 10)), lambda: bd.Cylinder(5.0, 20), lambda: bd.Ball(25.0),
                                   lambda: bd.Cell((20.0, 20.0, 20.0))])  # fmt: skip
def test_a_shape_in_millimetres_is_a_warning(shape):
    """A specimen of ten metres, in whole numbers of them, is more likely one of ten millimetres."""
    with pytest.warns(UnitWarning, match="metres"):
        shape()


@pytest.mark.parametrize("size", [(1.0, 1.0, 1.0), (0.5, 0.1, 0.1), (10e-3, 20e-3, 10e-3), (3.0, 2.0, 2.0)])
def test_a_shape_of_usual_size_is_not(size):
    bd.Box(size)


def test_threads_are_set_for_all_that_follows():
    before = current_threads()
    bd.set_threads(1)
    assert current_threads() == 1
    bd.set_threads(before)
    assert current_threads() == before
    for wrong in (0, 1.5, "two", most_threads() + 1):
        with pytest.raises(InputError, match="set_threads: count = "):
            bd.set_threads(wrong)


def test_the_environment_sets_the_largest_number_of_threads():
    def said(value):
        code = "import bondem; from bondem._threads import most_threads; print(most_threads())"
        done = subprocess.run(
            [sys.executable, "-c", code], env=os.environ | {"BONDEM_NUM_THREADS": value}, capture_output=True,
            text=True, timeout=120,
        )  # fmt: skip
        return done.stdout + done.stderr

    assert said("1").strip() == "1"
    assert "BONDEM_NUM_THREADS = 'many' is not a number of threads" in said("many")
