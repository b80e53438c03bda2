"""Program that reads points and point arrays of a VTK file by VTK, run in a separate process.

VTK aborts its process if a damaged file declares more data than memory. This file imports nothing of bondem.

Run: python vtk_arrays.py FILE RESULT.npz
"""

import sys
from pathlib import Path
from typing import Any

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOLegacy import vtkGenericDataObjectReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader

_READERS = {".vtk": vtkGenericDataObjectReader, ".vtp": vtkXMLPolyDataReader, ".vtu": vtkXMLUnstructuredGridReader}


def write_arrays(path: str, result: str) -> None:
    """Save points as "centre" and point arrays as "array NAME" in an .npz file; exit with a message on failure."""
    reader: Any = _READERS[Path(path).suffix.lower()]()
    complaints: list[str] = []

    def on_error(_caller: Any, _event: str, text: str) -> None:
        complaints.append(text)

    on_error.CallDataType = "string0"  # type: ignore[attr-defined]  # how VTK passes the text
    reader.AddObserver("ErrorEvent", on_error)
    reader.SetFileName(path)
    reader.Update()
    data: Any = reader.GetOutput()
    if complaints:
        sys.exit(complaints[0].strip().splitlines()[-1])
    if data is None or not hasattr(data, "GetPoints") or data.GetNumberOfPoints() == 0:
        sys.exit("no points")
    fields = data.GetPointData()
    arrays = [fields.GetArray(k) for k in range(fields.GetNumberOfArrays())]
    named = {f"array {one.GetName()}": vtk_to_numpy(one) for one in arrays if one is not None}
    np.savez(result, centre=np.array(vtk_to_numpy(data.GetPoints().GetData()), dtype=float), **named)


if __name__ == "__main__":
    write_arrays(*sys.argv[1:])
