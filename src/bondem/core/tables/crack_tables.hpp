// Tables of the passes over cracked facets and yielding cells.
#pragma once
#include "../array.hpp"

namespace bondem {

// Mean stresses of n cells, and Σ b⊗f of their cracks, with the forces f at the levers b.
struct StressesOfCells {
    Array<const double, 1> volume;  // [m³], (n,)
    Array<double, 2> tensor;  // stress in the last step, xx … yz [Pa], Σ T_b² [Pa²], size [Pa], (n, 8)
    // Σ b⊗f of cracks, b in the reference and f in space: b_x f, b_y f, b_z f [J], and a number after each, the
    // first of which is 0 for cells that have had no crack
    Array<double, 2> carried;  // (n, 12)
    Array<const double, 3> pressed;  // contribution of loads on free facets to V σ at full load [J], (*, n, 6)
};
// Strengths and plastic strains of cells that yield.
struct YieldingCells {
    Index cone;  // 1 for Drucker and Prager, 0 for Mohr and Coulomb
    Array<const double, 1> cohesion;  // c cos φ or k [Pa], inf for cells that do not yield, (n,)
    Array<const double, 1> slope;  // sin φ, or α [-], (n,)
    Array<const double, 1> dilation;  // sin ψ, or β [-], (n,)
    Array<const double, 1> stiffness;  // H [Pa], (n,)
    Array<const double, 1> fade;  // share of the cohesion lost at a mean slip of 1 of the cells nearby, (n,)
    Array<const Index, 1> near_start;  // cells near cell p are near[near_start[p]] …, (n + 1,)
    Array<const Short, 1> near;  // (*,)
    Array<double, 1> slipped;  // Σ Δγ before this step, which other cells read, (n,)
    Array<double, 1> carry;  // array of the state: slip with which the next step begins, (n,)
    // P - 1 by rows, Σ Δγ, last increment of strain in space, energy dissipated [J]
    Array<double, 2> plastic;  // (n, plastic_column::count)
    Array<int32_t, 2> base_i;  // levers of facets without plastic strain [pitch], (3, m)
    Array<int32_t, 2> base_j;  // levers of facets without plastic strain [pitch], (3, m)
    Array<double, 2> base_wall;  // levers of walls without plastic strain [m], (supports, 3)
};

// Strengths of m facets.
struct FacetStrengths {
    Array<const double, 1> area;  // [m²], (m,)
    Array<const double, 1> strength;  // f_t [Pa], (m,)
    Array<const double, 1> absorbed;  // fracture energy G_f A [J], inf of brittle facets, (m,)
    Array<const double, 1> brittleness;  // 1 over the traction k u / A of the last opening [1/Pa], (m,)
    Array<const double, 1> part;  // part of cell i in the compliance, (m,)
    Array<const double, 1> fastest;  // largest loss of integrity in a step of facets that break at once, (m,)
    Array<const double, 1> friction;  // tan φ, μ of closed cracks, (m,)
    Array<const double, 1> plane;  // 1 for facets of material planes, (m,)
    Array<const double, 1> cohesion;  // cohesion of facets of material planes [Pa], (m,)
    Array<const double, 1> slip_brittleness;  // `brittleness` for slip along a material plane [1/Pa], (m,)
    Array<const Index, 1> planes;  // facets of material planes, (*,)
    double kink;  // κ of the softening curve [-]
    double steep;  // m of the softening curve [-]
    double hot;  // √(σ:σ) + √Σ T_b² of a cell above which its facets are evaluated [Pa]
};
// Marks of facets that begin to crack, and of cells whose facets are evaluated.
struct CrackOnset {
    Array<Byte, 1> cracked;  // 1 for cells with cracks, (n,)
    Array<Byte, 1> judged;  // 1 for cells whose facets are evaluated, 2 for those without cohesion, (n,)
    // 1 for facets that begin to crack, 2 for those of a cell without cohesion; zero between steps
    Array<Byte, 1> marked;  // (m,)
    Array<Byte, 1> listed;  // `listed` of `CohesiveCracks`, (m,)
    Array<Index, 1> found;  // number of marks of each portion of facets, and of planes, (bond_portions + 1,)
};

// Cracked facets, by the number of their facet; rows as in `core/passes/cracks/crack_rows.hpp`.
struct CohesiveCracks {
    Array<double, 2> shape;  // `CrackShapeRow`, (facets, 8)
    Array<double, 2> face;  // `CrackFaceRow`, (facets, 8)
    Array<double, 2> state;  // `CrackStateRow`, (facets, 8)
    Array<double, 2> frame;  // `CrackFrameRow`, (facets, 8)
    Array<double, 2> past;  // `CrackPastRow`, (facets, 8)
    Array<double, 2> softening;  // `CrackSofteningRow`, (facets, 8)
    Array<double, 2> history;  // `CrackHistoryRow`, (facets, 8)
    Array<double, 2> pull;  // force on cell i [N], (facets, 4)
    Array<int32_t, 2> lever;  // levers of cells i and j in the reference, each with an unused number [pitch], (facets, 8)
    Array<double, 1> pitch;  // unit of levers [m], (3,)
    Array<Index, 1> order;  // cracked facets in the order in which they began, (facets,)
    Array<Byte, 1> listed;  // 0 for whole facets, else 1 plus the `crack::CrackStatus`, (m,)
    Array<double, 1> integrity;  // integrity of cracks, array of the state [-], (facets,)
    Array<Index, 1> size;  // number of cracks, and 1 where lists are out of date, (2,)
    double slide;  // largest slip of faces of material planes that face each other, over √A, at most 1 [-]
};
// Facets of each cell, and the increase of 1 / weight of the cell if a facet breaks.
struct CellSlack {
    Array<const Index, 1> in_start;  // facets of each cell, as `FacetsOfCells` has them, (n + 1,)
    Array<const Index, 1> out_start;  // facets of each cell, as `FacetsOfCells` has them, (n + 1,)
    Array<const Short, 1> out_bond;  // (*,)
    Array<const double, 1> slack_i;  // increase of 1 / weight of cell i if the facet parts [m³/Pa], (m,)
    Array<const double, 1> slack_j;  // increase of 1 / weight of cell j if the facet parts [m³/Pa], (m,)
    Array<const double, 1> weight;  // λ / V of each cell with all its facets [Pa/m³], (n,)
};
// Lists of active and of resting cracks in a step, and data of the cracks on them.
struct CrackLists {
    Array<Index, 1> size;  // numbers of entries by `list_count`, (4,)
    Array<Index, 1> treated;  // active cracks; lanes after the last one repeat it, (places,)
    Array<Index, 1> resting;  // resting cracks; lanes after the last one repeat it, (places,)
    Array<Short, 1> treated_i;  // cells i of active cracks, (places,)
    Array<Short, 1> treated_j;  // cells j of active cracks, (places,)
    Array<Short, 1> resting_i;  // cells i of resting cracks, (places,)
    Array<Short, 1> resting_j;  // cells j of resting cracks, (places,)
    Array<Index, 1> parted;  // facets whose faces have parted in this step, (places,)
    Array<Short, 1> cell;  // cells of active cracks, (*,)
    Array<int32_t, 1> head;  // first half of an active crack at each cell, 0 without, (n,)
    Array<int32_t, 1> next;  // half at the same cell that follows a half, 0 at the end, (halves,)
    Array<Byte, 1> flag;  // `crack::Flag` of active cracks, by place, (places,)
    Array<Byte, 1> waking;  // `crack::Flag` of resting cracks, by place, (places,)
    Array<Index, 1> flagged;  // above 0 for a portion of active cracks with a flag, (crack_portions,)
    Array<Index, 1> woken;  // above 0 for a portion of resting cracks with a flag, (crack_portions,)
    Array<Byte, 1> outdated;  // 1 for cells whose stress has to be found again, (n,)
    Array<int32_t, 1> leader;  // facet of the leading crack of each cell, -1 without, (n,)
    Array<double, 1> base;  // V θ without active cracks [m³], (n,)
    // `SwellingHalf` of each half by its number (`half_of`), replaced by loads (`crack::LoadColumn`) once forces are
    // known: one memory for both, because the data of many cracks exceed the caches
    Array<double, 2> half;  // (halves, 16)
    Array<double, 2> sum;  // sums of the first eight columns of loads over the halves of each cell, (n, 8)
    Array<double, 2> slip;  // slip of the cracks of each cell in this step [m], and `crack::Slipping`, (n, 4)
    Array<Index, 2> lost;  // exact sum of the energy dissipated in a step [J], (1, exact_word::count)
};
// Distances of centres at which two cells touch once their facet has parted.
struct PartedReach {
    Array<double, 1> apart;  // distance of each facet [m], (*,)
};

}  // namespace bondem
