"""Particle files: exact round trips, what others write, and messages that name file and line."""

import sys

import h5py
import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError, RunFileError
from tests.bits import same_spheres
from tests.specimens import FOUR_CENTRES, FOUR_RADII

# The files hold a handful of spheres of about a metre.
pytestmark = [
    pytest.mark.filterwarnings("ignore::bondem.errors.FillingWarning"),
    pytest.mark.filterwarnings("ignore::bondem.errors.UnitWarning"),
]

PAIRS = np.array([[0, 1], [1, 2], [2, 3]])


def table(separator=" "):
    return "".join(
        separator.join(map(repr, map(float, (*x, r)))) + "\n" for x, r in zip(FOUR_CENTRES, FOUR_RADII, strict=True)
    )


@pytest.mark.parametrize("shape", [None, bd.Cylinder(2.0, 4.0), bd.Cell((4.0, 5.0, 6.0))], ids=repr)
def test_what_is_saved_comes_back_to_the_bit(tmp_path, shape):
    particles = bd.Particles(FOUR_CENTRES + 0.1, FOUR_RADII, shape=shape)
    path = tmp_path / "packing.h5"
    bd.save_particles(path, particles, provenance={"method": "quench", "seed": 3, "shape": shape, "target": 6.2})
    again = bd.load_particles(path)
    assert same_spheres(again, particles.position, particles.radius)
    assert again.shape == shape
    assert (again.period is None) == (particles.period is None)
    told = bd.read_provenance(path)
    assert told == {"method": "quench", "seed": 3, "shape": shape, "target": 6.2, "bondem_version": bd.__version__}
    assert same_spheres(bd.read_particles(path), particles.position, particles.radius)
    with pytest.raises(InputError, match="has no bonds"):
        bd.read_lattice(path)


def test_a_lattice_is_saved_with_its_bonds(tmp_path):
    path = tmp_path / "lattice.h5"
    bd.save_particles(path, bd.Lattice(bd.Particles(FOUR_CENTRES, FOUR_RADII), PAIRS[::-1]))
    np.testing.assert_array_equal(bd.read_lattice(path).pairs, PAIRS[::-1])
    assert same_spheres(bd.load_particles(path))


def test_files_that_are_not_ours_or_damaged_are_refused(tmp_path, write):
    with pytest.raises(InputError, match=r"there is no particle file; check the path"):
        bd.load_particles(tmp_path / "nowhere.h5")
    with pytest.raises(InputError, match="not a particle file"):
        bd.load_particles(write("text.h5", "x y z r"))
    path = tmp_path / "good.h5"
    bd.save_particles(path, bd.Particles(FOUR_CENTRES, FOUR_RADII))
    with h5py.File(path, "a") as file:
        del file["elements/radius"]
    with pytest.raises(InputError, match="damaged"):
        bd.load_particles(path)
    with h5py.File(path, "a") as file:
        file.attrs["schema"] = 99
    with pytest.raises(InputError, match="update bondem"):
        bd.load_particles(path)
    with pytest.raises(InputError, match="folder"):
        bd.save_particles(tmp_path, bd.Particles(FOUR_CENTRES, FOUR_RADII))
    with pytest.raises(RunFileError, match="object cannot be written"):
        bd.save_particles(path, bd.Particles(FOUR_CENTRES, FOUR_RADII), provenance={"by": object()})


@pytest.mark.parametrize(
    ("head", "separator"),
    [
        ("x,y,z,r\n", ","),
        ("", ", "),
        ("x y z radius\n", "  "),
        ("# made by hand\nX [m];Y [m];Z [m];Radius (m)\n", ";"),
        ('"x"\t"y"\t"z"\t"r"\n', "\t"),
    ],
)
def test_csv_with_and_without_header(write, head, separator):
    assert same_spheres(bd.read_particles(write("spheres.csv", head + table(separator))))


