// What passes over an index take on a device beside the tables of a step. Named once more in
// `bondem/dynamics/device_tables.py`.
#pragma once
#include "contact_tables.hpp"
#include "step_tables.hpp"

namespace bondem {

// The clock of a run on a device, and how many elements and bonds there are.
struct DeviceSpan {
    Array<Index, 1> clock;  // a `Clock`, word by word, (9,)
    Array<const Byte, 1> postponed;  // not 0 for elements that do not open the next step with the others, (n,), or none
    Array<Index, 1> halted;  // 1 where a list of contacts has to be made anew before the step continues, (1,)
    Index n, m;
};
// How the clock is set.
struct Tick {
    Index ahead;  // by how many steps
    Index goes_on, still, first;  // as a `Clock` says; `still` leaves no time to a step
};
// What each bond does to its two ends.
struct LoadsOfBonds {
    Array<double, 2> load;  // force on j, torque on i, torque on j [N, N·m], (9, m)
};
// Bonds whose load reaches their bound, and those of them that fail.
struct BondMarks {
    Array<Byte, 1> mark;  // see `gpu/breakage.hpp`, (m,)
    Array<Short, 1> failing;  // bonds that fail in a step, in any order, (m,)
    Array<Byte, 1> mode;  // how, (m,)
};
// Energy that beams dissipate in a step, by the place of their rows in the lists of `SofteningBeams` [J].
struct SofteningLosses {
    Array<double, 1> lost;  // (m,)
};
// Bonds of each element, both lists ascending.
struct BondsOfElements {
    Array<const int32_t, 1> in_start;  // bonds in_start(p) … in_start(p + 1) have j = p, (n + 1,)
    Array<const int32_t, 1> out_start;  // where the list of those with i = p begins, (n + 1,)
    Array<const Short, 1> out_bond;  // (m,)
};
// Pairs of contact whose earlier element each element is, ascending.
struct EarlierPairs {
    Array<const int32_t, 1> start;  // (n + 1,)
    Array<const Short, 1> pair;
};
// Loads of each row, or walls, in their order.
struct RowOrder {
    Array<const Index, 1> start;  // where those of each row begin, (r + 1,)
    Array<const Index, 1> load;
};
// Sums over portions of the works, work and its absolute value [J].
struct WorkPortions {
    Array<double, 2> works;  // (portions, 2)
};
// Strains that change: whether any does in this step, and whether ∂U/∂factor is needed; and portions of it [J].
struct StrainPortions {
    Array<Index, 1> due;  // (2,)
    Array<double, 2> power;  // (portions, g)
};
// Energy of portions of walls that hold facets [J].
struct WallEnergy {
    Array<double, 1> energy;
};
// What cracks dissipate in a step [J], and those of which nothing is left.
struct LossesOfCracks {
    Array<double, 1> lost;  // of each facet, (m,)
    Array<double, 1> portion, group;  // sums of it
    Array<Index, 1> fallen, number;  // facets, in any order until they are logged, (m,), and how many, (1,)
};
// Energy that faces which begin to touch take over.
struct BegunFaces {
    Array<double, 1> gained;  // of each portion of elements [J]
};
// Levers of the cells of each facet in space [m], and T_b² [Pa²].
struct FacetArms {
    Array<double, 2> arm;  // (7, m)
};
// Energies across and along cracks, and of bending, of portions of facets [J].
struct CrackPortions {
    Array<double, 2> energy;  // (portions, 3)
};
// What portions of facets have released beyond their fracture energy.
struct CrushingPortions {
    Array<double, 1> energy;  // [J], (portions,)
};
// Sums over groups of portions, see `gpu/record.hpp`.
struct FoldedPortions {
    Array<double, 2> sums;  // (groups, 13)
};
// Parts of the sums or largest values of gauges, as many for each.
struct GaugeParts {
    Index each;
    Array<double, 2> parts;  // (gauges × each, 3)
};

}  // namespace bondem
