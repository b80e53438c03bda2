"""Try what is installed by `pip install .` alone, without pytest: python tests/clean_install.py

Imports, a small body that tears, its files, surfaces in encodings of CAD programs and damaged ones, and the commands.
It prints what it tried; a failure is a traceback, and exit status 1.
"""

import io
import os
import struct
import subprocess
import sys
import tempfile
from contextlib import redirect_stdout
from pathlib import Path

import numpy as np

import bondem as bd
from bondem.cli import bondem
from bondem.errors import InputError

STUDY = """
name = "small"
packings = 1
tests = ["static_tension"]
[material]
name = "glass"
E = 1e10
nu = 0.2
rho = 2000.0
[specimen]
shape = "cylinder"
radius = 5e-3
length = 20e-3
count = 150
[bond]
law = "CellBond"
[output]
figures = false
"""
CORNERS = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
SIDES = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
CUBE = [tuple(CORNERS[k] for k in one) for a, b, c, d in SIDES for one in ((a, b, c), (a, c, d))]


def every_name() -> None:
    """Import every public name."""
    for name in dir(bd):
        getattr(bd, name)


def a_run_and_its_files(folder: Path) -> None:
    """Tear a bar, draw it, and read what was written."""
    body = bd.connect(bd.pack(bd.Box((4e-3, 2e-3, 2e-3)), count=60, method="even", seed=1), method="laguerre")
    torn = bd.MohrCoulomb(tension=2e6, cohesion=6e6, friction_angle=0.6)
    ends = [bd.Fix(bd.Face("x_min")), bd.Drive(bd.Face("x_max"), vx=bd.Ramp(0.0, 1.0, 5e-6))]
    model = bd.Model(body, bd.CellBond(E=30e9, nu=0.2), density=2500.0, failure=torn, boundary=ends)
    run = bd.solve_explicit(model, duration=2e-5, out=folder / "run.h5", snapshot_every=50)
    assert len(run.state.broken), "nothing broke"
    assert bd.read_run(folder / "run.h5").state.step == run.state.step
    bd.export(folder / "body.csv", body, state=run.state)
    bd.write_vtkhdf(folder / "body.vtkhdf", body, state=run.state)
    bd.save_particles(folder / "body.h5", body)
    assert len(bd.read_lattice(folder / "body.h5").pairs) == len(body.pairs)
    body.plot(folder / "body.png")


def surfaces(folder: Path) -> None:
    """Read cubes whose names are in other encodings, and refuse files that are cut."""
    path = folder / "cube.stl"
    for name, encoding in (("Körper", "latin-1"), ("Prüfling – 5°", "cp1252"), ("立方体", "gbk"), ("куб", "koi8-r")):
        facets = "".join(
            "facet normal 0 0 1\nouter loop\n" + "".join("vertex {} {} {}\n".format(*corner) for corner in one)
            + "endloop\nendfacet\n" for one in CUBE
        )  # fmt: skip
        path.write_bytes(f"solid {name}\n{facets}endsolid {name}\n".encode(encoding))
        assert np.isclose(bd.Surface(path, unit="mm").volume, 1e-9), encoding
    binary = bytes(80) + struct.pack("<I", 12)
    binary += b"".join(struct.pack("<12fH", 0, 0, 0, *np.ravel(one), 0) for one in CUBE)
    path.write_bytes(binary)
    assert np.isclose(bd.Surface(path, unit="mm").volume, 1e-9)
    path.write_bytes(binary[:-30])
    message = ""
    try:
        bd.Surface(path, unit="mm")
    except InputError as error:
        message = str(error)
    assert "cut" in message, f"a file that was cut: {message or 'it was read'}"  # and no module is missing


def commands(folder: Path) -> None:
    """Run each command that needs no extra."""
    (folder / "study.toml").write_text(STUDY, encoding="utf-8")
    python = [sys.executable, *(["-S"] if sys.flags.no_site else [])]
    for given in (["check", "study.toml"], ["run", "study.toml", "--out", "out"]):
        done = subprocess.run(
            [*python, "-c", "from bondem.cli import main; main()", *given], cwd=folder, capture_output=True,
            text=True, encoding="cp1252", env=os.environ | {"PYTHONIOENCODING": "cp1252"}, check=False,
        )  # fmt: skip
        assert done.returncode == 0, f"bondem {' '.join(given)}: {done.returncode}\n{done.stderr}"
    assert (folder / "out" / "report.html").stat().st_size > 1000
    run, new = str(folder / "run.h5"), str(folder / "new.toml")
    for given in (["new", "cells", new], ["info", run], ["export", run, run + ".csv"], ["schema"]):
        with redirect_stdout(io.StringIO()) as text:
            bondem.main(given, standalone_mode=False)
        assert text.getvalue() or given[0] == "export", given


def main() -> None:
    """Try everything in a temporary folder."""
    print(f"bondem {bd.__version__} in {Path(bd.__file__).parent}")
    every_name()
    with tempfile.TemporaryDirectory() as name:
        for part in (a_run_and_its_files, surfaces, commands):
            part(Path(name))
            print(f"{part.__name__}: works")


if __name__ == "__main__":
    main()
