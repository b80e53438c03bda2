"""What `import bondem as bd` offers: every name once, with its types, and a stub that says so to type checkers.

`python tests/architecture/test_public_names.py` writes the stub anew.
"""

import importlib
import inspect
import typing
from pathlib import Path

import bondem as bd
from bondem import labtests
from bondem._outlets import OUTLETS, Outlets

ROOT = Path(__file__).resolve().parents[2]
STUB = ROOT / "src/bondem/__init__.pyi"

# Arrays in the kernels' order, which a model keeps for solvers, and the shape of the elements of a lattice: not for
# users.
INTERNAL = {
    "BondTable", "CellConstants", "Constraints", "ContactLaws", "ContactModel", "FailureTable", "Joint", "Layout",
    "Interaction", "CellInteraction", "Origin", "Softening", "BeamSoftening", "SofteningTable", "FailurePart",
    "Elements", "SlipTable",
}  # fmt: skip


def stub() -> str:
    """The stub that belongs to `bondem._PUBLIC`."""
    names = [(module, name) for module, names in bd._PUBLIC.items() for name in names]
    names += [tuple(module.rsplit(".", 1)) for module in bd._MODULES.values()]
    lines = [f"from {module} import {name} as {name}" for module, name in sorted(names)]
    return "\n".join([*lines, "", "__version__: str", ""])


def public() -> dict[str, object]:
    found = {name: getattr(bd, name) for name in bd.__all__ if name != "__version__"}
    return found | {f"labtests.{name}": getattr(labtests, name) for name in labtests.__all__}


def functions_of(name: str, thing: object) -> dict[str, object]:
    """A function, or a class with its public methods and properties."""
    if not inspect.isclass(thing):
        return {name: thing} if inspect.isfunction(thing) else {}
    found: dict[str, object] = {name: thing}
    for key, item in vars(thing).items():
        inner = item.fget if isinstance(item, property) else getattr(item, "func", getattr(item, "__func__", item))
        if inspect.isfunction(inner) and (not key.startswith("_") or key == "__init__"):
            found[f"{name}.{key}"] = inner
    return found


def classes_in(hint: object) -> set[type]:
    inner = set().union(*(classes_in(part) for part in typing.get_args(hint)))
    return inner | ({hint} if isinstance(hint, type) and hint.__module__.startswith("bondem") else set())


def test_the_stub_names_all_that_is_public():
    assert STUB.read_text() == stub(), f"run: python {Path(__file__).relative_to(ROOT)}"


def test_types_are_shipped():
    assert (ROOT / "src/bondem/py.typed").is_file()


def test_every_type_that_public_things_take_or_return_is_public():
    things = public()
    known = {id(thing) for thing in things.values()}
    hidden = {
        f"{kind.__qualname__} of {where}"
        for name, thing in things.items()
        for where, function in functions_of(name, thing).items()
        for argument, hint in typing.get_type_hints(function).items()
        if not argument.startswith("_")
        for kind in classes_in(hint)
        if id(kind) not in known and kind.__name__ not in INTERNAL
    }
    assert not hidden


def test_every_public_function_says_what_it_returns():
    functions = {name: thing for name, thing in public().items() if inspect.isfunction(thing)}
    assert len(functions) > 25
    assert not [name for name, function in functions.items() if "return" not in typing.get_type_hints(function)]


def test_all_solvers_give_a_solution():
    solvers = [bd.solve_static, bd.solve_modes, bd.solve_relaxed, bd.solve_explicit, bd.resume]
    for solve in solvers:
        assert issubclass(typing.get_type_hints(solve)["return"], bd.Solution)


def test_functions_of_upper_layers_are_those_that_the_package_enters():
    entered = [(module, name) for module, names in bd._OUTLETS.items() for name in names]
    assert sorted(name for _, name in entered) == sorted(Outlets.__annotations__) == sorted(vars(OUTLETS))
    for module, name in entered:
        assert inspect.isfunction(getattr(importlib.import_module(module), name))


if __name__ == "__main__":
    STUB.write_text(stub())
