"""Passes of the core by themselves: what is full goes on with more room, and every ending is reached."""

import numpy as np
import pytest

import bondem as bd
from bondem._core import run_pass
from bondem._passes import calls
from bondem._tables.columns import RelaxationReport
from bondem.packing.packing_tables import new_flight, new_growing, new_relaxing
from bondem.packing.start import thrown
from bondem.packing.wall_contacts import walls
from bondem.specimen.particles import Particles, filled
from bondem.specimen.tessellation.cutting import tessellate
from bondem.specimen.tessellation.laguerre import (
    bins,
    new_cell_request,
    new_cell_room,
    plain_cells,
    roomier_request,
    usual_reach,
)
from bondem.specimen.tessellation.polygon_buffer import buffer_corners, new_buffer, polygon_count, roomier_buffer
from bondem.specimen.tessellation.solids import bulk, solid_count

BOX = bd.Box(size=(1.0, 1.0, 1.0))


def relax(*tables, threads: int = 1) -> str:
    return run_pass(calls.relax_spheres(*tables), threads=threads)


def fly(*tables) -> str:
    return run_pass(calls.fly_and_grow(*tables))


def make_cells(*tables) -> str:
    return run_pass(calls.make_cells(*tables))


def points(count: int, shape: bd.Shape, seed: int = 0) -> Particles:
    x = np.random.default_rng(seed).random((count, 3))
    x = x[shape.depth(x) > 1e-3]
    return filled(Particles(x, np.full(len(x), 1e-6), None), shape)


def cell_bins(particles: Particles):
    return bins(particles, np.zeros(3), np.ones(3), usual_reach(particles))


def test_cells_fill_the_box():
    particles = points(60, BOX)
    _, facets, cells = tessellate(particles)
    assert cells.volume.sum() == pytest.approx(1.0, rel=1e-12)
    assert (facets.area > 0.0).all()


def test_full_piles_and_lists_change_nothing():
    particles = points(40, BOX)
    centres, chosen = cell_bins(particles), np.arange(len(particles))
    half = np.full(len(chosen), 2.0)
    made = []
    for polygons, corners, room in ((2000, 20000, 256), (8, 30, 1)):
        request, pile, seen = new_cell_request(chosen, half), new_buffer(polygons, corners), set()
        request = request._replace(
            found=np.empty(room, np.int64), offset=np.empty((room, 4)), order=np.empty(room, np.int64)
        )
        while (ended := make_cells(centres, request, new_cell_room(), pile)) != "cells_made":
            seen.add(ended)
            full = ended == "lists_full"
            request, pile = (roomier_request(request), pile) if full else (request, roomier_buffer(pile))
        count = polygon_count(pile)
        made.append((request.end, pile.what[:count], pile.plane[:count], buffer_corners(pile)))
        assert seen == (set() if room == 256 else {"lists_full", "pile_full"})
    for ample, scarce in zip(*made, strict=True):
        np.testing.assert_array_equal(ample, scarce)


def test_a_swallowed_cell_is_named():
    particles = points(2, BOX)
    centres = cell_bins(particles)._replace(
        position=np.array([[0.5, 0.5, 0.5], [0.55, 0.5, 0.5]]), radius=np.array([0.4, 0.01]), bound=np.full(2, 0.4)
    )
    request = new_cell_request(np.arange(2), np.full(2, 2.0))
    assert make_cells(centres, request, new_cell_room(), new_buffer(100, 1000)) == "swallowed"
    assert request.done.tolist() == [1, 1]


SLOT = bd.Box(size=(0.6, 0.02, 1.0)).moved(by=(0.2, 0.5, 0.0))


@pytest.mark.parametrize("shape", [BOX - bd.Ball(radius=0.4), BOX - SLOT], ids=["hole", "slot"])
def test_pieces_of_cut_cells_fill_the_shape(shape):
    particles = points(70, shape, seed=3)
    _, _, cells = tessellate(particles)
    # a ball becomes a polyhedron of its volume; an eighth of it need not have an eighth of that
    assert cells.volume.sum() == pytest.approx(shape.volume, rel=1e-3)


def test_no_cells_are_no_solids():
    none = plain_cells(cell_bins(points(5, BOX)), np.zeros(0, np.int64), np.zeros(0))
    assert solid_count(none) == 0
    assert bulk(none).volume.shape == (0,)


def relaxing_spheres(fraction: float, shape: bd.Shape):
    spheres = thrown(shape, np.linspace(1.0, 1.4, 60), fraction, np.random.default_rng(1))
    return spheres, spheres.near(0.5 * spheres.mean_radius, 0.499)


def test_every_ending_of_a_relaxation():
    spheres, near = relaxing_spheres(0.7, BOX)
    some = new_relaxing(60, 1e-3, 0.0)
    assert relax(spheres.table, spheres.walls, near, some._replace(steps=2)) == "exhausted"
    assert some.report[RelaxationReport.STEPS] == 2
    assert relax(spheres.table, spheres.walls, near._replace(slack=0.0), some._replace(steps=2)) == "out_of_date"
    ended, steps = "out_of_date", 0
    while ended == "out_of_date":
        near = spheres.near(0.5 * spheres.mean_radius, 0.499)
        ended = relax(spheres.table, spheres.walls, near, some._replace(steps=20_000), threads=2)
        steps += int(some.report[RelaxationReport.STEPS])
    assert ended == "converged"
    assert steps < 20_000
    spheres, near = relaxing_spheres(0.01, BOX)
    few = new_relaxing(60, 0.0, 1.0)._replace(steps=5, tolerance=-1.0)
    assert relax(spheres.table, spheres.walls, near, few) == "loose"
    assert few.report[RelaxationReport.MEAN_OVERLAP] < 1.0


def test_spheres_between_walls_on_a_grid_stay_inside():
    shape = BOX - bd.Ball(radius=0.5)
    spheres, near = relaxing_spheres(0.5, shape)
    assert walls(shape, spheres.unit).depth.size
    relax(spheres.table, spheres.walls, near, new_relaxing(60, 1e-9, 0.0)._replace(steps=10), threads=2)
    inside = shape.depth(spheres.sphere[:, :3]) - spheres.sphere[:, 3]
    assert inside.min() > -0.1 * spheres.mean_radius


def test_flying_spheres_end_when_their_lists_do():
    spheres, near = relaxing_spheres(0.05, BOX)
    spheres.relax(1.0, tolerance=1e-2, steps=2000)
    spheres.table.sphere[:, 3] *= 0.9
    spheres.table.unit[:] *= 0.9
    spheres.table.velocity[:] = np.random.default_rng(2).standard_normal((60, 3))
    near = spheres.near(0.5 * spheres.mean_radius, 0.3)
    ended = fly(spheres.table, spheres.walls, near, new_growing(1.0, 0.0, 1e3, 10**6), new_flight(60))
    assert ended == "list_out_of_date"
    near = near._replace(slack=1e9)
    few = new_growing(1.0, 0.0, 1e3, 3)
    assert fly(spheres.table, spheres.walls, near, few, new_flight(60)) == "too_many_events"