def test_csv_columns_units_and_diameters(write):
    path = write("mm.csv", "id,diameter,x,y,z\n7,2,0,0,0\n8,2,2,0,0\n")
    assert same_spheres(bd.read_particles(path, unit=1e-3), np.array([[0, 0, 0], [2e-3, 0, 0]]), np.full(2, 1e-3))
    path = write("odd.csv", "a,b,c,d,e\n7,0,0,0,2\n8,5,0,0,2\n")
    expected = np.array([[0, 0, 0], [5, 0, 0]]), np.full(2, 2.0)
    assert same_spheres(bd.read_particles(path, columns=("b", "c", "d", "e")), *expected)
    assert same_spheres(bd.read_particles(path, columns=(1, 2, 3, 4)), *expected)
    shape = bd.Box((1.0, 1.0, 1.0))
    assert bd.read_particles(path, columns=(1, 2, 3, 4), unit=0.1, shape=shape).shape == shape


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("x,y,z,r\n0,0,0,1\n\n0,0,five,1\n", r"bad.csv', line 4: 'five' is not a number"),
        ("x,y,z,r\n0,0,0,1\n0,0,nan,1\n", r"line 3: 'nan' is not finite"),
        ("x,y,z,r\n0,0,0\n", r"line 2: 3 columns where at least 4"),
        ("x,y,z,r\n0,0,0,-1\n", r"line 2: -1 is not a size"),
        ("x,y,w,r\n0,0,0,1\n", r"line 1: no column 'z' among x, y, w, r; .*columns="),
        ("# nothing\n", "has no spheres"),
        ("0 0 0 1\n0 0 0.1 1\n", r"bad.csv': elements 0 and 1 overlap"),
    ],
)
def test_csv_errors_name_file_and_line(write, text, message):
    with pytest.raises(InputError, match=message):
        bd.read_particles(write("bad.csv", text))


@pytest.mark.parametrize(
    "text",
    [
        "0;0;0;0,5\n1;0,1;0;0,4\n",
        "x;y;z;r;\n0;0;0;0,5;\n1;0,1;0;0,4;\n",
        "0\t0\t0\t0,5\n1\t0,1\t0\t0,4\n",
        "0 0 0 0,5\n1 0,1 0 0,4\n",
        '"x","y","z","r"\n"0","0","0","0,5"\n"1","0,1","0","0,4"\n',
    ],
)
def test_csv_decimals_with_commas(write, text):
    assert same_spheres(bd.read_particles(write("comma.csv", text)), FOUR_CENTRES[:2] * [[1, 1, 1]], FOUR_RADII[:2])


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("1,0,0,0,1\n2,3,0,0,1\n", r"line 1: 5 columns where 4 are known; name all.* in a header, give columns="),
        ("0,5,0,0,0,0,0,5\n", r"line 1: 8 columns where 4 are known.*decimals with a point"),
        ("x,y,z,r\n0,5,1,5,2,5,0,5\n", r"line 2: 8 columns where 4 are known.*decimals with a point"),
        ("x;y;z;r\n0;0;0;1.000,5\n", r"'1.000,5' is not a number"),
        ("x;y;z;r\n1,5;0;0;0.5\n", "with commas and with points"),
    ],
)
def test_csv_that_would_be_misread_is_refused(write, text, message):
    with pytest.raises(InputError, match=message):
        bd.read_particles(write("odd.csv", text))


@pytest.mark.parametrize(
    ("text", "options"),
    [
        ("x [mm],y [mm],z [mm],r [mm]\n0,0,0,1\n2,0,0,1\n", {}),
        ("x_mm;y_mm;z_mm;radius_mm\n0;0;0;1\n2;0;0;1\n", {}),
        ("x [m] y [m] z [m] Diameter [mm]\n0 0 0 2\n2e-3 0 0 2\n", {}),
        ("X (mm),Y,Z,Dia\n0,0,0,2\n2,0,0,2\n", {}),
        ("# id x y z r\n7 0 0 0 1\n8 2 0 0 1\n", {"unit": "mm"}),
        ("a,b,c,diameter\n0,0,0,2\n2,0,0,2\n", {"unit": "mm", "columns": ("a", "b", "c", "diameter")}),
        ("0 0 0 2\n2 0 0 2\n", {"unit": "mm", "diameters": True}),
        ("x [px],y [px],z [px],r [px]\n0,0,0,1\n2,0,0,1\n", {"unit": 1e-3}),
    ],
)
def test_csv_units_and_diameters_of_headers(write, text, options):
    particles = bd.read_particles(write("mm.csv", text), **options)
    np.testing.assert_allclose(particles.position, [[0, 0, 0], [2e-3, 0, 0]], rtol=1e-15)
    np.testing.assert_allclose(particles.radius, 1e-3, rtol=1e-15)


