"""Line numbers of keys in study files, for messages."""

import re

from bondem.errors import StudyError

_HEADER = re.compile(r"\s*(\[\[?)\s*([^\[\]]+?)\s*\]\]?\s*(#.*)?$")
_KEY = re.compile(r"""\s*["']?([\w.-]+)["']?\s*=""")
_NAMED = re.compile(r"'([A-Za-z_][\w.\[\]-]*)'|\[([A-Za-z_][\w.]*)\]")


def line_of(text: str, key: str) -> int | None:
    """Find the line of a dotted key such as "specimens[1].radius" in the text of a file, counted from 1.

    A missing key has the line of its table; the result is None if neither exists.
    """
    places = _places(text)
    while key:
        if key in places:
            return places[key]
        shorter = re.sub(r"\[\d+\]$", "", key)
        key = shorter if shorter != key else key.rpartition(".")[0]
    return None


def located(error: StudyError, text: str, file: str) -> StudyError:
    """Return a copy of an error whose message states the file and, if found, the line of a key that it names."""
    own, places = _specimen_of(str(error), text), _places(text)
    named = [found.group(1) or found.group(2) for found in _NAMED.finditer(str(error))]
    within = [
        re.sub(r"^specimen\b", own, key) if key.startswith("specimen") else f"{own}.{key}" for key in named if own
    ]
    exact = [places[key] for key in (*named, *within) if key in places]
    near = [line for key in (*named, *within) if (line := line_of(text, key)) is not None]
    for line in (*exact, *near):
        return StudyError(f"{file}, line {line}: {error}")
    return StudyError(f"{file}: {error}")


def _specimen_of(message: str, text: str) -> str:
    """Return the key "specimens[k]" of the specimen that an error of a test programme names; "" if none."""
    of = re.match(r"specimen '(.+?)': ", message)
    lines = text.splitlines()
    for place, number in _places(text).items():
        if of is not None and re.fullmatch(r"specimens\[\d+\]\.name", place) and of.group(1) in lines[number - 1]:
            return place.removesuffix(".name")
    return ""


def _places(text: str) -> dict[str, int]:
    places: dict[str, int] = {}
    table, lists = "", dict[str, int]()
    for number, line in enumerate(text.splitlines(), start=1):
        header = _HEADER.match(line)
        if header is not None:
            table = header.group(2).replace('"', "").replace(" ", "")
            if header.group(1) == "[[":
                lists[table] = lists.get(table, -1) + 1
                places.setdefault(table, number)
            for name, last in lists.items():
                if table == name or table.startswith(f"{name}."):
                    table = f"{name}[{last}]{table[len(name) :]}"
                    break
            places.setdefault(table, number)
            continue
        key = _KEY.match(line)
        if key is not None:
            places.setdefault(f"{table}.{key.group(1)}" if table else key.group(1), number)
    return places
