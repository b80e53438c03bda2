"""Import of spheres from VTK files, points with an array of radii.

The module requires VTK; import it on use only.
"""

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
    """Read spheres from a legacy, PolyData or UnstructuredGrid file.

    Args:
        path: the file, with the suffix .vtk, .vtp or .vtu.
        radius: name of the point array of radii; None for the default names of `radii`.

    Raises:
        InputError: no points, or no such array; the message states the file.
    """
    reader: Any = _READERS[path.suffix.lower()]()
    complaints: list[str] = []
    reader.AddObserver("ErrorEvent", lambda *said: complaints.append(str(said[-1])))
    reader.SetFileName(str(path))
    vtkObject.GlobalWarningDisplayOff()
    reader.Update()
    data: Any = reader.GetOutput()
    if data is None or not hasattr(data, "GetPoints") or data.GetNumberOfPoints() == 0:
        raise InputError(f"'{path}' has no points that VTK can read; write PolyData or an UnstructuredGrid")
    fields = data.GetPointData()
    arrays = {fields.GetArrayName(k): vtk_to_numpy(fields.GetArray(k)) for k in range(fields.GetNumberOfArrays())}
    centre = np.array(vtk_to_numpy(data.GetPoints().GetData()), dtype=float)
    return RawSpheres(centre, radii(path, arrays, radius))