def test_units_of_headers_that_do_not_fit_are_refused(write):
    path = write("px.csv", "x [px],y [px],z [px],r [px]\n0,0,0,1\n")
    with pytest.raises(InputError, match=r"\[px\] of column 'x' is no known unit of length.*give unit="):
        bd.read_particles(path)
    path = write("mm.csv", "x [mm],y [mm],z [mm],r [mm]\n0,0,0,1\n")
    with pytest.raises(InputError, match=r"unit = 'm', but .* says that its unit is 0.001 m"):
        bd.read_particles(path, unit="m")
    path = write("two.csv", "x [mm],y [mm],z,r [m]\n0,0,0,1\n")
    with pytest.raises(InputError, match="of two units, and one without"):
        bd.read_particles(path)


def test_tables_of_windows_editors_read_alike(tmp_path):
    for k, encoding in enumerate(("utf-8-sig", "utf-16")):
        path = tmp_path / f"{k}.csv"
        path.write_bytes(("x,y,z,r\r\n" + table(",").replace("\n", "\r\n")).encode(encoding))
        assert same_spheres(bd.read_particles(path))


def test_yade_text_plain_and_periodic(write):
    assert same_spheres(bd.read_particles(write("export.txt", "#format x_y_z_r\n" + table())))
    assert same_spheres(
        bd.read_particles(write("ext.txt", "#format x_y_z_r_matId\n" + table().replace("\n", " 0\n")))
    )
    rows = "1 1 1 0.5 -1\n2 1 1 0.5 -1\n"
    periodic = bd.read_particles(write("pack.txt", "##PERIODIC:: 4 5 6\n" + rows))
    np.testing.assert_array_equal(periodic.period, [4.0, 5.0, 6.0])
    with pytest.raises(InputError, match=r"line 1: 5 columns without a line #format, and the fifth, 0\.5"):
        bd.read_particles(write("id.txt", "1 0 0 0 0.5\n2 0 0 3 0.5\n"))
    with pytest.raises(InputError, match="line 1: the format does not begin"):
        bd.read_particles(write("bad.txt", "#format id_x_y_z_r\n"))


def lammps(style, bonds=True, hint=True):
    molecule = "1 " if style == "bpm/sphere" else ""
    places = [" ".join(map(repr, map(float, centre))) for centre in FOUR_CENTRES]
    atoms = "".join(
        f"{10 + k} {molecule}1 {float(2.0 * FOUR_RADII[k])!r} 2500 {places[k]} 0 0 0\n" for k in (2, 0, 3, 1)
    )
    ends = "".join(f"{k + 1} 1 {10 + i} {10 + j} # bond\n" for k, (i, j) in enumerate(PAIRS))
    return (
        "LAMMPS data file\n\n4 atoms\n1 atom types\n3 bonds\n1 bond types\n\n"
        "-1 5 xlo xhi\n-2 4 ylo yhi\n-3 3 zlo zhi\n"
        f"\nAtoms{f' # {style}' if hint else ''}\n\n{atoms}\nVelocities\n\n10 0 0 0 0 0 0\n"
        + (f"\nBonds\n\n{ends}" if bonds else "")
    )


@pytest.mark.parametrize("hint", [True, False])
@pytest.mark.parametrize("style", ["sphere", "bpm/sphere"])
def test_lammps_data_with_bonds(write, style, hint):
    path = write("data.beam", lammps(style, hint=hint))
    assert same_spheres(bd.read_particles(path))
    lattice = bd.read_lattice(path)
    np.testing.assert_array_equal(lattice.pairs, PAIRS)


def test_lammps_box_as_a_periodic_cell(write):
    path = write("cell.data", lammps("sphere"))
    particles = bd.read_particles(path, periodic=True)
    np.testing.assert_array_equal(particles.period, [6.0, 6.0, 6.0])
    np.testing.assert_allclose(particles.position, FOUR_CENTRES + np.array([1.0, 2.0, 3.0]))


def test_lammps_bonds_over_the_border_need_the_periodic_cell(write):
    atoms = "".join(f"{k + 1} 1 1.0 1 {0.5 + k} 0 0\n" for k in range(10))
    ends = "".join(f"{k + 1} 1 {k + 1} {(k + 1) % 10 + 1}\n" for k in range(10))
    text = f"\n\n0 10 xlo xhi\n-5 5 ylo yhi\n-5 5 zlo zhi\n\nAtoms # sphere\n\n{atoms}\nBonds\n\n{ends}"
    path = write("ring.data", text)
    with pytest.raises(InputError, match=r"bond 9 reaches across.*periodic=True"):
        bd.read_lattice(path)
    np.testing.assert_allclose(bd.read_lattice(path, periodic=True).length, 1.0)


