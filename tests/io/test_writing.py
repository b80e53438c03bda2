"""Writing of files on full disks, through links, into places that one may not enter, and by several processes."""

import os
import resource
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from importlib import import_module
from pathlib import Path

import h5py
import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError, RunFileError
from bondem.io.atomic import replacing, require_folder, write_text
from bondem.io.vtk_polygons import write_polygons
from tests.specimens import bar, spheres

BODY, BLOCK = bar(40), spheres(bd.Box((4e-3, 2e-3, 2e-3)), 100)
MODEL = bd.Model(BODY, bd.CellBond(E=1e9, nu=0.2), density=2000.0)
DT = 1e-7
WRITERS: dict[str, Callable[[Path], object]] = {
    "run.h5": lambda path: bd.solve_explicit(MODEL, duration=DT, dt=DT, out=path),
    "particles.h5": lambda path: bd.save_particles(path, BODY),
    "cells.vtkhdf": lambda path: bd.write_vtkhdf(path, BODY),
    "beams.vtkhdf": lambda path: bd.write_vtkhdf(path, BLOCK),
    "cracks.vtkhdf": lambda path: write_polygons(path, np.zeros((300, 3)), np.arange(0, 301, 3), {}),
    "cells.csv": lambda path: bd.export(path, BODY),
    "beams.data": lambda path: bd.export(path, BLOCK, density=2000.0),
    "cells.vtu": lambda path: bd.export(path, BODY),
    "picture.png": BODY.plot,
    "text.toml": lambda path: write_text(path, "x" * 10_000),
}


@contextmanager
def full_disk(room: int) -> Iterator[None]:
    """No file may become longer than this; the error is another one than that of a full disk, at the same place."""
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    # Python would keep cut bytecode of what is imported
    written, sys.dont_write_bytecode = sys.dont_write_bytecode, True
    resource.setrlimit(resource.RLIMIT_FSIZE, (room, hard))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
        sys.dont_write_bytecode = written


@contextmanager
def nobody() -> Iterator[None]:
    """Have the rights of a user who owns nothing, and may not read what is imported later."""
    import_module("bondem.report.plots")
    if os.geteuid() == 0:
        os.seteuid(65534)
        try:
            yield
        finally:
            os.seteuid(0)
    else:
        yield


@pytest.mark.parametrize("name", WRITERS)
def test_a_full_disk_is_one_error_and_the_old_file_stays(tmp_path: Path, name: str) -> None:
    path = tmp_path / name
    if name == "run.h5":
        WRITERS[name](path)
    else:
        path.write_bytes(b"old")
    old = path.read_bytes()
    with full_disk(2048), pytest.raises(RunFileError, match=f"{name}' could not be written.*make room"):
        WRITERS[name](path)
    assert path.read_bytes() == old
    assert os.listdir(tmp_path) == [name]


def test_a_run_replaces_run_files_and_empty_ones_only(tmp_path: Path) -> None:
    path = tmp_path / "run.h5"
    path.touch()
    for _ in range(2):
        WRITERS["run.h5"](path)
    others = tmp_path / "notes.txt", tmp_path / "thesis.h5"
    others[0].write_text("precious")
    with h5py.File(others[1], "w") as file:
        file["a"] = [1, 2, 3]
    for other in others:
        before = other.read_bytes()
        with pytest.raises(InputError, match=r"out = .*: the file exists and is no run file.* Give another name"):
            WRITERS["run.h5"](other)
        assert other.read_bytes() == before


@pytest.mark.parametrize("name", ["run.h5", "particles.h5", "picture.png"])
def test_links_stay_and_the_file_behind_them_is_written(tmp_path: Path, name: str) -> None:
    (tmp_path / "scratch").mkdir()
    link, behind = tmp_path / name, tmp_path / "scratch" / f"far_{name}"
    link.symlink_to(behind)
    for _ in range(2):  # the file is new, then it is there
        WRITERS[name](link)
        assert link.is_symlink()
        assert behind.stat().st_size > 1000
        assert os.listdir(tmp_path / "scratch") == [behind.name]


def test_a_run_goes_on_in_the_file_behind_a_link(tmp_path: Path) -> None:
    (tmp_path / "far").mkdir()
    link = tmp_path / "run.h5"
    link.symlink_to(tmp_path / "far" / "run.h5")

    calls: list[object] = []

    def stop(*_: object) -> None:
        calls.append(None)
        if len(calls) == 3:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        bd.solve_explicit(MODEL, duration=40 * DT, dt=DT, every=10, save_every=10, out=link, callback=stop)
    bd.resume(link)
    assert bd.read_contents(tmp_path / "far" / "run.h5").step == 40
    assert link.is_symlink()


