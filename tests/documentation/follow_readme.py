"""Follow README to the letter, as on a machine that has never seen bondem: each block in order, in one shell.

    python tests/documentation/follow_readme.py [--tests] [--folder DIR]

The clone, the environment, the home folder and all caches are new and empty. REPOSITORY stands for this repository,
of which the last commit is cloned. What a block of Python prints must be the text below it. The script stops at the
first line that fails, with status 1; it leaves out the line that runs the tests unless --tests is given.
"""

import argparse
import os
import re
import shlex
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
_BLOCK = re.compile(r"^```(sh|python|text)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
# Carries out a line in this shell, so that activation and folder hold for the lines below, and tells its time.
_STEP = """step() {
    printf '\\n$ %s\\n' "$1"
    SECONDS=0
    eval "$1" || { status=$?; printf '\\nfailed with status %s: %s\\n' "$status" "$1"; exit 1; }
    printf '(%s s)\\n' "$SECONDS"
}
"""


def steps(text: str, folder: Path, *, tests: bool = False) -> Iterator[str]:
    """The lines of a page that a reader types; code and what it prints are written to files in a folder."""
    printed = folder / "printed.txt"
    for k, block in enumerate(_BLOCK.finditer(text)):
        kind, body = block.groups()
        if kind == "sh":
            for line in body.splitlines():
                if tests or "pytest -n" not in line:
                    yield line.replace("REPOSITORY", shlex.quote(str(ROOT)))
        elif kind == "python":
            code = folder / f"block_{k}.py"
            code.write_text(body, encoding="utf-8")
            yield f"python {code} | tee {printed}"
        else:
            expected = folder / f"expected_{k}.txt"
            expected.write_text(body, encoding="utf-8")
            yield f"diff {expected} {printed}"


def follow(text: str, folder: Path, *, tests: bool = False) -> int:
    """Carry out the lines of a page in an empty folder; 0 if all of them work."""
    for name in ("home", "files", "work"):
        (folder / name).mkdir(parents=True)
    lines = [f"step {shlex.quote(line)}" for line in steps(text, folder / "files", tests=tests)]
    script = folder / "files" / "readme.sh"
    text = "\n".join(["set -o pipefail", _STEP, *lines, "echo; echo 'every line works'"])
    script.write_text(text, encoding="utf-8")
    own = {"VIRTUAL_ENV", "VIRTUAL_ENV_PROMPT", "PYTHONHOME", "PYTHONPATH", "OPENBLAS_CORETYPE"}
    kept = {name: value for name, value in os.environ.items() if name not in own and not name.startswith("BONDEM_")}
    folders = [one for one in kept["PATH"].split(os.pathsep) if Path(one) != Path(sys.executable).parent]
    home = folder / "home"
    new = {"HOME": str(home), "XDG_CACHE_HOME": str(home / ".cache"), "PATH": os.pathsep.join(folders)}
    return subprocess.run(["bash", str(script)], cwd=folder / "work", env=kept | new, check=False).returncode


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tests", action="store_true", help="run the tests too")
    parser.add_argument("--folder", type=Path, help="keep everything in this new folder")
    given = parser.parse_args()
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    if given.folder is not None:
        return follow(text, given.folder.resolve(), tests=given.tests)
    with tempfile.TemporaryDirectory() as folder:
        return follow(text, Path(folder), tests=given.tests)


if __name__ == "__main__":
    sys.exit(main())
