"""What type checkers say of usual calls: right ones pass, and a wrong word of a choice is an error."""

import re
import subprocess
import sys
from pathlib import Path

RIGHT = """
from pathlib import Path

import numpy as np

import bondem as bd

edges: tuple[float, ...] = (1e-2,) * 3  # what some checkers make of the product
cell, box = bd.Cell((1e-2,) * 3), bd.Box(edges)
box = bd.Box([1e-2, 2e-2, 3e-2]) | bd.Box(np.array([1e-2, 2e-2, 3e-2])).moved([0, 0, 1]).rotated("x", 0.1)
body = bd.connect(bd.pack(box, count=100, method="even"), method="laguerre")
held = [bd.Fix(bd.Face("x_min")), bd.Load(bd.Face("x_max"), force=[0.0, 0.0, 1.0]), bd.BodyForce([0, 0, -9.81])]
law, wall = bd.CellBond(E=1e9, nu=0.2, facet_rotation="full"), bd.PlaneWall([0, 0, 0], np.array([0.0, 0.0, 1.0]))
model = bd.Model(body, law, 2500.0, held, mass_matrix="lumped")
gauges = {"end": bd.Gauge(bd.Face("x_max"), "displacement")}
run = bd.solve_explicit(model, duration=1e-5, gauges=gauges, device="cpu", out=Path("run.h5"))
model.state().velocity = (0, 0, -5)
"""
# A wrong call, and the argument that a checker names.
WRONG = {
    'bd.pack(bd.Ball(1e-3), count=9, method="voronoi")': "method",
    'bd.CellBond(E=1e9, nu=0.2, facet_rotation="twist")': "facet_rotation",
    'bd.Timoshenko(E=1e9, nu=0.2, radius_ratio=0.5, radius_rule="max")': "radius_rule",
    'bd.Gauge(bd.Face("x_min"), "strain")': "quantity",
    'bd.resume("run.h5", device="cuda")': "device",
    'bd.Ball(1e-3).rotated("w", 0.1)': "axis",
    'bd.Rankine(tension=1e6, on="strain")': "on",
}


def checked(folder: Path, text: str) -> str:
    (folder / "pyrefly.toml").write_text('project-includes = ["*.py"]\n')
    (folder / "script.py").write_text(text)
    words = [sys.executable, "-m", "pyrefly", "check", "--python-interpreter-path", sys.executable]
    done = subprocess.run(words, cwd=folder, capture_output=True, text=True, timeout=120, check=False)
    return done.stdout + done.stderr


def test_usual_calls_pass_and_wrong_words_are_errors(tmp_path: Path) -> None:
    said = checked(tmp_path, RIGHT + "\n".join(WRONG) + "\n")
    named = re.findall(r"not assignable to parameter `(\w+)` with type `[^`]*Literal", said)
    assert named == list(WRONG.values()), said
    assert said.count("ERROR") == len(WRONG), said