def test_processes_that_write_one_name_leave_a_whole_file(tmp_path: Path) -> None:
    path = tmp_path / "a.csv"
    with replacing(path) as one, replacing(path) as other:
        assert one != other
        one.write_text("one")
        other.write_text("other")
    assert path.read_text() == "one"
    assert os.listdir(tmp_path) == ["a.csv"]


def test_permissions_of_a_replaced_file_are_kept(tmp_path: Path) -> None:
    path = tmp_path / "a.csv"
    path.touch()
    path.chmod(0o640)
    write_text(path, "x")
    assert path.stat().st_mode & 0o777 == 0o640


@pytest.mark.parametrize("name", WRITERS)
def test_places_that_cannot_be_written_are_refused_in_one_line(tmp_path: Path, name: str) -> None:
    (tmp_path / "secret").mkdir(mode=0o700)
    if os.geteuid():
        (tmp_path / "secret").chmod(0)
    (tmp_path / "file").touch()
    (tmp_path / "loop").symlink_to("loop")
    os.mkfifo(tmp_path / f"pipe_{name}")
    for place in ("secret", "secret/below", "file", "loop", "none"):
        with nobody(), pytest.raises((InputError, RunFileError), match=r"^[^\n]+$"):
            WRITERS[name](tmp_path / place / name)
    for place in (tmp_path / f"pipe_{name}", tmp_path / ("n" * 260 + name)):
        with pytest.raises((InputError, RunFileError), match=r"^[^\n]+$"):
            WRITERS[name](place)
    assert (tmp_path / f"pipe_{name}").is_fifo()


READERS = (
    bd.read_run, bd.read_contents, bd.resume, bd.load_particles, bd.read_particles, bd.read_lattice,
    lambda path: bd.Surface(path.with_suffix(".stl"), unit="mm"),
)  # fmt: skip


@pytest.mark.parametrize("read", READERS, ids=range(len(READERS)))
def test_files_that_may_not_be_read_are_refused_in_one_line(tmp_path: Path, read: Callable[[Path], object]) -> None:
    (tmp_path / "secret").mkdir(mode=0o700)
    for name in ("a.h5", "a.stl"):
        (tmp_path / "secret" / name).touch()
    if os.geteuid():
        (tmp_path / "secret").chmod(0)
    (tmp_path / "loop").symlink_to("loop")
    for place in (tmp_path / "secret" / "a.h5", tmp_path / "loop" / "a.h5", tmp_path / ("n" * 260 + ".h5")):
        with nobody(), pytest.raises((InputError, RunFileError), match=r"cannot be read \(.*\)"):
            read(place)


def test_a_folder_of_results_in_a_place_without_entry_is_refused(tmp_path: Path) -> None:
    (tmp_path / "secret").mkdir(mode=0o700)
    if os.geteuid():
        (tmp_path / "secret").chmod(0)
    with nobody(), pytest.raises(InputError, match="Permission denied"):
        require_folder(tmp_path / "secret" / "out", "output folder")


def run_while(tmp_path: Path, act: Callable[[Path], object]) -> Path:
    """A run of four checkpoints, before the third of which something happens to its file."""
    path, calls = tmp_path / "run.h5", [0]

    def callback(*_: object) -> None:
        calls[0] += 1
        if calls[0] == 3:
            act(path)

    bd.solve_explicit(
        MODEL, duration=40 * DT, dt=DT, every=10, out=path, save_every=10, snapshot_every=10, callback=callback
    )
    return path


def test_a_run_file_that_is_removed_meanwhile_is_written_again(tmp_path: Path) -> None:
    path = run_while(tmp_path, Path.unlink)
    found = bd.read_contents(path)
    assert (found.step, found.snapshots) == (40, 5)
    assert bd.read_run(path).state.step == 40
    assert os.listdir(tmp_path) == ["run.h5"]


@pytest.mark.parametrize(
    ("act", "told"),
    [
        (lambda path: os.truncate(path, 100), "cut during the run"),
        (lambda path: path.write_bytes(b"other"), "cut during the run"),
        (lambda path: os.replace(path.with_name("other"), path), "replaced by another file"),
    ],
)
def test_a_run_file_that_is_cut_or_replaced_meanwhile_is_an_error(tmp_path: Path, act: Callable, told: str) -> None:
    (tmp_path / "other").write_bytes(b"mine")
    with pytest.raises(RunFileError, match=told):
        run_while(tmp_path, act)
    left = (tmp_path / "run.h5").read_bytes()
    assert len(left) == 100 or left in (b"other", b"mine")  # of what somebody else wrote nothing is lost
