// Tables of the passes over facets and cells.
//
// A pose has the stress λ θ of its cell in its spare column [Pa]: the pass over forces finds it with the rest of the row.
#pragma once
#include "../array.hpp"

namespace bondem {

using Byte = uint8_t;

// Bonded facets, m of them; fewer than a group are followed by facets without force.
//
// Levers are whole multiples of a pitch, shares and H single precision: results from them are exact, and passes read
// half as much.
struct ElasticFacets {
    Array<const Short, 1> i;  // (m,)
    Array<const Short, 1> j;  // (m,)
    Array<double, 1> integrity;  // 1 intact … 0 broken [-], (m,)
    Array<const double, 1> k;  // 2 G A / L [N/m], (m,)
    Array<const double, 1> pitch;  // unit of the levers along x, y, z [m], (3,)
    Array<int32_t, 2> lever_i;  // from the centres of mass to the facet [pitch], (3, m)
    Array<int32_t, 2> lever_j;  // from the centres of mass to the facet [pitch], (3, m)
    Array<const float, 2> share_i;  // A w m [m²], (3, m)
    Array<const float, 2> share_j;  // A w m [m²], (3, m)
    Array<const float, 2> H;  // resistance to relative rotation, xx, yy, zz, xy, xz, yz [N·m], (6, m)
    Array<const double, 2> normal;  // from i to j in the reference [-], (3, m)
    Array<const double, 1> period;  // edges of the periodic cell and their inverses, zero where there is none, (6,)
};
// Cells, n of them, and the dilatation that their facets add up.
struct CellDilatation {
    Array<double, 1> weight;  // λ / V [Pa/m³], (n,)
    Array<double, 1> given;  // part of V θ from tractions on free facets [m³], (n,)
    // the rest of V θ [m³], zero between passes: of n cells, then of shared cells by domains
    Array<double, 1> swelling;  // (*,)
    Array<const Short, 1> to_i;  // place in `swelling` where a facet adds to its cell i, (m,)
};
// Springs between the stresses λ θ of neighbouring cells, and bending of layers one cell thick.
struct DilatationGradients {
    Array<const Index, 1> start;  // springs of cell p are start[p] … start[p + 1] - 1, (n + 1,)
    Array<const Short, 1> other;  // cell on the other side, (springs,)
    Array<const double, 1> spring;  // c [m³/Pa], (springs,)
    Array<double, 1> difference;  // Σ c (σ_p - σ_q) of each cell [m³], (n,)
    // facets of cell p within its layer, (layered + 1,); layered is n, or 0
    Array<const Index, 1> layer;  // (layered + 1,)
    Array<const Short, 1> next;  // cell on the other side, (turns,)
    // n × s of the cell and of the other, for both directions, turned to the cell as i [m²]
    Array<const double, 2> way;  // (turns, 12)
    Array<const Index, 1> wall_start;  // walls that hold cell p of a layer, (layered + 1,)
    Array<const Index, 1> wall;  // number of the wall, (layer_walls,)
    Array<const double, 2> wall_way;  // n × s of the wall for both directions, in space [m²], (layer_walls, 6)
    Array<const double, 2> weight;  // J λ / V² for both directions [Pa/m], (layered, 2)
    Array<double, 2> bend;  // J λ χ / V for both directions, and by small motions [Pa·m], (layered, 4)
    Array<double, 2> torque;  // on each cell by bent layers [N·m], (layered, 3)
};
// The mass that waves of pressure lack in cells of finite size.
struct CorrectedMass {
    Array<const Index, 1> in_start;  // facets of each cell, as in `FacetsOfCells`, (n + 1,)
    Array<const Index, 1> out_start;  // facets of each cell, as in `FacetsOfCells`, (n + 1,)
    Array<const Short, 1> out_bond;  // (*,)
    Array<const double, 1> factor;  // ρ β / V of each cell [kg/m⁶], (n,)
    Array<const Index, 1> wall_start;  // walls of cell p are wall[wall_start[p]] …, (n + 1,)
    Array<const Index, 1> wall;  // (supports,)
    Array<double, 2> acceleration;  // of each element by its loads [m/s², rad/s²], (n, 6)
    Array<double, 1> inertia;  // ρ β θ̈ of each cell [Pa], (n,)
    Array<double, 2> force;  // force and torque of the correction on each element [N, N·m], (n, 6)
};
// Energies of all facets, cells and walls.
struct CellEnergies {
    Array<double, 1> energy;  // normal, shear, bending, twisting [J], (4,)
};
// Poses of cells, whose stresses passes write.
struct CellPoses {
    Array<double, 2> pose;  // (n, 8)
    Array<const double, 2> rest;  // centres in the reference [m], (n, 3)
};

// Forces of facets and moments of cells, which criteria of cracks and yielding need.
struct FacetForces {
    Array<const double, 1> bends;  // 4 k / A², by which bending is a traction [1/(N m³)], (m,)
    Array<double, 2> force;  // of each facet on its cell i in the last step [N], (3, m)
    // V σ of each cell, xx, yy, zz, xy, xz, yz [J], and the square of its bending [Pa²]
    Array<double, 2> moment;  // (n, 7)
    Array<double, 2> sums;  // sums of them in rows as `StepBlocks.sums`, (*, 8)
};
// Facets of each cell: first those of which it is j, then those of which it is i.
struct FacetsOfCells {
    Array<const Index, 1> in_start;  // facets in_start[p] … in_start[p + 1] have j = p, (n + 1,)
    Array<const Index, 1> out_start;  // those with i = p are out_bond[out_start[p]] …, (n + 1,)
    Array<const Short, 1> out_bond;  // (*,)
};
// Effect of failing facets on their cells, n of them; a failed facet is a free facet of both cells.
struct FacetRelease {
    Array<const double, 1> whole;  // λ / V of each cell with all its facets [Pa/m³], (n,)
    Array<double, 1> weight;  // λ / V with the unbroken facets: the array of `CellDilatation`, (n,)
    Array<const double, 1> given;  // the array of `CellDilatation`, (n,)
    Array<const double, 1> slack_i;  // increase of 1 / weight of cell i if the facet fails [m³/Pa], (bonds,)
    Array<const double, 1> slack_j;  // increase of 1 / weight of cell j if the facet fails [m³/Pa], (bonds,)
    Array<const Index, 1> in_start;  // facets of each cell, as in `FacetsOfCells`, (n + 1,)
    Array<const Index, 1> out_start;  // (n + 1,)
    Array<const Short, 1> out_bond;  // (bonds,)
    // walls of each cell: wall(wall_start(p)) … wall(wall_start(p + 1) - 1)
    Array<const Index, 1> wall_start;  // (n + 1,)
    Array<const Index, 1> wall;  // ascending, (supports,)
    Array<Short, 1> changed;  // cells of the facets that fail in a step, then their neighbours, (n,)
    Array<Index, 1> changes;  // their number, (1,)
};

// Facets on the surface that walls hold, g of them, each by the half facet of its cell.
struct WallConstraints {
    Array<const Index, 1> cell;  // (supports,)
    Array<const Index, 1> row;  // row of the boundary that the cell owns, (supports,)
    Array<const double, 1> k;  // 2 G A / d [N/m], (supports,)
    Array<const double, 2> lever;  // from the centre of the cell to the facet in the reference [m], (supports, 3)
    Array<double, 2> arm;  // the same with stress-free and plastic strains of the cell [m], (supports, 3)
    Array<const double, 2> share;  // A m along the fixed axes [m²], (supports, 3)
    Array<const double, 2> H;  // resistance to rotation, xx, yy, zz, xy, xz, yz [N·m], (supports, 6)
    Array<double, 2> base;  // origin of the motion of the wall [m], and the quaternion of the cell there, (supports, 7)
    Array<const double, 2> axes;  // 1 where fixed, along x, y, z, (supports, 3)
    Array<const Index, 2> drive;  // schedule that moves the wall along x, y, z, or -1, (supports, 3)
    Array<const Byte, 1> rate;  // 1 for schedules of velocities, (support_schedules,)
    Array<const double, 1> times;  // schedules, one after the other, (support_times,)
    Array<const double, 1> values;  // schedules, as `Timeline` has them, (support_times,)
    Array<const Index, 1> start;  // (support_schedules + 1,)
    Array<double, 2> wall;  // displacement of the wall now [m], (supports, 3)
    Array<double, 2> increment;  // of it in this step [m], (supports, 3)
    Array<double, 2> load;  // force and torque on the cell [N, N·m], (supports, 6)
    Array<const double, 1> friction;  // μ of a wall on which the facet may slide, NaN for one that holds it, (supports,)
    Array<const double, 2> inward;  // axis along which such a wall presses on the cell, (supports, 3)
};
// Tractions on free facets, l of them, which change the dilatation of their cells.
struct FacetTractions {
    Array<const double, 2> value;  // contribution of each to V θ at full load [m³], (tractions, n)
    Array<const Index, 1> schedule;  // (tractions,)
    Array<double, 1> factor;  // present factors, (tractions,)
    Array<double, 1> increment;  // of them in this step, (tractions,)
};
// Stress-free strains of cells that change in time, g of them.
struct CellStrains {
    Array<const Index, 1> schedule;  // (strains,)
    Array<const double, 2> base_i;  // levers of the reference [m], (3, strained)
    Array<const double, 2> base_j;  // levers of the reference [m], (3, strained)
    Array<const double, 1> still;  // 1 + ε* of the state, (strained,)
    Array<const double, 2> part;  // strain of each facet at factor 1, (strains, strained)
    Array<const double, 2> wall_base;  // levers of walls [m], (supports, 3)
    Array<const double, 1> wall_still;  // (supports,)
    Array<const double, 2> wall_part;  // (strains, supports)
    Index place;  // of their work in the list of works
    Array<double, 2> factor;  // of each strain: now, its increment, ∂U/∂factor before and now [J], (4, strains)
    Array<Index, 2> power;  // exact sums of ∂U/∂factor [J], zero between steps, (strains, exact_word::count)
    Array<Byte, 1> due;  // 1 where ∂U/∂factor is needed, and where levers have changed, (2,)
};
// Time that walls are placed at.
struct WallTime {
    double time;  // [s]
};
// Vectors, k of them, and the same rotated by unit quaternions.
struct TurnedVectors {
    Array<const double, 2> quaternion;  // w x y z, (vectors, 4)
    Array<const double, 2> vector;  // (vectors, 3)
    Array<double, 2> turned;  // (vectors, 3)
};
// Forces on elements, k of them, and V σ of the elements.
struct MomentsOfForces {
    Array<double, 2> moment;  // xx, yy, zz, xy, yz, zx [J], (*, 6)
    Array<const Index, 1> owner;  // element that each force acts on, (vectors,)
    Array<const double, 2> arm;  // from its centre [m], (vectors, 3)
    Array<const double, 2> force;  // [N], (vectors, 3)
    double sign;
};

}  // namespace bondem
