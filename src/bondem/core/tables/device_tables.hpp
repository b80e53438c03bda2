// Tables of passes that run on a device (GPU), in addition to those of a step.
#pragma once
#include "contact_tables.hpp"
#include "step_tables.hpp"

namespace bondem {

// The clock of a run on a device, and how many elements and bonds there are.
struct DeviceSpan {
    // words of `Clock`: time, dt and coefficients of the scheme (5), step, first, goes_on, record
    Array<Index, 1> clock;  // (9,)
    Array<const Byte, 1> postponed;  // not 0 for elements that do not open the next step with the others, (*,)
    Array<Index, 1> halted;  // 1 where a list of contacts has to be made anew before the step goes on, (1,)
    Index n;  // number of elements
    Index m;  // number of bonds
};
// Change of the clock of a device.
struct Tick {
    Index ahead;  // number of steps ahead
    Index goes_on;  // 1 if elements open the next step
    Index still;  // 1 for a step of duration 0
    Index first;  // 1 at the start of a call of the loop, before its first step
};
// Loads of each bond on its two ends.
struct LoadsOfBonds {
    Array<double, 2> load;  // force on j, torque on i, torque on j [N, N·m], (9, *)
};
// Bonds whose load reaches their bound, and those of them that fail.
struct BondMarks {
    Array<Byte, 1> mark;  // 1 for bonds near to failure, 2 for those that fail, (bonds,)
    Array<Short, 1> failing;  // bonds that fail in a step, in any order, (bonds,)
    Array<Byte, 1> mode;  // `failure_mode` of the bonds in `failing`, (bonds,)
};
// Bonds of each element, both lists ascending.
struct BondsOfElements {
    Array<const int32_t, 1> in_start;  // bonds in_start[p] … in_start[p + 1] - 1 have j = p, (n + 1,)
    Array<const int32_t, 1> out_start;  // start of the bonds with i = p in `out_bond`, (n + 1,)
    Array<const Short, 1> out_bond;  // bonds by their elements i, (*,)
};
// Contact pairs of each element as the earlier one of the pair, ascending.
struct EarlierPairs {
    Array<const int32_t, 1> start;  // start of the pairs of each element, (n + 1,)
    Array<const Short, 1> pair;  // numbers of the pairs, element by element, (pairs,)
};
// Loads, walls or contacts that act on each row, cell or wall, in their order.
struct RowOrder {
    Array<const Index, 1> start;  // start of the entries of each row, cell or wall in `load`, (*,)
    Array<const Index, 1> load;  // numbers of the loads, walls or contacts, (*,)
};
// Cracks that break in a step.
struct FallenCracks {
    Array<Index, 1> fallen;  // facets, in any order until they are logged, (*,)
    Array<Index, 1> number;  // number of facets in `fallen`, (1,)
};
// Levers of the cells of each facet in space, and the square of T_b.
struct FacetArms {
    Array<double, 2> arm;  // [m], and T_b² [Pa²], (7, *)
};
// Sums of gauges, and largest values of their parts.
struct GaugeParts {
    Index each;  // parts of each gauge
    Array<Index, 2> sums;  // exact sums of the components of gauges, zero between records, (*, exact_word::count)
    Array<double, 2> largest;  // largest absolute values of each part, (*, 3)
};

}  // namespace bondem
