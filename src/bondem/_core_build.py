"""Compilation of the core to one library per level of instructions, by the compiler in the package `ziglang`.

`BONDEM_CXX` names another clang++, as required by distributions with their own compiler.

The build hook (`hatch_build.py`) loads this file by its path, before bondem is installed. `_core.py` imports it to
compile changed sources. This file imports the standard library only.
"""

import hashlib
import importlib.util
import os
import platform
import shlex
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterable, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

#: Sources of the core, and the folder of its libraries among them.
SOURCES = Path(__file__).parent / "core"
LIBRARIES = "libraries"
#: Small library that returns the level of instructions of a CPU; it is compiled for the lowest level.
PROBE = "level"
#: Suffix of a level, for its library with loops over indices, by which tests simulate a device. Wheels do not contain
#: it, as these loops take a third of the compilation.
LOOPS = "_with_loops"

_OTHER = "BONDEM_CXX"
# Contraction within expressions only: the same bits on every level that has fused multiply-add. The SLP vectoriser
# makes the passes over lanes slower.
_FLAGS = [
    "-x", "c++", "-std=c++17", "-O3", "-fno-math-errno", "-ffp-contract=on", "-fno-exceptions", "-fno-rtti",
    "-fno-slp-vectorize", "-fno-sanitize=undefined", "-fvisibility=hidden", "-fPIC",
]  # fmt: skip
_LINKED = ["-shared", "-s"]
_LEVELS = {
    "x86_64": {
        "x86_64_v2": ["-mcpu=x86_64_v2"],
        "x86_64_v3": ["-mcpu=x86_64_v3"],
        "x86_64_v4": ["-mcpu=x86_64_v4", "-mprefer-vector-width=512"],
    },
    "aarch64": {"aarch64": ["-mcpu=generic"]},
}
# Instructions of a level beyond the lowest one. Zig compiles the C library of MinGW again for each `-mcpu` or
# `-mavx`, which takes minutes. For Windows all levels therefore have the lowest `-mcpu`, and
# `-Xclang -target-feature` adds the further instructions for the sources of the core only.
_V3 = ("avx", "avx2", "bmi", "bmi2", "f16c", "fma", "lzcnt", "movbe")
_V4 = (*_V3, "avx512f", "avx512bw", "avx512cd", "avx512dq", "avx512vl")


def _beyond(features: tuple[str, ...]) -> list[str]:
    return [part for one in features for part in ("-Xclang", "-target-feature", "-Xclang", f"+{one}")]


_ON_WINDOWS = {
    "x86_64_v2": ["-mcpu=x86_64_v2"],
    "x86_64_v3": ["-mcpu=x86_64_v2", *_beyond(_V3)],
    "x86_64_v4": ["-mcpu=x86_64_v2", *_beyond(_V4), "-mprefer-vector-width=512"],
}
# Names of machines and systems in `platform`, and here.
_MACHINES = {"amd64": "x86_64", "x86_64": "x86_64", "arm64": "aarch64", "aarch64": "aarch64"}
_SYSTEMS = {"Linux": "linux", "Darwin": "macos", "Windows": "windows"}


@dataclass(frozen=True)
class Platform:
    """Machine and system for which libraries are compiled.

    Attributes:
        machine: "x86_64" or "aarch64".
        system: "linux", "macos" or "windows".
    """

    machine: str
    system: str

    @classmethod
    def named(cls, name: str | None) -> "Platform":
        """Return the platform of a name such as "aarch64-linux"; None is this machine.

        Raises:
            ValueError: a machine or system for which the core is not compiled.
        """
        here = f"{platform.machine().lower()}-{_SYSTEMS.get(platform.system(), platform.system())}"
        machine, _, system = (name or here).partition("-")
        machine = _MACHINES.get(machine, machine)
        if machine not in _LEVELS or system not in _SYSTEMS.values():
            known = ", ".join(f"{m}-{s}" for m in _LEVELS for s in _SYSTEMS.values())
            raise ValueError(f"target = {machine}-{system}: the core is not compiled for it; choose one of {known}")
        return cls(machine, system)

    @property
    def triple(self) -> str:
        """Name of the platform for the compiler."""
        return {
            "linux": f"{self.machine}-linux-gnu.2.17",
            "macos": f"{self.machine}-macos.11.0",
            "windows": f"{self.machine}-windows-gnu",
        }[self.system]

    @property
    def tag(self) -> str:
        """Tag of the wheels of the platform: any Python, because the libraries do not depend on it."""
        machine = {"macos": {"aarch64": "arm64"}, "windows": {"x86_64": "amd64", "aarch64": "arm64"}}.get(
            self.system, {}
        ).get(self.machine, self.machine)
        system = {"linux": "manylinux_2_17", "macos": "macosx_11_0", "windows": "win"}[self.system]
        return f"py3-none-{system}_{machine}"

    @property
    def suffix(self) -> str:
        """Suffix of the libraries of the platform."""
        return {"linux": ".so", "macos": ".dylib", "windows": ".dll"}[self.system]

    @property
    def levels(self) -> tuple[str, ...]:
        """Names of the levels of instructions of the platform, the lowest first."""
        return tuple(_LEVELS[self.machine])

    def offered(self, level: int) -> tuple[str, ...]:
        """Return the levels up to the one that `bondem_level` of a CPU returns (2, 3 or 4), the lowest first."""
        return self.levels[: level - 1]

    def flags(self, level: str) -> list[str]:
        """Return the flags of the compiler for a level.

        The compiler of `BONDEM_CXX` compiles for its own machine unless that variable states a target. That compiler
        expects hyphens in the names of levels.
        """
        if os.environ.get(_OTHER):
            named = level.replace("_", "-")
            return [f"-march={named}", *_LEVELS["x86_64"][level][1:]] if named != "aarch64" else []
        levels = _ON_WINDOWS | _LEVELS["aarch64"] if self.system == "windows" else _LEVELS[self.machine]
        return ["-target", self.triple, *levels[level]]

    def made_of(self, library: str, folder: Path) -> tuple[str, list[Path]]:
        """Return the level for which a library is compiled, and its sources."""
        if library == PROBE:
            return self.levels[0], [folder / f"{PROBE}.cpp"]
        sources = core_sources("*.cpp", folder=folder)
        if library.endswith(LOOPS):
            return library.removesuffix(LOOPS), sources
        return library, [source for source in sources if source != folder / "loops.cpp"]

    @property
    def linked(self) -> list[str]:
        """Flags of the linker, for all levels."""
        if self.system == "windows":
            needed = []
        elif (self.machine, self.system) == ("x86_64", "linux"):
            # Otherwise the compiler first builds its runtime library, which the core does not need (ten seconds).
            needed = ["-nostdlib", "-lc", "-lm", "-lpthread", "-Wl,-z,defs"]
        else:
            needed = ["-lpthread", "-lm"]
        return [*self.flags(self.levels[0]), *_LINKED, *needed]


