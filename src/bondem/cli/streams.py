"""Output of commands on consoles whose encoding lacks some characters, on full disks and in pipes that close."""

import codecs
import io
import os
import sys
import unicodedata
from typing import TextIO

_ERRORS = "bondem-plain"
# Characters without a decomposition into plain ones.
_PLAIN = str.maketrans({
    "−": "-", "–": "-", "—": "-", "·": "*", "×": "x", "≤": "<=", "≥": ">=", "≈": "~", "→": "->", "±": "+-",
    "‘": "'", "’": "'", "“": "'", "”": "'", "°": "deg",
})  # fmt: skip


def in_ascii(text: str) -> str:
    """Spell a text in ASCII: Greek letters by name, others without accents, signs by similar ones, ? for the rest."""
    found = []
    for character in unicodedata.normalize("NFKD", text.translate(_PLAIN)):
        name = unicodedata.name(character, "")
        if character.isascii():
            found.append(character)
        elif name.startswith("GREEK") and " LETTER " in name:
            spelled = name.partition(" LETTER ")[2].split()[0]
            found.append(spelled.capitalize() if "CAPITAL" in name else spelled.lower())
        elif not unicodedata.combining(character):
            found.append("?")
    return "".join(found)


def accept_all_characters() -> None:
    """Set stdout and stderr to write characters that their encoding lacks by `in_ascii`, without an error."""
    codecs.register_error(_ERRORS, _spelled)
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors=_ERRORS)


def flush(stream: TextIO | None) -> None:
    """Write the buffered text of stdout or stderr now, so that a failure is raised before the process ends.

    Raises:
        OSError: The stream cannot be written to.
    """
    if stream is None:  # a process without a console
        return
    try:
        stream.flush()
    except OSError:
        # without this, the interpreter flushes again at its end, prints a traceback and sets its own exit status
        os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())
        raise


def _spelled(error: UnicodeError) -> tuple[str, int]:
    if not isinstance(error, UnicodeEncodeError):
        raise error
    return in_ascii(error.object[error.start : error.end]), error.end
