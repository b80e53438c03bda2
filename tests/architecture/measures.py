"""Measures of the tree, read off the sources without importing them: `python -m tests.architecture.measures`."""

import ast
from collections import defaultdict
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SOURCE = ROOT / "src"
PACKAGE = "bondem"
# Modules with a function a pass of the core.
_PASSES = f"{PACKAGE}._passes."
Function = ast.FunctionDef | ast.AsyncFunctionDef


@dataclass(frozen=True, order=True)
class Measured:
    """A function and a number that belongs to it.

    Attributes:
        count: arguments, or lines.
        name: module and function.
    """

    count: int
    name: str

    def __str__(self) -> str:
        return f"{self.count:5d}  {self.name}"


@cache
def modules() -> dict[str, ast.Module]:
    """Every module of the package and its syntax tree."""
    found = {}
    for path in sorted((SOURCE / PACKAGE).rglob("*.py")):
        parts = path.relative_to(SOURCE).with_suffix("").parts
        name = ".".join(parts[:-1] if parts[-1] == "__init__" else parts)
        found[name] = ast.parse(path.read_text(), filename=str(path))
    return found


# ---- functions


def functions(tree: ast.AST, prefix: str) -> Iterator[tuple[str, Function]]:
    """Functions and methods with their dotted names, nested ones too."""
    for node in ast.iter_child_nodes(tree):
        if isinstance(node, Function | ast.ClassDef):
            name = f"{prefix}.{node.name}"
            if not isinstance(node, ast.ClassDef):
                yield name, node
            yield from functions(node, name)
        else:
            yield from functions(node, prefix)


def argument_lists() -> list[Measured]:
    """Tables of the passes of the core, most first."""
    found = [
        Measured(len(one.args.args), name)
        for module, tree in modules().items()
        if module.startswith(_PASSES)
        for name, one in functions(tree, module.removeprefix(_PASSES))
    ]
    return sorted(found, reverse=True)


def lengths() -> list[Measured]:
    """Lines of all functions, docstring and signature included, longest first."""
    found = [
        Measured((function.end_lineno or 0) - function.lineno + 1, full)
        for name, tree in modules().items()
        for full, function in functions(tree, name)
    ]
    return sorted(found, reverse=True)


# ---- imports


def imports(name: str, tree: ast.Module) -> set[str]:
    """Modules of the package that a module imports, wherever in the file."""
    known = modules()
    found = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names if alias.name in known}
        elif isinstance(node, ast.ImportFrom) and not node.level and node.module in known:
            # a name of a package may be a module in it
            inside = {alias.name: f"{node.module}.{alias.name}" for alias in node.names}
            found |= {path for path in inside.values() if path in known}
            if any(path not in known for path in inside.values()):
                found.add(str(node.module))
    return found - {name}


def import_cycles() -> list[tuple[str, ...]]:
    """Groups of modules that import each other, in a circle or more."""
    return circles({name: imports(name, tree) for name, tree in modules().items()})


def circles(graph: dict[str, set[str]]) -> list[tuple[str, ...]]:
    """Strongly connected parts of more than one node, and nodes that point at themselves."""

    def reached(start: str) -> set[str]:
        seen: set[str] = set()
        waiting = list(graph.get(start, ()))
        while waiting:
            node = waiting.pop()
            if node not in seen:
                seen.add(node)
                waiting.extend(graph.get(node, ()))
        return seen

    reach = {node: reached(node) for node in graph}
    parts = {tuple(sorted(other for other in reach[node] if node in reach.get(other, ()))) for node in graph}
    return sorted(part for part in parts if part)


# ---- names


def _literal(tree: ast.Module, name: str) -> dict | list | tuple:
    for node in tree.body:
        if isinstance(node, ast.Assign) and any(isinstance(t, ast.Name) and t.id == name for t in node.targets):
            return ast.literal_eval(node.value)
    raise KeyError(name)


def exported(module: str) -> dict[str, str]:
    """Public names of a module that hands out those of others, and where each is defined."""
    tree = modules()[module]
    home = {}
    for node in tree.body:
        if isinstance(node, ast.ImportFrom) and node.module:
            home |= {alias.asname or alias.name: f"{node.module}.{alias.name}" for alias in node.names}
    assigned = [t.id for node in tree.body if isinstance(node, ast.Assign) for t in node.targets
                if isinstance(t, ast.Name)]  # fmt: skip
    own = [*public(tree), *(name for name in assigned if not name.startswith("_"))]
    names = _literal(tree, "__all__") if "__all__" in assigned else own
    return {name: home.get(name, f"{module}.{name}") for name in names}


