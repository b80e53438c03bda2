"""Sphinx extension: examples and readable types on the pages of the reference.

An example of a name is the shortest statement that uses it in the code of the guides, which the tests run as printed,
or else in `examples/`, which the tests run too. Types in signatures are those of the annotations, with arrays written
as "array", public unions by their names, and classes without their modules. Members that `dir` omits are omitted.
"""

import ast
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any, get_args

DOCS = Path(__file__).parent
_FENCE = re.compile(r"^```python\n(.*?)^```$", re.MULTILINE | re.DOTALL)
_LONGEST = 6  # lines of an example
# What annotations of arrays look like once they are resolved, innermost brackets first.
_WITHIN = r"(?:\[(?:[^\[\]]|\[(?:[^\[\]]|\[[^\[\]]*\])*\])*\])?"
_ARRAY = re.compile(rf"~?(?:numpy\.)?(?:typing\.)?(?:nd|ND)[aA]rray{_WITHIN}")
# Two stars, but not those of a name in bold, "**StepWarning** -- text", as napoleon writes the section Warns.
_STARS = re.compile(r"(?<!\w)\*\*(?!\w+\*\* --)|(?<=\w)\*\*(?! --)")
# Of arrays with a shape, `Annotated[array, "(n,)"]`.
_SHAPE = re.compile(r"Annotated\[(array), '[^']*'\]")
_MODULES = re.compile(r"~?\b(?:bondem|collections|typing|pathlib|numpy)(?:\.\w+)*\.(?=[A-Z])")


def pages() -> Iterator[str]:
    """Code that the tests run, the guides before the examples."""
    for folder in ("start", "guides", ".", "reference"):
        for page in sorted((DOCS / folder).glob("*.md")):
            yield from _FENCE.findall(page.read_text(encoding="utf-8"))
    for script in sorted((DOCS.parent / "examples").rglob("*.py")):
        yield script.read_text(encoding="utf-8")


def _used(node: ast.AST) -> Iterator[str]:
    """Names of bondem that a statement uses."""
    for one in ast.walk(node):
        if isinstance(one, ast.Attribute):
            found = ast.unparse(one)
            if found.startswith("bd."):
                yield found.removeprefix("bd.")


@cache
def examples() -> dict[str, str]:
    """The shortest statement that uses each name."""
    found: dict[str, str] = {}
    for code in pages():
        lines, first = code.splitlines(), {}
        for node in ast.walk(ast.parse(code)):
            simple = isinstance(node, ast.Assign | ast.Expr | ast.AnnAssign)
            if not simple or (node.end_lineno or node.lineno) - node.lineno >= _LONGEST:
                continue
            text = "\n".join(lines[node.lineno - 1 : node.end_lineno])
            text = "\n".join(one[node.col_offset :] if one[: node.col_offset].isspace() else one.strip()
                             for one in text.splitlines()) if node.col_offset else text  # fmt: skip
            for name in _used(node):
                if name not in first or len(text) < len(first[name]):
                    first[name] = text
        for name, text in first.items():
            found.setdefault(name, text)
    return found


@cache
def makers() -> dict[str, str]:
    """The public function that returns each class, by the name of the class."""
    import bondem

    found: dict[str, str] = {}
    for owner, prefix in ((bondem, ""), (bondem.labtests, "labtests.")):
        for name in owner.__all__:
            made = getattr(getattr(owner, name), "__annotations__", {}).get("return")
            if isinstance(made, type):
                found.setdefault(made.__name__, prefix + name)
    return found


def add_example(app: object, what: str, name: str, thing: object, options: object, lines: list[str]) -> None:
    """Put an example of a public name at the end of its docstring."""
    if what not in ("class", "function", "data"):
        return
    short = name.removeprefix("bondem.")
    text = examples().get(short) or examples().get(makers().get(short.split(".")[-1], ""))
    if text is not None:
        code = [f"   {one}" for one in text.splitlines()]
        lines += ["", ".. rubric:: Example", "", ".. code-block:: python", "", *code, ""]


@cache
def unions() -> dict[str, str]:
    """The name of each union, by what Sphinx writes for it, the longest first."""
    from sphinx.util.typing import stringify_annotation

    import bondem
    from bondem import _types

    named = [(name, getattr(bondem, name)) for name in bondem.__all__] + [("array", _types.ArrayLike)]
    found = {
        _shortened(stringify_annotation(one, mode)): name
        for name, one in named if get_args(one) and not isinstance(one, type) for mode in ("smart", "fully-qualified")
    }  # fmt: skip
    return dict(sorted(found.items(), key=lambda item: -len(item[0])))


def _shortened(text: str) -> str:
    text = _MODULES.sub("", _ARRAY.sub("array", text))
    return _SHAPE.sub(r"\1", text)


def readable(text: str | None) -> str | None:
    """A signature with short names of types."""
    if text is None:
        return None
    text = _shortened(text)
    for written, name in unions().items():
        text = text.replace(written, name)
    return text.replace("ArrayLike", "array")


def shorten(app: object, what: str, name: str, thing: object, options: object, signature: str | None,
            returned: str | None) -> tuple[str | None, str | None]:  # fmt: skip
    """Make the types of a signature readable."""
    return readable(signature), readable(returned)


def shorten_properties(app: object, document: Any) -> None:
    """Make the types of properties readable, which Sphinx writes without asking."""
    from docutils import nodes
    from sphinx import addnodes

    for note in document.findall(addnodes.desc_annotation):
        for both in list(note.findall(addnodes.pending_xref_condition)):
            if both["condition"] == "resolved":  # the short name, beside the whole one
                both.parent.remove(both)
        text = note.astext()
        if "array" in text.lower():
            note.children = [nodes.Text(readable(text) or "")]


def internal() -> dict[str, str]:
    """Members of public classes that `dir` of their objects leaves out, by the name of the class."""
    import bondem

    found = {}
    for name in bondem.__all__:
        one = getattr(bondem, name)
        if isinstance(one, type) and "__dir__" in vars(one):
            found[f"bondem.{name}"] = ", ".join(sorted({*dir(one)} - {*one.__dir__(object.__new__(one))}))
    return found


def escape_bars(app: object, what: str, name: str, thing: object, options: object, lines: list[str]) -> None:
    """Keep |M| and x**2 as they are: to docutils they would be a substitution and bold, as names of warnings are."""
    lines[:] = [_STARS.sub(r"\\*\\*", line.replace("|", "\\|")) for line in lines]


def setup(app: Any) -> dict[str, bool]:
    """Connect to Sphinx."""
    app.connect("autodoc-process-docstring", escape_bars)
    app.connect("autodoc-process-docstring", add_example, priority=900)
    app.connect("autodoc-process-signature", shorten)
    app.connect("doctree-read", shorten_properties)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
