"""Spheres from files of VTK: points with an array of radii. Needs VTK, so load this only on use."""

from pathlib import Path
from typing import Any

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkIOLegacy import vtkGenericDataObjectReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader

from bondem.errors import InputError
from bondem.io.raw_spheres import RawSpheres
from bondem.io.vtkhdf_spheres import radii

_READERS = {".vtk": vtkGenericDataObjectReader, ".vtp": vtkXMLPolyDataReader, ".vtu": vtkXMLUnstructuredGridReader}


def read_vtk(path: Path, radius: str | None = None) -> RawSpheres:
    """Spheres from a legacy, PolyData or UnstructuredGrid file.

    Args:
        path: the file, ending in .vtk, .vtp or .vtu.
        radius: name of the point array of radii; default as for `radii`.

    Raises:
        InputError: no points, or no such array, naming the file.
    """
    reader: Any = _READERS[path.suffix.lower()]()
    complaints: list[str] = []
    reader.AddObserver("ErrorEvent", lambda *said: complaints.append(str(said[-1])))
    reader.SetFileName(str(path))
    vtkObject.GlobalWarningDisplayOff()
    reader.Update()
    data: Any = reader.GetOutput()
    if data is None or not hasattr(data, "GetPoints") or data.GetNumberOfPoints() == 0:
        raise InputError(f"'{path}' holds no points that VTK can read; write PolyData or an UnstructuredGrid")
    fields = data.GetPointData()
    arrays = {fields.GetArrayName(k): vtk_to_numpy(fields.GetArray(k)) for k in range(fields.GetNumberOfArrays())}
    centre = np.array(vtk_to_numpy(data.GetPoints().GetData()), dtype=float)
    return RawSpheres(centre, radii(path, arrays, radius))
