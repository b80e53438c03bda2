"""Compiling the core: what has changed, what does not compile, other machines, and the library with sanitizers."""

import os
import shutil
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest

from bondem import _core, _core_build
from bondem._core_build import LOOPS, SOURCES, Platform, compile_core, source_digest

ROOT = Path(__file__).resolve().parents[2]
SMALL = 'extern "C" __attribute__((visibility("default"))) int answer() { return %s; }\n'
needs_compiler = pytest.mark.skipif(_core_build.compiler() is None, reason="needs ziglang")


def small_core(folder: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    # what the compiler knows already of this machine is the longer part
    monkeypatch.setenv("ZIG_GLOBAL_CACHE_DIR", str(SOURCES / "build"))
    (folder / "core").mkdir()
    (folder / "core/index.cpp").write_text(SMALL % 1)
    return folder / "core"


@needs_compiler
def test_a_changed_source_is_another_library_which_replaces_the_former(tmp_path, monkeypatch):
    folder, target = small_core(tmp_path, monkeypatch), Platform.named(None)
    level = target.levels[0]
    (first,) = compile_core(target, [level], folder=folder)
    assert first.name == f"{level}.{source_digest(folder)}{target.suffix}"
    (folder / "index.cpp").write_text(SMALL % 2)
    (second,) = compile_core(target, [level], folder=folder)
    assert second != first
    assert second.is_file()
    assert not first.exists()


@needs_compiler
def test_a_source_that_does_not_compile_is_named(tmp_path, monkeypatch):
    folder, target = small_core(tmp_path, monkeypatch), Platform.named(None)
    (folder / "index.cpp").write_text("int answer() { return unknown; }\n")
    with pytest.raises(RuntimeError, match=r"(?s)does not compile.*index.cpp:1.*unknown"):
        compile_core(target, target.levels[:1], folder=folder)


def test_wheels_leave_out_the_loops_by_which_tests_simulate_a_device(monkeypatch):
    target = Platform.named(None)
    level = target.levels[-1]
    whole, shipped = (set(target.made_of(name, SOURCES)[1]) for name in (level + LOOPS, level))
    assert whole - shipped == {SOURCES / "loops.cpp"}
    of_a_wheel = replace(_core._library(), index_loops={})
    monkeypatch.setattr(_core, "_library", lambda: of_a_wheel)
    with pytest.raises(ImportError, match="only a source tree"):
        _core.index_loop("load_beam")


def test_without_a_compiler_it_is_said_what_to_install(tmp_path, monkeypatch):
    monkeypatch.setattr(_core_build, "compiler", lambda: None)
    with pytest.raises(RuntimeError, match="pip install ziglang"):
        compile_core(Platform.named(None), ["x86_64_v2"], folder=tmp_path)


def test_another_compiler_gets_the_flags_of_any_clang(monkeypatch):
    monkeypatch.setenv("BONDEM_CXX", "clang++-19 --sysroot=/there")
    assert _core_build.compiler() == ["clang++-19", "--sysroot=/there"]
    target = Platform("x86_64", "linux")
    assert target.flags("x86_64_v4") == ["-march=x86-64-v4", "-mprefer-vector-width=512"]
    assert Platform("aarch64", "macos").flags("aarch64") == []


def test_targets_have_the_tags_of_their_wheels():
    tags = {
        "x86_64-linux": "py3-none-manylinux_2_17_x86_64", "aarch64-linux": "py3-none-manylinux_2_17_aarch64",
        "aarch64-macos": "py3-none-macosx_11_0_arm64", "x86_64-windows": "py3-none-win_amd64",
    }  # fmt: skip
    assert {name: Platform.named(name).tag for name in tags} == tags
    with pytest.raises(ValueError, match="target = riscv64-linux"):
        Platform.named("riscv64-linux")


@needs_compiler
@pytest.mark.parametrize(("level", "seen", "unseen"), [
    ("x86_64_v2", "xmm", "ymm"), ("x86_64_v3", "vfmadd", "zmm"), ("x86_64_v4", "zmm", "nothing"),
])  # fmt: skip
def test_levels_for_windows_differ_in_our_instructions_only(level, seen, unseen, tmp_path, monkeypatch):
    """One C library serves all levels, because the compiler makes it anew for each `-mcpu`, for minutes."""
    monkeypatch.setenv("ZIG_GLOBAL_CACHE_DIR", str(SOURCES / "build"))
    flags = Platform.named("x86_64-windows").flags(level)
    others = [flag for flag in flags if flag.startswith("-m") and not flag.startswith("-mprefer")]
    assert others == ["-mcpu=x86_64_v2"]
    source = tmp_path / "loop.cpp"
    source.write_text("void f(double *a, double *b, int n) { for (int i = 0; i < n; i++) a[i] += a[i] * b[i]; }\n")
    command = _core_build.compiler()
    assert command is not None
    asked = [*command, *_core_build._FLAGS[:5], *flags, "-S", "-o", str(tmp_path / "loop.s"), str(source)]
    subprocess.run(asked, check=True, capture_output=True)
    made = (tmp_path / "loop.s").read_text()
    assert seen in made
    assert unseen not in made


def test_the_core_needs_no_standard_library_and_allocates_nothing():
    sources = [path for path in SOURCES.rglob("*.[ch]pp") if "build" not in path.parts]
    lines = [line.partition("//")[0] for path in sources for line in path.read_text().splitlines()]
    allowed = {"stddef.h", "stdint.h", "pthread.h", "unistd.h", "cpuid.h"}
    assert {line.split("<")[1].split(">")[0] for line in lines if line.startswith("#include <")} == allowed
    assert not [line for line in lines for word in ("throw", "new ", "malloc", "std::") if word in line]


SANITIZERS = {"address": "libasan.so", "thread": "libtsan.so"}
# Tests that run with them, without those that compare numbers: another compiler rounds otherwise.
TESTED = (
    "tables", "passes", "steps", "beams", "breakage", "beam_softening", "stress_criteria", "lagged_steps",
    "dynamic_relaxation", "cells", "facet_breakage", "cohesive_cracks", "crack_laws", "stress_onset", "contacts",
)


@pytest.mark.sanitize
@pytest.mark.parametrize("kind", SANITIZERS)
def test_sanitizers_find_nothing_in_the_tests_of_the_core(kind, tmp_path):
    gcc = shutil.which("g++")
    if gcc is None or not sys.platform.startswith("linux"):
        pytest.skip("needs g++, whose sanitizers can be loaded into Python")
    library = tmp_path / "core.so"
    checks = f"-fsanitize={kind}" + (",undefined" if kind == "address" else "")
    flags = [
        "-x", "c++", "-std=c++17", "-O1", "-g", "-DBONDEM_CHECKED", "-fno-exceptions", "-fno-rtti", "-fPIC",
        "-shared", "-pthread", "-Wno-psabi", checks, "-fno-sanitize-recover=undefined",
    ]  # fmt: skip
    sources = [str(path) for path in SOURCES.rglob("*.cpp") if "build" not in path.parts]
    subprocess.run([gcc, *flags, *sources, "-o", str(library)], check=True)
    asked = [gcc, f"-print-file-name={SANITIZERS[kind]}"]
    runtime = subprocess.run(asked, capture_output=True, text=True, check=True)
    environment = os.environ | {
        "BONDEM_CORE": str(library), "LD_PRELOAD": runtime.stdout.strip(), "ASAN_OPTIONS": "detect_leaks=0",
    }  # fmt: skip
    tests = [f"tests/core/test_{name}.py" for name in TESTED]
    done = subprocess.run(
        [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "-k", "not former", *tests], cwd=ROOT,
        env=environment, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stdout + done.stderr
    assert "Sanitizer" not in done.stderr
