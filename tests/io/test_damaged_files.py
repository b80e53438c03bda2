"""Studies and run files that are damaged anywhere: refused in one line, or what was written. Fuzzing: benchmarks/."""

import warnings
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import bondem as bd
from bondem.errors import InputError, RunFileError, StudyError
from bondem.study.programme import read
from tests.specimens import spheres

EXAMPLES = sorted(Path("examples").glob("*.toml"))
QUIET = settings(
    max_examples=100, deadline=None, derandomize=True,
    suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow],
)  # fmt: skip
EDIT = st.tuples(
    st.sampled_from(["cut", "put", "twice", "turn"]), st.floats(0, 1), st.integers(1, 80),
    st.sampled_from([b"[", b"]", b'"', b"=", b"nan", b"-", b"0", b"\n", b"\xff", b"specimen", b"1e400", b"{"]),
)  # fmt: skip


def edited(data: bytes, edits: list[tuple[str, float, int, bytes]]) -> bytes:
    for kind, where, length, new in edits:
        at = int(where * max(len(data) - 1, 0))
        part = data[at : at + length]
        turned = bytes(255 - byte for byte in part)
        middle = {"cut": b"", "put": new + part, "twice": part + part, "turn": turned}[kind]
        data = data[:at] + middle + data[at + length :]
    return data


def check_line(error: Exception) -> None:
    assert "\n" not in str(error)
    assert len(str(error)) < 600


@QUIET
@given(st.sampled_from(EXAMPLES), st.lists(EDIT, min_size=1, max_size=4))
def test_a_damaged_study_is_read_or_refused_in_one_line(tmp_path: Path, example: Path, edits: list) -> None:
    (tmp_path / "study.toml").write_bytes(edited(example.read_bytes(), edits))
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            read(tmp_path / "study.toml")
    except StudyError as error:
        check_line(error)
        assert str(error).startswith((f"{tmp_path}", "study '"))  # noqa: PT017


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    body = spheres(bd.Box((4e-3, 2e-3, 2e-3)), 100)
    model = bd.Model(body, bd.Timoshenko(E=1e9, nu=0.3, radius_ratio=0.5), density=2000.0)
    path = tmp_path_factory.mktemp("run") / "run.h5"
    bd.solve_explicit(model, duration=0.0, out=path)
    return path


@QUIET
@given(st.lists(EDIT, min_size=1, max_size=3))
def test_a_damaged_run_file_is_what_was_written_or_refused(tmp_path: Path, run: Path, edits: list) -> None:
    whole = bd.read_run(run)
    (tmp_path / "run.h5").write_bytes(edited(run.read_bytes(), edits))
    try:
        bd.read_contents(tmp_path / "run.h5")
        found = bd.read_run(tmp_path / "run.h5")
    except RunFileError as error:
        check_line(error)
    else:
        for name in type(whole.state).ARRAYS:
            np.testing.assert_array_equal(getattr(found.state, name), getattr(whole.state, name))
        np.testing.assert_array_equal(found.model.mass, whole.model.mass)


def test_a_head_that_cannot_be_read_is_damage(run: Path, tmp_path: Path) -> None:
    """It was an error of HDF5's: found by fuzzing."""
    data = bytearray(run.read_bytes())
    at = data.find(b"bondem_version")
    data[at] ^= 1  # the checksum of the header is another one now
    (tmp_path / "run.h5").write_bytes(data)
    for reader in (bd.read_contents, bd.read_run):
        with pytest.raises(RunFileError, match=r"damaged|not a run file"):
            reader(tmp_path / "run.h5")


@pytest.fixture(scope="module")
def saved(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    body, folder = spheres(bd.Box((4e-3, 2e-3, 2e-3)), 100), tmp_path_factory.mktemp("saved")
    bd.save_particles(folder / "own.h5", body)
    bd.write_vtkhdf(folder / "own.vtkhdf", body)
    return {path.suffix: path for path in folder.iterdir()}


@pytest.mark.parametrize("suffix", [".h5", ".vtkhdf"])
def test_damaged_particles_are_what_was_written_or_refused_in_one_line(
    tmp_path: Path, saved: dict[str, Path], suffix: str
) -> None:
    """Every file is cut somewhere, has one changed bit, or 512 bytes of zeros, as a disk leaves them."""
    random, path = np.random.default_rng(3), tmp_path / f"damaged{suffix}"
    whole, data = bd.read_lattice(saved[suffix]), saved[suffix].read_bytes()
    for number in range(100):
        broken, at = bytearray(data), int(random.integers(len(data)))
        if number < 25:
            broken = broken[: len(data) * number // 25]
        else:
            broken[at] ^= 1 << int(random.integers(8))
            broken[at : at + 512 * (number % 3 == 0)] = bytes(len(broken[at : at + 512 * (number % 3 == 0)]))
        path.write_bytes(broken)
        try:
            found = bd.read_lattice(path)
        except (InputError, RunFileError) as error:
            check_line(error)
        else:
            np.testing.assert_array_equal(found.particles.position, whole.particles.position)
            np.testing.assert_array_equal(found.particles.radius, whole.particles.radius)
            np.testing.assert_array_equal(found.pairs, whole.pairs)


X = "".join(f"{k + 1} 1 1 2e-3 2500 {2e-3 * k:g} 0 0\n" for k in range(4))
TEXTS = {
    "a.csv": "x,y,z,r\n0,0,0,1e-3\n2e-3,0,0,1e-3\n4e-3,0,0,1e-3\n",
    "a.txt": "#format x_y_z_r\n0 0 0 1e-3\n2e-3 0 0 1e-3\n4e-3 0 0 1e-3\n",
    "a.xyz": '2\nLattice="1 0 0 0 1 0 0 0 1" pbc="T T T" Properties=pos:R:3:radius:R:1\n0 0 0 1e-3\n2e-3 0 0 1e-3\n',
    "a.data": f"x\n\n4 atoms\n1 bonds\n0 1 xlo xhi\n\nAtoms # bpm/sphere\n\n{X}\nBonds\n\n1 1 1 2\n",
    "a.dump": "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp pp\n0 1\n0 1\n0 1\n"
              "ITEM: ATOMS id x y z radius\n1 0 0 0 1e-3\n",
    "a.off": "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n",
    "a.obj": "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n",
}  # fmt: skip


@pytest.mark.filterwarnings("ignore::UserWarning")
@pytest.mark.parametrize("name", TEXTS)
def test_damaged_texts_are_read_or_refused_in_one_line(tmp_path: Path, name: str, capfd) -> None:
    """Words that are no numbers, bytes that are no text, and parts that are missing, as fuzzing tries them."""
    random, data, path = np.random.default_rng(4), TEXTS[name].encode(), tmp_path / name
    bad = [b"nan", b"-1", b"1e400", b"9" * 5000, b"\0", b"\xff\xfe", b"inf", b"", b"\n", b"#", b'"', b"1e-320"]
    for _ in range(80):
        at = int(random.integers(len(data)))
        path.write_bytes(data[:at] + bad[int(random.integers(len(bad)))] + data[at + int(random.integers(9)) :])
        try:
            bd.Surface(path, unit="mm") if name in ("a.off", "a.obj") else bd.read_particles(path)
        except InputError as error:
            check_line(error)
    assert capfd.readouterr() == ("", "")  # nor do libraries say anything
