// Tables of the passes of a packing.
#pragma once
#include "../array.hpp"

namespace bondem {

// Spheres, n of them; passes write all but `unit`, `period` and `ease`.
struct Spheres {
    Array<double, 2> sphere;  // centres and radii [m], (n, 4)
    Array<const double, 1> unit;  // radii at scale 1 [m], (n,)
    Array<double, 2> velocity;  // kept between calls, (n, 3)
    Array<double, 2> force;  // overlap forces [m], without the parts that walls carry, (n, 3)
    Array<const double, 1> period;  // periodic edge lengths [m], 0 where there is none, (3,)
    Array<const double, 1> ease;  // 1 / √mass of each sphere in a relaxation [-], (n,)
};

// A box, infinite where it has no wall, and a round wall; any other shape is given by its depth on a grid.
struct PackingWalls {
    Array<const double, 1> lower;  // corner of the box [m], (3,)
    Array<const double, 1> upper;  // corner of the box [m], (3,)
    // 1 for the axes along which the distance from the centre, or the centre line, of the round wall counts, else 0
    Array<const double, 1> weight;  // (3,)
    double radius;  // radius of the round wall [m], infinite without one
    Array<const double, 1> corner;  // first node of the grid [m], (3,)
    double spacing;  // distance of the nodes of the grid [m]
    Array<const double, 3> depth;  // depth at the nodes [m], empty without a grid, (grid_x, grid_y, grid_z)
};

// Neighbour lists, and the motion for which they are valid.
struct Near {
    Array<const Index, 1> start;  // where the neighbours of each sphere begin, (n + 1,)
    Array<const Short, 1> neighbour;  // (neighbours,)
    Array<const double, 2> listed;  // centres when the list was made [m], (n, 3)
    double slack;  // how far a centre may move before the list is out of date [m]
};

// Criteria for the end of a relaxation, and data that the descent keeps between calls.
struct Relaxing {
    double tolerance;  // converged when the rms force is below this share of the mean contact force [-]
    double loose;  // mean overlap below which a relaxation ends: the spheres do not press on each other [m]
    Index steps;  // largest number of steps
    Array<double, 1> fire;  // time step, mixing, steps downhill; zeros at the beginning, (3,)
    Array<double, 2> part;  // sums of each block of spheres, (blocks, 8)
    Array<double, 1> report;  // rms force [m], mean overlap [m], contacts, largest overlap [m], steps, (5,)
};

// Growth of flying spheres, and a report of its end.
struct Growing {
    double scale;  // scale of the radii at the beginning [-]
    double rate;  // scale gained per unit of time
    double duration;  // duration of the growth
    Index events;  // largest number of collisions
    Array<double, 1> report;  // elapsed time, sum of distance times exchanged momentum [m²], collisions, (3,)
};

// Times and next events of n flying spheres; passes write all.
struct Flight {
    Array<double, 1> since;  // time for which the centre of each sphere is stored, (n,)
    Array<double, 1> when;  // time of the next event of each sphere, (n,)
    Array<Index, 1> what;  // next event of each sphere: the number of another sphere, or a code, (n,)
    Array<Index, 1> heap;  // spheres by the time of their events, the next one first, (n,)
    Array<Index, 1> place;  // place of each sphere in the heap, (n,)
};

// Spheres sorted into the cells of a grid.
struct SphereGrid {
    Array<const double, 2> sphere;  // centres and radii [m], (n, 4)
    Array<const double, 1> lower;  // corner of the grid [m], (3,)
    Array<const double, 1> edge;  // edges of the cells of the grid [m], (3,)
    Array<const double, 1> period;  // periodic edge lengths [m], 0 where there is none, (3,)
    Array<const Index, 1> cells;  // along each axis, (3,)
    double skin;  // largest gap of neighbours [m]
    Array<Index, 1> cell;  // cell of each sphere, (n,)
    Array<Index, 1> first;  // where the members of each cell begin, (cells + 1,)
    Array<Short, 1> member;  // spheres, cell by cell, (n,)
    Array<double, 2> place;  // centres and radii of `member` [m], and room to read several at once, (4, n + 8)
    Array<Index, 1> start;  // where the neighbours of each sphere begin, (n + 1,)
};

// The lists of all spheres one after the other.
struct NeighbourLists {
    Array<Short, 1> neighbour;  // (neighbours,)
};

}  // namespace bondem
