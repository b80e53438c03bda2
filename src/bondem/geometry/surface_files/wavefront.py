"""OBJ files (Wavefront): polygons, with the names of their groups and objects."""

import numpy as np

from bondem._types import Ints
from bondem.errors import InputError
from bondem.geometry.surface_files.contents import Contents, by_name, name_of
from bondem.geometry.surface_files.polygons import ears

_MOST_CORNERS = 2000  # of a polygon; cutting larger ones into triangles takes minutes


def read_obj(name: str, data: bytes) -> Contents:
    """Read the bytes of an OBJ file; groups (`g`), else objects (`o`), are its named parts.

    Polygons become triangles. Materials, textures, normals, lines and points are ignored.

    Raises:
        InputError: A line cannot be read, a corner does not exist, or there is no polygon.
    """
    vertices: list[list[float]] = []
    polygons: list[list[int]] = []
    labels: dict[bytes, list[bytes]] = {b"g": [], b"o": []}
    present = {b"g": b"", b"o": b""}
    text = data.replace(b"\\\r\n", b" ").replace(b"\\\n", b" ")
    for number, line in enumerate(text.splitlines(), start=1):
        key, _, rest = line.strip().replace(b"\t", b" ").partition(b" ")
        try:
            if key == b"v":
                x, y, z = rest.split()[:3]
                vertices.append([float(x), float(y), float(z)])
            elif key == b"f":
                corners = [int(word.split(b"/", 1)[0]) for word in rest.split()]
                if len(corners) < 3 or len(corners) > _MOST_CORNERS or 0 in corners:
                    raise ValueError
                # negative numbers count back from the latest corner
                corners = [k - 1 if k > 0 else len(vertices) + k for k in corners]
                if min(corners) < 0:
                    raise ValueError
                polygons.append(corners)
                for kind, here in present.items():
                    labels[kind].append(here)
            elif key in present:
                present[key] = rest.strip()
        except ValueError as error:
            raise InputError(
                f"{name}, line {number}: {name_of(line[:60])!r} is no vertex of three numbers or polygon of 3 to"
                f" {_MOST_CORNERS} corners; export it again"
            ) from error
    if not polygons:
        raise InputError(f"{name} holds no polygon (curved patches of OBJ are not read); export it as triangles")
    place = np.array(vertices, dtype=float).reshape(-1, 3)
    highest = max(map(max, polygons))
    if highest >= len(place):
        raise InputError(
            f"{name}: a polygon has corner {highest + 1} of {len(place)}: it was cut or damaged; export it again"
        )
    triangles = [_triangles(place, corners) for corners in polygons]
    kind = b"g" if len(set(labels[b"g"])) > 1 else b"o"
    names = [name_of(label) for label, some in zip(labels[kind], triangles, strict=True) for _ in some]
    return Contents(place, np.concatenate(triangles), by_name(names))


def _triangles(place: np.ndarray, corners: list[int]) -> Ints:
    if len(corners) == 3:
        return np.array([corners])
    return np.array(corners)[ears(place[corners])]
