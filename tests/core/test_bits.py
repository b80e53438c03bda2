"""Bits of the core: the same on every level of instructions with fused multiply-add, and on any number of threads."""

import hashlib
import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import bondem as bd
from bondem import _core_build
from bondem._core import compiled_level, run_pass
from bondem._passes import calls
from bondem.packing.packing_tables import new_relaxing
from bondem.packing.start import thrown

# Prints the level, a hash of bits, and a number.
SCRIPT = Path(__file__).with_name("hashed_runs.py")


def run_at(level: str, library: Path | None = None) -> tuple[str, str, float]:
    environment = os.environ | {"BONDEM_ISA": level} | ({"BONDEM_CORE": str(library)} if library else {})
    done = subprocess.run(
        [sys.executable, str(SCRIPT)], env=environment, capture_output=True, text=True, check=True, timeout=1800
    )
    found, digest, total = done.stdout.split()
    return found, digest, float(total)


def levels() -> list[str]:
    """The levels of this CPU, the lowest first."""
    known = ["v2", "v3", "v4"]
    present = compiled_level().rpartition("_")[2]
    return known[: known.index(present) + 1] if present in known else []


@pytest.mark.validate
@pytest.mark.skipif(not compiled_level().startswith("x86_64"), reason="one level only")
def test_levels_give_the_same_numbers_and_with_fused_multiply_add_the_same_bits():
    found = {level: run_at(level) for level in levels()}
    assert [level for level, _, _ in found.values()] == [f"x86_64_{level}" for level in found]
    assert len({digest for level, (_, digest, _) in found.items() if level != "v2"}) == 1
    totals = [total for _, _, total in found.values()]
    assert totals == pytest.approx([totals[0]] * len(totals), rel=1e-9)


@pytest.mark.validate
@pytest.mark.skipif(_core_build.compiler() is None, reason="needs ziglang")
@pytest.mark.skipif(not {"v3", "v4"} & set(levels()), reason="two kinds of lanes with fused multiply-add")
def test_without_optimisation_and_with_the_other_number_of_lanes_bits_are_the_same(tmp_path, monkeypatch):
    # AVX2 computes the groups of eight numbers of AVX-512 in halves
    level = levels()[-1]
    lanes = ["-D__AVX512F__", "-Wno-psabi"] if level == "v3" else []
    flags = [flag for flag in _core_build._FLAGS if flag != "-O3"]
    monkeypatch.setattr(_core_build, "_FLAGS", [*flags, "-O0", *lanes])
    monkeypatch.setenv("ZIG_GLOBAL_CACHE_DIR", str(_core_build.SOURCES / "build"))
    folder = tmp_path / "core"
    shutil.copytree(_core_build.SOURCES, folder, ignore=shutil.ignore_patterns("build", "libraries"))
    (debug,) = _core_build.compile_core(_core_build.Platform.named(None), ["x86_64_v3"], folder=folder)
    assert run_at(level, debug)[1:] == run_at(level)[1:]


def test_an_unknown_level_is_refused():
    done = subprocess.run(
        [sys.executable, "-c", "from bondem._core import compiled_level; compiled_level()"],
        env=os.environ | {"BONDEM_ISA": "v9"}, capture_output=True, text=True, check=False, timeout=1800,
    )  # fmt: skip
    assert "BONDEM_ISA = v9: this CPU offers v2" in done.stderr


def relaxed(threads: int) -> str:
    spheres = thrown(bd.Ball(radius=1.0), np.linspace(1.0, 1.3, 700), 0.66, np.random.default_rng(5))
    near = spheres.near(0.5 * spheres.mean_radius, 0.499, threads=threads)
    relaxing = new_relaxing(700, 1e-6, 0.0)._replace(steps=30)
    run_pass(calls.relax_spheres(spheres.table, spheres.walls, near, relaxing), threads=threads)
    parts = near.start, near.neighbour, spheres.sphere, spheres.table.force, relaxing.report
    return hashlib.sha256(b"".join(part.tobytes() for part in parts)).hexdigest()


def test_bits_do_not_depend_on_the_number_of_threads():
    assert len({relaxed(threads) for threads in (1, 2, 3, 4)}) == 1


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork")
def test_a_fork_has_threads_of_its_own():
    # threads of the parent are asleep at the fork; a child that waits for them is ended by the alarm
    code = (
        "import os, signal, sys, time; sys.path.insert(0, '.'); from tests.core.test_bits import relaxed\n"
        "one = relaxed(3); time.sleep(0.2); child = os.fork()\n"
        "if child == 0: signal.alarm(120); os._exit(0 if relaxed(3) == one else 1)\n"
        "assert os.waitpid(child, 0)[1] == 0"
    )
    subprocess.run([sys.executable, "-W", "ignore", "-c", code], check=True, timeout=1800)
