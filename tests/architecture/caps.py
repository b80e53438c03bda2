"""Counts of the sources that may only fall, and their caps.

`python -m tests.architecture.caps` prints every count beside its cap; with words behind it, the places of the counts
whose names contain one of these.
"""

import ast
import io
import re
import sys
import tokenize
import tomllib
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache

from tests.architecture.measures import PACKAGE, ROOT, SOURCE, Function, functions, lengths, modules, sources

# Parts that a model may lack.
_PARTS = frozenset({
    "cells", "breaking", "softening", "beam_softening", "non_local", "contacts", "walls", "facets", "tractions",
    "strains", "yielding", "slip", "bond_forces", "failure", "contact", "contact_laws",
})  # fmt: skip
# Attributes that a lattice has if it is cut into cells; those that a model has if its law is that of cells, or the
# non-local law; and the laws that code asks for by their class.
_OF_SHAPE = frozenset({"cells", "facets"})
_OF_LAW = _OF_SHAPE | {"_cells", "non_local", "_non_local"}
_LAWS = frozenset({"CellBond", "NonLocal", "CellConstants", "NonLocalConstants"})
_SHAPES = frozenset({"Cells", "Facets", "CellElements"})
# Names of variables for a lattice, and for the section of a study about its bonds; others are models.
_LATTICES = frozenset({"lattice", "body", "bar", "own", "o", "one"})
_SECTION = "bond"
_NON_LOCAL = re.compile(r"non_local|NonLocal")
_OWN_OF_NON_LOCAL = re.compile(r"interactions/non_local/|/_(?:tables|passes)/")
_KIND_OF_PASS = re.compile(r"^ *BONDEM_PASS(?:_AS)?\(\w+(?:##\w+)?, (\w+)")
# Words in names that do not say what is meant.
_VAGUE = frozenset({"hold", "holds", "held", "told", "tell", "begun", "kept", "came", "gone", "alike", "look"})
_NAME = re.compile(r"(?<!\w)[A-Za-z_]\w*")
_WORD = re.compile(r"[A-Z]?[a-z]+|[A-Z]+")
_LOWERED = re.compile(r"\bintegrity\(\w+\) [-*]?= ")
# Sources that a command writes: the stub of the public names, the version, tables, passes and lists.
_GENERATED = re.compile(
    r"__init__\.pyi|_version\.py|/_(?:tables|passes)/|core/(?:described_tables|table_names)\.hpp"
    r"|criteria/bond_criteria\.hpp|gpu/index_passes\.hpp"
)


