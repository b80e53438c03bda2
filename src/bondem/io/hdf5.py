"""Opening of HDF5 files for reading, and writing of complete HDF5 files.

HDF5 does not survive a failing disk: it crashes when it closes a file that it could not write. Files are therefore
made in memory, and their bytes are written by Python. Reading a damaged file can raise errors of any type. Each is
replaced by an error of one line that names the file.
"""

import io
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import h5py
import numpy as np

from bondem import __version__
from bondem.errors import BondemError
from bondem.io.atomic import write_bytes
from bondem.io.digest import fixed

#: Version of the format, whose metadata have checksums.
FORMAT = ("v108", "v108")
# Largest compression factor of HDF5 [-], and the size of arrays that are not checked against it [bytes].
_MOST_COMPRESSED, _LITTLE = 1100, 1 << 20


@dataclass(frozen=True)
class Kind:
    """Kind of HDF5 file, with the texts and the type of its errors.

    Attributes:
        name: name of the kind.
        given: advice for a file of another kind.
        again: advice for a damaged file.
        error: type of the errors.
    """

    name: str
    given: str
    again: str
    error: type[BondemError]


@contextmanager
def writing(path: Path) -> Iterator[h5py.File]:
    """Yield a new file in memory, which is written to `path` at the end of the block.

    Raises:
        InputError, RunFileError: errors of `bondem.io.atomic.replacing`.
    """
    content = io.BytesIO()
    with h5py.File(content, "w", libver=FORMAT) as file:
        yield file
    write_bytes(path, content.getbuffer())


def write_head(file: h5py.File, name: str, schema: int, texts: Mapping[str, str]) -> None:
    """Write the name and the schema of a format, the version of bondem, and texts by name."""
    file.attrs["format"], file.attrs["schema"] = fixed(name), schema
    file.attrs["bondem_version"] = fixed(__version__)
    for key, text in texts.items():
        file.create_dataset(key, data=fixed(text))


def refuse_newer(path: Path, schema: int, version: str, known: int, kind: Kind) -> None:
    """Raise the error of `kind` if the schema of a file, which bondem `version` wrote, is above `known`."""
    if schema > known:
        raise kind.error(
            f"'{path}' was written by bondem {version}, which is newer than this {__version__}; update bondem to read"
            " it"
        )


def put(group: Any, name: str, values: Any) -> None:
    """Store an array, with checksums unless it is empty or a scalar."""
    array = np.asarray(values)
    if array.ndim and array.size:
        group.create_dataset(name, data=array, chunks=True, fletcher32=True)
    else:
        group[name] = array


@contextmanager
def reading(path: Path, kind: Kind, source: Path | io.BytesIO | None = None) -> Iterator[h5py.File]:
    """Yield an HDF5 file that is open for reading.

    Args:
        path: the file.
        kind: kind of the file, for errors.
        source: source of the contents, such as a recovered file; None for `path` itself.

    Raises:
        BondemError: the error of the kind, for a file that is not HDF5 or is damaged, or whose arrays announce more
            than the file contains. Errors of bondem raised by the block pass unchanged.
    """
    try:
        file = h5py.File(source or path, "r")
    except PermissionError as error:
        raise kind.error(f"'{path}' cannot be read ({error.strerror}); check its permissions") from None
    except Exception:
        raise kind.error(f"'{path}' is not {kind.name}; {kind.given}") from None
    with file, damage(path, kind, BondemError):
        file.visititems(_require_stored)
        yield file


@contextmanager
def damage(path: Path, kind: Kind, *passing: type[Exception]) -> Iterator[None]:
    """Turn errors of the block into the error of `kind`, for a damaged file or one that does not fit into memory.

    Args:
        path: the file.
        kind: kind of the file.
        passing: types of errors that are raised as they are.
    """
    try:
        yield
    except passing:
        raise
    except MemoryError:
        raise kind.error(f"'{path}' does not fit into the memory of this machine; read it on a larger one") from None
    except Exception as error:
        reason = " ".join(str(error).split())
        raise kind.error(f"'{path}' is damaged ({reason}); {kind.again}") from error


def _require_stored(name: str, item: Any) -> None:
    """Raise ValueError for an array that announces more bytes than the file can contain, before it is read."""
    if isinstance(item, h5py.Dataset):
        stored = item.id.get_storage_size()
        if item.nbytes > _LITTLE + _MOST_COMPRESSED * stored:
            raise ValueError(f"{name} announces {item.nbytes:.3g} bytes, holds {stored}")


def array_at(file: Any, name: str) -> np.ndarray:
    """Read an array.

    Raises:
        KeyError: The file has no array of this name.
        ValueError: The name is not that of an array.
    """
    item = file[name]
    if not isinstance(item, h5py.Dataset):
        raise ValueError(f"{name} is not an array")
    return np.asarray(item[()])
