"""Reader of 3MF files: ZIP archives with models in XML, which state their unit.

It reads meshes, components and the items of the build, also from separate model files (production extension). It
rejects very large archives, document types with their entities, and components that refer to themselves.
Reference: 3MF Core Specification 1.3, and Production Extension 1.1.2 (3MF Consortium).
"""

import io
import posixpath
import zipfile
import zlib
from dataclasses import dataclass, field
from typing import IO
from xml.parsers import expat

import numpy as np

from bondem._types import Floats, Ints
from bondem.errors import InputError
from bondem.geometry.surface_files.contents import Contents, by_name

_UNITS = {
    "micron": 1e-6, "millimeter": 1e-3, "centimeter": 1e-2, "inch": 0.0254, "foot": 0.3048, "meter": 1.0,
}  # fmt: skip
_CORE = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
_MOST_BYTES, _MOST_TRIANGLES, _MOST_OBJECTS, _DEEPEST = 1 << 30, 20_000_000, 100_000, 50


@dataclass
class _Object:
    """An object of a model: a mesh, or other objects with their transforms."""

    name: str
    kind: str
    vertices: list[tuple[float, ...]] = field(default_factory=list)
    triangles: list[tuple[int, ...]] = field(default_factory=list)
    components: list[tuple[str, str, Floats]] = field(default_factory=list)


@dataclass
class _Model:
    """A model file: its unit, its objects by number, and the items of its build."""

    unit: str = "millimeter"  # the default of the specification
    objects: dict[str, _Object] = field(default_factory=dict)
    items: list[tuple[str, str, Floats]] = field(default_factory=list)


def read_3mf(name: str, data: bytes) -> Contents:
    """Read the bytes of a 3MF file; its objects are its named parts.

    Raises:
        InputError: The file is no 3MF file or is damaged, has no triangles, declares a document type, or exceeds a
            limit: 1 GiB unpacked, 20 million triangles, 100 000 objects, or 50 levels of components.
    """
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            return _Archive(name, archive).contents()
    except InputError:
        raise
    except (zipfile.BadZipFile, zlib.error, EOFError, NotImplementedError, RuntimeError, KeyError) as error:
        raise InputError(f"{name} cannot be read as 3MF ({error}); export it again") from error
    except (expat.ExpatError, ValueError, IndexError) as error:
        raise InputError(f"{name}: its model cannot be read ({error}); export it again") from error


class _Archive:
    """Reader of the model files of a 3MF archive, each parsed once."""

    def __init__(self, name: str, archive: zipfile.ZipFile) -> None:
        self._name, self._archive = name, archive
        self._models: dict[str, _Model] = {}
        self._room = _MOST_BYTES
        self._vertices: list[Floats] = []
        self._triangles: list[Ints] = []
        self._names: list[str] = []
        self._objects = 0

    def contents(self) -> Contents:
        files = [entry for entry in self._archive.namelist() if entry.lower().endswith(".model")]
        if not files:
            raise InputError(f"{self._name} holds no model; export it as 3MF again")
        root = next((entry for entry in files if entry.lower().lstrip("/") == "3d/3dmodel.model"), files[0])
        model = self._model(root)
        if model.unit not in _UNITS:
            raise InputError(f"{self._name}: unit {model.unit!r} is none of {', '.join(_UNITS)}; export it again")
        # for a file without a build, all objects that are no component of another
        used = {number for one in model.objects.values() for _, number, _ in one.components}
        rest = [("", number, np.eye(4)) for number in model.objects if number not in used]
        for path, number, transform in model.items or rest:
            self._add(path or root, number, transform, "", 0)
        if not self._triangles:
            raise InputError(f"{self._name} holds no triangles; export it again")
        return Contents(
            np.concatenate(self._vertices), np.concatenate(self._triangles), by_name(self._names),
            _UNITS[model.unit],
        )  # fmt: skip

    def _add(self, path: str, number: str, transform: Floats, name: str, depth: int) -> None:
        """Add an object and its components: rows (x, y, z, 1) times `transform`; `name`, if any, replaces theirs."""
        found = self._model(path).objects.get(number)
        if found is None:
            raise InputError(f"{self._name}: object {number} does not exist; export it again")
        self._objects += 1
        if depth > _DEEPEST or self._objects > _MOST_OBJECTS:
            raise InputError(
                f"{self._name}: object {number} is part of itself, or more than {_MOST_OBJECTS} objects are built;"
                " export it again"
            )
        if found.kind == "support":  # a structure for printing, not part of the body
            return
        name = name or found.name
        if found.triangles:
            place = np.array(found.vertices, dtype=float).reshape(-1, 3)
            triangles = np.array(found.triangles)
            if triangles.min() < 0 or triangles.max() >= len(place):
                raise InputError(f"{self._name}: a triangle has a corner that does not exist; export it again")
            if np.linalg.det(transform[:3, :3]) < 0.0:  # mirrored
                triangles = triangles[:, ::-1]
            self._triangles.append(triangles + sum(map(len, self._vertices)))
            self._vertices.append(place @ transform[:3, :3] + transform[3, :3])
            self._names += [name] * len(triangles)
            if len(self._names) > _MOST_TRIANGLES:
                raise InputError(f"{self._name} has more than {_MOST_TRIANGLES} triangles; export it coarser")
        for inner, part, moved in found.components:
            self._add(inner or path, part, moved @ transform, name, depth + 1)

    def _model(self, path: str) -> _Model:
        path = posixpath.normpath(path).lstrip("/")
        if path not in self._models:
            entry = {one.lstrip("/").lower(): one for one in self._archive.namelist()}[path.lower()]
            self._room -= self._archive.getinfo(entry).file_size  # `open` unpacks no more than this
            if self._room < 0:
                raise InputError(f"{self._name} unpacks to more than {_MOST_BYTES >> 30} GB; export it coarser")
            with self._archive.open(entry) as stream:
                self._models[path] = _parsed(self._name, stream)
        return self._models[path]


def _parsed(name: str, stream: IO[bytes]) -> _Model:
    """Return the unit, objects and items in the XML of a model."""
    model, present = _Model(), _Object("", "")

    def begin(tag: str, given: dict[str, str]) -> None:
        nonlocal present
        space, _, word = tag.rpartition(" ")
        if space not in ("", _CORE):  # an element of an extension, such as a beam lattice
            return
        if word == "model":
            model.unit = given.get("unit", model.unit)
        elif word == "object":
            present = model.objects[given["id"]] = _Object(given.get("name", "").strip(), given.get("type", "model"))
        elif word == "vertex":
            present.vertices.append((float(given["x"]), float(given["y"]), float(given["z"])))
        elif word == "triangle":
            present.triangles.append((int(given["v1"]), int(given["v2"]), int(given["v3"])))
        elif word in ("component", "item"):
            path = next((value for key, value in given.items() if key.rpartition(" ")[2] == "path"), "")
            use = (path, given["objectid"], _transform(given.get("transform")))
            (present.components if word == "component" else model.items).append(use)

    def refuse(*_: object) -> None:
        raise InputError(f"{name}: its model declares a document type, which 3MF forbids; export it again")

    parser = expat.ParserCreate(namespace_separator=" ")
    parser.StartElementHandler = begin
    parser.StartDoctypeDeclHandler = refuse
    parser.ParseFile(stream)
    return model


def _transform(text: str | None) -> Floats:
    """Return a transform of twelve numbers as a matrix that acts on row vectors, (4, 4); the identity for None."""
    matrix = np.eye(4)
    if text is not None:
        matrix[:, :3] = np.array([float(word) for word in text.split()]).reshape(4, 3)
    return matrix
