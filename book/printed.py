"""What the code of the pages prints: run, kept as a record, and written below the code.

    python -m book.printed [PAGE ...]      run the code of these pages, or of all, and keep what it prints

A block of Python that a block of text follows at once prints that text. The record names a block by its code and that
of all blocks before it on its page, so that a block which has changed keeps its text until its code is run again.
"""

import datetime
import hashlib
import io
import json
import os
import re
import shutil
import sys
import tempfile
from collections.abc import Iterator
from contextlib import chdir, redirect_stdout
from pathlib import Path

from book.errors import BookError
from book.results import RESULTS, ROOT, Measurement
from validation.frame.sources import commit

PRINTED = Measurement("printed", "python -m book.printed", "3 min")
_CODE = re.compile(r"^```python\n(.*?)^```$", re.MULTILINE | re.DOTALL)
_FIGURE = re.compile(r"figures/(\w+\.png)\)")
_OUTPUT = re.compile(r"\n\n```text\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def pages() -> list[Path]:
    """README and the pages of the documentation that are not written from results."""
    found = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]
    return [page for page in found if "validation" not in page.parts]


def blocks(text: str) -> Iterator[tuple[str, re.Match[str], re.Match[str] | None]]:
    """The key, the code and, where there is one, the printed text of each block of Python of a page."""
    so_far = hashlib.sha256()
    for code in _CODE.finditer(text):
        so_far.update(code[1].encode())
        yield so_far.hexdigest()[:16], code, _OUTPUT.match(text, code.end())


def run(page: Path, text: str) -> Iterator[tuple[str, str, str | None]]:
    """Run the code of a page in the present folder: key, what a block printed, and what the page says of it."""
    names: dict[str, object] = {}
    for key, code, output in blocks(text):
        line = text[: code.start(1)].count("\n")
        printed = io.StringIO()
        with redirect_stdout(printed):  # line numbers of the page in a traceback
            exec(compile("\n" * line + code[1], str(page), "exec"), names)
        yield key, printed.getvalue(), output[1] if output else None


def with_output(text: str) -> str:
    """A page with what its code printed.

    Raises:
        BookError: a block of text is empty, and the record has nothing for it.
    """
    known = PRINTED.at("printed")
    for key, code, output in reversed(list(blocks(text))):
        if output and key in known:
            text = text[: output.start(1)] + known[key] + text[output.end(1) :]
        elif output and not output[1]:
            line = text[: code.start()].count("\n") + 1
            raise BookError(f"the code of line {line} was not run; run python -m book --measure printed")
    return text


def main(names: list[str]) -> None:
    """Run the code of pages, and keep what it prints."""
    known = PRINTED.at("printed") if PRINTED.path.exists() else {}
    chosen = [ROOT / name for name in names] or pages()
    for page in chosen:
        text = page.read_text(encoding="utf-8")
        if not any(output for *_, output in blocks(text)):
            continue
        print(page.relative_to(ROOT), flush=True)
        with tempfile.TemporaryDirectory() as folder, chdir(folder):
            Path("examples").symlink_to(ROOT / "examples")
            known |= {key: printed for key, printed, output in run(page, text) if output is not None}
            for figure in _FIGURE.findall(text):  # those that the code of the page has drawn
                if Path(figure).exists():
                    shutil.copyfile(figure, ROOT / "docs/figures" / figure)
    present = {key for page in pages() for key, _, output in blocks(page.read_text(encoding="utf-8")) if output}
    kept = {
        "command": PRINTED.command,
        "started": datetime.datetime.now(datetime.UTC).isoformat(timespec="seconds"),
        "commit": commit(),
        "printed": {key: known[key] for key in sorted(present & set(known))},
    }
    path = RESULTS / "printed.json"
    path.write_text(json.dumps(kept, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")


if __name__ == "__main__":
    os.environ.setdefault("MPLBACKEND", "agg")
    main(sys.argv[1:])
