"""Write what follows from the passes of the core: one typed function a pass, for Python's callers.

`python -m tests.core.passes` compiles the core, reads names and tables of its passes from the library, and writes
`bondem/_passes`, a file for each source of passes; a test compares them. A pass is registered behind its definition
(`core/registered.hpp`), and the first sentence of the comment above it says what it is for: the one of its header
where a header declares it for other sources. A pass without a sentence of its own is refused. A pass over an index
without one takes that of the pass of a step whose counterpart launches it, if there is one such pass. Behind the
sentence of a pass of a step are the columns of elements that it reads and writes.
"""

import re
from functools import cache
from pathlib import Path
from textwrap import wrap

from bondem import _core
from bondem._core import pass_tables
from tests.core.launched_passes import launched
from tests.core.pass_columns import words_of
from tests.core.tables import SOURCE

FOLDER = SOURCE / "_passes"
#: Of each module: title, and the words behind the sentence of a pass.
TITLES = {
    "steps": "Passes that steps are composed of",
    "calls": "Passes that Python calls",
    "kernels": "Passes over an index, for devices",
}
KINDS = {"steps": "StepEntry", "calls": "Call", "kernels": "Kernel"}
# A function with its comment; a pass that is made of a template; what passes of each kind run over.
FUNCTION = re.compile(
    r"((?:^//[^\n]*\n)+)(?:^template <[^>]*>[ \n])?(?:inline )?"
    r"(?:void|Index) (\w+)\((?:const Range &|Index\b)([^)]*)\)",
    re.MULTILINE,
)
REGISTERED = re.compile(r"BONDEM_(?:PASS|CALL)(?:_AS)?\((\w+)")
MADE = re.compile(r'BONDEM_(?:PASS|CALL)_AS\((\w+?)(?:##name)?, [^,]+, (?:"[^"]*", )?(\w+)')
KIND = re.compile(r"^    (\w+),?  // (.+)$", re.MULTILINE)
INIT = '''"""Passes of the core with their tables, written by `python -m tests.core.passes` from the library."""

from typing import Any, NamedTuple


class StepEntry(NamedTuple):
    """An entry of a list of a step: a pass with its tables."""

    name: str
    tables: tuple[Any, ...]


class Kernel(NamedTuple):
    """A pass over an index with its tables: a thread of a device does one."""

    name: str
    tables: tuple[Any, ...]


class Call(NamedTuple):
    """A pass that Python calls, with its tables."""

    name: str
    tables: tuple[Any, ...]
'''


def comments() -> dict[str, tuple[str, list[str]]]:
    """Return comment and names of the tables of every function with a comment; those of headers come first."""
    found: dict[str, tuple[str, list[str]]] = {}
    made: dict[str, str] = {}
    for path in [*sorted((SOURCE / "core").rglob("*.hpp")), *sorted((SOURCE / "core").rglob("*.cpp"))]:
        text = path.read_text()
        made |= dict(MADE.findall(text))
        for words, name, given in FUNCTION.findall(text):
            joined = " ".join(line[2:].strip() for line in words.splitlines())
            found.setdefault(name, (joined, re.findall(r"const \w+ &(\w+)", given)))
    return found | {prefix: found[function] for prefix, function in made.items() if function in found}


def sentence(name: str, words: str) -> str:
    """Return the first sentence of the comment of a pass; SystemExit where it says nothing by itself."""
    first = words.split(". ")[0].rstrip(".")
    if not first or re.match(r"(?:The same|Those|And|Them|It|They|Sorts them|Lists them)\b", first):
        raise SystemExit(f"{name}: write a comment above it whose first sentence says by itself what the pass is for")
    return f"{first}."


def _kinds() -> list[tuple[str, str]]:
    return KIND.findall((SOURCE / "core/steps.hpp").read_text().partition("enum PassKind")[2].partition("};")[0])


def kinds_of_passes() -> list[str]:
    """Return the names of `PassKind`, in its order."""
    return [name for name, _ in _kinds()]


def pass_kinds() -> list[str]:
    """Return what passes of each kind run over, in the order of `PassKind`."""
    return [words for _, words in _kinds()]


def snake(name: str) -> str:
    """Return the name of a table as that of an argument."""
    return re.sub(r"(?<!^)(?=[A-Z])", "_", name).lower()


def _function(kind: str, name: str, tables: tuple[str, ...], words: str, named: list[str], over: str) -> list[str]:
    given = [snake(table) for table in tables]
    if len(set(given)) < len(given):  # a table occurs twice: only the definition can name them
        given = named
        if len(set(named)) != len(tables):
            raise SystemExit(f"{name}: name its tables where it is defined")
    arguments = [f"{one}: {table}" for one, table in zip(given, tables, strict=True)]
    lines = _wrapped(f"def {name}(", arguments, f") -> {kind}:", "    ")
    doc = wrap(sentence(name, words), 108)
    more = ["", *(f"    {line}" for line in wrap(f"Over {over}.", 108))] if over else []
    if len(doc) == 1 and not more:
        lines.append(f'    """{doc[0]}"""')
    else:
        lines += [f'    """{doc[0]}', *(f"    {line}" for line in doc[1:]), *more, '    """']
    named = ", ".join(given) + "," * (len(given) == 1)
    return [*lines, *_wrapped(f'    return {kind}("{name}", (', [named], "))", "        "), "", ""]


def _wrapped(head: str, parts: list[str], tail: str, indent: str) -> list[str]:
    line = f"{head}{', '.join(parts)}{tail}"
    if len(line) <= 118:
        return [line]
    return [head, *(f"{indent}{row}" for row in wrap(", ".join(parts), 110)), f"{indent[:-4]}{tail}"]


