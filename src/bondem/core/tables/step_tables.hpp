// What the passes of a step take. Named once more in `bondem/dynamics/step_tables.py`.
//
// Rows of eight are one cache line: pose (x, y, z, spare, quaternion w x y z), motion (velocity, 1/m, angular velocity,
// 1/I) and sums (force, 0, torque, 0).
#pragma once
#include "../array.hpp"

namespace bondem {

using Byte = uint8_t;

// The motion of n elements.
struct Moving {
    Array<double, 2> pose, motion;  // (n, 8)
    Array<double, 2> acceleration;  // at a pause [m/s², rad/s²], (n, 6)
    Array<double, 2> loss;  // taken by damping [J], its present power [W], lost to friction [J], (n, 3)
    Array<const double, 2> rest;  // centres in the reference [m], (n, 3)
};

constexpr Index rubbed_loss = 2;  // column of the losses of an element

// Beams, m of them, sorted by j; a few may follow that have no force, so that lanes can be filled.
struct Beams {
    Array<const Short, 1> i, j;
    Array<const double, 1> X0, Y0, Z0;  // reference direction i→j [-]
    Array<double, 1> length;  // at rest, L (1 + ε*) [m]
    Array<const double, 1> kn, A, B, C, kt;  // constants of the energy [N/m, N·m]
    Array<double, 1> ks, lever;  // [N/m], and of the contact point from i [m]
    Array<const double, 1> integrity;  // 1 intact … 0 broken [-]
    Array<const double, 1> period;  // edges of the periodic cell and their inverses, zero where there is none, (6,)
};
// What all beams share that differ in length only.
struct AlikeBeams {
    Array<const double, 1> hold;  // integrity over rest length [1/m], (m,)
    double knL, AL, BL, ktL;  // kn L [N]; A L = C L, B L and kt L [N·m²]
};
// Where elements are, whether they move there or not.
struct Poses {
    Array<const double, 2> pose;  // (n, 8)
};
// Where the forces of beams on their two ends are added.
struct BeamSums {
    Array<const Short, 1> row_i, row_j;  // (m,)
    Array<double, 2> sums;  // force, 0, torque, 0 [N, N·m], (rows, 8)
};
// Normal, shear, bending and twisting energy of all beams.
struct BeamEnergies {
    Array<double, 1> energy;  // [J], (4,)
};
// Unbroken beams turned wide and lost, and 1 where a number is not finite.
struct BeamTurns {
    Array<Index, 1> found;  // (3,)
};
// Dashpots beside the springs of beams, and their forces.
struct Dashpots {
    Array<const double, 2> c;  // cn, cs [N·s/m], cb, ct [N·m·s], (4, m)
    Array<const double, 1> share;  // where the contact point divides a beam, from i [-], (m,)
    Array<double, 2> sums;  // force and torque on each element, in rows as `StepCut` has them, (rows, 8)
};

// How a step is cut into blocks and domains (`bondem/model/domain_blocks.py`), and the sums of forces.
struct StepCut {
    Array<const Index, 1> domain, bond, move, held;
    Array<const Short, 1> ready, ready_row, row_i, row_j, shared, shared_row;
    Index shared_held;
    Array<const Index, 1> part;
    Index parts;
    Array<double, 2> sums;  // (rows, 8)
};
// Coefficients of a step, see `bondem/dynamics/schemes.py`.
struct StepScheme {
    double dt, finish, begin;  // [s]
    double extra;  // [s²]
    double gamma;  // of local damping [-]
    double origin;  // time of step 0 [s]
};

// Elements that are held, driven or loaded own a row, r of them.
struct Rows {
    Array<const Index, 1> of;  // row of each element, or -1, (n,)
    Array<const Byte, 2> fixed;  // degrees of freedom with prescribed motion, (r, 6)
    Array<double, 2> force;  // of loads now [N, N·m], (r, 6)
    Array<double, 2> half, full;  // prescribed velocities over the step, and now [m/s, rad/s], (r, 6)
    Array<double, 2> reaction;  // minus the bond forces [N, N·m], (r, 6)
    Array<double, 2> grip;  // force and torque of walls that hold facets of cells [N, N·m], (r, 6), or none
    Array<double, 1> work;  // of loads and drives on each row [J], then of body forces and strains
};
// Piecewise linear functions of time, one after the other.
struct Timeline {
    Array<const double, 1> times, values;  // [s], and what they are of
    Array<const Index, 1> start;  // where each begins, (schedules + 1,)
};
// Degrees of freedom that follow schedules.
struct Drives {
    Array<const Index, 1> row, dof, schedule;
    Array<const Byte, 1> rate;  // 1 for a velocity, 0 for a displacement
};
// Forces and torques that follow schedules.
struct RowLoads {
    Array<const Index, 1> row, schedule;
    Array<const double, 2> value;  // [N, N·m], (loads, 6)
    Array<const Index, 1> turns;  // element with which each turns, or -1
};
// Moments on points of elements, c of them, as forces that turn with their regions.
struct CoupleTable {
    Array<const Index, 1> start;  // where the points of each begin, (c + 1,)
    Array<const Index, 1> schedule;
    Array<const double, 2> moment;  // [N·m], (c, 3)
    Array<const Index, 1> element, row;  // of each point
    Array<const double, 2> arm;  // from the centre of its element [m]
    Array<const double, 1> share;  // of the moment's forces [-]
};
// Body forces, b of them, on g groups of elements.
struct BodyForces {
    Array<const Short, 1> group;  // of each element, (n,)
    Array<const double, 2> member;  // whether each acts on a group, (g, b)
    Array<const double, 2> pull;  // accelerations [m/s²], (b, 3)
    Array<const Index, 1> schedule;  // (b,)
    Array<double, 2> present;  // acceleration of each group now [m/s²], (g, 3)
    Array<double, 1> factor;  // of which factors it is, (b,)
    Array<double, 2> work;  // on each element [J], (n, 1)
};
// What resists the motion of elements.
struct Resistance {
    double gamma;  // of local damping [-]
    double alpha;  // of mass damping [1/s]
    Index viscous;  // whether there is mass damping or any dashpot
    Array<double, 2> dashed;  // the sums of `Dashpots`, or none, (…, 8)
    Array<const double, 2> absorbing;  // dashpots of each row, xx, yy, zz, xy, xz, yz [N·s/m], (r, 6), or none
};
// Stress-free strains that change in time, g of them on e bonds.
struct Strain {
    Array<const Index, 1> schedule;
    Array<const Short, 1> bond;
    Array<const double, 2> part;  // strain of each bond at factor 1 [-], (g, e)
    Array<const double, 1> still, length, shear, lever;  // 1 and what does not change [-]; L [m], ks [N/m], a [m]
    Array<double, 2> factor;  // factors now and to come, energy by factor [J] a step ago and now, (4, g)
    Index place;  // in the list of works
};

// Sums over portions of elements and bonds, which do not depend on threads, and what is made of them.
struct Portions {
    Array<double, 2> elements;  // translation, rotation, damped, rubbed [J]
    Array<double, 2> bonds;  // energy of the four modes [J]
    Array<Index, 2> turned;  // unbroken bonds turned wide, and lost; and whether a number was not finite
    // energy at the start, the most that was put in since, and what walls have supplied [J], (3,)
    Array<double, 1> budget;
    // bonds turned wide and lost; 1 for a number that is not finite, 2 for a runaway; 1 for a list out of date; (4,)
    Array<Index, 1> found;
};
// What is read off for the history.
struct Gauges {
    Array<const Index, 1> start, element, quantity, reduction;
};
// The rows of the history of one call.
struct HistoryRows {
    Array<double, 2> record;  // (records, columns)
};

// Lists of passes, eight words each: address, kind, and six tables.
struct StepPasses {
    Array<const Index, 2> present;  // bring boundary conditions to the time of the clock
    Array<const Index, 2> opening;  // elements open a step after a pause
    Array<const Index, 2> travel;  // walls move, and lists of contacts may be out of date
    Array<const Index, 2> forces;  // forces, and what elements do with them
    Array<const Index, 2> resume;  // postponed elements find their acceleration without what failed
    Array<const Index, 2> reopening;  // and open the next step
    Array<const Index, 2> guard;  // whether the run is sound
    Array<const Index, 2> record;  // a row of the history
};
// Which steps a call takes.
struct StepSpan {
    Index step, steps;  // number of the present one, how many to go
    Index every;  // steps between records, 0 for none
    Index looks;  // whether it takes none, and records the present
    Index stale;  // whether the acceleration is to be found for that
    Index moved;  // whether elements and walls have moved already in the first step, whose list was out of date
    Index n, m;  // elements, and bonds without those that fill lanes
    Array<Index, 1> done;  // steps done, records written, bonds turned wide at most and lost, (4,)
};

}  // namespace bondem
