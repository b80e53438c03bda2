"""The bond loop must become packed arithmetic: without it, it runs three to four times slower and says nothing."""

import re
from collections.abc import Callable
from types import FunctionType

import llvmlite.binding as llvm
import numba
import numpy as np
import pytest

import bondem as bd
from bondem.kernels.bond_pass import bond_forces
from bondem.laws.beam_energy import bond_force
from bondem.model.state import State

ARITHMETIC = re.compile(r"^\s+v(?:fn?m(?:add|sub)\d+|mul|add|sub|div|sqrt)([ps])d\s(.*)$", re.MULTILINE)


@pytest.fixture(scope="module")
def arguments() -> tuple:
    lattice = bd.Lattice(bd.Particles([[0.0, 0, 0], [1.0, 0, 0]], [0.5, 0.5]), [(0, 1)])
    model = bd.Model(lattice, bond=bd.EulerBernoulli(E=1.0, nu=0.3, radius=0.1), density=1000.0)
    layout, state = model.layout, State(model)
    whole = (None, state.integrity, model.period, 0, 1, *np.empty((9, 1)))
    return (state.pose, layout.i, layout.j, model.bonds.constants, *whole)


def arithmetic(arguments: tuple, loop: Callable) -> tuple[int, int]:
    """Packed and scalar double-precision instructions in the machine code of a bond loop.

    It is compiled afresh with the kernel's own options: what comes from the disk cache has no assembly.
    """
    options = {key: value for key, value in bond_forces.targetoptions.items() if key not in ("cache", "nopython")}
    options["pipeline_class"] = bond_forces._compiler.pipeline_class
    types = tuple(numba.typeof(value) for value in arguments)
    compiled = numba.njit(types, **options)(loop)
    code = compiled.overloads[types]._asdict()["library"]
    assembly = "".join(part.get_asm_str() for part in (code, *code._linking_libraries))
    found = ARITHMETIC.findall(assembly)
    packed = sum(kind == "p" and ("%ymm" in registers or "%zmm" in registers) for kind, registers in found)
    return packed, sum(kind == "s" for kind, _ in found)


@pytest.fixture(autouse=True)
def _needs_avx2() -> None:
    if not llvm.get_process_triple().startswith(("x86_64", "amd64")):
        pytest.skip("reads x86-64 assembly only")
    if not llvm.get_host_cpu_features().get("avx2", False) or numba.config.CPU_NAME is not None:
        pytest.skip("the CPU, or the one numba was told to compile for, has no AVX2")


def test_bond_forces_are_packed_arithmetic(arguments: tuple) -> None:
    packed, scalar = arithmetic(arguments, bond_forces.py_func)
    assert packed >= 100
    # scalar once more: for the bonds that do not fill a register, and for a fallback that never runs
    assert packed >= 0.45 * scalar


@pytest.mark.parametrize("change", [{"error_model": "python"}, {"forceinline": False}], ids=str)
def test_the_count_notices_a_loop_that_is_not_vectorised(arguments: tuple, change: dict) -> None:
    """With Python's error model, or without forced inlining, of the bond's physics the loop stays scalar."""
    physics = numba.njit(**({"error_model": "numpy", "fastmath": {"contract"}} | change))(bond_force.py_func)
    names = bond_forces.py_func.__globals__ | {"bond_force": physics}
    loop = FunctionType(bond_forces.py_func.__code__, names)
    packed, scalar = arithmetic(arguments, loop)
    assert scalar >= 100
    assert packed == 0
