"""Compile the core when bondem is installed, and put it into the wheel."""

import ctypes
import os
import sys
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface  # type: ignore


class CompiledCore(BuildHookInterface):
    """Build hook of hatch: libraries for all levels of instructions of the machine that BONDEM_TARGET names.

    An editable installation has those of this CPU alone; `bondem._core` compiles others where they are asked for.
    """

    PLUGIN_NAME = "custom"

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Compile the libraries of the target, of this machine unless the environment names another."""
        root = Path(self.root)
        spec = spec_from_file_location("bondem_core_build", root / "src/bondem/_core_build.py")
        assert spec is not None
        assert spec.loader is not None
        build = module_from_spec(spec)
        sys.modules[spec.name] = build  # dataclasses look their module up
        spec.loader.exec_module(build)
        foreign = os.environ.get("BONDEM_TARGET")
        target = build.Platform.named(foreign)
        levels = target.levels
        made = build.compile_core(target, [build.PROBE]) if len(levels) > 1 else []
        if version == "editable" and made and foreign is None:
            levels = target.offered(ctypes.CDLL(str(made[0])).bondem_level())[-1:]
        made += build.compile_core(target, levels)
        if version != "editable":
            build_data["force_include"] |= {str(path): f"bondem/core/{build.LIBRARIES}/{path.name}" for path in made}
        build_data["pure_python"] = False
        build_data["tag"] = target.tag
