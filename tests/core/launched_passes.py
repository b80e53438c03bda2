"""Which passes over an index the counterpart of each pass launches, read from the sources.

Counterparts cannot be imported here: they call the functions that `tests.core.passes` writes from this.
"""

import ast
from collections.abc import Iterator
from functools import cache

from tests.core.tables import SOURCE


@cache
def launched() -> dict[str, set[str]]:
    """Return the passes over an index that each counterpart names, itself or by what it refers to.

    Passes made for each criterion stand by the beginning of their names.
    """
    trees = {path.stem: ast.parse(path.read_text()) for path in sorted((SOURCE / "dynamics/on_device").glob("*.py"))}
    defined = {(module, name): node for module, tree in trees.items() for node in tree.body for name in _names(node)}
    public = {name: (module, name) for module, name in defined if not name.startswith("_")}

    def named(module: str, node: ast.AST, seen: set[tuple[str, str]]) -> Iterator[str]:
        for part in ast.walk(node):
            if isinstance(part, ast.Attribute) and ast.unparse(part.value) == "kernels":
                yield f"{part.attr.lower()}_" if part.attr.isupper() else part.attr
            if isinstance(part, ast.Name):
                place = (module, part.id) if (module, part.id) in defined else public.get(part.id)
                if place is not None and place not in seen:
                    seen.add(place)
                    yield from named(place[0], defined[place], seen)

    found: dict[str, set[str]] = {}
    for module, tree in trees.items():
        for table in (node.value for node in tree.body if isinstance(node, ast.AnnAssign)):
            if isinstance(table, ast.Dict):
                for key, value in zip(table.keys, table.values, strict=True):
                    if name := _name_of_pass(key, value):
                        found.setdefault(name, set()).update(named(module, value, set()))
    return found


def _names(node: ast.stmt) -> list[str]:
    if isinstance(node, ast.FunctionDef):
        return [node.name]
    if isinstance(node, ast.AnnAssign):
        return [node.target.id] if isinstance(node.target, ast.Name) and node.target.id != "COUNTERPARTS" else []
    return [to.id for to in node.targets if isinstance(to, ast.Name)] if isinstance(node, ast.Assign) else []


def _name_of_pass(key: ast.expr | None, value: ast.expr) -> str:
    """Return the name in an entry of counterparts, of a family its beginning; empty if a name has other parts."""
    if key is None and isinstance(value, ast.DictComp) and isinstance(value.key, ast.JoinedStr):
        key = value.key.values[0] if len(value.key.values) == 2 else None
    return str(key.value) if isinstance(key, ast.Constant) else ""
