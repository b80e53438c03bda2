"""Which code a number hangs on: all modules that the one behind it imports, and theirs, by their text."""

import ast
import hashlib
import subprocess
from collections.abc import Mapping
from functools import cache
from importlib.metadata import version
from pathlib import Path

import bondem
from bondem._core_build import source_digest

REPOSITORY = Path(__file__).parents[2]
#: Where the packages lie whose sources count; of others their version does.
ROOTS: Mapping[str, Path] = {
    "bondem": Path(bondem.__file__).parent,
    "validation": REPOSITORY / "validation",
}
_OTHERS = ("numpy", "scipy")
#: Module of each public name.
_HOMES: Mapping[str, str] = vars(bondem)["_HOME"] | vars(bondem)["_MODULES"]


@cache
def code_hash(module: str) -> str:
    """A hash of a module, of all that it imports, wherever in the file, and of the data that lie beside them.

    Args:
        module: its dotted name, in one of `ROOTS`.
    """
    return closure_hash(module, ROOTS)


def closure_hash(module: str, roots: Mapping[str, Path]) -> str:
    """`code_hash` with the packages in other places."""
    digest = hashlib.sha256(" ".join(f"{name} {version(name)}" for name in _OTHERS).encode())
    files = [_file(name, roots) for name in sorted(closure(module, roots))]
    folders = sorted({path.parent for path in files})
    data = [path for folder in folders for path in sorted(folder.rglob("*.json"))]
    for path in [*files, *dict.fromkeys(data)]:
        digest.update(path.name.encode())
        digest.update(path.read_bytes())
    if roots["bondem"].joinpath("_core.py") in files:
        digest.update(source_digest(roots["bondem"] / "core").encode())
    return digest.hexdigest()


def closure(module: str, roots: Mapping[str, Path]) -> set[str]:
    """Names of a module in one of the roots, of the packages it is in, and of all that these import."""
    seen: set[str] = set()
    todo = [module] if _known(module, roots) else []
    while todo:
        name = todo.pop()
        if name in seen:
            continue
        seen.add(name)
        package = name.rpartition(".")[0]
        todo += [*([package] if package else []), *_imports(name, roots)]
    return seen


def _file(name: str, roots: Mapping[str, Path]) -> Path:
    root, _, rest = name.partition(".")
    path = roots[root].joinpath(*rest.split(".")) if rest else roots[root]
    return path / "__init__.py" if path.is_dir() else path.with_suffix(".py")


def _known(name: str, roots: Mapping[str, Path]) -> bool:
    return name.partition(".")[0] in roots and _file(name, roots).is_file()


def _imports(name: str, roots: Mapping[str, Path]) -> list[str]:
    names, asked = _named(_file(name, roots).read_text(encoding="utf-8"))
    found = [one for one in [*names, *map(_home, asked)] if _known(one, roots)]
    # a name that the package does not list may be in any of its modules
    return found if all(map(_home, asked)) else found + _all_of("bondem", roots["bondem"])


def _home(name: str) -> str:
    """Module of a public name; none where the package lists no such name."""
    return _HOMES.get(name, "")


@cache
def _named(text: str) -> tuple[list[str], set[str]]:
    """Modules, or names in them, that a source imports, and names that it asks the package itself for."""
    found: list[str] = []
    tree = ast.parse(text)
    whole: set[str] = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            found += [alias.name for alias in node.names]
            whole |= {alias.asname or alias.name for alias in node.names if alias.name == "bondem"}
        elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
            # a name of a package may be a module in it
            found += [node.module, *(f"{node.module}.{alias.name}" for alias in node.names)]
    asked = {
        node.attr
        for node in ast.walk(tree)
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id in whole
    }
    return found, {attribute for attribute in asked if not attribute.startswith("__")}


def _all_of(name: str, folder: Path) -> list[str]:
    parts = [path.relative_to(folder).with_suffix("").parts for path in folder.rglob("*.py")]
    names = [".".join((name, *(one[:-1] if one[-1] == "__init__" else one))) for one in parts]
    return [one for one in names if not one.endswith("__main__")]


def commit() -> str:
    """The commit of the repository, with "+" where files differ from it; "" where it is none."""
    try:
        head, changed = (
            subprocess.run(["git", *words], cwd=REPOSITORY, capture_output=True, text=True, check=True).stdout.strip()
            for words in (["rev-parse", "--short=12", "HEAD"], ["status", "--porcelain", "--untracked-files=no"])
        )
    except (OSError, subprocess.CalledProcessError):
        return ""
    return head + ("+" if changed else "")