@pytest.mark.parametrize("n", [3, 4, 5, 6])
def test_bonds_over_the_border_are_refused_in_narrow_cells_too(write, n):
    x = np.argwhere(np.ones((n, n, n))) + 0.5
    apart = x[:, None] - x[None]
    near = np.argwhere(np.triu(np.linalg.norm(apart - n * np.rint(apart / n), axis=2) < 1.001, 1))
    atoms = "".join(f"{k} 1 1.0 1 {a} {b} {c}\n" for k, (a, b, c) in enumerate(x, start=1))
    ends = "".join(f"{k} 1 {i + 1} {j + 1}\n" for k, (i, j) in enumerate(near, start=1))
    box = "".join(f"0 {n} {axis}lo {axis}hi\n" for axis in "xyz")
    path = write("cell.data", f"\n\n{box}\nAtoms # sphere\n\n{atoms}\nBonds\n\n{ends}")
    with pytest.raises(InputError, match=rf"across half the specimen \({3 * n * n} such bonds\)"):
        bd.read_lattice(path)
    if n > 3:  # below two diameters of the largest no cell is periodic
        np.testing.assert_allclose(bd.read_lattice(path, periodic=True).length, 1.0)


def test_long_bonds_within_a_small_body_are_read(write):
    """Second neighbours of three in a row reach across, too."""
    x = np.argwhere(np.ones((3, 3, 3))).astype(float)
    near = np.argwhere(np.triu(np.linalg.norm(x[:, None] - x[None], axis=2) < 2.001, 1))
    atoms = "".join(f"{k} 1 1.0 1 {a} {b} {c}\n" for k, (a, b, c) in enumerate(x, start=1))
    ends = "".join(f"{k} 1 {i + 1} {j + 1}\n" for k, (i, j) in enumerate(near, start=1))
    path = write("reach.data", f"\n\nAtoms # sphere\n\n{atoms}\nBonds\n\n{ends}")
    assert len(bd.read_lattice(path).pairs) == len(near)


@pytest.mark.parametrize(
    ("head", "velocities", "words"),
    [
        ("LAMMPS data file via write_data, version 2 Aug 2023, timestep = 5000, units = si", "", "of timestep 5000"),
        ("LAMMPS data file", "\nVelocities\n\n10 0 0 -1 0 0 0\n", "velocities, which are not read"),
        ("LAMMPS data file via write_data, version 2 Aug 2023, timestep = 0, units = si", "", ""),
    ],
)
def test_strained_lammps_data_are_read_with_a_warning(write, head, velocities, words):
    text = lammps("sphere").replace("LAMMPS data file", head).replace("\nVelocities\n\n10 0 0 0 0 0 0\n", velocities)
    path = write("strained.data", text)
    if words:
        with pytest.warns(bd.errors.StressFreeWarning, match=f"{words}.* free of stress"):
            bd.read_lattice(path)
    else:
        bd.read_lattice(path)
    assert bd.read_particles(path) is not None  # spheres without bonds have no stress to lose


def test_units_of_write_data_are_taken(write):
    head = "LAMMPS data file via write_data, version 2 Aug 2023, timestep = 0, units = micro"
    path = write("micro.data", lammps("sphere").replace("LAMMPS data file", head))
    np.testing.assert_allclose(bd.read_particles(path).position, 1e-6 * FOUR_CENTRES)


@pytest.mark.parametrize(
    ("edit", "message"),
    [
        (("# sphere", "# atomic"), r"line 12: atom style 'atomic' .* atom_style sphere"),
        (("Atoms", "Ellipsoids"), "no section Atoms"),
        (("12 1 1.0", "12 1 0.0"), "line 14: diameter 0"),
        (("12 1 1.0 2500", "12 1 1.0 2500 oops"), "line 14: 'oops' is not a number"),
        (("11 1 0.8", "10 1 0.8"), "two atoms of id 10"),
        (("3 1 12 13", "3 1 12 99"), r"line 27: there is no atom 99"),
    ],
)
def test_lammps_errors_name_file_and_line(write, edit, message):
    path = write("bad.data", lammps("sphere").replace(*edit))
    with pytest.raises(InputError, match=message) as caught:
        bd.read_lattice(path)
    assert "bad.data" in str(caught.value)


