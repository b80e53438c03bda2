"""Language of all public text: no banned phrase, and first lines of docstrings that stand alone."""

import ast
import re
from collections.abc import Iterable, Iterator
from functools import cache
from pathlib import Path

import click
import pytest

import bondem.cli
from tests.architecture.sample import header_comments

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "src/bondem"

# Names under which tests record numbers; results of earlier measurements contain them.
RECORDED = {"energy that comes back, plane wave", "energy that comes back, thin bar"}

# Each pattern and the wording that replaces it. All letters are compared in lower case.
BANNED = {
    r"\b(?:tell|tells|told|telling)\b": "state, show, set, distinguish",
    r"\bwarn(?:ed|s)? of\b": "bondem warns when …",
    r"\b(?:wait|waits|waited)\b": "postpone",
    r"\b(?:hold|holds|held|holding) back\b": "postpone, prevent",
    r"\b(?:let|lets|letting) go\b": "release",
    r"\b(?:hand|hands|handed|handing) on\b": "pass, apply",
    r"\b(?:take|takes|took|taken|taking) up\b": "absorb, dissipate, initialise",
    r"\b(?:come|comes|came|coming) back\b": "return",
    r"\b(?:bear|bears|bore|borne|bearing)\b": "carry, transmit, support",
    r"\blook(?:s|ed)? (?:at|on)\b": "evaluate, check, observe",
    r"\bin print\b": "published",
    r"\bnothing is left\b": "name what is empty",
    r"\b(?:hang|hangs|hung) together\b": "are connected",
    r"\bthe same of\b": "repeat the noun",
    r"(?<!exactly )(?<!only )\bone an? (?:element|cell|bond|facet|step|packing|file|line|process|row)\b": "one per …",
    r"\bnow and then\b": "at intervals",
    r"\blittle by little\b": "gradually",
    r"\b(?:as|where|when) (?:it|they) (?:is|are) there\b": "state the condition",
    r"\bgives? way\b": "yield, deform",
    r"\bof what there is\b": "name the quantity",
    r"\bwhat (?:comes|goes) (?:in|out)\b": "input, output, result",
}  # fmt: skip

# Wordings that written pages avoid, and the term of the glossary or of the field.
COLLOQUIAL = {
    r"\b(?:go|goes|went|going) on\b": "continue",
    r"\bledger\b": "energy balance",
    r"\bread off\b": "evaluate",
    r"\bput in\b": "enter",
    r"\basked for\b": "require",
    r"\bwhat is left\b": "name the rest",
    r"\bjudged?\b": "evaluate, check",
    r"\b(?:is|are) refused\b": "raises an error",
    r"\bthe book\b": "the validation",
    r"\bnobody\b": "name the person or part",
}

# First words of a docstring that need the sentence before them, or that leave out its noun.
BARE = re.compile(
    r"(?:The same|The one|Of|What|Those|Whether|That|Where|How|Which|Who|Whose|When|While|If|There|It|Its|They|Their"
    r"|This|These|Them|In|On|At|By|From|To|With|Without|As|And|But|Or|So|Such|Like|Not|Nothing|Again|Here|Else|Let"
    r"|Make sure|Go on|Put|Tell|Told|Now|Also|Besides)\b"
)

# First words of the description of an argument that leave out its noun.
BARE_ENTRY = re.compile(
    r"(?:of|what|who|whose|where|how|which|when|the same|likewise|told|called|it|its|they|their|over|by|to|from|in|on"
    r"|at|that|those|as)\b"
)


def named(tree: ast.AST, prefix: str = "") -> Iterator[tuple[str, ast.AST]]:
    """Classes, functions and methods of a module, private ones included."""
    for node in ast.iter_child_nodes(tree):
        if isinstance(node, ast.FunctionDef | ast.ClassDef):
            yield prefix + node.name, node
            if isinstance(node, ast.ClassDef):
                yield from named(node, f"{prefix}{node.name}.")


