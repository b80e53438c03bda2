"""A file that changes as a whole or not at all: kills at every write of a commit."""

import os
from pathlib import Path

import h5py
import numpy as np
import pytest

import bondem as bd
from bondem.errors import RunFileError
from bondem.io import journal
from bondem.io.journal import JournaledFile, committed
from tests.specimens import two_spheres

V = ("v108", "v108")


class KilledError(BaseException):
    pass


def begin(path: Path) -> tuple[JournaledFile, h5py.File]:
    raw = JournaledFile(path, new=True)
    file = h5py.File(raw, "w", libver=V)
    file.create_dataset("grows", data=np.zeros(5000), maxshape=(None,), chunks=(1000,))
    file["fixed"] = np.zeros(20_000)
    file.attrs["commit"] = 1
    file.flush()
    raw.commit()
    return raw, file


def change(file: h5py.File, number: int) -> None:
    file["grows"].resize(5000 + 700 * number, axis=0)
    file["grows"][...] = number
    file["fixed"][...] = number
    file.attrs["commit"] = number


def consistent(path: Path) -> int:
    """The number of the commit that a reader finds, which all parts of the file must have."""
    with h5py.File(committed(path), "r") as file:
        number = int(file.attrs["commit"])
        value = number if number > 1 else 0
        assert file["grows"].shape == (5000 + 700 * value,)
        assert (file["grows"][()] == value).all()
        assert (file["fixed"][()] == value).all()
    return number


def test_readers_see_commits_and_nothing_between(tmp_path: Path) -> None:
    path = tmp_path / "a.h5"
    raw, file = begin(path)
    change(file, 2)
    file.flush()
    assert consistent(path) == 1
    raw.commit()
    assert consistent(path) == 2
    change(file, 3)
    raw.roll_back()
    file.close()
    raw.close()
    assert consistent(path) == 2
    assert os.listdir(tmp_path) == ["a.h5"]


@pytest.mark.parametrize("torn", [False, True])
def test_a_kill_at_any_write_leaves_a_whole_commit(tmp_path: Path, monkeypatch, torn: bool) -> None:
    """After write number k of a commit nothing more happens; `torn`: of that write only half."""
    found = []
    for k in range(200):
        path = tmp_path / f"{k}.h5"
        raw, file = begin(path)
        change(file, 2)
        file.flush()
        left, write, sync, unlink = [k], os.pwrite, os.fsync, Path.unlink

        def counted(act, *given, left=left, write=write):
            if left[0] == 0:
                if torn and act is write:
                    act(given[0], given[1][: len(given[1]) // 2], given[2])
                raise KilledError
            left[0] -= 1
            return act(*given)

        with monkeypatch.context() as patch:
            patch.setattr(os, "pwrite", lambda *given, w=write, c=counted: c(w, *given))
            patch.setattr(os, "fsync", lambda *given, s=sync, c=counted: c(s, *given))
            patch.setattr(Path, "unlink", lambda self, u=unlink, c=counted, **o: c(lambda: u(self, **o)))
            try:
                raw.commit()
            except KilledError:
                ended = False
            else:
                ended = True
        number = consistent(path)
        found.append(number)
        # nobody closes the file of a process that was killed
        monkeypatch.setattr(raw, "_committed", 1 << 60)
        raw._file.close()
        again = JournaledFile(path)
        again.close()
        assert consistent(path) == number
        if ended:
            break
    assert found[0] == 1
    assert found[-1] == 2
    assert sorted(found) == found
    assert 5 < len(found) < 200


def test_half_a_journal_counts_for_nothing(tmp_path: Path) -> None:
    path = tmp_path / "a.h5"
    raw, file = begin(path)
    raw.roll_back()
    file.close()
    raw.close()
    whole = path.read_bytes()
    journal._write_journal(tmp_path / ".a.h5.journal", len(whole), {0: bytearray(4096)})
    data = (tmp_path / ".a.h5.journal").read_bytes()
    (tmp_path / ".a.h5.journal").write_bytes(data[: len(data) // 2])
    assert committed(path) == path
    JournaledFile(path).close()
    assert path.read_bytes() == whole
    assert os.listdir(tmp_path) == ["a.h5"]


def test_what_cannot_be_opened_says_so(tmp_path: Path) -> None:
    with pytest.raises(RunFileError, match="could not be written"):
        JournaledFile(tmp_path / "none.h5")
    with pytest.raises(RunFileError, match="could not be written"):
        JournaledFile(tmp_path / "no folder" / "a.h5", new=True)


def test_contents_carry_out_a_commit_that_was_cut_off(tmp_path: Path) -> None:
    """Some of its pages are in the file, all of them in the journal: the file is whole afterwards, for all."""
    model = bd.Model(
        two_spheres(), bd.EulerBernoulli(E=1e9, nu=0.2, radius_ratio=0.5), 1000.0, boundary=[bd.Fix(bd.Index([0]))],
    )  # fmt: skip
    bd.solve_explicit(model, duration=0.01, out=tmp_path / "run.h5")
    path = tmp_path / "run.h5"
    whole = path.read_bytes()
    pages = {k: bytearray(whole[4096 * k : 4096 * (k + 1)]) for k in range(-(-len(whole) // 4096))}
    journal._write_journal(journal.journal_of(path), len(whole), pages)
    path.write_bytes(whole[:4096] + bytes(4096) + whole[8192:])
    assert bd.read_contents(path).elements == 2
    assert path.read_bytes() == whole
    assert os.listdir(tmp_path) == ["run.h5"]
