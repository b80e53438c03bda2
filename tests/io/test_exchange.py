"""What other programs read: LAMMPS, CSV, meshio, pandas and xarray."""

from itertools import pairwise
from pathlib import Path
from typing import Any

import meshio
import numpy as np
import pandas as pd
import pytest
from click.testing import CliRunner

import bondem as bd
from bondem.cli.export import command
from bondem.errors import InputError, StressFreeWarning
from tests import specimens


@pytest.fixture(scope="module")
def spheres() -> bd.Lattice:
    return specimens.spheres(bd.Box((4e-2, 2e-2, 2e-2)), 300)


@pytest.fixture(scope="module")
def body() -> bd.Lattice:
    return specimens.bar(200, 4e-2)


def moved(lattice: bd.Lattice) -> bd.State:
    """Under way, with three bonds broken."""
    law = bd.Timoshenko(E=1e9, nu=0.3, radius_ratio=0.5) if lattice.cells is None else bd.CellBond(E=1e9, nu=0.2)
    state = bd.Model(lattice, law, density=2000.0).state()
    random = np.random.default_rng(1)
    state.set_pose(position=lattice.centre + 1e-4 * random.standard_normal(lattice.centre.shape))
    state.set_motion(velocity=random.standard_normal(lattice.centre.shape))
    state.integrity[[3, 17, 40]] = 0.0
    return state


def test_lammps_data_come_back_to_the_bit(spheres: bd.Lattice, tmp_path: Path) -> None:
    path, state = tmp_path / "body.data", moved(spheres)
    bd.export(path, spheres, state=state, density=2000.0)
    with pytest.warns(StressFreeWarning, match=r"bd.export wrote it of a state with displacements.*free of stress"):
        back = bd.read_lattice(path, shape=bd.Box((4.2e-2, 2.2e-2, 2.2e-2)).moved((-1e-3, -1e-3, -1e-3)))
    np.testing.assert_array_equal(back.particles.position, spheres.particles.position + state.displacement)
    np.testing.assert_array_equal(back.particles.radius, spheres.particles.radius)
    np.testing.assert_array_equal(back.pairs, spheres.pairs[state.bond_integrity > 0.0])
    assert len(back.pairs) == len(spheres.pairs) - 3
    text = path.read_text()
    assert "\nAtoms # bpm/sphere\n" in text
    row = text.split("Velocities\n\n")[1].splitlines()[4].split()
    np.testing.assert_array_equal([float(word) for word in row[1:4]], state.velocity[4])


def test_a_dump_holds_what_ovito_looks_for(spheres: bd.Lattice, tmp_path: Path) -> None:
    path, state = tmp_path / "body.dump", moved(spheres)
    load = np.arange(300.0)
    bd.export(path, spheres, state=state, elements={"load": load})
    head, rows = path.read_text().split("ITEM: ATOMS ")
    assert head.splitlines()[:5] == [
        "ITEM: TIMESTEP", "0", "ITEM: NUMBER OF ATOMS", "300", "ITEM: BOX BOUNDS ff ff ff",
    ]  # fmt: skip
    names, *lines = rows.splitlines()
    table = pd.DataFrame([line.split() for line in lines], columns=names.split()).astype(float)
    np.testing.assert_array_equal(table[["x", "y", "z"]], spheres.particles.position + state.displacement)
    np.testing.assert_array_equal(table[["vx", "vy", "vz"]], state.velocity)
    np.testing.assert_array_equal(table["radius"], spheres.particles.radius)
    np.testing.assert_array_equal(table["load"], load)
    with_own = {"velocity_error": load, "load": load}  # which begins as the velocity does
    bd.export(path, spheres, state=state, elements=with_own)
    assert path.read_text().split("ITEM: ATOMS ")[1].splitlines()[0].split()[-2:] == ["velocity_error", "load"]
    back = bd.read_particles(path)
    np.testing.assert_array_equal(back.position, spheres.particles.position + state.displacement)
    low, high = (np.array([line.split() for line in head.splitlines()[5:8]], dtype=float)[:, k] for k in (0, 1))
    assert (low < table[["x", "y", "z"]].min()).all()
    assert (high > table[["x", "y", "z"]].max()).all()


