"""Reading of text files with the encodings and line ends of all systems."""

import codecs
from pathlib import Path

# Marks at the beginning of a file, and the encoding that each stands for.
_MARKS = {codecs.BOM_UTF8: "utf-8-sig", codecs.BOM_UTF16_LE: "utf-16", codecs.BOM_UTF16_BE: "utf-16"}


def encoding_of(path: Path) -> str:
    """Return the encoding of a text file: UTF-8 unless a byte-order mark states UTF-16.

    Raises:
        OSError: the file cannot be read.
    """
    with open(path, "rb") as file:
        start = file.read(4)
    return next((name for mark, name in _MARKS.items() if start.startswith(mark)), "utf-8")


def read_text(path: Path) -> str:
    """Read a text file, UTF-8 unless a byte-order mark states UTF-16, and convert line ends to those of Unix.

    Raises:
        OSError: the file cannot be read.
        UnicodeDecodeError: The file is in another encoding.
    """
    return path.read_bytes().decode(encoding_of(path)).replace("\r\n", "\n").replace("\r", "\n")
