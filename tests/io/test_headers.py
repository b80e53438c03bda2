"""Files that announce more than they hold, that are periodic in some directions only, or that have time steps."""

from collections.abc import Callable
from pathlib import Path

import h5py
import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError, RunFileError
from bondem.io.vtkhdf_spheres import read_vtkhdf_spheres
from tests.specimens import bar, two_spheres

HEAD = (
    "LAMMPS\n\n{} atoms\n{} bonds\n1 atom types\n1 bond types\n0 0.1 xlo xhi\n0 0.1 ylo yhi\n0 0.1 zlo zhi\n"
    "\nAtoms # bpm/sphere\n\n"
)
ATOMS = "".join(f"{k + 1} 1 1 0.002 2500 {0.002 * k:g} 0 0\n" for k in range(4))
BONDS = "\nBonds\n\n" + "".join(f"{k + 1} 1 {k + 1} {k + 2}\n" for k in range(3))
DUMP = (
    "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n{}\nITEM: BOX BOUNDS {}\n0 8e-3\n0 8e-3\n0 6e-3\n"
    "ITEM: ATOMS id x y z radius\n"
)
MANY = "9" * 5000


def test_two_columns_of_one_name_are_told_apart_by_number(tmp_path: Path) -> None:
    (tmp_path / "a.csv").write_text("x,y,z,r,x\n1,2,3,0.1,9\n")
    for columns in (None, ["x", "y", "z", "r"]):
        with pytest.raises(InputError, match="line 1: two columns 'x'; rename one, or give columns= as numbers"):
            bd.read_particles(tmp_path / "a.csv", unit="m", columns=columns)
    found = bd.read_particles(tmp_path / "a.csv", unit="m", columns=[4, 1, 2, 3])
    assert found.position.tolist() == [[9.0, 2.0, 3.0]]


@pytest.mark.parametrize(
    ("name", "text", "told"),
    [
        ("a.data", HEAD.format(6, 3) + ATOMS + BONDS, "line 3: 6 atoms announced, 4 there"),
        ("a.data", HEAD.format(3, 3) + ATOMS + BONDS, "line 3: 3 atoms announced, 4 there"),
        ("a.data", HEAD.format(4, 9) + ATOMS + BONDS, "line 4: 9 bonds announced, 3 there"),
        ("a.data", HEAD.format(4, 3) + ATOMS, "line 4: 3 bonds announced, 0 there"),
        ("a.data", HEAD.format(MANY, 3) + ATOMS, "where the number of atoms is due"),
        ("a.data", HEAD.format(1, 0) + f"{MANY} 1 1 0.002 2500 0 0 0\n", r"line 13: '9+\.\.\. is not finite"),
        ("a.dump", DUMP.format(3, "ff ff ff") + "1 0 0 0 1e-3\n", "line 3: 3 atoms announced, 1 there"),
        ("a.dump", DUMP.format(MANY, "ff ff ff") + "1 0 0 0 1e-3\n", "where the number of atoms is due"),
        ("a.dump", DUMP.format(1, "ff ff ff") + f"{MANY} 0 0 0 1e-3\n", "an id below is no number"),
        ("a.xyz", "3\nx\nA 0 0 0\n", "3 atoms announced, 1 there"),
        ("a.xyz", MANY + "\nx\nA 0 0 0\n", "where the number of atoms is due"),
        ("a.xyz", f"1\nProperties=pos:R:3:radius:R:{MANY}\n0 0 0 1\n", "is no list of name:type:columns"),
    ],
)
def test_counts_of_headers_are_compared(tmp_path: Path, name: str, text: str, told: str) -> None:
    (tmp_path / name).write_text(text)
    with pytest.raises(InputError, match=told) as caught:
        bd.read_particles(tmp_path / name, radius=1e-3 if name == "a.xyz" and "Prop" not in text else None)
    assert len(str(caught.value)) < 500


@pytest.mark.parametrize("call", [
    lambda: bd.pack(bd.Box((1, 1, 1)), count=10**5000), lambda: bd.Ball(10**5000), lambda: bd.Index([10**5000]),
])  # fmt: skip
def test_numbers_of_thousands_of_digits_are_refused_in_one_line(call: Callable) -> None:
    with pytest.raises(InputError, match="an integer of more than 4300 digits"):
        call()


def slab(tmp_path: Path, kind: str) -> Path:
    """Spheres that touch over all borders."""
    x, y, z = (1e-3 + 2e-3 * np.indices((4, 4, 3)).reshape(3, -1))
    rows = list(zip(x, y, z, strict=True))
    if kind == "dump":
        text = DUMP.format(len(rows), "pp pp ff")
        text += "".join(f"{k} {a:.6g} {b:.6g} {c:.6g} 1e-3\n" for k, (a, b, c) in enumerate(rows, start=1))
    else:
        lattice = "8e-3 0 0 0 8e-3 0 0 0 6e-3"
        text = f'{len(rows)}\nLattice="{lattice}" pbc="T T F" Properties=species:S:1:pos:R:3:radius:R:1\n'
        text += "".join(f"A {a:.6g} {b:.6g} {c:.6g} 1e-3\n" for a, b, c in rows)
    path = tmp_path / f"slab.{kind}"
    path.write_text(text)
    return path


