"""Import of spheres from VTK files, points with an array of radii."""

import importlib.util
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

from bondem._extras import install
from bondem.errors import InputError
from bondem.io.raw_spheres import RawSpheres
from bondem.io.vtkhdf_spheres import radii

_PROGRAM = Path(__file__).with_name("vtk_arrays.py")
# Longest time for reading a file [s]: a constant part, and a part per megabyte for slow disks.
_START, _PER_MEGABYTE = 60.0, 1.0


def read_vtk(path: Path, radius: str | None = None) -> RawSpheres:
    """Read spheres from a legacy, PolyData or UnstructuredGrid file.

    Args:
        path: the file, with the suffix .vtk, .vtp or .vtu.
        radius: name of the point array of radii; None for the default names of `radii`.

    Raises:
        InputError: VTK is not installed, no points, no such array, or a damaged file; the message states the file.
    """
    if importlib.util.find_spec("vtkmodules") is None:
        raise InputError(
            f"'{path}' needs VTK, which is not installed; {install('view')}, or write the spheres as CSV"
        )
    wanted = "write PolyData or an UnstructuredGrid"
    with tempfile.TemporaryDirectory() as folder:
        result = Path(folder) / "arrays.npz"
        # -P: modules in the folder of the program must not replace those that VTK imports
        command = [sys.executable, "-P", str(_PROGRAM), str(path.absolute()), str(result)]
        patience = _START + _PER_MEGABYTE * path.stat().st_size / 1e6
        try:
            done = subprocess.run(command, capture_output=True, timeout=patience, check=False)
        except subprocess.TimeoutExpired:
            raise InputError(f"'{path}': VTK did not read it within {patience:.0f} s; {wanted}") from None
        if done.returncode or not result.exists():
            said = " ".join(done.stderr.decode(errors="replace").strip().split("\n")[-1].split())
            raise InputError(f"'{path}' has no points that VTK can read ({said[-120:]}); {wanted}")
        with np.load(result) as found:
            arrays = {name.removeprefix("array "): found[name] for name in found.files if name != "centre"}
            return RawSpheres(found["centre"], radii(path, arrays, radius))
