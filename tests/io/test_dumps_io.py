"""LAMMPS dumps and XYZ files of spheres."""

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError
from tests.bits import same_spheres
from tests.specimens import FOUR_CENTRES, FOUR_RADII

# The files hold a handful of spheres of about a metre.
pytestmark = [
    pytest.mark.filterwarnings("ignore::bondem.errors.FillingWarning"),
    pytest.mark.filterwarnings("ignore::bondem.errors.UnitWarning"),
]


def dump(columns="id type x y z radius", borders="ff ff ff", scale=1.0):
    box = "-1 5\n-2 4\n-3 3\n"
    frames = []
    for step, moved in ((0, 7.0), (10, 0.0)):
        places = [" ".join(repr(float(v)) for v in centre + moved) for centre in FOUR_CENTRES]
        rows = "".join(f"{10 + k} 1 {places[k]} {float(FOUR_RADII[k] * scale)!r}\n" for k in (2, 0, 3, 1))
        head = f"ITEM: TIMESTEP\n{step}\nITEM: NUMBER OF ATOMS\n4\nITEM: BOX BOUNDS {borders}\n{box}"
        frames.append(f"{head}ITEM: ATOMS {columns}\n{rows}")
    return "".join(frames)


def test_lammps_dumps(write):
    path = write("dump.beam", dump())
    assert same_spheres(bd.read_particles(path))
    assert same_spheres(bd.read_particles(path, frame=0), FOUR_CENTRES + 7.0)
    assert same_spheres(bd.read_particles(path, frame=-2), FOUR_CENTRES + 7.0)
    assert same_spheres(bd.read_particles(write("d.dump", dump("id type xu yu zu diameter", scale=2.0))))
    assert same_spheres(bd.read_particles(write("n.dump", dump("id type x y z c_size")), radius="c_size"))
    assert same_spheres(
        bd.read_particles(write("o.lammpstrj", dump("id type x y z q")), radius=0.3), radius=np.full(4, 0.3)
    )
    cell = bd.read_particles(write("p.dump", dump(borders="pp pp pp")))
    np.testing.assert_array_equal(cell.period, [6.0, 6.0, 6.0])
    np.testing.assert_allclose(cell.position, FOUR_CENTRES + np.array([1.0, 2.0, 3.0]))
    assert bd.read_particles(write("p.dump", dump(borders="pp pp pp")), periodic=False).period is None
    units = bd.read_particles(write("u.dump", "ITEM: UNITS\nmicro\n" + dump()))
    np.testing.assert_allclose(units.position, 1e-6 * FOUR_CENTRES)
    scaled = dump("id type xs ys zs radius").replace("-1 5\n-2 4\n-3 3", "0 2\n0 2\n0 2")
    np.testing.assert_allclose(bd.read_particles(write("s.dump", scaled)).position, 2.0 * FOUR_CENTRES)


@pytest.mark.parametrize(
    ("text", "options", "message"),
    [
        (dump("id type x y z q"), {}, r"line 22: no column radius or diameter among id, .* q; dump it, or give"),
        (dump("id type a b c radius"), {}, "no columns x y z among"),
        (dump(), {"frame": 5}, "frame = 5: .* has 2 snapshots; give one from 0 to 1"),
        (dump().replace("-1 5", "-1 5 0.3"), {"periodic": True}, "the box is tilted"),
        (dump()[:-20], {}, "columns where ITEM: ATOMS names 6"),
        (dump().replace("13 1", "12 1"), {}, "two atoms of id 12"),
        ("nothing\n", {}, "no ITEM: TIMESTEP"),
    ],
)
def test_lammps_dumps_that_do_not_fit(write, text, options, message):
    with pytest.raises(InputError, match=message):
        bd.read_particles(write("bad.dump", text), **options)


def xyz(comment="", scale=1.0):
    sized = zip(FOUR_CENTRES, FOUR_RADII * scale, strict=True)
    rows = "".join(f"Si {' '.join(repr(float(v)) for v in x)} {float(r)!r}\n" for x, r in sized)
    return f"4\n{comment}\n{rows}"


def test_xyz_plain_and_extended(write):
    assert same_spheres(bd.read_particles(write("p.xyz", xyz()), columns=(1, 2, 3, 4)))
    assert same_spheres(bd.read_particles(write("d.xyz", xyz(scale=2.0)), columns=(1, 2, 3, 4), diameters=True))
    assert same_spheres(
        bd.read_particles(write("o.xyz", xyz("Atoms. Timestep: 0")), radius=0.3), radius=np.full(4, 0.3)
    )
    said = "Properties=species:S:1:pos:R:3:radius:R:1"
    assert same_spheres(bd.read_particles(write("e.xyz", xyz(said))))
    assert same_spheres(bd.read_particles(write("f.extxyz", xyz(said.replace("radius", "diameter"), 2.0))))
    two = bd.read_particles(write("t.xyz", xyz(said).replace("Si 0.0", "Si 0.25") + xyz(said)), frame=0)
    assert two.position[0, 0] == 0.25
    cell = write("c.xyz", xyz(f'Lattice="6 0 0 0 6 0 0 0 6" {said} pbc="T T T"'))
    np.testing.assert_array_equal(bd.read_particles(cell).period, [6.0, 6.0, 6.0])
    assert bd.read_particles(cell, periodic=False).period is None


@pytest.mark.parametrize(
    ("text", "options", "message"),
    [
        (xyz(), {}, r"does not say where radii are; give columns= \(1, 2, 3, 4\).* or radius="),
        (xyz("Properties=species:S:1:pos:R:3:mass:R:1"), {}, "no property radius among species, pos, mass"),
        (xyz()[:-20], {"radius": 0.1}, "complete"),
        ("four\n\n", {"radius": 0.1}, "line 1: 'four' where the number of atoms is due"),
        (xyz(), {"columns": (1, 2, 3, "r")}, "four numbers from 0"),
        (xyz('Lattice="6 1 0 0 6 0 0 0 6"'), {"radius": 0.1, "periodic": True}, "no cell with edges along the axes"),
    ],
)
def test_xyz_that_does_not_fit(write, text, options, message):
    with pytest.raises(InputError, match=message):
        bd.read_particles(write("bad.xyz", text), **options)