def docstrings(tree: ast.Module) -> Iterator[tuple[str, str]]:
    for name, node in [("module", tree), *named(tree)]:
        text = ast.get_docstring(node)
        if text:
            yield name, text


def messages(tree: ast.Module) -> Iterator[tuple[str, str]]:
    """Strings of the code, without docstrings."""
    nodes = (node.body for node in ast.walk(tree) if isinstance(node, ast.Module | ast.FunctionDef | ast.ClassDef))
    said = {id(body[0].value) for body in nodes if body and isinstance(body[0], ast.Expr)}
    for node in ast.walk(tree):
        words = isinstance(node, ast.Constant) and isinstance(node.value, str) and " " in node.value
        if words and id(node) not in said:
            yield f"line {node.lineno}", node.value


def banned_in(text: str, patterns: Iterable[str] = tuple(BANNED)) -> list[str]:
    """Banned phrases of a text, names of arguments and code left out."""
    prose = re.sub(r"(?m)^    [*\w]+(?:, [*\w]+)*:", "", re.sub(r"`[^`\n]+`", "`", text))
    flat = re.sub(r"\s+", " ", prose).lower()
    if not any_of(tuple(patterns)).search(flat):
        return []
    return [found.group() for pattern in patterns for found in re.finditer(pattern, flat)]


@cache
def any_of(patterns: tuple[str, ...]) -> re.Pattern[str]:
    return re.compile("|".join(patterns))


@cache
def parsed(path: Path) -> ast.Module:
    return ast.parse(path.read_text(encoding="utf-8"))


def first_line_faults(text: str) -> list[str]:
    """Faults of the first paragraph of a docstring."""
    first = text.split("\n\n")[0].replace("\n", " ").strip()
    faults = []
    if BARE.match(first):
        faults.append("the first words need a noun or a verb")
    if not (first[0].isupper() or first[0] in "`\"{["):
        faults.append("the first letter is not a capital")
    if first[-1] not in ".:":
        faults.append("no period at the end")
    return [f"{fault}: {first[:60]}" for fault in faults]


def bare_entries(text: str) -> list[str]:
    """Arguments and attributes whose description lacks its noun."""
    found, section = [], ""
    for line in text.splitlines():
        if line and not line.startswith(" "):
            section = line.strip()
        entry = re.match(r"    [*\w]+(?:, [*\w]+)*: (.*)", line)
        if section in ("Args:", "Attributes:") and entry and BARE_ENTRY.match(entry[1]):
            found.append(line.strip())
    return found


def sources() -> list[Path]:
    return sorted(PACKAGE.rglob("*.py"))