def test_csv_is_a_table_with_a_header(spheres: bd.Lattice, body: bd.Lattice, tmp_path: Path) -> None:
    bd.export(tmp_path / "s.csv", spheres, elements={"stress": np.zeros((300, 9))})
    table = pd.read_csv(tmp_path / "s.csv")
    assert list(table.columns[:5]) == ["x", "y", "z", "radius", "stress_0"]
    back = bd.read_particles(tmp_path / "s.csv", shape=spheres.particles.shape)
    np.testing.assert_array_equal(back.position, spheres.particles.position)
    bd.export(tmp_path / "c.csv", body)
    table = pd.read_csv(tmp_path / "c.csv")
    assert list(table.columns) == ["x", "y", "z", "volume"]
    assert body.cells is not None
    np.testing.assert_array_equal(
        np.loadtxt(tmp_path / "c.csv", delimiter=",", skiprows=1), np.column_stack([body.centre, body.cells.volume])
    )


@pytest.mark.parametrize("suffix", [".vtu", ".vtk", ".xdmf", ".msh"])
def test_meshio_reads_points_and_bonds(spheres: bd.Lattice, tmp_path: Path, suffix: str) -> None:
    path, state = tmp_path / f"body{suffix}", moved(spheres)
    bd.export(path, spheres, state=state)
    mesh, holds = meshio.read(path), spheres.pairs[state.bond_integrity > 0.0]
    np.testing.assert_allclose(mesh.points, spheres.particles.position + state.displacement, rtol=1e-15)
    np.testing.assert_array_equal(np.vstack([one.data for one in mesh.cells if one.type == "line"]), holds)
    np.testing.assert_array_equal(np.ravel(mesh.point_data["radius"]), spheres.particles.radius)


def test_cells_are_polyhedra_of_their_volume(body: bd.Lattice, tmp_path: Path) -> None:
    """By the divergence theorem over the polygons that meshio reads."""
    bd.export(tmp_path / "body.vtu", body, elements={"number": np.arange(200.0)})
    mesh = meshio.read(tmp_path / "body.vtu")
    volume, number = [], []
    for block, numbers in zip(mesh.cells, mesh.cell_data["number"], strict=True):
        for faces, one in zip(block.data, np.ravel(numbers), strict=True):
            total = 0.0
            for face in faces:
                a, *rest = mesh.points[face]
                total += sum(np.linalg.det([a, b, c]) for b, c in pairwise(rest)) / 6.0
            volume.append(total)
            number.append(int(one))
    assert sorted(number) == list(range(200))
    assert body.cells is not None
    np.testing.assert_allclose(volume, body.cells.volume[number], rtol=1e-6)


def test_histories_are_tables_and_arrays() -> None:
    records = np.random.default_rng(1).random((4, 21))
    history = bd.History(records, ("end", "middle"))
    frame, data = history.to_pandas(), history.to_xarray()
    np.testing.assert_array_equal(frame.index, history.time)
    np.testing.assert_array_equal(frame["middle_y"], history["middle"][:, 1])
    np.testing.assert_array_equal(frame["balance"], history.energy["balance"])
    np.testing.assert_array_equal(data["end"].sel(component="z"), history["end"][:, 2])
    np.testing.assert_array_equal(data["work"], history.energy["work"])
    assert data["work"].dims == ("time",)


@pytest.mark.parametrize(("name", "given", "words"), [
    ("x.stp", {}, "unsupported suffix; give one of .csv"),
    ("x.data", {}, "give density="),
    ("x.data", {"density": -1.0}, "density"),
    ("x.csv", {"elements": {"a": np.zeros(3)}}, r"has shape \(3,\); give \(300,\)"),
    ("x.csv", {"elements": {"a": "words"}}, "holds no numbers"),
    ("x.csv", {"elements": [1]}, "fields by name"),
    ("x.csv", {"state": 3}, "a state of a model"),
    ("none/x.csv", {}, "none"),
    ("x.dump", {"elements": {"my load": np.zeros(300)}}, r"field 'my load' has a blank.*use '_' instead"),
    ("x.vtk", {"elements": {"my load": np.zeros(300)}}, r"field 'my load' has a blank"),
    ("x.csv", {"elements": {"radius": np.zeros(300)}}, r"field 'radius' is in the file already"),
    ("x.dump", {"elements": {"id": np.zeros(300)}}, r"field 'id' is in the file already"),
    ("x.csv", {"elements": {"a\nb": np.zeros(300)}}, r"printable characters"),
    ("x.csv", {"elements": {"": np.zeros(300)}}, r"printable characters"),
    ("x.csv", {"elements": {3: np.zeros(300)}}, r"printable characters"),
    ("x.csv", {"elements": {"u": np.zeros((300, 3)), "u_x": np.zeros(300)}}, r"two fields make a column 'u_x'"),
])  # fmt: skip
def test_what_cannot_be_written_is_told(
    spheres: bd.Lattice, tmp_path: Path, name: str, given: dict[str, Any], words: str
) -> None:
    with pytest.raises(InputError, match=words):
        bd.export(tmp_path / name, spheres, **given)
    assert not list(tmp_path.iterdir())


