"""Modules beside the scripts of benchmarks, and commands in processes of their own."""

import importlib
import subprocess
import sys
from pathlib import Path
from types import ModuleType

ROOT = Path(__file__).parents[1]


def scripts(folder: str, **modules: str) -> dict[str, ModuleType]:
    """Modules of a folder of the repository by the names given, which import their neighbours as its scripts do."""
    path = str(ROOT / folder)
    sys.path.insert(0, path)
    try:
        return {name: importlib.import_module(module) for name, module in modules.items()}
    finally:
        sys.path.remove(path)


def command(*arguments: object, cwd: Path, package: str = "bondem", **options) -> subprocess.CompletedProcess[str]:
    """Run `python -m bondem` with arguments in a folder."""
    words = [sys.executable, "-m", package, *map(str, arguments)]
    return subprocess.run(words, cwd=cwd, capture_output=True, text=True, timeout=300, **options)
