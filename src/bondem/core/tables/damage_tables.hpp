// Tables of the damage pipeline (`passes/damage/pipeline.hpp`). "Bonds" are the m interactions of one kind that may
// fail: beams, facets of cells, or bonds of the non-local law.
#pragma once
#include "step_tables.hpp"

namespace bondem {

// Bounds of the loads of bonds, below which no bond fails.
struct FailureBounds {
    Array<float, 1> limit;  // bound of of_force |F|² + of_moment (|M_i|² + |M_j|²), inf for bonds that cannot fail, (m,)
    double of_force;  // [1/N²]
    double of_moment;  // [1/(N·m)²]
};
// Coefficients of the criterion of each bond.
struct Strengths {
    Array<const double, 2> coefficient;  // (bonds, 4)
    // place where the moment counts, from i over the length; below 0 for the larger end
    Array<const double, 1> station;  // (bonds,)
};
// Bonds that are near to failure, and then those of them that fail, in the order of the bonds.
struct Candidates {
    Array<const Index, 1> begin;  // first bond of each block, (blocks + 1,)
    Array<Index, 1> marked;  // numbers of the bonds; those of a block from begin[block] on, (bonds,)
    Array<Index, 1> mode;  // modes of bonds that fail, (bonds,)
    Array<Index, 1> count;  // number of bonds in `marked` of each block, (blocks,)
    Array<Index, 1> any;  // 1 where a bond fails in this step, (1,)
};
// Postponed elements, which close a step with all bonds and open the next one without failed bonds.
struct Postponed {
    Array<Byte, 1> flag;  // not 0 for elements that are postponed, (n,)
    Array<Short, 1> element;  // lists of postponed elements, (n,)
    Array<Short, 1> row;  // rows of the sums of the elements in the lists, (n,)
    Index first_row;  // first of the rows of `StepBlocks.sums` that keep sums of postponed elements, one per element
    Array<double, 2> sum;  // sums of postponed elements until they resume, in the rows from `first_row` on, (n, 8)
};
// Failures of one call of the core, in the order of time.
struct EventLog {
    // time [s], step, bond, mode, gap [m], energy [J], place [m], steps since onset
    Array<double, 2> event;  // (bonds, event_column::count)
    Array<double, 1> pressed;  // largest overlap with which a contact may take over from each event [m], (bonds,)
    Array<Index, 1> written;  // number of events, and of those before the present step, (2,)
    Array<double, 1> released;  // energy released since the start of the run [J], (1,)
    Array<double, 1> crushed;  // energy released beyond the fracture energy before the run [J], (1,)
};
// Integrity of beams, which failure changes.
struct BeamIntegrity {
    Array<double, 1> integrity;  // 1 intact … 0 broken [-], (m,)
    Array<double, 1> per_length;  // integrity over rest length of beams that share their constants [1/m], (*,)
};
// Index of the criterion of each bond.
struct FailureIndices {
    Array<double, 1> index;  // 1 at failure, 0 of broken bonds [-], (m,)
};
// Facets with given tractions, for which a criterion is evaluated.
struct LoadedTractions {
    Array<const double, 2> normal;  // [-], (m, 3)
    Array<const double, 2> traction;  // [Pa], (m, 3)
    Array<const double, 1> area;  // [m²], (m,)
};
// Bonds or facets whose stress a criterion evaluates in a step, with their stresses.
struct StressCandidates {
    Array<Index, 1> bond;  // bonds; those of a portion begin at the number of its first bond, (candidates,)
    Array<double, 3> stress;  // symmetric [Pa], (candidates, 3, 3)
    Array<double, 1> found;  // index of each, at 1 a bond fails [-], (candidates,)
    Array<Index, 1> number;  // number of candidates of each portion, (bond_portions,)
    Array<Index, 1> total;  // number of candidates of all portions, once moved together, (1,)
};
// A criterion that is a function of a stress.
struct StressFunction {
    Index address;  // of a C function (`passes/damage/stress_criteria.hpp`), 0 for a criterion of the core
    Array<const double, 1> parameter;  // (parameters,)
};

}  // namespace bondem
