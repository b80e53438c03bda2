"""What the decorators of compiled code promise: branches decided, no entry for Python, no variant for a constant."""

import errno
import os
import subprocess
import sys
from operator import attrgetter

import numpy as np
import pytest
from llvmlite.binding import Linkage
from numba import typeof, types

from bondem import _compile
from bondem._compile import device, kernel, loop, prange

# Of a compiled function, what numba keeps its machine code in.
code_of = attrgetter("library")


@kernel(parallel=False)
def first_or(table, other):
    if table is not None:
        return table[0]
    return other.no_such_thing  # cannot be compiled


@device
def _first(table, other):
    if table is None:
        return other.no_such_thing
    return table[0]


@kernel(parallel=False)
def first_of(table, other):
    return _first(table, other)


@loop(parallel=False)
def shifted(x, by):
    return x[0] + by


@loop(parallel=False)
def between(x, span):
    return x[span[0]] + span[1]


@kernel(parallel=False)
def shifted_twice(x, by):
    return shifted(x, 1) + shifted(x, by) + between(x, (0, by)) + between(x, (by, by))


def test_a_branch_on_none_is_decided_where_the_argument_is_there():
    table = np.arange(3.0) + 5.0
    assert first_or(table, 1.0) == 5.0
    assert first_of(table, 1.0) == 5.0


def test_the_branch_that_is_taken_is_compiled():
    with pytest.raises(Exception, match="no_such_thing"):
        first_or(None, 1.0)


def test_a_loop_is_for_compiled_code_only():
    with pytest.raises(TypeError, match="decorate it as a kernel"):
        shifted(np.arange(3.0), 1)


def test_constants_make_no_variants():
    x = np.arange(3.0)
    assert shifted_twice(x, 2) == 1.0 + 2.0 + 2.0 + 4.0
    constant, variable = types.Tuple([types.literal(0), types.int64]), typeof((0, 1))
    for one, pair in ((types.literal(1), constant), (types.int64, variable)):
        shifted.get_call_template([typeof(x), one], {})  # what a caller asks for, also where it is on disk itself
        between.get_call_template([typeof(x), pair], {})
    assert len(shifted.signatures) == 1
    assert len(between.signatures) == 1


def test_a_pool_forked_after_threads_gives_the_same_numbers():
    """Numba ended such workers at their first threaded loop, and the pool replaced them for ever."""
    script = (
        "import multiprocessing as mp, warnings, bondem as bd\n"
        "warnings.simplefilter('error')\n"
        "def work(seed):\n"
        "    particles = bd.pack(bd.Box((2.0, 1.0, 1.0)), count=300, seed=seed)\n"
        "    model = bd.Model(bd.connect(particles), bd.EulerBernoulli(E=1e9, nu=0.2, radius_ratio=0.5), 2000.0,\n"
        "                     boundary=[bd.Fix(bd.Face('x_min')), bd.Drive(bd.Face('x_max'), vx=1.0)])\n"
        "    bd.set_threads(2)\n"
        "    state = bd.solve_explicit(model, duration=1e-4).state\n"
        "    return float(state.displacement.sum())\n"
        "first = [work(1), work(2)]\n"
        "with mp.get_context('fork').Pool(2) as pool:\n"
        "    print(pool.map_async(work, [1, 2]).get(90) == first)\n"
    )
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=300, check=False)
    assert done.stdout.split() == ["True"], done.stderr


