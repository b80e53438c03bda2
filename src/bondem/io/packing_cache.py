"""Cache of packings on disk: identical requests reuse a stored packing.

The files are in the folder `packings` of bondem's cache: `$BONDEM_CACHE_DIR/bondem`, or the folder that the system
provides for caches, such as `~/.cache/bondem`. Each file is named after its request. The folder may be deleted at any
time. `BONDEM_PACKING_CACHE=off` in the environment disables the cache, so that every packing is computed.
"""

import hashlib
import json
import os
from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import fields, is_dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import scipy

import bondem
from bondem._cache_folder import cache_folder
from bondem._core import compiled_level
from bondem._core_build import source_digest
from bondem.errors import RunFileError
from bondem.io.particles_file import load_particles, save_particles
from bondem.specimen.particles import Particles, filled

_MOST_BYTES = 2 << 30
# Packages whose code determines the bits of a packing. They are read as text, as some may not be imported here.
_ROOMS = (
    "geometry", "specimen", "boundary", "interactions", "damage", "model", "observables", "dynamics", "packing",
)  # fmt: skip
# Least number of spheres of a cached packing: smaller ones are computed about as fast as a file is read.
_WORTH_KEEPING = 1000


def wanted(count: int) -> bool:
    """Return True if packings of `count` spheres are cached: if this saves time, and the environment allows it."""
    return count >= _WORTH_KEEPING and os.environ.get("BONDEM_PACKING_CACHE", "on").lower() != "off"


def key(request: Mapping[str, Any]) -> str:
    """Return the key of a request for a packing: a hash of all inputs that determine its bits.

    Args:
        request: all arguments by name, with defaults: JSON values, arrays, and shapes, size laws and targets of
            bondem. A surface is represented by its mesh.

    Returns:
        40 hexadecimal digits, independent of the order of the arguments. They differ for another version of NumPy or
        SciPy, and after any change of the core or of the Python packages whose code determines a packing.

    Raises:
        RunFileError: an argument that cannot be serialised, such as a user-defined shape, whose code may change.
    """
    text = json.dumps(written(request), sort_keys=True)
    return hashlib.sha256(f"{_program()}\n{text}".encode()).hexdigest()[:40]


def written(value: Any, *, packages: tuple[str, ...] = ("bondem",)) -> Any:
    """Serialise the inputs that determine the bits of a value, for JSON.

    Args:
        value: plain values, arrays, sequences and mappings of them, and dataclasses.
        packages: packages whose dataclasses are allowed.

    Raises:
        RunFileError: another type, such as a user-defined shape, whose code may change.
    """
    match value:
        case None | bool() | int() | float() | str():
            return value
        case np.generic():
            return value.item()
        case np.ndarray():
            return [value.dtype.str, list(value.shape), hashlib.sha256(value.tobytes()).hexdigest()]
        case list() | tuple():
            return [written(item, packages=packages) for item in value]
        case Mapping():
            return {str(name): written(item, packages=packages) for name, item in value.items()}
    kind = type(value)
    if not (is_dataclass(kind) and kind.__module__.partition(".")[0] in packages):
        raise RunFileError(f"a request with an object of type {kind.__name__} cannot be stored; use types of bondem")
    return {"type": f"{kind.__module__}.{kind.__qualname__}"} | {
        item.name: written(getattr(value, item.name), packages=packages) for item in fields(value)
    }


@cache
def _program() -> str:
    # All levels of instructions with fused multiply-add give identical bits.
    core = source_digest() + ("-unfused" if compiled_level() == "x86_64_v2" else "")
    versions = (np.__version__, scipy.__version__, core)
    digest = hashlib.sha256(" ".join(versions).encode())
    package = Path(bondem.__file__).parent
    for source in sorted(path for room in _ROOMS for path in package.joinpath(room).rglob("*.py")):
        digest.update(source.read_bytes())
    return digest.hexdigest()


class PackingCache:
    """Folder of packings by key.

    Failures of the cache (a full disk, a damaged file, missing permission) cost time only: the packing is computed as
    if it had not been stored.

    Args:
        folder: the folder; None for the folder `packings` in the cache of bondem.
        most_bytes: largest total size of the files [bytes]; the least recently used files are removed first.
    """

    def __init__(self, folder: str | Path | None = None, *, most_bytes: int = _MOST_BYTES) -> None:
        self.folder = Path(folder) if folder is not None else cache_folder() / "packings"
        self._most = most_bytes

    def get(self, name: str) -> Particles | None:
        """Return the packing stored under a key, or None; any damage counts as absence."""
        path = self._path(name)
        # a damaged file can raise any type of error, and none may stop a packing
        with suppress(Exception):
            particles = load_particles(path)
            os.utime(path)
            return particles
        return None

    def put(self, name: str, particles: Particles, *, provenance: Mapping[str, Any] | None = None) -> None:
        """Store a packing under a key, replacing an existing one by one atomic move."""
        path = self._path(name)
        with suppress(Exception):  # as above
            self.folder.mkdir(parents=True, exist_ok=True)
            save_particles(path, particles, provenance=provenance)
            self._shrink(path)

    def remembered(self, request: Mapping[str, Any], make: Callable[[], Particles]) -> Particles:
        """Return the stored packing of a request, or compute one and store it if possible.

        Args:
            request: request as for `key`; its `shape` is that of the particles.
            make: function that computes the packing.
        """
        try:
            name, provenance = key(request), written(request)
        except (RunFileError, OSError):
            return make()
        cached = self.get(name)
        if cached is not None:
            # the shape of the user may already have cached measures of its surface
            return filled(cached, request["shape"])
        particles = make()
        self.put(name, particles, provenance=provenance)
        return particles

    def _path(self, name: str) -> Path:
        return self.folder / f"{name}.h5"

    def _shrink(self, newest: Path) -> None:
        found = [(path.stat(), path) for path in self.folder.glob("*.h5") if path != newest]
        room = self._most - newest.stat().st_size - sum(stat.st_size for stat, _ in found)
        for stat, path in sorted(found, key=lambda one: one[0].st_mtime_ns):
            if room >= 0:
                return
            path.unlink(missing_ok=True)
            room += stat.st_size