def _part(module: str, tables: dict[str, tuple[str, ...]], over: dict[str, str], place: str) -> str:
    """Return the text of one file: passes of one source or header."""
    words, where = comments(), _modules_of_tables()
    lines = [f'"""{TITLES[module]}, of `core/{place}`.', "", "Written by `python -m tests.core.passes`.", '"""', "",
             f"from bondem._passes import {KINDS[module]}"]  # fmt: skip
    used = {table for names in tables.values() for table in names}
    for file in sorted({where[table] for table in used}):
        names = sorted((table for table in used if where[table] == file), key=str.lower)
        line = f"from bondem._tables.{file} import {', '.join(names)}"
        long = [f"from bondem._tables.{file} import (", *(f"    {name}," for name in names), ")"]
        lines += [line] if len(line) <= 118 else long
    lines += ["", ""]
    for name in sorted(tables):
        of = _family(name)
        found = words.get(name) or words.get(of) or ("", [])
        more = over.get(name, "")
        if module == "kernels" and not found[0]:
            found, more = (_words_of_pass(of, words), []), "one index"
            if not found[0]:
                found, more = (f"Pass of one index, defined in `core/{place}`.", []), ""
        lines += _function(KINDS[module], name, tables[name], *found, more)
    for of in sorted({of for name in tables if (of := _family(name)) != name}):
        lines += [f"#: Passes `{of}…` by the name of their criterion.", f"{of[:-1].upper()} = {{"]
        lines += [*(f'    "{name.removeprefix(of)}": {name},' for name in sorted(tables) if name.startswith(of)), "}"]
    return "\n".join(lines).rstrip() + "\n"


def _package(module: str, tables: dict[str, tuple[str, ...]], over: dict[str, str]) -> dict[str, str]:
    """Return the text of each file of a package by its name."""
    by_place: dict[str, dict[str, tuple[str, ...]]] = {}
    for name in sorted(tables):
        by_place.setdefault(_place(module, name), {})[name] = tables[name]
    made = {}
    head = [f'"""{TITLES[module]}; written by `python -m tests.core.passes`: change the core instead."""', ""]
    for place, names in sorted(by_place.items(), key=lambda one: Path(one[0]).stem):
        file = Path(place).stem
        made[file] = _part(module, names, over, place)
        head.append(f"from bondem._passes.{module}.{file} import *")
    if over:
        head += ["", "#: What the passes of each kind run over.", "KINDS = ("]
        head += [*(f'    "{one}",' for one in pass_kinds()), ")"]
    return {"__init__": "\n".join(head) + "\n", **made}


def _words_of_pass(kernel: str, words: dict[str, tuple[str, list[str]]]) -> str:
    """Return the sentence of the one pass whose counterpart launches a pass over an index; empty if there is none."""
    by_pass = launched()
    passes = [name for name, kernels in by_pass.items() if kernel in kernels]
    if len(passes) != 1 or passes[0] not in words:
        return ""
    said = sentence(passes[0], words[passes[0]][0])
    if len(by_pass[passes[0]]) == 1:
        return said
    return f"Launched for `{passes[0].removesuffix('_by_')}`: {said[0].lower()}{said[1:]}"


@cache
def _families() -> list[str]:
    """Return the beginnings of the names of passes that a macro makes for each criterion."""
    texts = (path.read_text() for path in (SOURCE / "core").rglob("*.[ch]pp"))
    return sorted({of for text in texts for of in re.findall(r"(?:auto |_AS\()(\w+_by_)##name", text)})


def _family(name: str) -> str:
    """Return the beginning of the name of a pass that a macro makes for each criterion; of others the name."""
    return next((of for of in _families() if name.startswith(of)), name)


@cache
def _places() -> dict[str, str]:
    """Return the source of each registered pass; of families by the beginning of their names."""
    core = SOURCE / "core"
    return {
        name: path.relative_to(core).as_posix()
        for path in sorted(core.rglob("*.cpp"))
        for name in REGISTERED.findall(path.read_text())
    }


def _place(module: str, name: str) -> str:
    """Return the source of a pass, or the header of one over an index, below `core`."""
    of = _family(name)
    if module != "kernels":
        return _places().get(name) or _places()[of]
    defined = re.compile(rf"(?:void {of}\(Index|auto {of}(?:##name)? =)")
    return next(
        f"gpu/{path.name}"
        for path in sorted((SOURCE / "core/gpu").glob("*.hpp"))
        if defined.search(path.read_text())
    )


def _modules_of_tables() -> dict[str, str]:
    return {
        table: path.stem
        for path in (SOURCE / "_tables").glob("*.py")
        for table in re.findall(r"^class (\w+)\(", path.read_text(), re.MULTILINE)
    }


def written() -> dict[Path, str]:
    """Return every generated file and its text."""
    words = pass_kinds()
    over = {
        name: ". ".join(filter(None, (words[_core.step_pass(name)[0][1]], words_of(name))))
        for name in pass_tables("steps")
    }
    made = {"__init__": INIT}
    for module in KINDS:
        files = _package(module, pass_tables(module), over if module == "steps" else {})
        made |= {f"{module}/{name}": text for name, text in files.items()}
    return {FOLDER / f"{name}.py": text for name, text in made.items()}


def stale() -> list[str]:
    """Return the names of generated files that differ from what the library gives."""
    made = written()
    left = {str(path.relative_to(FOLDER)) for path in set(FOLDER.rglob("*.py")) - set(made)}
    wrong = [path for path, text in made.items() if not path.exists() or path.read_text() != text]
    return sorted(left | {str(path.relative_to(FOLDER)) for path in wrong})


if __name__ == "__main__":
    for name in stale():
        (FOLDER / name).unlink(missing_ok=True)
    for file, content in written().items():
        file.parent.mkdir(exist_ok=True, parents=True)
        file.write_text(content)