def test_vtkhdf_of_our_own_comes_back_with_its_bonds(tmp_path):
    path = tmp_path / "lattice.vtkhdf"
    bd.write_vtkhdf(path, bd.Lattice(bd.Particles(FOUR_CENTRES, FOUR_RADII), PAIRS))
    lattice = bd.read_lattice(path)
    assert same_spheres(lattice.particles)
    np.testing.assert_array_equal(lattice.pairs, PAIRS)


def test_a_strained_vtkhdf_is_read_with_a_warning(tmp_path):
    lattice = bd.Lattice(bd.Particles(FOUR_CENTRES, FOUR_RADII), PAIRS)
    bd.write_vtkhdf(tmp_path / "strained.vtkhdf", lattice, elements={"displacement": 0.01 * FOUR_CENTRES})
    with pytest.warns(bd.errors.StressFreeWarning, match="its elements have displacements"):
        bd.read_lattice(tmp_path / "strained.vtkhdf")


def test_broken_bonds_of_a_vtkhdf_stay_broken(tmp_path):
    row = np.column_stack([np.arange(24.0), np.zeros((24, 2))])
    lattice = bd.Lattice(bd.Particles(row, np.full(24, 0.5)), np.column_stack([np.arange(23), np.arange(1, 24)]))
    strength = bd.PeripheralStress(tension=1e6, shear=1e6)
    model = bd.Model(lattice, bd.EulerBernoulli(E=1e9, nu=0.2, radius_ratio=0.5), density=1000.0, failure=strength)
    state = model.state()
    state.integrity[[2, 5]] = 0.0, 0.5
    bd.write_vtkhdf(tmp_path / "broken.vtkhdf", lattice, state=state)
    with pytest.warns(bd.errors.StressFreeWarning, match="1 of its 23 bonds are broken and left out; 1 of its 23"):
        again = bd.read_lattice(tmp_path / "broken.vtkhdf")
    np.testing.assert_array_equal(again.pairs, np.delete(lattice.pairs, 2, axis=0))
    state.integrity[13] = 0.0
    bd.write_vtkhdf(tmp_path / "pieces.vtkhdf", lattice, state=state)
    with pytest.raises(bd.errors.DisconnectedError, match=r"broken and left out; .* of 11 and 10 .*with bd.read_run"):
        bd.read_lattice(tmp_path / "pieces.vtkhdf")


@pytest.mark.parametrize("suffix", ["vtk", "vtp", "vtu"])
def test_vtk_points_with_radii(tmp_path, suffix):
    pv = pytest.importorskip("pyvista")
    cloud = pv.PolyData(FOUR_CENTRES) if suffix != "vtu" else pv.PolyData(FOUR_CENTRES).cast_to_unstructured_grid()
    cloud.point_data["Radius"] = FOUR_RADII
    path = tmp_path / f"spheres.{suffix}"
    cloud.save(path)
    assert same_spheres(bd.read_particles(path))


def test_files_at_which_vtk_ends_its_process_are_refused(tmp_path, write):
    """VTK aborts where a damaged file announces more points than memory holds: found by fuzzing."""
    pytest.importorskip("pyvista")
    none = " ".join(f'NumberOf{kind}="0"' for kind in ("Verts", "Lines", "Strips", "Polys"))
    points = '<DataArray type="Float64" NumberOfComponents="3" format="ascii">0 0 0</DataArray>'
    text = f'<Piece NumberOfPoints="{10**15}" {none}><Points>{points}</Points></Piece>'
    path = write("spheres.vtp", f'<VTKFile type="PolyData" version="1.0"><PolyData>{text}</PolyData></VTKFile>')
    with pytest.raises(InputError, match=r"has no points that VTK can read \(.*bad_alloc"):
        bd.read_particles(path)


def test_without_vtk_the_message_says_what_to_install(write, monkeypatch):
    monkeypatch.setitem(sys.modules, "vtkmodules", None)
    with pytest.raises(InputError, match=r"\[view\]"):
        bd.read_particles(write("spheres.vtp", ""))


def test_an_unknown_suffix_lists_the_known_ones(write):
    with pytest.raises(InputError, match=r"'.stp' files of spheres are not supported; give one of \.h5"):
        bd.read_particles(write("spheres.stp", ""))
    with pytest.raises(InputError, match="there is no file"):
        bd.read_particles("nowhere.csv")