@dataclass(frozen=True)
class Cap:
    """A count that may only fall.

    Attributes:
        name: what is counted.
        places: file and line of each.
        most: the cap.
        step: the cap is the next multiple of it, so that not every change of lines changes the cap.
    """

    name: str
    places: Callable[[], list[str]]
    most: int
    step: int = 1

    @property
    def count(self) -> int:
        """Number of places at present."""
        return len(self.places())

    @property
    def fault(self) -> str:
        """What is wrong with the count and what to do, in one line; empty if nothing is."""
        count = self.count
        if count > self.most:
            return (f"{self.name}: {count}, above the cap of {self.most}. Remove as many;"
                    f' `python -m tests.architecture.caps "{self.name}"` lists them.')  # fmt: skip
        if count <= self.most - self.step:
            new = -(-count // self.step) * self.step
            return f"{self.name}: {count}, below the cap of {self.most}. Write {new} into tests/architecture/caps.py."
        return ""


def compared(module: str, tree: ast.Module) -> Iterator[tuple[str, str, ast.expr, int]]:
    """Yield (module, attribute or variable, expression, line) of everything that is compared with None.

    A variable stands for the attribute that its function assigns to it, else for its annotation.
    """
    bound: dict[int, dict[str, ast.expr]] = {}
    for _, function in functions(tree, module):  # nested functions come last
        names = _bindings(function)
        bound |= {id(node): names for node in ast.walk(function) if isinstance(node, ast.Compare)}
    for node in ast.walk(tree):
        if not isinstance(node, ast.Compare) or not isinstance(node.ops[0], ast.Is | ast.IsNot):
            continue
        left = node.left.value if isinstance(node.left, ast.NamedExpr) else node.left
        name = left.attr if isinstance(left, ast.Attribute) else getattr(left, "id", "")
        if isinstance(left, ast.Name):
            left = bound.get(id(node), {}).get(left.id, left)
        yield module, name, left, node.lineno


@cache
def _all_compared() -> list[tuple[str, str, ast.expr, int]]:
    return [one for module, tree in modules().items() for one in compared(module, tree)]


def _bindings(function: Function) -> dict[str, ast.expr]:
    given = function.args
    arguments = (*given.posonlyargs, *given.args, *given.kwonlyargs)
    names = {one.arg: one.annotation for one in arguments if one.annotation is not None}
    for node in ast.walk(function):
        if isinstance(node, ast.NamedExpr):
            names[node.target.id] = node.value
        if not isinstance(node, ast.Assign):
            continue
        for target in node.targets:
            pairs = [(target, node.value)]
            if isinstance(target, ast.Tuple) and isinstance(node.value, ast.Tuple):
                pairs = list(zip(target.elts, node.value.elts, strict=False))
            names |= {to.id: value for to, value in pairs if isinstance(to, ast.Name)}
    return names


def asked_of(module: str, asked: ast.expr) -> str:
    """Return "lattice", "study" or "model": what an expression asks for cells or a law; "" for another question."""
    text = ast.unparse(asked)
    if isinstance(asked, ast.Attribute):
        owner = ast.unparse(asked.value).rpartition(".")[2].lstrip("_")
        lattice = owner in _LATTICES or (owner == "self" and module == f"{PACKAGE}.specimen.lattice")
        if lattice and asked.attr in _OF_SHAPE:
            return "lattice"
        return "study" if owner == _SECTION else "model"
    kind = text.removesuffix(" | None")  # an argument
    return "lattice" if kind in _SHAPES else "model" if kind in _LAWS else ""


@cache
def _questions() -> dict[str, list[str]]:
    """Places that ask a model, a lattice or a study whether there are cells, or the non-local law."""
    found: dict[str, list[str]] = {"model": [], "lattice": [], "study": [], "": []}
    for module, name, asked, line in _all_compared():
        if name in _OF_LAW:
            found[asked_of(module, asked)].append(f"{module}:{line} {ast.unparse(asked)}")
    for module, tree in modules().items():
        for node in ast.walk(tree):
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "isinstance":
                named = {part.id for part in ast.walk(node.args[1]) if isinstance(part, ast.Name)}
                for whom, kinds in (("model", _LAWS), ("lattice", _SHAPES)):
                    if named & kinds:
                        found[whom].append(f"{module}:{node.lineno} {ast.unparse(node)}")
    return found


def _asked(capability: str) -> list[str]:
    """Places that read this attribute of a law; a method of the same name, such as that of a load, is called."""
    found = []
    for module, tree in modules().items():
        called = {id(node.func) for node in ast.walk(tree) if isinstance(node, ast.Call)}
        read = (node for node in ast.walk(tree) if isinstance(node, ast.Attribute) and node.attr == capability)
        found += [f"{module}:{node.lineno} {ast.unparse(node)}" for node in read if id(node) not in called]
    return found


def _tests_for_none() -> list[str]:
    return [f"{module}:{line} {name}" for module, name, _, line in _all_compared() if name in _PARTS]


def _files_of_the_non_local_law() -> list[str]:
    named = (path for path in sources(".py") if _NON_LOCAL.search(path.read_text()))
    return [str(path.relative_to(SOURCE)) for path in named if not _OWN_OF_NON_LOCAL.search(str(path))]


def _of_core(wanted: Callable[[str], object]) -> list[str]:
    """Places of the lines of the core that are wanted."""
    lines = (
        (path, number, line)
        for path in sources(".hpp", ".cpp", ".cu")
        for number, line in enumerate(path.read_text().splitlines(), 1)
    )
    return [f"{path.relative_to(SOURCE)}:{number}" for path, number, line in lines if wanted(line)]


def _passes_of_kind(kind: str) -> list[str]:
    return _of_core(lambda line: (found := _KIND_OF_PASS.match(line)) and found[1] == kind)


def _vague_names() -> list[str]:
    """Names in code that contain a vague word, each once."""
    found: set[str] = set()
    for path in sources(".py"):
        tokens = tokenize.generate_tokens(io.StringIO(path.read_text()).readline)
        found |= {token.string for token in tokens if token.type == tokenize.NAME}
    for path in sources(".hpp", ".cpp", ".cu"):
        found |= set(_NAME.findall(re.sub(r"//[^\n]*|\"[^\"\n]*\"", "", path.read_text())))
    return sorted(name for name in found if _VAGUE & {word.lower() for word in _WORD.findall(name)})


def _lines(*suffixes: str) -> list[str]:
    return [
        f"{path.relative_to(SOURCE)}:{number + 1}"
        for path in sources(*suffixes)
        if not _GENERATED.search(str(path))
        for number in range(len(path.read_text().splitlines()))
    ]


def _counterparts_by_hand() -> list[str]:
    """Passes whose counterpart on a device is a function that someone wrote, not launches of their tables."""
    found = []
    for module, tree in modules().items():
        if not module.startswith(f"{PACKAGE}.dynamics.on_device.") or not module.endswith("_counterparts"):
            continue
        written = {node.name for node in tree.body if isinstance(node, ast.FunctionDef)}
        for node in ast.walk(tree):
            if not isinstance(node, ast.AnnAssign) or getattr(node.target, "id", "") != "COUNTERPARTS":
                continue
            assert isinstance(node.value, ast.Dict), f"{module}: write COUNTERPARTS as one dictionary"
            for key, value in zip(node.value.keys, node.value.values, strict=True):
                if isinstance(value, ast.Lambda) or getattr(value, "id", "") in written:
                    found.append(f"{module}:{value.lineno} {ast.unparse(key) if key else ''}")
    return found


def _longest_function() -> list[str]:
    longest = lengths()[0]
    return [f"{longest.name} line {number + 1}" for number in range(longest.count)]


def _named_from_below() -> list[str]:
    """Strings that name a module of an upper layer; `bondem/__init__.py` is above all layers."""
    layers = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["importlinter"]["contracts"][0]["layers"]
    height = {room.strip(): -row for row, layer in enumerate(layers) for room in layer.split("|")}

    def level(module: str) -> int | None:
        return next((height[room] for room in height if f"{module}.".startswith(f"{room}.")), None)

    return [
        f"{module}:{node.lineno} {node.value}"
        for module, tree in modules().items()
        if (own := level(module)) is not None
        for node in ast.walk(tree)
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and node.value in modules()
        if (other := level(node.value)) is not None and other > own
    ]


CAPS = (
    Cap("questions to a model about its law", lambda: _questions()["model"], 0),
    Cap("questions to a lattice about its shape", lambda: _questions()["lattice"], 20),
    Cap("questions to a study about its law", lambda: _questions()["study"], 0),
    Cap("questions to a law whether it is on facets", lambda: _asked("on_facets"), 4),
    Cap("tests of a part for None", _tests_for_none, 65),
    Cap("files of Python that name the non-local law", _files_of_the_non_local_law, 3),
    Cap("places of the core that lower integrity", lambda: _of_core(_LOWERED.search), 1),
    Cap("names of vague words", _vague_names, 5),
    Cap("passes that are single", lambda: _passes_of_kind("single"), 5),
    Cap("passes that are serial", lambda: _passes_of_kind("serial"), 0),
    Cap("device counterparts written by hand", _counterparts_by_hand, 9),
    Cap("lines of Python", lambda: _lines(".py"), 58185, step=500),
    Cap("lines of C++", lambda: _lines(".hpp", ".cpp", ".cu"), 19355, step=500),
    Cap("lines of the longest function", _longest_function, 142),
    Cap("names of an upper layer in strings", _named_from_below, 0),
)


def main(words: list[str]) -> None:
    """Print the counts and their caps, or the places of some."""
    for cap in CAPS:
        if not words:
            print(f"{cap.count:6d} of {cap.most:6d}  {cap.name}")
        elif any(word in cap.name for word in words):
            print(*cap.places(), sep="\n")


if __name__ == "__main__":
    main(sys.argv[1:])
