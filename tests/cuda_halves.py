"""What small runs that change sides half-way share: states as they are handed over, and what processes leave."""

import pickle
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

import bondem as bd
import device_cases
from bondem.kernels.cell_pass import STRESS
from bondem.solve.plan import ExplicitResult

#: Arrays of the states of bodies that break.
FIELDS = "pose", "motion", "acceleration", "loss", "work", "reaction", "integrity", "released", "broken"
#: Carries out the cases on a device, "gpu" or "cpu", from states that were handed over, and hands its own over.
Results = Callable[[str, dict[str, Any], dict[str, Any]], Iterator[tuple[str, ExplicitResult]]]


def start(model: bd.Model, kept: dict[str, Any]) -> bd.State:
    """A state with the arrays and numbers that were kept of another one."""
    state = device_cases.moving(model)
    for name, value in kept.items():
        setattr(state, name, value)
    return state


def kept(state: bd.State, fields: tuple[str, ...]) -> dict[str, Any]:
    """What `start` takes: arrays of these names, and the numbers of a state."""
    return {name: getattr(state, name) for name in (*fields, "step", "time", "stale")}


def leave_cells(results: Results, fields: tuple[str, ...]) -> None:
    """Carry out cases of cells as the command line says (gpu|cpu OUT.npz BODIES IN HANDED); write what they leave.

    Args:
        results: of the cases.
        fields: arrays of states.
    """
    device, out, bodies, source, target = sys.argv[1:]
    if Path(bodies).is_file():
        device_cases.BODIES.update(pickle.loads(Path(bodies).read_bytes()))
    given = pickle.loads(Path(source).read_bytes()) if Path(source).is_file() else {}
    arrays: dict[str, np.ndarray] = {}
    handed: dict[str, Any] = {}
    for name, result in results(device, given, handed):
        for field in fields:
            arrays[f"{name}/{field}"] = getattr(result.state, field)
        arrays[f"{name}/pose"] = np.delete(result.state.pose, STRESS, axis=1)
        arrays[f"{name}/stress"] = result.state.pose[:, STRESS]
        arrays[f"{name}/records"] = result.history.records
        arrays[f"{name}/end"] = np.array([result.status.name, result.message])
    for name, half in handed.items():
        if "cracks" in half:
            arrays[f"{name}/half_cracks"] = half["cracks"]
    np.savez(out, **arrays)
    Path(bodies).write_bytes(pickle.dumps(device_cases.BODIES))
    Path(target).write_bytes(pickle.dumps(handed))


def leave(results: Results, fields: tuple[str, ...]) -> None:
    """The same of beams, which need no bodies: gpu|cpu OUT.npz IN HANDED."""
    device, out, source, target = sys.argv[1:]
    given = pickle.loads(Path(source).read_bytes()) if Path(source).is_file() else {}
    arrays: dict[str, np.ndarray] = {}
    handed: dict[str, Any] = {}
    for name, result in results(device, given, handed):
        for field in fields:
            arrays[f"{name}/{field}"] = getattr(result.state, field)
        arrays[f"{name}/records"] = result.history.records
        arrays[f"{name}/end"] = np.array([result.status.name, result.message])
    np.savez(out, **arrays)
    Path(target).write_bytes(pickle.dumps(handed))