def test_a_user_without_a_home_has_a_cache(monkeypatch):
    def nobody():
        raise RuntimeError("Could not determine home directory.")

    for name in ("BONDEM_CACHE_DIR", "XDG_CACHE_HOME"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setattr("pathlib.Path.home", nobody)
    assert _compile._cache_root().name.startswith("bondem-")


@kernel(parallel=False)
def doubled(x):
    return 2.0 * x


def test_a_full_disk_costs_the_cache_and_nothing_else(monkeypatch):
    def full(*_):
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(doubled._cache, "_save_overload", full)
    monkeypatch.setattr(doubled._cache, "_load_overload", lambda *_: None)
    monkeypatch.setattr(_compile, "_used", set())
    with pytest.warns(RuntimeWarning, match="No space left on device.*: make room, or set BONDEM_CACHE_DIR"):
        assert doubled(2.0) == 4.0


def test_what_is_only_linked_has_no_machine_code_of_its_own(monkeypatch, tmp_path):
    monkeypatch.setattr(_compile, "cache_directory", tmp_path)
    inner = loop(parallel=False)(shifted.py_func)
    monkeypatch.setitem(globals(), "shifted", inner)
    assert kernel(parallel=False)(shifted_twice.py_func)(np.arange(3.0), 2) == 9.0
    (made,) = inner.overloads.values()
    assert code_of(made).get_pointer_to_function(made.fndesc.llvm_func_name) == 0


def long_sum(x, power):
    total = 0.0
    for k in range(len(x)):
        total += np.sin(x[k]) * np.exp(-x[k]) + np.cos(x[k]) ** power + np.arctan2(x[k], power)
        if total > 1e3:
            total -= np.log(total) + np.tanh(x[k]) * np.sqrt(np.abs(x[k]))
    return total


def two_sums(x):
    return long_sum(x, 2.0) + long_sum(x, 3.0)


def linkages(made):
    """Of all functions of compiled code, by name."""
    return {one.name: one.linkage for one in code_of(made)._final_module.functions if not one.is_declaration}


def test_a_kernel_calls_its_own_copies_of_what_it_is_linked_from(monkeypatch, tmp_path):
    """Where copies were visible, the first that a process loads would serve all kernels, by the order of loading."""
    monkeypatch.setattr(_compile, "cache_directory", tmp_path)
    inner = loop(parallel=False)(long_sum)
    monkeypatch.setitem(globals(), "long_sum", inner)
    outer = kernel(parallel=False)(two_sums)
    outer(np.ones(3))
    (linked,), (made,) = inner.overloads.values(), outer.overloads.values()
    linkage = linkages(made)
    assert linkage[linked.fndesc.llvm_func_name] is Linkage.internal
    assert set(linkage.values()) == {Linkage.internal, Linkage.external}
    assert linkage[made.fndesc.llvm_func_name] is Linkage.external


def sums_of_all(x, out):
    for k in prange(len(out)):
        out[k] = long_sum(x, 1.0 + k)


def all_sums(x, out):
    sums_of_all(x, out)


def test_what_threads_call_is_a_copy_of_the_kernel_too(monkeypatch, tmp_path):
    """Numba keeps it visible in a way of its own; without this a run on two threads was not that on one."""
    monkeypatch.setattr(_compile, "cache_directory", tmp_path)
    monkeypatch.setitem(globals(), "long_sum", loop(parallel=False)(long_sum))
    monkeypatch.setitem(globals(), "sums_of_all", loop(parallel=True)(sums_of_all))
    outer = kernel(parallel=False)(all_sums)
    outer(np.ones(3), np.empty(2))
    (made,) = outer.overloads.values()
    linkage = linkages(made)
    assert any("gufunc" in name for name in linkage)
    assert [name for name, kind in linkage.items() if kind is not Linkage.internal] == [
        made.fndesc.llvm_func_name,
        made.fndesc.llvm_cpython_wrapper_name,
    ]


_LOOKS_UP = """
import numpy as np
from bondem.kernels.non_local import small_extra_forces

pairs, one, three = np.array([[0, 1]]), np.ones(1), np.ones((1, 3))
small_extra_forces(pairs, one, one, 0.2, True, three, np.ones((2, 6)), three, np.empty((1, 3)))
print(sum(small_extra_forces.stats.cache_hits.values()))
"""


def test_code_for_another_cpu_in_a_shared_cache_is_never_used(tmp_path):
    """Two machines with one cache directory: each finds what it compiled itself, and nothing else."""
    other = {"NUMBA_CPU_NAME": "generic", "NUMBA_CPU_FEATURES": ""}
    shared = {"BONDEM_CACHE_DIR": str(tmp_path), "BONDEM_LANES": "4"}

    def found(**cpu):
        environment = {name: value for name, value in os.environ.items() if not name.startswith("NUMBA_CPU")}
        done = subprocess.run(
            [sys.executable, "-c", _LOOKS_UP], env=environment | shared | cpu, capture_output=True, text=True,
            check=True,
        )
        return int(done.stdout)

    assert [found(**other), found(), found(**other), found()] == [0, 0, 1, 1]
