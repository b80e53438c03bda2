"""The packing cache: what is packed once, what is packed anew, and that it never does harm."""

import os
from dataclasses import dataclass
from pathlib import Path

import h5py
import numpy as np
import pytest

import bondem as bd
from bondem import packing
from bondem.io import packing_cache
from bondem.io.packing_cache import PackingCache, key
from bondem.packing.targets import Contacts, Fraction, Jammed
from tests.bits import same_spheres
from tests.scripts import python
from tests.specimens import FOUR_CENTRES, FOUR_RADII

REQUEST = {
    "shape": bd.Ball(1.0), "sizes": bd.Uniform(0.25), "count": 20, "target": Contacts(6.2), "method": "quench",
    "seed": 1,
}  # fmt: skip
ASKED = {"count": 1000, "volume_fraction": 0.5, "seed": 3}


def tetrahedron(scale=1.0):
    corner = scale * np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
    return bd.Surface(vertices=corner, triangles=[[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """The folder of the cache that `bd.pack` uses, empty, and the cache on."""
    monkeypatch.setenv("BONDEM_PACKING_CACHE", "on")
    monkeypatch.setattr(packing_cache, "cache_folder", lambda: tmp_path)
    return tmp_path / "packings"


@pytest.fixture
def packings(monkeypatch):
    """Grows by one whenever `bd.pack` really packs."""
    made = []
    quench = packing._METHODS["quench"]
    counted = lambda *given: made.append(1) or quench(*given)  # noqa: E731
    monkeypatch.setitem(packing._METHODS, "quench", counted)
    return made


def test_the_same_request_is_packed_once_to_the_bit(folder, packings):
    shape = bd.Cylinder(1.0, 3.0)
    first, shares = bd.pack(shape, **ASKED), []
    again = bd.pack(shape, **ASKED, progress=shares.append)
    assert len(packings) == 1
    assert same_spheres(again, first.position, first.radius)
    assert again.shape is shape
    assert shares[-1] == 1.0
    # one law, said in two ways
    other = bd.pack(shape, **ASKED, spread=0.1)
    assert len(packings) == 2
    assert same_spheres(bd.pack(shape, **ASKED, sizes=bd.Uniform(0.1)), other.position, other.radius)
    assert len(packings) == 2
    assert len(list(folder.iterdir())) == 2


def test_it_can_be_told_to_pack_anew(folder, packings, monkeypatch):
    for _ in range(2):
        bd.pack(bd.Ball(1.0), **ASKED, cache=False)
    monkeypatch.setenv("BONDEM_PACKING_CACHE", "off")
    bd.pack(bd.Ball(1.0), **ASKED)
    assert len(packings) == 3
    assert not folder.exists()


def test_small_packings_are_not_kept(folder, packings):
    for _ in range(2):
        bd.pack(bd.Ball(1.0), count=200, volume_fraction=0.4)
    assert len(packings) == 2
    assert not folder.exists()


def test_what_lies_in_a_periodic_cell_comes_back_to_the_bit(folder, packings):
    cell = bd.Cell((1.0, 1.0, 1.0))
    first, again = bd.pack(cell, **ASKED), bd.pack(cell, **ASKED)
    assert len(packings) == 1
    assert same_spheres(again, first.position, first.radius)
    np.testing.assert_array_equal(again.period, first.period)
    below_zero = bd.Particles([[-1e-300, 0.5, 0.5]], 0.1, shape=cell)
    PackingCache(folder).put("a", below_zero)
    assert same_spheres(PackingCache(folder).get("a"), below_zero.position, below_zero.radius)


@dataclass(frozen=True)
class MyLaw(bd.SizeLaw):
    most: float = 1.2

    def quantile(self, share):
        return 1.0 + (self.most - 1.0) * share


class MyBall(bd.Ball):
    pass


@pytest.mark.parametrize(
    ("shape", "sizes"), [(bd.Ball(1.0), MyLaw()), (MyBall(1.0), None), (MyBall(1.0).moved((1, 0, 0)), None)]
)
def test_what_the_user_wrote_is_packed_anew(folder, packings, shape, sizes):
    for _ in range(2):
        assert bd.pack(shape, **ASKED, sizes=sizes).shape is shape
    assert len(packings) == 2
    assert not folder.exists()


def test_the_key_holds_all_that_decides_the_bits(monkeypatch):
    assert key(REQUEST) == key(dict(reversed(REQUEST.items())))
    box, ball = bd.Box((1.0, 1.0, 1.0)), bd.Ball(0.4)
    others = [
        {"seed": 2}, {"count": 21}, {"method": "growth"},
        {"target": Contacts(6.1)}, {"target": Fraction(6.2)}, {"target": Jammed()},
        {"sizes": bd.Uniform(0.26)}, {"sizes": bd.Lognormal(0.25)}, {"sizes": bd.Lognormal(0.25, cut=2.0)},
        {"sizes": bd.Sieve((1.0, 2.0), (0.0, 1.0))}, {"sizes": bd.Sieve((1.0, 3.0), (0.0, 1.0))},
        {"shape": bd.Ball(1.0 + 1e-15)}, {"shape": box}, {"shape": bd.Cell(box.size)}, {"shape": box & ball},
        {"shape": box | ball}, {"shape": box - ball}, {"shape": box - bd.Ball(0.3)},
        {"shape": box.cut(ball, name="a")},
        {"shape": ball.moved((1, 0, 0))}, {"shape": ball.moved((2, 0, 0))}, {"shape": ball.rotated("z", 1.0)},
        {"shape": tetrahedron()}, {"shape": tetrahedron(2.0)}, {"shape": tetrahedron() - ball},
    ]  # fmt: skip
    assert len({key(REQUEST | change) for change in [{}, *others]}) == len(others) + 1
    before = key(REQUEST)
    monkeypatch.setattr(packing_cache, "_program", lambda: "another version")
    assert key(REQUEST) != before


def test_a_surface_counts_by_its_mesh_and_not_by_its_file(tmp_path):
    tetra = tetrahedron()
    corner = "\n".join(" ".join(map(str, row)) for row in tetra.vertices)
    three = "\n".join(f"3 {a} {b} {c}" for a, b, c in tetra.triangles)
    header = "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
    text = f"{header}element face 4\nproperty list uchar int vertex_indices\nend_header\n{corner}\n{three}\n"
    for name in ("one.ply", "two.ply"):
        (tmp_path / name).write_text(text)
    keys = [key({"shape": bd.Surface(tmp_path / name, unit="m")}) for name in ("one.ply", "two.ply")]
    (tmp_path / "one.ply").write_text(text.replace("1.0 0.0 0.0", "1.5 0.0 0.0"))
    assert keys[0] == keys[1]
    assert key({"shape": bd.Surface(tmp_path / "one.ply", unit="m")}) != keys[0]


@pytest.mark.parametrize("damage", [lambda kept: kept[:700], lambda kept: b"", lambda kept: kept[::-1]])
def test_a_damaged_file_is_as_good_as_none(tmp_path, damage):
    calls = []

    def make():
        calls.append(1)
        return bd.Particles(FOUR_CENTRES, FOUR_RADII)

    cache = PackingCache(tmp_path / "kept")
    assert same_spheres(cache.remembered(REQUEST, make))
    path = tmp_path / "kept" / f"{key(REQUEST)}.h5"
    provenance = bd.read_provenance(path)
    assert provenance["method"] == "quench"
    assert provenance["sizes"] == {"type": "bondem.packing.sizes.Uniform", "spread": 0.25}
    path.write_bytes(damage(path.read_bytes()))
    assert cache.get(key(REQUEST)) is None
    for _ in range(2):
        assert same_spheres(cache.remembered(REQUEST, make))
    assert len(calls) == 2


def test_a_file_that_lacks_what_it_should_have_is_as_good_as_none(tmp_path):
    cache = PackingCache(tmp_path)
    for missing in ("schema", "bondem_version", "elements/radius", "shape"):
        cache.put("a", bd.Particles(FOUR_CENTRES, FOUR_RADII))
        with h5py.File(tmp_path / "a.h5", "a") as file:
            del (file if "/" in missing or missing == "shape" else file.attrs)[missing]
        assert cache.get("a") is None


def test_the_cache_keeps_to_its_size_and_forgets_what_was_used_least(tmp_path):
    particles = bd.Particles(FOUR_CENTRES, FOUR_RADII)
    PackingCache(tmp_path).put("a", particles)
    size = (tmp_path / "a.h5").stat().st_size
    cache = PackingCache(tmp_path, most_bytes=3 * size)
    for age, name in ((400, "b"), (300, "c")):
        cache.put(name, particles)
        os.utime(tmp_path / f"{name}.h5", (1e9 - age, 1e9 - age))
    os.utime(tmp_path / "a.h5", (1e9 - 500, 1e9 - 500))
    assert cache.get("a") is not None  # used now: no longer the oldest
    cache.put("d", particles)
    assert sorted(path.stem for path in tmp_path.glob("*.h5")) == ["a", "c", "d"]


def test_a_cache_that_cannot_be_written_does_no_harm(tmp_path):
    (tmp_path / "file").write_text("not a folder")
    cache = PackingCache(tmp_path / "file")
    assert same_spheres(cache.remembered(REQUEST, lambda: bd.Particles(FOUR_CENTRES, FOUR_RADII)))


def test_the_cache_lies_beside_the_compiled_code():
    assert PackingCache().folder.name == "packings"
    assert PackingCache().folder.parent.name.startswith("bondem")


def test_a_user_without_a_home_has_a_cache(monkeypatch):
    for name in ("BONDEM_CACHE_DIR", "XDG_CACHE_HOME"):
        monkeypatch.delenv(name, raising=False)
    (folder,) = python("""
import os

os.path.expanduser = lambda path: path  # as where neither HOME nor the user database names a home
from bondem.io.packing_cache import PackingCache
print(PackingCache().folder)
""")
    assert Path(folder).parent.name.startswith("bondem-")


def test_a_flipped_bit_is_packed_again(tmp_path):
    """Whatever bit of a kept packing is flipped: the packing is the same, kept or made anew."""
    shape = bd.Cylinder(radius=5e-3, length=2e-2)
    cache, made = PackingCache(tmp_path), []
    particles = bd.pack(shape, count=150, seed=3)

    def make():
        made.append(1)
        return particles

    request = {"shape": shape, "count": 150}
    cache.remembered(request, make)
    (file,) = tmp_path.glob("*.h5")
    data, random = file.read_bytes(), np.random.default_rng(5)
    used = np.flatnonzero(np.frombuffer(data, dtype=np.uint8))
    for _ in range(60):
        changed = bytearray(data)
        changed[int(random.choice(used))] ^= 1 << int(random.integers(8))
        file.write_bytes(changed)
        found = cache.remembered(request, make)
        np.testing.assert_array_equal(found.position, particles.position)
        np.testing.assert_array_equal(found.radius, particles.radius)
    assert len(made) > 20