@pytest.mark.parametrize("kind", ["dump", "xyz"])
def test_a_body_that_is_periodic_in_two_directions_is_not_another_one_silently(tmp_path: Path, kind: str) -> None:
    path = slab(tmp_path, kind)
    for periodic in (None, True):
        with pytest.raises(InputError, match="periodic along x and y only"):
            bd.read_particles(path, periodic=periodic)
    free = bd.connect(bd.read_particles(path, periodic=False), tolerance=1e-3)
    tall = bd.connect(bd.read_particles(path, period=(8e-3, 8e-3, 20e-3)), tolerance=1e-3)
    # 3·16 - 2·12 bonds in a layer of 4 x 4 without borders, 32 with both, and 16 between two layers
    assert len(free.pairs) == 3 * 24 + 2 * 16
    assert len(tall.pairs) == 3 * 32 + 2 * 16


@pytest.mark.parametrize("value", [2000, 2000.0, np.float64(2000), np.float32(2000), np.int64(2000)], ids=type)
def test_numbers_of_numpy_are_numbers_in_text(tmp_path: Path, value: float) -> None:
    bd.export(tmp_path / "a.data", two_spheres(2e-3), density=value)
    rows = (tmp_path / "a.data").read_text().partition("Atoms # bpm/sphere\n\n")[2].splitlines()
    assert rows[0].split()[4] == "2000.0"


def vtkhdf(path: Path, pieces: list[list[int]], *, announced: int = 0) -> list[np.ndarray]:
    """Write PolyData of time steps, each with some pieces of so many spheres in a row; returns their centres."""
    counts = [count for step in pieces for count in step]
    centres = [
        np.column_stack([2.0 * np.arange(sum(step)), np.full(sum(step), 100.0 * k), np.zeros(sum(step))])
        for k, step in enumerate(pieces)
    ]
    lines = [[k, k + 1] for count in counts for k in range(count - 1)]
    before = np.cumsum([0, *map(len, pieces)])[:-1]
    rows = np.cumsum([0, *map(len, centres)])[:-1]
    cells = np.cumsum([0, *(sum(count - 1 for count in step) for step in pieces)])[:-1]
    with h5py.File(path, "w") as file:
        root = file.create_group("VTKHDF")
        root.attrs["Type"] = np.bytes_("PolyData")
        root["NumberOfPoints"] = np.array(counts) + announced
        root["Points"] = np.concatenate(centres)
        root["PointData/radius"] = np.ones(sum(counts))
        root["Lines/NumberOfCells"] = np.array(counts) - 1
        root["Lines/NumberOfConnectivityIds"] = 2 * (np.array(counts) - 1)
        root["Lines/Offsets"] = np.concatenate([2 * np.arange(count) for count in counts])
        root["Lines/Connectivity"] = np.ravel(lines)
        if len(pieces) > 1:
            root["Steps/Values"] = np.arange(len(pieces), dtype=float)
            root["Steps"].attrs["NSteps"] = len(pieces)
            root["Steps/PartOffsets"], root["Steps/NumberOfParts"] = before, [len(step) for step in pieces]
            root["Steps/PointOffsets"] = root["Steps/PointDataOffsets/radius"] = rows
            root["Steps/CellOffsets"] = np.outer(cells, [0, 1, 0, 0])
            root["Steps/ConnectivityIdOffsets"] = np.outer(2 * cells, [0, 1, 0, 0])
    return centres


@pytest.mark.filterwarnings("ignore::bondem.errors.UnitWarning")
@pytest.mark.parametrize("pieces", [[[5]], [[3, 4]], [[5], [3], [4]], [[3, 4], [2, 2]]], ids=str)
def test_time_steps_and_pieces_of_vtkhdf_are_read(tmp_path: Path, pieces: list[list[int]]) -> None:
    path = tmp_path / "a.vtkhdf"
    centres = vtkhdf(path, pieces)
    for frame in range(-1, len(pieces)):
        np.testing.assert_array_equal(bd.read_particles(path, frame=frame).position, centres[frame])
    last = pieces[-1]
    begin = np.cumsum([0, *last])
    wanted = [(a + k, a + k + 1) for a, count in zip(begin, last, strict=False) for k in range(count - 1)]
    np.testing.assert_array_equal(read_vtkhdf_spheres(path).pairs, wanted)
    with pytest.raises(InputError, match=f"has {len(pieces)} snapshots"):
        bd.read_particles(path, frame=len(pieces))
    vtkhdf(path, pieces, announced=1)
    with pytest.raises(InputError, match=r"damaged.*announced"):
        bd.read_particles(path, frame=-1)


@pytest.mark.parametrize("rows", [10**9, 10**12])
@pytest.mark.parametrize(
    ("name", "place", "read"),
    [
        ("a.h5", "elements/position", bd.load_particles), ("a.h5", "elements/radius", bd.read_particles),
        ("run.h5", "state/pose", bd.read_run), ("run.h5", "elements/position", bd.read_run),
        ("run.h5", "history/records", bd.read_contents), ("a.vtkhdf", "VTKHDF/Points", bd.read_particles),
    ],
)  # fmt: skip
def test_arrays_that_announce_more_than_the_file_holds_are_not_allocated(
    tmp_path: Path, name: str, place: str, read: Callable, rows: int
) -> None:
    path, body = tmp_path / name, bar(40)
    if name == "run.h5":
        model = bd.Model(body, bd.CellBond(E=1e9, nu=0.2), density=2000.0)
        bd.solve_explicit(model, duration=0.0, out=path)
    elif name == "a.h5":
        bd.save_particles(path, body.particles)
    else:
        bd.write_vtkhdf(path, two_spheres(2e-3))
    with h5py.File(path, "r+") as file:
        tail, dtype = file[place].shape[1:], file[place].dtype
        del file[place]
        file.create_dataset(place, (rows, *tail), dtype, chunks=(1 << 10, *tail), compression="gzip")
    with pytest.raises((InputError, RunFileError), match=r"damaged \(\S+ announces \S+ bytes, holds 0"):
        read(path)