def source_digest(folder: Path = SOURCES) -> str:
    """Hash of all sources and of the flags, 12 hexadecimal digits: part of the name of each library."""
    digest = hashlib.sha256(" ".join([*_FLAGS, *_LINKED, str(_LEVELS), str(_ON_WINDOWS)]).encode())
    for path in core_sources("*.cpp", "*.hpp", folder=folder):
        digest.update(f"{path.relative_to(folder)}\n".encode() + path.read_bytes())
    return digest.hexdigest()[:12]


def compiler() -> list[str] | None:
    """Return the command of the compiler: BONDEM_CXX, else that of `ziglang`; None if neither exists."""
    if other := os.environ.get(_OTHER):
        return shlex.split(other)
    return [sys.executable, "-m", "ziglang", "cc"] if importlib.util.find_spec("ziglang") else None


def compile_core(target: Platform, names: Iterable[str], *, folder: Path = SOURCES) -> list[Path]:
    """Compile libraries that do not exist yet, and remove older ones of the same names.

    Sources are compiled in parallel on all cores. The compiler stores their objects in the folder `build`, and
    recompiles changed sources only.

    Args:
        target: the machine to compile for.
        names: some of its levels, a level followed by `LOOPS`, or `PROBE`.
        folder: folder of the sources.

    Returns:
        The libraries.

    Raises:
        RuntimeError: no compiler, or a source with errors; the text has the messages of the compiler.
    """
    command = compiler()
    if command is None:
        raise RuntimeError(
            "bondem's core is to be compiled, and there is no compiler; pip install ziglang, or name a clang++ by"
            f" {_OTHER}"
        )
    cache = folder / "build"
    environment = {"ZIG_GLOBAL_CACHE_DIR": str(cache), "ZIG_LOCAL_CACHE_DIR": str(cache), **os.environ}
    out = folder / LIBRARIES
    out.mkdir(exist_ok=True)
    digest = source_digest(folder)
    libraries = {name: out / f"{name}.{digest}{target.suffix}" for name in names}

    with tempfile.TemporaryDirectory(dir=out) as aside, ThreadPoolExecutor(os.cpu_count()) as pool:

        def compiled(name: str, level: str, source: Path) -> str:
            made = Path(aside) / name / source.relative_to(folder).with_suffix(".o")
            made.parent.mkdir(parents=True, exist_ok=True)
            _run([*command, *_FLAGS, *target.flags(level), "-c", str(source), "-o", str(made)], environment)
            return str(made)

        def linked(name: str, objects: list[str]) -> None:
            made = Path(aside) / libraries[name].name
            _run([*command, *target.linked, *objects, "-o", str(made)], environment)
            for old in out.glob(f"{name}.*{target.suffix}"):
                old.unlink(missing_ok=True)
            shutil.move(made, libraries[name])

        # pip runs a build twice
        lacking = [name for name, library in libraries.items() if not library.is_file()]
        made_of = {name: target.made_of(name, folder) for name in lacking}
        objects = {
            name: [pool.submit(compiled, name, level, one) for one in sources]
            for name, (level, sources) in made_of.items()
        }
        for name, made in objects.items():
            linked(name, [one.result() for one in made])
    return list(libraries.values())


def _run(command: list[str], environment: Mapping[str, str]) -> None:
    done = subprocess.run(command, env=dict(environment), capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise RuntimeError(f"bondem's core does not compile:\n{done.stderr or done.stdout}")


def core_sources(*patterns: str, folder: Path = SOURCES) -> list[Path]:
    """List the sources of the core that match patterns, without compiled files."""
    inner = {folder / "build", folder / LIBRARIES}
    return sorted(path for pattern in patterns for path in folder.rglob(pattern) if not inner & set(path.parents))