def public(tree: ast.Module) -> list[str]:
    """Classes and functions a module defines without an underscore."""
    kinds = Function | ast.ClassDef
    return [node.name for node in tree.body if isinstance(node, kinds) and not node.name.startswith("_")]


def public_interface() -> dict[str, str]:
    """What a user reaches: `bd.NAME`, `bd.labtests.NAME`, …, and where each is defined."""
    top = _literal(modules()[PACKAGE], "_PUBLIC")
    rooms = _literal(modules()[PACKAGE], "_MODULES")
    assert isinstance(top, dict)
    assert isinstance(rooms, dict)
    reached = {f"bd.{name}": f"{module}.{name}" for module, names in top.items() for name in names}
    for room, module in rooms.items():
        reached |= {f"bd.{room}.{name}": home for name, home in exported(module).items()}
    return reached


def names_reached_twice() -> dict[str, list[str]]:
    """Names that stand for two different things in the public interface."""
    homes = defaultdict(set)
    for path, home in public_interface().items():
        homes[path.rpartition(".")[2]].add(home)
    return {name: sorted(found) for name, found in homes.items() if len(found) > 1}


def names_defined_twice() -> dict[str, list[str]]:
    """Public classes and functions that two modules define under one name.

    Every command line is a `command` in a file of its own. What prepares the tables of a pass may have its name.
    """
    where = defaultdict(list)
    for module, tree in modules().items():
        for name in public(tree):
            if not ((name == "command" and module.startswith(f"{PACKAGE}.cli")) or module.startswith(_PASSES)):
                where[name].append(module)
    return {name: found for name, found in sorted(where.items()) if len(found) > 1}


def files_of_one_name() -> dict[str, list[str]]:
    """Modules whose file has the name of another's."""
    where = defaultdict(list)
    for module in modules():
        where[module.rpartition(".")[2]].append(module)
    return {name: found for name, found in sorted(where.items()) if len(found) > 1}


def modules_like_public_names() -> list[str]:
    """Modules that lie where a public name of theirs is reached, so that one hides the other.

    `bd.fabric` hides no module, as that is `bondem.specimen.fabric`; `bondem.labtests.impact` would be hidden.
    """
    return sorted({PACKAGE + path.removeprefix("bd") for path in public_interface()} & set(modules()))


# ---- sources


def sources(*suffixes: str) -> list[Path]:
    """Sources of the package with some suffixes, without what is compiled from them."""
    found = (path for path in (SOURCE / PACKAGE).rglob("*") if path.suffix in suffixes)
    return sorted(path for path in found if "build" not in path.parts)


def breakers() -> list[str]:
    """Passes of the core that break bonds, facets or pairs."""
    names = (one.name.rpartition(".")[2] for one in argument_lists())
    return sorted(name for name in names if name.startswith("break_"))


# ---- report


def _table(title: str, rows: Iterable[object], most: int = 8) -> None:
    rows = list(rows)
    print(f"\n{title}")
    for row in rows[:most]:
        print(f"  {row}")


def main() -> None:
    tables, longest = argument_lists(), lengths()
    cycles = import_cycles()
    print(f"modules: {len(modules())}")
    _table(f"import cycles: {len(cycles)}", [" <-> ".join(part) for part in cycles])
    many, long = sum(m.count >= 10 for m in tables), sum(m.count > 60 for m in longest)
    _table(f"tables of passes: {tables[0].count} at most, {many} have ten or more", tables, most=max(8, many))
    _table(f"lines of functions: {longest[0].count} at most, {long} have over 60", longest)
    for title, found in (
        ("names reached twice from bd", names_reached_twice()),
        ("public names defined twice", names_defined_twice()),
        ("files of one name", files_of_one_name()),
    ):
        rows = [f"{name}: {', '.join(where)}" for name, where in found.items()]
        _table(f"{title}: {len(found)}", rows, most=len(rows))
    _table(f"passes that break something: {len(breakers())}", breakers())
    hidden = modules_like_public_names()
    _table(f"modules that a public name hides: {len(hidden)}", hidden)


if __name__ == "__main__":
    main()
