"""The public boundary: methods are guarded as functions are, and an error shows the line of its user."""

import traceback
import warnings

import numpy as np
import pytest

import bondem as bd
from bondem.errors import ArgumentError, BondemError, InputError, UnitWarning
from tests.specimens import row

BOX = bd.Box((1e-3, 1e-3, 1e-3))
LAW = bd.EulerBernoulli(E=1e9, nu=0.2, radius_ratio=0.5)
MODEL = bd.Model(row(4), LAW, 1000.0)
RUN = bd.solve_explicit(MODEL, duration=1e-5)

ARGUMENTS = {
    "a method": ("Lattice.plot: there is no argument 'value'; did you mean 'values'", lambda: row(4).plot(value=1)),
    "a method of a base": ("Plotted.plot: there is no argument 'dpi'; it takes path", lambda: RUN.plot(dpi=3)),
    "components one by one": (r"moved: .* give one tuple: Shape.moved\(\(1, 2, 3\)\)", lambda: BOX.moved(1, 2, 3)),
    "too many": ("State.copy: 1 argument without a name; it takes none", lambda: RUN.state.copy(1)),
    "steps of a run": ("no argument 'steps'; did you mean 'duration'", lambda: bd.solve_explicit(MODEL, steps=9)),
    "no places at all": ("CellBond: .* give them by name: E=, nu=", lambda: bd.CellBond(1e9, 0.2)),
}  # fmt: skip
ATTRIBUTES = {
    "of a member": (r"ExplicitResult has no attribute 'displacement'; did you mean '\.state\.displacement'",
                    lambda: RUN.displacement),
    "by a function": (r"use bd\.cell_stress\(model, state\)", lambda: RUN.stress),
    "of a plural": ("State has no attribute 'velocities'; did you mean 'velocity'", lambda: RUN.state.velocities),
    "of a module": (r"bondem has no attribute 'plot'; use \.plot\(\) of a lattice", lambda: bd.plot),
    "of a module inside": (r"use bd\.labtests\.brazilian", lambda: bd.brazilian),
    "of a material": (r"use bd\.materials\.granite", lambda: bd.granite),
}  # fmt: skip
REFUSED = {
    "the whole body by name": (r"'all' is not a region; give bd\.Everything\(\)",
                               lambda: bd.Model(row(4), {"all": LAW}, 1e3)),
    "all axes": ("give 'xyz' for all", lambda: bd.Fix(bd.Face("x_min"), "all")),
    "a text with a unit": (r"in Python quantities are numbers in SI units, such as 70e9",
                           lambda: bd.CellBond(E="70 GPa", nu=0.2)),
    "an object in place of another": (r"model = Lattice: 4 elements, .*; give bd.Model",
                                      lambda: bd.solve_static(row(4))),
    "regions by words": ("a region has no truth value; join two by &", lambda: bd.Face("x_min") and bd.Face("y_min")),
    "shapes by words": ("a shape has no truth value", lambda: BOX or BOX),
    "no function for progress": ("pack: progress = True; give", lambda: bd.pack(BOX, count=9, progress=True)),
    "time of a history": (r"did you mean history\.time", lambda: RUN.history["time"]),
    "arguments in the wrong order": ("cell_stress: model = State: .*; give bd.Model",
                                     lambda: bd.cell_stress(RUN.state, MODEL)),
    "calibration of cells": (r"bd\.CellBond\(material\) gives E and ν without calibration", lambda: bd.calibrate(
        bd.connect(bd.pack(bd.Box((2e-3, 1e-3, 1e-3)), count=40, method="even", seed=1), method="laguerre"),
        bd.materials.granite)),
    "one number for three": ("velocity has shape", lambda: setattr(MODEL.state(), "velocity", 5.0)),
}  # fmt: skip


@pytest.mark.parametrize(("words", "call"), ARGUMENTS.values(), ids=ARGUMENTS)
def test_arguments_of_methods_are_guarded(words, call) -> None:
    with pytest.raises(ArgumentError, match=words) as caught:
        call()
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(("words", "call"), ATTRIBUTES.values(), ids=ATTRIBUTES)
def test_a_wrong_attribute_leads_to_the_right_name(words, call) -> None:
    with pytest.raises(AttributeError, match=words):
        call()


@pytest.mark.parametrize(("words", "call"), REFUSED.values(), ids=REFUSED)
def test_what_a_new_user_gives_is_refused_with_what_to_give(words, call) -> None:
    with pytest.raises(InputError, match=words) as caught:
        call()
    assert "\n" not in str(caught.value)


def test_errors_of_properties_and_missing_private_names_stay_what_they_are() -> None:
    class Own(bd.Ball):
        @property
        def broken(self) -> float:
            return self.radius.nothing  # type: ignore[attr-defined]

    with pytest.raises(AttributeError, match="'float' object has no attribute 'nothing'"):
        Own(1e-3).broken  # noqa: B018
    assert not hasattr(RUN, "__array__")
    assert not hasattr(RUN, "_repr_latex_")


