"""The machine that measures: its processor, and how busy it is."""

import os
import platform
import re
from importlib.metadata import version
from pathlib import Path
from typing import Any


def machine() -> dict[str, Any]:
    """CPU, its vector extension, cores, the compiler, and the load."""
    return {
        "processor": processor(),
        "vector": "+".join(vector_extensions()) or "none known",
        "cores": os.cpu_count(),
        "system": f"{platform.system()} {platform.machine()}",
        "python": platform.python_version(),
        "ziglang": version("ziglang"),
        "load at the start": round(os.getloadavg()[0], 2),
    }


def processor() -> str:
    """Name of the CPU, where the system states it."""
    return _of_cpu("model name") or platform.processor()


def vector_extensions() -> list[str]:
    """Vector extensions of the CPU, where the system states them."""
    features = set((_of_cpu("flags") or _of_cpu("Features")).split())
    return [name for name in ("avx2", "avx512f", "asimd", "sve") if name in features]


def _of_cpu(name: str) -> str:
    """An entry of the first CPU in /proc/cpuinfo, or nothing."""
    info = Path("/proc/cpuinfo")
    found = re.search(rf"^{name}\s*:(.*)$", info.read_text(), re.MULTILINE) if info.exists() else None
    return found[1].strip() if found else ""
