// What the passes over cracked facets and cells that yield take. Named once more in
// `bondem/dynamics/cohesive_tables.py`.
#pragma once
#include "../array.hpp"

namespace bondem {

using Byte = uint8_t;

// Mean stresses of n cells, and what their cracks carry.
struct StressesOfCells {
    Array<const double, 1> volume;  // [m³], (n,)
    // in the last step, in space, xx, yy, zz, xy, xz, yz [Pa], Σ T_b² [Pa²], size √(σ:σ) [Pa], (n, 8)
    Array<double, 2> tensor;
    // Σ b⊗f of cracks, b in the reference and f in space: b_x f, b_y f, b_z f [J], and a number behind each,
    // the first of which is 0 for cells that have had no crack, (n, 12)
    Array<double, 2> carried;
    Array<const double, 3> pressed;  // what loads on free facets add to V σ at full load [J], (l, n, 6)
};
// Cells that yield (`laws/plasticity.hpp`).
struct YieldingCells {
    Index cone;  // whether by Drucker and Prager
    Array<const double, 1> cohesion;  // c cos φ or k [Pa], inf for cells that do not yield, (n,)
    Array<const double, 1> slope, dilation, stiffness;  // (n,)
    Array<const double, 1> fade;  // share of the cohesion lost by a mean slip of 1 of the cells near, (n,)
    Array<const Index, 1> near_start;  // cells near cell p are near[near_start[p]] …, (n + 1,)
    Array<const Short, 1> near;
    Array<double, 1> slipped;  // Σ Δγ before this step, which other cells read, (n,)
    Array<double, 1> held;  // slip that the next step begins with, (n,)
    Array<double, 2> plastic;  // P - 1 by rows, Σ Δγ, last increment of strain in space, energy dissipated [J], (n, 17)
    Array<int32_t, 2> base_i, base_j;  // levers of facets without plastic strain [pitch], (3, m)
    Array<double, 2> base_wall;  // those of walls [m], (g, 3)
};

// m facets as softening has them (`laws/softening.hpp`).
struct FacetStrengths {
    Array<const double, 1> area;  // [m²]
    Array<const double, 1> strength;  // f_t [Pa]
    Array<const double, 1> absorbed;  // G_f A [J], inf of brittle facets
    Array<const double, 1> brittleness;  // 1 / T_l [1/Pa]
    Array<const double, 1> part;  // part of cell i in the compliance
    Array<const double, 1> fastest;  // by how much the integrity of what breaks at once falls in a step at most
    Array<const double, 1> friction;  // tan φ, μ of closed cracks
    Array<const double, 1> plane;  // 1 for facets of material planes
    Array<const double, 1> cohesion, slip_brittleness;  // of these [Pa, 1/Pa]
    Array<const Index, 1> planes;  // facets of material planes
    double kink, steep;  // of the softening curve
    double hot;  // largest principal stress of a cell from which the criterion of its facets is evaluated [Pa]
};
// Which facets begin to crack.
struct CrackOnset {
    Array<Byte, 1> cracked;  // 1 for cells with cracks, (n,)
    Array<Byte, 1> judged;  // 1 for cells whose facets are evaluated, 2 for those without cohesion, (n,)
    // 1 for facets that begin to crack, 2 for those of a cell without cohesion; zero between steps, (m,)
    Array<Byte, 1> marked;
    Array<Byte, 1> listed;  // that of `CohesiveCracks`, (m,)
    Array<Index, 1> found;  // how many of a portion of facets are marked, and at the end of the planes
};

// Cracked facets, by the number of their facet. Rows are lines of the cache, each for some passes
// (`passes/cracks/crack_rows.hpp`); those of whole facets are not used, and take no memory.
struct CohesiveCracks {
    Array<double, 2> shape, face, state, frame, past, softening, history;  // (facets, 8)
    Array<double, 2> pull;  // force on cell i [N], (facets, 4)
    Array<double, 1> pitch;  // unit of levers [m], (3,)
    Array<Index, 1> order;  // cracked facets in the order in which they began
    Array<Byte, 1> listed;  // of each facet: 0 whole, else 1 and how its crack is treated, (m,)
    Array<double, 1> integrity;  // of each facet, (facets,)
    Array<Index, 1> size;  // number of cracks, and whether lists are out of date, (2,)
    double slide;  // largest slip of faces of material planes that face each other, over √A, at most 1 [-]
};
// What cells lose with facets that are treated as facets of less integrity.
struct CellSlack {
    Array<const Index, 1> in_start, out_start;  // facets of each cell, as `FacetsOfCells` has them, (n + 1,)
    Array<const Short, 1> out_bond;
    Array<const double, 1> slack_i, slack_j;  // what 1 / weight of a cell gains where the facet parts [m³/Pa], (m,)
    Array<const double, 1> weight;  // λ / V of each cell with all its facets [Pa/m³], (n,)
};
// Lists of a step, and what is known of the cracks on them. A half is a side of a crack; those of a cell have numbers that
// follow each other, but for halves of cracks that have woken in this step. Number 0 is none.
struct CrackLists {
    // numbers of cracks treated one by one, of those that rest, of cells of the first, and of `parted`, (4,)
    Array<Index, 1> size;
    Array<Index, 1> treated, resting;  // cracks; lanes behind the last one repeat it
    Array<Short, 1> treated_i, treated_j, resting_i, resting_j;  // their cells
    Array<Index, 1> parted;  // facets whose faces have parted in this step
    Array<Short, 1> cell;  // cells of cracks that are treated one by one
    Array<int32_t, 1> head;  // first half of each cell, (n,)
    Array<int32_t, 2> number;  // of the halves on cells i and j, by place, (places, 2)
    Array<int32_t, 1> side;  // of a half: twice its facet on cell i, and one more on cell j, (halves,)
    Array<int32_t, 2> node;  // next half of its cell, and the lever of this one in the reference [pitch], (halves, 4)
    Array<Byte, 1> flag, waking;  // what becomes of a crack, by place
    Array<Index, 1> flagged, woken;  // whether there is a flag in a portion
    Array<Byte, 1> stale;  // 1 for cells whose stress is to be found again, (n,)
    Array<double, 1> base;  // V θ without cracks that are treated one by one [m³], (n,)
    // By number of the half a `SwellingHalf`, and once forces are known `crack::LoadColumn`, (halves, 16): one memory for
    // both, as what is known of many cracks is more than caches have.
    Array<double, 2> half;
    Array<double, 2> sum;  // of the first eight columns of loads over the halves of a cell, (n, 8)
    Array<double, 2> slip;  // by how much the cracks of a cell slip in this step [m], (n, 4)
    Array<double, 2> lost;  // energy of portions dissipated, and that of cracks that part [J], (portions, 2)
};
// Where elements touch that a facet does not join any more.
struct PartedReach {
    Array<double, 1> apart;  // distance of the centres, by facet [m]
};
// Energies of cells with cracks.
struct CrackEnergies {
    Array<double, 1> dilatation;  // of portions of cells [J]
    Array<double, 1> heat;  // that these have dissipated by yielding [J]
    Array<double, 1> cracked;  // elastic energy across and along cracks, and of bending [J], (3,)
};

}  // namespace bondem