def refusal(call) -> BaseException:
    with pytest.raises(BondemError) as caught:
        call()
    return caught.value


def frames(call) -> list[str]:
    """Files of the frames of the error of a call, without those of this function."""
    return [one.filename for one in traceback.extract_tb(refusal(call).__traceback__)][1:]


SHORT = [
    lambda: bd.pack(bd.Box((1e-3, 1e-3, 1e-3)), count="ten"),
    lambda: bd.Box((1e-3, -1e-3, 1e-3)),
    lambda: bd.labtests.direct_tension(row(4), LAW, None),
    lambda: BOX.cut("a"),
]


@pytest.mark.parametrize("call", SHORT)
def test_an_error_shows_the_line_of_the_user_and_one_of_the_package(call, monkeypatch) -> None:
    monkeypatch.delenv("BONDEM_TRACEBACK", raising=False)
    own, last = (list(group) for group in (frames(call)[:-1], frames(call)[-1:]))
    assert set(own) == {__file__}
    assert last[0].endswith("_guard.py")
    shown = "".join(traceback.format_exception(refusal(call)))
    assert "BONDEM_TRACEBACK=full" in shown
    assert len(shown.splitlines()) < 25
    monkeypatch.setenv("BONDEM_TRACEBACK", "full")
    assert len(frames(call)) > len(own) + 1


def test_frames_of_functions_of_the_user_stay(monkeypatch) -> None:
    monkeypatch.delenv("BONDEM_TRACEBACK", raising=False)

    def look(state, record) -> None:
        bd.Ball(-1.0)

    names = [one.name for one in traceback.extract_tb(
        refusal(lambda: bd.solve_explicit(MODEL, duration=1e-5, callback=look)).__traceback__)]  # fmt: skip
    assert "look" in names
    assert names.count("guarded") <= 2


def test_errors_within_the_package_keep_all_frames(monkeypatch) -> None:
    monkeypatch.delenv("BONDEM_TRACEBACK", raising=False)
    monkeypatch.setattr("bondem.run.begin", lambda *_: 1 / 0)
    with pytest.raises(ZeroDivisionError) as caught:
        bd.solve_explicit(MODEL, duration=1e-5)
    assert any(one.name == "solve_explicit" for one in traceback.extract_tb(caught.value.__traceback__))


QUESTIONED = {
    "a modulus in GPa": ("E = 70 Pa; .* if GPa is meant, write 7e.10", lambda: bd.CellBond(E=70, nu=0.2)),
    "a modulus in MPa": ("if MPa is meant, write 2.1e.11", lambda: bd.Timoshenko(E=2.1e5, nu=0.2, radius_ratio=0.5)),
    "a density in g/cm³": ("density = 2.5 kg/m³; .* write 2500", lambda: bd.Model(row(4), LAW, 2.5)),
    "a strength in MPa": ("tension = 4 Pa; .* write 4e.06", lambda: bd.Rankine(tension=4)),
    "a cohesion in MPa": ("cohesion = 7 Pa", lambda: bd.MohrCoulomb(tension=4e6, cohesion=7, friction_angle=0.5)),
    "an energy in N/mm": ("if N/mm is meant, write 100", lambda: bd.Rankine(tension=4e6, fracture_energy=0.1)),
    "a contact in GPa": ("LinearContact: E = 70 Pa", lambda: bd.LinearContact(E=70)),
    "a box in millimetres": ("the shape is 2 m long", lambda: bd.Box((2, 1, 1))),
    "of numpy": ("E = 70 Pa", lambda: bd.CellBond(E=np.float32(70), nu=np.float64(0.2))),
}  # fmt: skip


@pytest.mark.parametrize(("words", "call"), QUESTIONED.values(), ids=QUESTIONED)
def test_a_value_that_another_unit_explains_is_a_warning(words, call) -> None:
    with pytest.warns(UnitWarning, match=words) as caught:
        call()
    assert [one.filename for one in caught] == [__file__]


def test_usual_values_units_of_ones_own_and_trials_of_the_package_are_not() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        bd.CellBond(E=1.0, nu=0.2)  # a unit of its own
        bd.CellBond(E=1e-6, nu=0.2)  # no unit explains it
        bd.Rankine(tension=1e30)  # never to be reached
        bd.LinearContact(E=1e4)  # softened for the step
        bd.Rankine(tension=2e5, fracture_energy=0.5)
        bd.Material("gel", E=5e3, nu=0.45, rho=1000.0)
        bd.materials.get("granite")
    lattice = bd.connect(bd.pack(bd.Cell((1e-2,) * 3), count=200, seed=1))
    with pytest.warns(UnitWarning, match="granite has about") as caught:
        bd.calibrate(lattice, bd.Material("granite", E=69, nu=0.26, rho=2630.0), law=bd.EulerBernoulli)
    assert len(caught) == 1
