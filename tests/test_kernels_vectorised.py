"""The loops of a step must be packed arithmetic: without it they run several times slower and say nothing."""

import re
from collections.abc import Callable

import llvmlite.binding as llvm
import numba
import numpy as np
import pytest

import bondem as bd
from bondem._compile import LANES
from bondem.kernels.bond_pass import bond_loads
from bondem.kernels.element_pass import move
from bondem.kernels.incremental import incremental_loads
from bondem.kernels.tables import Elements, StepScheme
from bondem.laws.beam_energy import bond_force
from bondem.model.blocks import Blocks
from tests.specimens import row

ARITHMETIC = re.compile(r"^\s+v(?:fn?m(?:add|sub)\d+|mul|add|sub|div|sqrt)([ps])d\s(.*)$", re.MULTILINE)


def arguments() -> dict[str, tuple]:
    """What each loop takes in a run, for a model of two bonds."""
    model = bd.Model(row(3, 1.0), bd.EulerBernoulli(E=1.0, nu=0.3, radius=0.1), 1.0)
    state, layout = model.state(), model.layout
    bonds = model.bonds.rows(layout, model.period, state.integrity, alike=True)
    cut = Blocks.of(layout, 4000, 1, np.zeros(3, dtype=bool)).table()
    elements = Elements(state.pose, state.motion, state.acceleration, state.loss, state.rest, np.zeros(0))
    rows = model.constraints.rows(state.reaction, state.work)
    scheme = StepScheme(1e-3, 5e-4, 5e-4, 0.0, 0.0, 0.0)
    ends = cut.sums, cut.row_i, cut.row_j, 0, 2
    return {
        "bonds": (state.pose, bonds, model.bonds.alike, *ends[:3], None, *ends[3:]),
        "incremental": (elements, bonds, np.zeros((6, len(bonds.i))), 1e-3, *ends),
        "elements": (elements, cut.sums, rows, scheme, None, True, cut.ready, cut.ready_row, 0, 3),
    }


LOOPS = {"bonds": bond_loads, "incremental": incremental_loads, "elements": move}


def arithmetic(taken: tuple, loop: Callable) -> tuple[int, int]:
    """Packed and scalar double-precision instructions in the machine code of a loop.

    It is compiled afresh with the kernel's own options: what comes from the disk cache has no assembly.
    """
    options = {key: value for key, value in bond_loads.targetoptions.items() if key not in ("cache", "nopython")}
    types = tuple(numba.typeof(value) for value in taken)
    compiled = numba.njit(types, **options)(loop)
    code = compiled.overloads[types]._asdict()["library"]
    assembly = "".join(part.get_asm_str() for part in (code, *code._linking_libraries))
    found = ARITHMETIC.findall(assembly)
    width = "%zmm" if LANES == 8 else "%ymm"
    packed = sum(kind == "p" and width in registers for kind, registers in found)
    return packed, sum(kind == "s" for kind, _ in found)


@pytest.fixture(autouse=True)
def _needs_avx2() -> None:
    if not llvm.get_process_triple().startswith(("x86_64", "amd64")):
        pytest.skip("reads x86-64 assembly only")
    if not llvm.get_host_cpu_features().get("avx2", False) or numba.config.CPU_NAME is not None:
        pytest.skip("the CPU, or the one numba was told to compile for, has no AVX2")


@pytest.mark.parametrize("name", LOOPS)
def test_loops_of_a_step_are_packed_arithmetic(name: str) -> None:
    packed, scalar = arithmetic(arguments()[name], LOOPS[name].py_func)
    assert packed >= 80
    # scalar: what is common to all bonds, and elements that turn far in one step, one by one
    assert scalar <= (50 * LANES if name == "elements" else 5)


def test_the_count_notices_scalar_arithmetic() -> None:
    """The same law for one bond."""
    numbers = tuple(np.arange(1.0, 21.0))
    packed, scalar = arithmetic(numbers, bond_force.py_func)
    assert packed == 0
    assert scalar >= 100