def test_fields_of_a_state_are_not_replaced(spheres: bd.Lattice, tmp_path: Path) -> None:
    state, values = moved(spheres), np.zeros((300, 3))
    for name in ("displacement", "velocity"):
        with pytest.raises(InputError, match=f"field '{name}' is in the file already"):
            bd.export(tmp_path / "x.csv", spheres, state=state, elements={name: values})
        with pytest.raises(InputError, match=f"field '{name}' is in the file already"):
            bd.write_vtkhdf(tmp_path / "x.vtkhdf", spheres, state=state, elements={name: values})
    for name, given in (("a/b", "elements"), ("length", "bonds")):
        with pytest.raises(InputError, match=f"field '{name}'"):
            bd.write_vtkhdf(tmp_path / "x.vtkhdf", spheres, **{given: {name: np.zeros(len(spheres.pairs))}})
    # a comma in a name is quoted, and read as a part of it
    bd.export(tmp_path / "comma.csv", spheres, elements={"a, b": np.zeros(300)})
    back = bd.read_particles(tmp_path / "comma.csv", shape=spheres.particles.shape)
    np.testing.assert_array_equal(back.radius, spheres.particles.radius)


def test_stresses_are_nine_columns_and_tensors(body: bd.Lattice, tmp_path: Path) -> None:
    stress = np.random.default_rng(2).standard_normal((len(body.particles), 3, 3))
    bd.export(tmp_path / "x.csv", body, elements={"stress": stress})
    table = pd.read_csv(tmp_path / "x.csv")
    np.testing.assert_array_equal(table["stress_xz"], stress[:, 0, 2])
    np.testing.assert_array_equal(table["stress_zy"], stress[:, 2, 1])
    bd.export(tmp_path / "x.vtu", body, elements={"stress": stress})
    blocks = meshio.read(tmp_path / "x.vtu").cell_data["stress"]
    assert np.sort(np.vstack(blocks), axis=0) == pytest.approx(np.sort(stress.reshape(-1, 9), axis=0))


def test_hdf5_is_not_written_under_the_suffix_of_another_format(body: bd.Lattice, tmp_path: Path) -> None:
    model = bd.Model(body, bd.CellBond(E=1e9, nu=0.2), density=2000.0)
    for suffix in (".vtu", ".csv", ".VTK"):
        with pytest.raises(InputError, match=f"write_vtkhdf: path = .*x{suffix}': the file is HDF5.*bd.export"):
            bd.write_vtkhdf(tmp_path / f"x{suffix}", body)
        with pytest.raises(InputError, match=r"out = .*the file is HDF5"):
            bd.solve_explicit(model, duration=0.0, out=tmp_path / f"x{suffix}")
    assert not list(tmp_path.iterdir())


def test_cells_are_not_written_as_spheres(body: bd.Lattice, tmp_path: Path) -> None:
    for suffix in (".data", ".msh"):
        with pytest.raises(InputError, match="hold spheres, not cells"):
            bd.export(tmp_path / f"x{suffix}", body, density=1.0)


def test_the_command_exports_runs_and_packings(spheres: bd.Lattice, tmp_path: Path) -> None:
    run, packing = tmp_path / "run.h5", tmp_path / "packing.h5"
    model = bd.Model(spheres, bd.Timoshenko(E=1e9, nu=0.3, radius_ratio=0.5), density=2000.0)
    bd.solve_explicit(model, duration=0.0, out=run)
    bd.save_particles(packing, spheres)

    def of(*words: object) -> BaseException | None:
        return CliRunner().invoke(command, [str(word) for word in words]).exception

    assert of(run, tmp_path / "a.data") is None
    assert of(packing, tmp_path / "b.data", "--density", 2000.0) is None
    one, other = ((tmp_path / f"{name}.data").read_text().split("Bonds")[1] for name in "ab")
    assert one == other
    assert "2000" in (tmp_path / "a.data").read_text()
    assert "leave out --density" in str(of(run, tmp_path / "c.data", "--density", 1.0))
    assert "give density=" in str(of(packing, tmp_path / "c.data"))
    assert "no run file" in str(of(tmp_path / "none.h5", tmp_path / "c.csv"))
