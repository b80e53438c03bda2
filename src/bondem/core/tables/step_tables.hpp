// Tables of the passes of a step.
//
// Rows of eight numbers are one cache line. A pose is x, y, z, the stress of a cell (else unused) and the quaternion
// w x y z. A motion is velocity, 1/m, angular velocity and 1/I, with the mass m and the moment of inertia I. A sum is
// force, 0, torque, 0.
#pragma once
#include "../array.hpp"

namespace bondem {

// The motion of n elements; arrays of a state.
struct Moving {
    Array<double, 2> pose;  // (n, 8)
    Array<double, 2> motion;  // (n, 8)
    Array<double, 2> acceleration;  // at a pause [m/s², rad/s²], (n, 6)
    Array<double, 2> loss;  // loss to damping [J], its present power [W], loss to friction [J], (n, 3)
    Array<const double, 2> rest;  // centres in the reference [m], (n, 3)
};

constexpr Index rubbed_loss = 2;  // column of the losses of an element

// Beams, m of them; beams without force follow if they are fewer than a group of lanes.
struct Beams {
    Array<const Short, 1> i;  // first element of each beam, (m,)
    Array<const Short, 1> j;  // second element of each beam, (m,)
    Array<const double, 1> X0;  // x of the reference direction i→j [-], (m,)
    Array<const double, 1> Y0;  // y of the reference direction i→j [-], (m,)
    Array<const double, 1> Z0;  // z of the reference direction i→j [-], (m,)
    Array<double, 1> length;  // rest length L (1 + ε*) [m], (m,)
    Array<const double, 1> kn;  // [N/m], (m,)
    Array<const double, 1> A;  // constants of the energy [N·m], (m,)
    Array<const double, 1> B;  // constants of the energy [N·m], (m,)
    Array<const double, 1> C;  // constants of the energy [N·m], (m,)
    Array<const double, 1> kt;  // [N·m], (m,)
    Array<double, 1> ks;  // [N/m], (m,)
    Array<double, 1> lever;  // distance of the contact point from i [m], (m,)
    Array<const double, 1> integrity;  // 1 intact … 0 broken [-], (m,)
    Array<const double, 1> period;  // edges of the periodic cell and their inverses, zero where there is none, (6,)
};
// Constants of beams that differ in length only.
struct UniformBeams {
    Array<const double, 1> per_length;  // integrity over rest length [1/m], (m,)
    double knL;  // kn L [N]
    double AL;  // A L = C L [N·m²]
    double BL;  // B L [N·m²]
    double ktL;  // kt L [N·m²]
};
// Places and orientations of elements.
struct Poses {
    Array<const double, 2> pose;  // (n, 8)
};
// Sums to which beams add the forces on their two ends.
struct BeamSums {
    Array<const Short, 1> row_i;  // row of the sums of element i of each beam, (m,)
    Array<const Short, 1> row_j;  // row of the sums of element j of each beam, (m,)
    Array<double, 2> sums;  // force, 0, torque, 0 [N, N·m], (sums, 8)
};
// Energies of all beams.
struct BeamEnergies {
    Array<double, 1> energy;  // normal, shear, bending, twisting [J], (4,)
};
// Counts of unbroken beams beyond safe angles and beyond valid angles, and 1 if a number is not finite.
struct BeamTurns {
    Array<Index, 1> found;  // (3,)
};
// Dashpots parallel to the springs of beams, and their forces.
struct Dashpots {
    Array<const double, 2> c;  // cn, cs [N·s/m], cb, ct [N·m·s], (4, m)
    Array<const double, 1> share;  // where the contact point divides a beam, from i [-], (m,)
    Array<double, 2> sums;  // forces on each element, in rows as `StepBlocks.sums`, (*, 8)
};

// Division of a step in the form of the core (attributes of `Blocks`), and the sums of elements.
struct StepBlocks {
    Array<const Index, 1> domain;  // (domains + 1,)
    Array<const Index, 1> bond;  // (blocks + 1,)
    Array<const Index, 1> move;  // (blocks + 1,)
    Array<const Index, 1> first_owner;  // (blocks,)
    Array<const Short, 1> ready;  // (ready,)
    Array<const Short, 1> ready_row;  // (ready,)
    Array<const Short, 1> row_i;  // (m,)
    Array<const Short, 1> row_j;  // (m,)
    Array<const Short, 1> shared;  // (shared,)
    Array<const Short, 1> shared_row;  // (shared,)
    Index shared_first_owner;
    Array<const Index, 1> part;  // (shared + 1,)
    Index parts;
    Array<double, 2> sums;  // force and torque of the bonds on each element [N, N·m], (sums, 8)
};
// One step of time integration; see `bondem.dynamics.schemes`.
struct StepScheme {
    double dt;  // [s]
    double finish;  // change of the velocity per acceleration that closes a step [s]
    double begin;  // change of the velocity per acceleration that opens a step [s]
    double extra;  // displacement of a step per acceleration, in addition to that by the velocity [s²]
    double gamma;  // of local damping [-]
    double origin;  // time of step 0 [s]
};

// Rows of the elements that are fixed, driven or loaded; passes write all but `of` and `fixed`.
struct Rows {
    Array<const Index, 1> of;  // row of each element, or -1, (n,)
    Array<const Byte, 2> fixed;  // degrees of freedom with prescribed motion, (rows, 6)
    Array<double, 2> force;  // loads now [N, N·m], (rows, 6)
    Array<double, 2> half;  // prescribed velocities over the step [m/s, rad/s], (rows, 6)
    Array<double, 2> full;  // prescribed velocities now, (rows, 6)
    Array<double, 2> reaction;  // minus the bond forces [N, N·m], (rows, 6)
    Array<double, 2> support;  // loads of walls on facets of cells [N, N·m], empty without any, (*, 6)
    // works of loads, drives, walls on facets and tractions on each row, then of body forces and strains [J]
    Array<double, 1> work;  // (works,)
};
// Piecewise linear functions of time, one after the other.
struct Timeline {
    Array<const double, 1> times;  // [s], (times,)
    Array<const double, 1> values;  // values at these times, (times,)
    Array<const Index, 1> start;  // start of each schedule, (schedules + 1,)
};
// Degrees of freedom that follow schedules.
struct Drives {
    Array<const Index, 1> row;  // (drives,)
    Array<const Index, 1> dof;  // (drives,)
    Array<const Index, 1> schedule;  // (drives,)
    Array<const Byte, 1> rate;  // 1 for a velocity, 0 for a displacement, (drives,)
};
// Forces and torques that follow schedules.
struct RowLoads {
    Array<const Index, 1> row;  // (loads,)
    Array<const Index, 1> schedule;  // (loads,)
    Array<const double, 2> value;  // [N, N·m], (loads, 6)
    Array<const Index, 1> turns;  // element with which each load turns, or -1, (loads,)
};
// Moments of loads on points of elements.
struct CoupleTable {
    Array<const Index, 1> start;  // start of the points of each moment, (couples + 1,)
    Array<const Index, 1> schedule;  // (couples,)
    Array<const double, 2> moment;  // [N·m], (couples, 3)
    Array<const Index, 1> element;  // element of each point, (points,)
    Array<const Index, 1> row;  // row of the boundary that the element owns, (points,)
    Array<const double, 2> arm;  // arm of each point from the centre of its element [m], (points, 3)
    Array<const double, 1> share;  // share of each point in its moment [-], (points,)
};
// Body forces on groups of elements.
struct BodyForces {
    Array<const Short, 1> group;  // group of each element, (n,)
    Array<const double, 2> member;  // 1 where a body force acts on a group, else 0, (groups, bodies)
    Array<const double, 2> pull;  // accelerations at factor 1 [m/s²], (bodies, 3)
    Array<const Index, 1> schedule;  // (bodies,)
    Array<double, 2> present;  // acceleration of each group now [m/s²], (groups, 3)
    Array<double, 1> factor;  // factors for which `present` is computed, (bodies,)
    Array<double, 2> work;  // work on each element [J], (n, 1)
};
// Damping and dashpots that resist the motion of elements.
struct Resistance {
    double gamma;  // of local damping [-]
    double alpha;  // of mass damping [1/s]
    Index viscous;  // 1 with mass damping or dashpots
    Array<double, 2> dashed;  // the sums of `Dashpots`, empty without, (*, 8)
    Array<const double, 2> absorbing;  // dashpots of each row, xx, yy, zz, xy, xz, yz [N·s/m], empty without, (*, 6)
};
// Stress-free strains of beams that change in time.
struct Strain {
    Array<const Index, 1> schedule;  // (strains,)
    Array<const Short, 1> bond;  // (strained,)
    Array<const double, 2> part;  // strain of each bond at factor 1 [-], (strains, strained)
    Array<const double, 1> still;  // 1 plus the strains that do not change [-], (strained,)
    Array<const double, 1> length;  // L without strain [m], (strained,)
    Array<const double, 1> shear;  // ks without strain [N/m], (strained,)
    Array<const double, 1> lever;  // a without strain [m], (strained,)
    Array<double, 2> factor;  // rows: factors a step ago and now, ∂U/∂factor [J] a step ago and now, (4, strains)
    Array<Index, 2> power;  // exact sums of ∂U/∂factor [J], zero between steps, (strains, exact_word::count)
    Array<Byte, 1> due;  // flags by `strain_due`: ∂U/∂factor is needed; lengths have changed, (2,)
    Index place;  // place of the work in the list of works
};

// Exact sums of a record or a guard, zero between them, to which passes add in any order.
struct Ledger {
    Array<Index, 2> sums;  // energies by `history_column` [J], (history_column::count, exact_word::count)
    Array<Index, 1> turned;  // unbroken bonds turned wide, and lost; portions with a number that is not finite, (3,)
    Array<double, 1> budget;  // energy at the start, and the largest energy supplied since [J], (2,)
    Array<Index, 1> found;  // bonds turned wide, and lost; 1 not finite, 2 a runaway; 1 for a list out of date, (4,)
};
// Elements, quantities and reductions of the gauges of a run.
struct Gauges {
    Array<const Index, 1> start;  // start of the elements of each gauge, (gauges + 1,)
    Array<const Index, 1> element;  // elements, or the number of a wall, (gauged,)
    Array<const Index, 1> quantity;  // number of the quantity, (gauges,)
    Array<const Index, 1> reduction;  // number of the reduction, (gauges,)
};
// Rows of the history.
struct HistoryRows {
    Array<double, 2> record;  // (*, columns)
};

// Lists of passes (`bondem._core_steps.Composer`).
struct StepPasses {
    Array<const Index, 2> present;  // bring boundary conditions to the time of the clock, (*, 8)
    Array<const Index, 2> opening;  // elements open a step after a pause, (*, 8)
    Array<const Index, 2> travel;  // walls move; check whether the list of contacts is valid, (*, 8)
    Array<const Index, 2> forces;  // forces, and the motion of elements by them, (*, 8)
    Array<const Index, 2> resume;  // postponed elements find their acceleration without failed bonds, (*, 8)
    Array<const Index, 2> reopening;  // postponed elements open the next step, (*, 8)
    Array<const Index, 2> guard;  // check of the run, (*, 8)
    Array<const Index, 2> record;  // a row of the history, (*, 8)
};
// Steps of a call of the core, and counts of its results.
struct StepSpan {
    Index step;  // number of the present step
    Index steps;  // number of steps to take
    Index every;  // steps between records, 0 for none
    Index records_present;  // 1 to record the present state without a step
    Index stale;  // 1 if forces have to be found before the present state is recorded
    Index moved;  // 1 if elements and walls have moved already in the first step, whose list was out of date
    Index n;  // number of elements
    Index m;  // number of bonds, without those that fill a group
    Array<Index, 1> done;  // steps done, records written, bonds turned wide at most and lost, (4,)
};
// Stresses of n elements in the previous step.
struct LaggedStresses {
    Array<const double, 1> inverse;  // 1 / V [1/m³], (n,)
    Array<double, 2> stress;  // in the element's own frame, xx, yy, zz, xy, xz, yz [Pa], (n, 6)
    Array<double, 2> space;  // in space, and bounds of σ1 and σ3 [Pa], (n, 8)
    // contributions of forces to V σ, zero between steps; rows of shared elements follow [N·m]
    Array<double, 2> moment;  // (*, 8)
    Array<const Short, 1> to_i;  // row of the moment of element i of each bond, (m,)
};

}  // namespace bondem