def pages() -> list[Path]:
    names = ("README.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "SECURITY.md", "paper.md")
    found = [ROOT / name for name in names]
    return [*found, *sorted((ROOT / "docs").rglob("*.md"))]


def commands(command: click.Command, name: str = "bondem") -> Iterator[tuple[str, click.Command]]:
    yield name, command
    if isinstance(command, click.Group):
        context = click.Context(command)
        for inner in command.list_commands(context):
            found = command.get_command(context, inner)
            assert found is not None
            yield from commands(found, f"{name} {inner}")


def helps() -> Iterator[tuple[str, str]]:
    """Help texts of all commands and options."""
    for name, command in commands(bondem.cli.bondem):
        yield name, command.help or ""
        for parameter in command.params:
            text = getattr(parameter, "help", None)
            if text:
                yield f"{name} {parameter.name}", text


def test_pages_have_no_banned_phrase():
    found = [(path.name, phrase) for path in pages() for phrase in banned_in(path.read_text(encoding="utf-8"))]
    assert not found


def test_pages_are_not_colloquial():
    found = []
    for path in pages():
        prose = re.sub(r"(?ms)^```.*?^```$", "", path.read_text(encoding="utf-8"))
        found += [(path.name, phrase) for phrase in banned_in(prose, COLLOQUIAL)]
    assert not found


def test_texts_of_the_validation_and_examples_have_no_banned_phrase():
    faults = []
    for path in [*sorted((ROOT / "book").rglob("*.py")), *sorted((ROOT / "examples").rglob("*.py"))]:
        tree = parsed(path)
        for where, text in [*docstrings(tree), *messages(tree)]:
            if text not in RECORDED:
                faults += [f"{path.relative_to(ROOT)} {where}: {phrase}" for phrase in banned_in(text)]
    assert not faults, "\n".join(faults)


def test_docstrings_are_not_colloquial():
    faults = []
    for path in sources():
        for where, text in docstrings(parsed(path)):
            faults += [f"{path.relative_to(PACKAGE)} {where}: {phrase}" for phrase in banned_in(text, COLLOQUIAL)]
    assert not faults, "\n".join(faults)


def test_docstrings_and_messages_have_no_banned_phrase():
    faults = []
    for path in sources():
        tree = parsed(path)
        for where, text in [*docstrings(tree), *messages(tree)]:
            faults += [f"{path.relative_to(PACKAGE)} {where}: {phrase}" for phrase in banned_in(text)]
    assert not faults, "\n".join(faults)


def test_first_lines_of_docstrings_stand_alone():
    faults = []
    for path in sources():
        for where, text in docstrings(parsed(path)):
            faults += [f"{path.relative_to(PACKAGE)} {where}: {fault}" for fault in first_line_faults(text)]
    assert not faults, "\n".join(faults)


def test_arguments_and_attributes_are_noun_phrases():
    faults = []
    for path in sources():
        for where, text in docstrings(parsed(path)):
            faults += [f"{path.relative_to(PACKAGE)} {where}: {entry}" for entry in bare_entries(text)]
    assert not faults, "\n".join(faults)


def header_faults(text: str) -> list[str]:
    """Faults of a comment of the core, whose headings and reasons within a function are no sentences."""
    faults = [f"banned: {phrase}" for phrase in banned_in(text)]
    if text[0].isupper() and BARE.match(text):
        faults.append("the first words need a noun or a verb")
    return faults


def test_comments_of_the_core_stand_alone():
    found = [f"{where}: {fault}: {text[:60]}" for where, text in header_comments() for fault in header_faults(text)]
    assert not found, "\n".join(found)


def test_help_texts_are_sentences():
    texts = [(name, re.sub(r"\s+\[[^]]*\]$", "", text)) for name, text in helps()]  # without a default
    faults = [f"{name}: {text}" for name, text in texts if banned_in(text) or first_line_faults(text)]
    assert not faults, "\n".join(faults)


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("Bonds that bear load.", 1), ("Steps until the wall comes back, as told.", 2), ("One a\ncell.", 1),
        ("Bonds that carry load, one per cell.", 0), ("Awaiting a bearable backlog.", 0),
    ],
)  # fmt: skip
def test_banned_phrases_are_found(text: str, found: int):
    assert len(banned_in(text)) == found


@pytest.mark.parametrize(
    ("text", "faults"),
    [
        ("The same, in the user's order.", 1), ("what breaks.", 1), ("Of a file", 2), ("Open the snapshots.", 0),
        ("Themes of a page.", 0), ("Ionic strength [mol/m³].", 0),
    ],
)  # fmt: skip
def test_bare_first_lines_are_found(text: str, faults: int):
    assert len(first_line_faults(text)) == faults


@pytest.mark.parametrize(
    ("text", "faults"),
    [
        ("Whether a face touches.", 1), ("What a facet does to its cells.", 1), ("Cells that bear load.", 1),
        ("Loads of a facet on its cells.", 0), ("---- forces", 0), ("of both, because the sum is exact", 0),
    ],
)  # fmt: skip
def test_faults_of_comments_of_the_core_are_found(text: str, faults: int):
    assert len(header_faults(text)) == faults


def test_bare_entries_are_found():
    text = "Sum.\n\nArgs:\n    a: of the ball.\n    b, c: mass [kg].\n\nReturns:\n    d: of it."
    assert bare_entries(text) == ["a: of the ball."]
