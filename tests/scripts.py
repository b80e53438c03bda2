"""Modules beside the scripts of benchmarks, and commands in processes of their own."""

import importlib
import io
import os
import subprocess
import sys
import warnings
from contextlib import chdir, redirect_stderr, redirect_stdout
from pathlib import Path
from types import ModuleType

from bondem import cli
from validation import __main__ as studies

ROOT = Path(__file__).parents[1]
# Modules whose `main` reads the command line, by package.
COMMANDS = {"bondem": cli, "validation": studies}


def scripts(folder: str, **modules: str) -> dict[str, ModuleType]:
    """Modules of a folder of the repository by the names given, which import their neighbours as its scripts do."""
    path = str(ROOT / folder)
    sys.path.insert(0, path)
    try:
        return {name: importlib.import_module(module) for name, module in modules.items()}
    finally:
        sys.path.remove(path)


def command(
    *arguments: object, cwd: Path, package: str = "bondem", process: bool = False, **options
) -> subprocess.CompletedProcess[str]:
    """Call the command `bondem`, or that of another package, in a folder; with `process` as `python -m bondem`."""
    words = [sys.executable, "-m", package, *map(str, arguments)]
    if process or options:
        return subprocess.run(words, cwd=cwd, capture_output=True, text=True, timeout=300, **options)
    out, err, former = io.StringIO(), io.StringIO(), sys.argv
    sys.argv, code = [package, *words[3:]], 0
    try:
        with chdir(cwd), redirect_stdout(out), redirect_stderr(err), warnings.catch_warnings():
            warnings.resetwarnings()
            COMMANDS[package].main()
    except SystemExit as ended:
        code = ended.code
    finally:
        sys.argv = former
    return subprocess.CompletedProcess(words, code, out.getvalue(), err.getvalue())


def python(code: str, *arguments: object, threads: int = 4) -> list[str]:
    """Run code in a process of its own, which may use a number of threads; return the lines that it prints."""
    environment = os.environ | {"BONDEM_NUM_THREADS": str(threads)}
    words = [sys.executable, "-c", code, *map(str, arguments)]
    done = subprocess.run(words, cwd=ROOT, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()


def files(folder: Path) -> dict[Path, int]:
    """Files below a folder, and when each was written [ns]."""
    return {path.relative_to(folder): path.stat().st_mtime_ns for path in folder.rglob("*") if path.is_file()}
