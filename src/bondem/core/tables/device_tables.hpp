// Tables of passes over an index on a device, beside those of a step.
#pragma once
#include "contact_tables.hpp"
#include "step_tables.hpp"

namespace bondem {

// The clock of a run on a device, and how many elements and bonds there are.
struct DeviceSpan {
    // word by word: times and coefficients of the scheme (5), step, first, continues, record;
    Array<Index, 1> clock;  // (9,)
    Array<const Byte, 1> postponed;  // not 0 for elements that do not open the next step with the others, (*,)
    Array<Index, 1> halted;  // 1 where a list of contacts has to be made anew before the step goes on, (1,)
    Index n;
    Index m;
};
// Change of the clock.
struct Tick {
    Index ahead;  // by how many steps
    Index goes_on;  // whether elements open the next step
    Index still;  // whether the step has no time
    Index first;  // whether the time was not reached by a step
};
// Loads of each bond on its two ends.
struct LoadsOfBonds {
    Array<double, 2> load;  // force on j, torque on i, torque on j [N, N·m], (9, *)
};
// Bonds whose load reaches their bound, and those of them that fail.
struct BondMarks {
    Array<Byte, 1> mark;  // 1 for bonds near to failure, 2 for those that fail, (bonds,)
    Array<Short, 1> failing;  // bonds that fail in a step, in any order, (bonds,)
    Array<Byte, 1> mode;  // how, (bonds,)
};
// Energy that beams dissipate in a step.
struct SofteningLosses {
    Array<double, 1> lost;  // by the place of their rows in the lists of `SofteningBeams` [J], (bonds,)
};
// Bonds of each element, both lists ascending.
struct BondsOfElements {
    Array<const int32_t, 1> in_start;  // bonds in_start[p] … in_start[p + 1] have j = p, (n + 1,)
    Array<const int32_t, 1> out_start;  // where the list of those with i = p begins, (n + 1,)
    Array<const Short, 1> out_bond;  // (*,)
};
// Pairs of contact whose earlier element each element is, ascending.
struct EarlierPairs {
    Array<const int32_t, 1> start;  // (n + 1,)
    Array<const Short, 1> pair;  // (pairs,)
};
// Loads of each row, or walls, in their order.
struct RowOrder {
    Array<const Index, 1> start;  // where those of each row begin, (*,)
    Array<const Index, 1> load;  // (*,)
};
// Sums over portions of the works.
struct WorkPortions {
    Array<double, 2> works;  // work and its absolute value [J], (work_portions, 2)
};
// Changes of strains in a step, and portions of their power.
struct StrainPortions {
    Array<Index, 1> due;  // whether any changes, and whether ∂U/∂factor is needed, (2,)
    Array<double, 2> power;  // ∂U/∂factor [J], (*, *)
};
// Energy of portions of walls that hold facets.
struct WallEnergy {
    Array<double, 1> energy;  // [J], (wall_portions,)
};
// Energies that cracks dissipate in a step, and cracks that break.
struct LossesOfCracks {
    Array<double, 1> lost;  // of each facet [J], (*,)
    Array<double, 1> portion;  // sums of it, (loss_portions,)
    Array<double, 1> group;  // sums of it, (loss_groups,)
    Array<Index, 1> fallen;  // facets, in any order until they are logged, (*,)
    Array<Index, 1> number;  // how many, (1,)
};
// Energy that faces store as they begin to touch.
struct BegunFaces {
    Array<double, 1> gained;  // of each portion of elements [J], (element_portions,)
};
// Levers of the cells of each facet in space, and the square of T_b.
struct FacetArms {
    Array<double, 2> arm;  // [m], and T_b² [Pa²], (7, *)
};
// Energies of cracks of portions of facets.
struct CrackPortions {
    Array<double, 2> energy;  // across and along cracks, and of bending [J], (*, 3)
};
// Energies that portions of facets have released beyond their fracture energy.
struct CrushingPortions {
    Array<double, 1> energy;  // [J], (*,)
};
// Sums over groups of portions.
struct FoldedPortions {
    Array<double, 2> sums;  // first columns of `device_column`, (folds, 13)
};
// Parts of the sums or largest values of gauges.
struct GaugeParts {
    Index each;  // for each gauge
    Array<double, 2> parts;  // (*, 3)
};

}  // namespace bondem
