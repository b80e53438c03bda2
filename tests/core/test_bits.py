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
from bondem._core import Pass, compiled_level
from bondem.packing.packing_tables import Near, PackingWalls, Relaxing, Spheres
from bondem.packing.start import thrown

relax = Pass("relax_spheres", Spheres, PackingWalls, Near, Relaxing)

# Prints the level, and a hash of a packing, of its cells, and of beams after some steps.
SCRIPT = """
import hashlib, bondem as bd
from bondem._core import compiled_level
p = bd.pack(bd.Box(size=(1.0, 1.0, 1.0)) - bd.Ball(radius=0.5), count=300, spread=0.3, seed=2)
b = bd.connect(p, method="laguerre")
drive, law = bd.Drive(bd.Face("x_min"), vx=bd.Ramp(0.0, 1.0, 1e-3)), bd.Timoshenko(E=1e9, nu=0.3, radius_ratio=0.7)
run = bd.solve_explicit(bd.Model(bd.connect(p), law, 2500.0, boundary=[drive]), duration=5e-3, every=20)
parts = p.position, p.radius, b.facets.area, b.facets.centroid, b.cells.volume, b.cells.inertia
parts += run.state.pose, run.state.motion, run.history.records
ends = [bd.Fix(bd.Face("x_min")), bd.Drive(bd.Face("x_max"), vx=bd.Ramp(0.0, 2.0, 1e-4))]
weak = bd.Elliptic(elongation=1e-3, rotation=3e-3), bd.PeripheralStress(tension=8e5, shear=8e5, fracture_energy=9e1)
for failure in weak:
    model = bd.Model(bd.connect(p), law, 2500.0, boundary=ends, failure=failure)
    run = bd.solve_explicit(model, duration=5e-3, every=20)
    assert len(run.state.broken) > 5, len(run.state.broken)
    parts += run.state.pose, run.state.broken, run.state.softened, run.history.records
print(compiled_level(), hashlib.sha256(b"".join(part.tobytes() for part in parts)).hexdigest(), float(p.radius.sum()))
"""


def run_at(level: str, library: Path | None = None) -> tuple[str, str, float]:
    environment = os.environ | {"BONDEM_ISA": level} | ({"BONDEM_CORE": str(library)} if library else {})
    done = subprocess.run(
        [sys.executable, "-c", SCRIPT], env=environment, capture_output=True, text=True, check=True, timeout=1800
    )
    found, digest, total = done.stdout.split()
    return found, digest, float(total)


def levels() -> list[str]:
    """The levels of this CPU, the lowest first."""
    known = ["v2", "v3", "v4"]
    return known[: known.index(compiled_level().rpartition("_")[2]) + 1]


@pytest.mark.skipif(not compiled_level().startswith("x86_64"), reason="one level only")
def test_levels_give_the_same_numbers_and_with_fused_multiply_add_the_same_bits():
    found = {level: run_at(level) for level in levels()}
    assert [level for level, _, _ in found.values()] == [f"x86_64_{level}" for level in found]
    assert len({digest for level, (_, digest, _) in found.items() if level != "v2"}) == 1
    totals = [total for _, _, total in found.values()]
    assert totals == pytest.approx([totals[0]] * len(totals), rel=1e-9)


@pytest.mark.skipif(_core_build.compiler() is None, reason="needs ziglang")
@pytest.mark.skipif(not compiled_level().startswith("x86_64"), reason="levels of x86-64")
def test_a_build_without_optimisation_has_the_same_bits(tmp_path, monkeypatch):
    monkeypatch.setattr(_core_build, "_FLAGS", ["-O0" if flag == "-O3" else flag for flag in _core_build._FLAGS])
    monkeypatch.setenv("ZIG_GLOBAL_CACHE_DIR", str(_core_build.SOURCES / "build"))
    folder = tmp_path / "core"
    shutil.copytree(_core_build.SOURCES, folder, ignore=shutil.ignore_patterns("build", "libraries"))
    (debug,) = _core_build.compile_core(_core_build.Platform.named(None), [compiled_level()], folder=folder)
    level = levels()[-1]
    assert run_at(level, debug) == run_at(level)


def test_an_unknown_level_is_refused():
    done = subprocess.run(
        [sys.executable, "-c", "from bondem._core import compiled_level; compiled_level()"],
        env=os.environ | {"BONDEM_ISA": "v9"}, capture_output=True, text=True, check=False, timeout=1800,
    )  # fmt: skip
    assert "BONDEM_ISA = v9: this CPU offers v2" in done.stderr


def relaxed(threads: int) -> str:
    spheres = thrown(bd.Ball(radius=1.0), np.linspace(1.0, 1.3, 700), 0.66, np.random.default_rng(5))
    near = spheres.near(0.5 * spheres.mean_radius, 0.499, threads=threads)
    relaxing = Relaxing.of(700, 1e-6, 0.0)._replace(steps=30)
    relax(spheres.table, spheres.walls, near, relaxing, threads=threads)
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
