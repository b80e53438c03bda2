"""What benchmarks/peers writes for other codes, read back; none of them need be installed."""

import json
from pathlib import Path

import numpy as np
import pytest

import bondem as bd
from tests.scripts import scripts

FOLDER = Path(__file__).parents[2] / "benchmarks" / "peers"


@pytest.fixture(scope="module")
def peers():
    """The modules of the driver, which are scripts beside each other."""
    modules = {"kratos": "kratos_kdem", "lammps": "lammps_bpm", "outcome": "outcome", "specimen": "specimen"}
    return scripts("benchmarks/peers", **modules)


@pytest.fixture(scope="module")
def small(peers):
    return peers["specimen"].build(1000)


def test_stiffnesses_are_those_of_the_law(peers, small):
    given = peers["specimen"]
    lattice = bd.Lattice(bd.Particles(small.position, small.radius), small.pairs)
    law = bd.EulerBernoulli(E=given.YOUNG, nu=given.POISSON, radius_ratio=given.RADIUS_RATIO)
    model = bd.Model(lattice, law, given.DENSITY)
    order = model.layout.bond_order
    np.testing.assert_allclose(small.kn[order], model.bonds.kn, rtol=1e-12)
    np.testing.assert_allclose(small.ks[order], model.bonds.ks, rtol=1e-12)
    np.testing.assert_allclose(small.kb[order], model.bonds.kb, rtol=1e-12)
    np.testing.assert_allclose(small.kt[order], model.bonds.kt, rtol=1e-12)
    np.testing.assert_allclose(small.mass, model.mass, rtol=1e-12)


def test_a_specimen_survives_its_file(small, tmp_path):
    small.save(tmp_path / "specimen.npz")
    again = type(small).load(tmp_path / "specimen.npz")
    np.testing.assert_array_equal(again.position, small.position)
    np.testing.assert_array_equal(again.velocity, small.velocity)
    assert again.dt == small.dt


def test_lammps_reads_the_same_specimen(peers, small, tmp_path):
    path = tmp_path / "specimen.data"
    peers["lammps"].write_data(path, small)
    with pytest.warns(bd.errors.StressFreeWarning, match="velocities"):
        found = bd.read_lattice(path)
    np.testing.assert_array_equal(found.particles.position, small.position)
    np.testing.assert_allclose(found.particles.radius, small.radius, rtol=1e-15)
    np.testing.assert_array_equal(found.pairs, small.pairs)


def test_lammps_has_the_stiffness_of_every_bond_within_a_class(peers, small):
    kind, length = peers["lammps"].classes(small)
    given = np.array([
        [float(word) for word in line.split()[2:6]]
        for line in peers["lammps"].script(small, 1, 1).splitlines()
        if line.startswith("bond_coeff")
    ])  # fmt: skip
    assert len(given) == len(length) == kind.max() + 1
    wanted = np.column_stack([small.kn, small.ks, small.kt, small.kb])
    width = np.ptp(small.length) / peers["lammps"].TYPES / small.length.min()
    # shear goes as the third power of the length
    assert (np.abs(given[kind] / wanted - 1.0).max(axis=0) < width * np.array([1.1, 3.3, 1.1, 1.1])).all()


def test_kratos_gets_spheres_and_normal_stiffness(peers, small, tmp_path):
    path = tmp_path / "bondsDEM.mdpa"
    peers["kratos"].write_spheres(path, small)
    body = path.read_text().split("Begin Nodes\n")[1].split("End Nodes")[0]
    nodes = np.array([[float(word) for word in line.split()] for line in body.splitlines()])
    np.testing.assert_array_equal(nodes[:, 1:], small.position)
    json.dumps(peers["kratos"].parameters(small))
    E = peers["kratos"].materials(small)["materials"][0]["Variables"]["YOUNG_MODULUS"]
    area = np.pi * small.radius[small.pairs].mean(axis=1) ** 2
    assert (E * area / small.length / small.kn).mean() == pytest.approx(1.0, rel=0.05)


def test_free_flight_is_no_motion_of_bonds(peers, small):
    given = peers["outcome"]
    flight = small.position + 3 * small.dt * small.velocity
    push = 1e-9 * np.random.default_rng(0).standard_normal(small.position.shape)
    blank = {"seconds": 1.0, "bonds": 0, "velocity": small.velocity, "spin": 0.0 * small.velocity, "version": ""}
    ours = given.Outcome(position=flight + push, **blank)
    theirs = given.Outcome(position=flight, **blank)
    assert given.difference(small, ours, ours, 3) == 0.0
    assert given.difference(small, theirs, ours, 3) == pytest.approx(1.0, rel=1e-6)
    assert given.kinetic_share(small, ours) == pytest.approx(1.0)
