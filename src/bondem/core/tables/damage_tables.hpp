// What the damage pipeline takes (`passes/damage/pipeline.hpp`). "Bonds" are beams, facets of cells or pairs of the
// non-local law: the m interactions of one kind that may fail. Named once more in `bondem/dynamics/damage_tables.py`.
#pragma once
#include "step_tables.hpp"

namespace bondem {

// Bounds that bonds do not reach as long as they cannot fail, on a size of their loads.
struct FailureBounds {
    Array<float, 1> limit;  // of of_force |F|² + of_moment |M|²; inf of bonds that cannot fail [-], (m,)
    double of_force, of_moment;  // [1/N², 1/(N·m)²]
};
// Coefficients of the criterion of each bond, and the place along a beam where its moment counts.
struct Strengths {
    Array<const double, 2> coefficient;  // (m, 4)
    Array<const double, 1> station;  // from i over the length, below 0 where the larger moment of both ends counts [-], (m,)
};
// Bonds that are near to failure, and then those of them that fail, in the order of the bonds.
struct Candidates {
    Array<const Index, 1> begin;  // first bond of each block, (blocks + 1,)
    Array<Index, 1> marked;  // those of a block from begin[block] on, (m,)
    Array<Index, 1> mode;  // of those that fail, as `FailureMode`, (m,)
    Array<Index, 1> count;  // number of each block, (blocks,)
    Array<Index, 1> any;  // 1 where a bond fails in this step, (1,)
};
// Elements that close a step with all bonds, and open the next without those that failed, n elements.
struct Postponed {
    Array<Byte, 1> held;  // not 0 for elements that are postponed, (n,)
    Array<Short, 1> element, row;  // lists of these elements, and rows of their sums, (n,)
    Index first_row;  // of the sums of `StepCut` that keep those of the postponed, one row per element
    Array<double, 2> kept;  // these rows, (n, 8)
};
// Failures of one call of the core, in the order of time.
struct EventLog {
    // time [s], step, bond, mode, gap [m], energy [J], place [m], steps since onset, (m, 10)
    Array<double, 2> event;
    Array<Index, 1> written;  // number of events, and of those before the present step, (2,)
    Array<double, 1> released;  // energy released since the start of the run [J], (1,)
    Array<double, 1> crushed;  // what bonds had released before it beyond their fracture energy [J], (1,)
};
// Of beams what failure changes: integrity, and integrity over rest length where beams differ in length only.
struct BeamIntegrity {
    Array<double, 1> integrity;  // 1 intact … 0 broken [-], (m,)
    Array<double, 1> hold;  // [1/m], (m,), or (0,)
};
// Index of the criterion of each bond.
struct FailureIndices {
    Array<double, 1> index;  // 1 at failure, 0 of broken bonds [-], (m,)
};
// Bonds of which a criterion evaluates a stress, those of a portion of bonds from its first bond on.
struct StressCandidates {
    Array<Index, 1> bond;  // (m,)
    Array<double, 3> stress;  // symmetric [Pa], (m, 3, 3)
    Array<double, 1> found;  // index of each, at 1 a bond fails [-], (m,)
    Array<Index, 1> number;  // of candidates of each portion
    Array<Index, 1> total;  // of all portions, where they have been moved together, (1,)
};
// A criterion that is a function of a stress.
struct StressFunction {
    Index address;  // of a C function (`passes/damage/stress_criteria.hpp`), 0 for a criterion of the core
    Array<const double, 1> parameter;
};

}  // namespace bondem
