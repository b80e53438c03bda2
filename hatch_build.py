"""Compile the core when bondem is installed, and put it into the wheel.

As a script it compiles what an editable installation needs, which finds it then: `.ci/run` does so beside downloads.
"""

import ctypes
import os
import sys
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface  # type: ignore


def _builder(root: Path) -> Any:
    """The module that compiles, without the package around it, which needs NumPy."""
    spec = spec_from_file_location("bondem_core_build", root / "src/bondem/_core_build.py")
    assert spec is not None
    assert spec.loader is not None
    build = module_from_spec(spec)
    sys.modules[spec.name] = build  # dataclasses look their module up
    spec.loader.exec_module(build)
    return build


def _compiled(build: Any, target: Any, *, for_tree: bool) -> list[Path]:
    """Compile the libraries of a target.

    Those for the source tree itself are of this CPU alone, with what simulates a device in tests; `bondem._core`
    compiles others where they are asked for.
    """
    names = target.levels
    made = build.compile_core(target, [build.PROBE]) if len(names) > 1 else []
    if for_tree:
        if made:
            names = target.offered(ctypes.CDLL(str(made[0])).bondem_level())[-1:]
        names = tuple(name + build.LOOPS for name in names)
    return made + build.compile_core(target, names)


class CompiledCore(BuildHookInterface):
    """Build hook of hatch: the libraries of all levels of instructions of the machine that BONDEM_TARGET names."""

    PLUGIN_NAME = "custom"

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Compile the libraries, and put them into a wheel that is not editable."""
        build, foreign = _builder(Path(self.root)), os.environ.get("BONDEM_TARGET")
        target = build.Platform.named(foreign)
        made = _compiled(build, target, for_tree=version == "editable" and foreign is None)
        if version != "editable":
            build_data["force_include"] |= {str(path): f"bondem/core/{build.LIBRARIES}/{path.name}" for path in made}
        build_data["pure_python"] = False
        build_data["tag"] = target.tag


if __name__ == "__main__":
    _build = _builder(Path(__file__).parent)
    _compiled(_build, _build.Platform.named(None), for_tree=True)
