// Tables of the passes over facets and cells.
//
// Column `stress_column` of a pose has the stress of its cell [Pa], so that passes read both from one cache line.
#pragma once
#include "../array.hpp"

namespace bondem {

// Bonded facets, m of them; facets without force follow if they are fewer than a group of lanes.
//
// Levers are whole multiples of a pitch, shares and H are in single precision. Their conversion to doubles is exact,
// and passes read half as many bytes.
struct ElasticFacets {
    Array<const Short, 1> i;  // first cell of each facet, (m,)
    Array<const Short, 1> j;  // second cell of each facet, (m,)
    Array<double, 1> integrity;  // 1 intact … 0 broken [-], (m,)
    Array<const double, 1> k;  // stiffness 2 G A / L [N/m], (m,)
    Array<const double, 1> pitch;  // unit of the levers along x, y, z [m], (3,)
    Array<int32_t, 2> lever_i;  // from the centre of mass of cell i to the facet [pitch], (3, m)
    Array<int32_t, 2> lever_j;  // from the centre of mass of cell j to the facet [pitch], (3, m)
    Array<const float, 2> share_i;  // share in V θ of cell i, A w m [m²], (3, m)
    Array<const float, 2> share_j;  // share in V θ of cell j, A w m [m²], (3, m)
    Array<const float, 2> H;  // resistance to relative rotation, xx, yy, zz, xy, xz, yz [N·m], (6, m)
    Array<const double, 2> normal;  // from i to j in the reference [-], (3, m)
    Array<const double, 1> period;  // edges of the periodic cell and their inverses, zero where there is none, (6,)
};
// Cells, n of them, and the dilatation that their facets add up.
struct CellDilatation {
    Array<double, 1> weight;  // λ / V [Pa/m³], (n,)
    Array<double, 1> given;  // part of V θ from tractions on free facets [m³], (n,)
    // rest of V θ [m³], zero until facets add to it: n cells, then parts of shared cells by domains
    Array<double, 1> swelling;  // (*,)
    Array<const Short, 1> to_i;  // place in `swelling` where a facet adds to its cell i, (m,)
};
// Springs between the stresses λ θ of neighbouring cells, and bending of layers one cell thick.
struct DilatationGradients {
    Array<const Index, 1> start;  // springs of cell p are start[p] … start[p + 1] - 1, (n + 1,)
    Array<const Short, 1> other;  // cell on the other side, (springs,)
    Array<const double, 1> spring;  // stiffness c of each spring [m³/Pa], (springs,)
    Array<double, 1> difference;  // Σ c (σ_p - σ_q) of each cell [m³], (n,)
    // start of the facets of cell p within its layer; layered is n, or 0
    Array<const Index, 1> layer;  // (layered + 1,)
    Array<const Short, 1> next;  // cell on the other side, (turns,)
    // n × s of the cell and of the other one for both directions, n normal to the layer, signs for the cell as i [m²]
    Array<const double, 2> way;  // (turns, 12)
    Array<const Index, 1> wall_start;  // start of the walls that fix cell p of a layer, (layered + 1,)
    Array<const Index, 1> wall;  // number of the wall, (layer_walls,)
    Array<const double, 2> wall_way;  // n × s of the wall for both directions, in space [m²], (layer_walls, 6)
    Array<const double, 2> weight;  // J λ / V² for both directions [Pa/m], (layered, 2)
    Array<double, 2> bend;  // J λ χ / V for both directions, then their changes by small motions [Pa·m], (layered, 4)
    Array<double, 2> torque;  // on each cell by bent layers [N·m], (layered, 3)
};
// Dispersion-corrected mass of cells, with which short waves of pressure keep their speed.
struct CorrectedMass {
    Array<const Index, 1> in_start;  // facets of each cell, as in `FacetsOfCells`, (n + 1,)
    Array<const Index, 1> out_start;  // facets of each cell, as in `FacetsOfCells`, (n + 1,)
    Array<const Short, 1> out_bond;  // facets of each cell, as in `FacetsOfCells`, (*,)
    Array<const double, 1> factor;  // ρ β / V of each cell [kg/m⁶], (n,)
    Array<const Index, 1> wall_start;  // walls of cell p are wall[wall_start[p]] …, (n + 1,)
    Array<const Index, 1> wall;  // numbers of the walls, cell by cell, (supports,)
    Array<double, 2> acceleration;  // acceleration of each element by its loads [m/s², rad/s²], (n, 6)
    Array<double, 1> inertia;  // ρ β θ̈ of each cell [Pa], (n,)
    Array<double, 2> force;  // force and torque of the correction on each element [N, N·m], (n, 6)
};
// Energies of all facets, cells and walls.
struct CellEnergies {
    Array<double, 1> energy;  // normal, shear, bending, twisting [J], (4,)
};
// Poses of cells; passes write the stresses λ θ in them.
struct CellPoses {
    Array<double, 2> pose;  // (n, 8)
    Array<const double, 2> rest;  // centres in the reference [m], (n, 3)
};

// Forces of facets and moments of cells, which criteria of cracks and yielding need.
struct FacetForces {
    Array<const double, 1> bends;  // factor 4 k / A² of v·H v in T_b² [N/m⁵], (m,)
    Array<double, 2> force;  // force of each facet on its cell i in the last step [N], (3, m)
    Array<double, 2> moment;  // V σ of each cell, xx, yy, zz, xy, xz, yz [J], and Σ T_b² of its facets [Pa²], (n, 7)
    Array<double, 2> sums;  // V σ and Σ T_b² (xx, yy, zz, Σ T_b², xy, xz, yz, 0) in rows as `StepBlocks.sums`, (*, 8)
};
// Facets of each cell: first those of which it is j, then those of which it is i.
struct FacetsOfCells {
    Array<const Index, 1> in_start;  // facets in_start[p] … in_start[p + 1] - 1 have j = p, (n + 1,)
    Array<const Index, 1> out_start;  // facets with i = p are out_bond[out_start[p]] …, (n + 1,)
    Array<const Short, 1> out_bond;  // facets by their cells i, (*,)
};
// Effect of failing facets on their cells, n of them; a failed facet is a free facet of both cells.
struct FacetRelease {
    Array<const double, 1> whole;  // λ / V of each cell with all its facets [Pa/m³], (n,)
    Array<double, 1> weight;  // λ / V with the unbroken facets: the array of `CellDilatation`, (n,)
    Array<const double, 1> given;  // array `given` of `CellDilatation`, (n,)
    Array<const double, 1> slack_i;  // increase of 1 / weight of cell i if the facet fails [m³/Pa], (bonds,)
    Array<const double, 1> slack_j;  // increase of 1 / weight of cell j if the facet fails [m³/Pa], (bonds,)
    Array<const Index, 1> in_start;  // facets of each cell, as in `FacetsOfCells`, (n + 1,)
    Array<const Index, 1> out_start;  // facets of each cell, as in `FacetsOfCells`, (n + 1,)
    Array<const Short, 1> out_bond;  // facets of each cell, as in `FacetsOfCells`, (bonds,)
    // walls of each cell: wall(wall_start(p)) … wall(wall_start(p + 1) - 1)
    Array<const Index, 1> wall_start;  // (n + 1,)
    Array<const Index, 1> wall;  // ascending, (supports,)
    Array<Short, 1> changed;  // cells of the facets that fail in a step, then their neighbours, (n,)
    Array<Index, 1> changes;  // number of these cells, (1,)
};

// Facets on the surface that walls fix or support, each by the half facet of its cell.
struct WallConstraints {
    Array<const Index, 1> cell;  // (supports,)
    Array<const Index, 1> row;  // row of the boundary that the cell owns, (supports,)
    Array<const double, 1> k;  // 2 G A / d [N/m], (supports,)
    Array<const double, 2> lever;  // from the centre of the cell to the facet in the reference [m], (supports, 3)
    Array<double, 2> arm;  // lever with stress-free and plastic strains of the cell [m], (supports, 3)
    Array<const double, 2> share;  // A m along the fixed axes [m²], (supports, 3)
    Array<const double, 2> H;  // resistance to rotation, xx, yy, zz, xy, xz, yz [N·m], (supports, 6)
    Array<double, 2> base;  // origin of the motion of the wall [m], and the quaternion of the cell there, (supports, 7)
    Array<const double, 2> axes;  // 1 where fixed, along x, y, z, (supports, 3)
    Array<const Index, 2> drive;  // schedule that moves the wall along x, y, z, or -1, (supports, 3)
    Array<const Byte, 1> rate;  // 1 for schedules of velocities, (support_schedules,)
    Array<const double, 1> times;  // times of the schedules, one after the other [s], (support_times,)
    Array<const double, 1> values;  // values of the schedules at these times, (support_times,)
    Array<const Index, 1> start;  // start of each schedule, (support_schedules + 1,)
    Array<double, 2> wall;  // displacement of the wall now [m], (supports, 3)
    Array<double, 2> increment;  // displacement of the wall in this step [m], (supports, 3)
    Array<double, 2> load;  // force and torque on the cell [N, N·m], (supports, 6)
    Array<const double, 1> friction;  // μ of a wall on which the facet may slide, NaN if it may not, (supports,)
    Array<const double, 2> inward;  // axis along which a wall with friction presses on the cell, (supports, 3)
};
// Tractions on free facets, which change the dilatation of their cells.
struct FacetTractions {
    Array<const double, 2> value;  // contribution of each to V θ of the cells at full load [m³], (tractions, n)
    Array<const Index, 1> schedule;  // (tractions,)
    Array<double, 1> factor;  // present factors, (tractions,)
    Array<double, 1> increment;  // changes of the factors in this step, (tractions,)
};
// Stress-free strains of cells that change in time.
struct CellStrains {
    Array<const Index, 1> schedule;  // (strains,)
    Array<const double, 2> base_i;  // levers of cells i in the reference [m], (3, strained)
    Array<const double, 2> base_j;  // levers of cells j in the reference [m], (3, strained)
    Array<const double, 1> still;  // 1 + ε* of each facet without the strains that change, (strained,)
    Array<const double, 2> part;  // strain of each facet at factor 1, (strains, strained)
    Array<const double, 2> wall_base;  // levers of walls [m], (supports, 3)
    Array<const double, 1> wall_still;  // 1 + ε* at each wall without the strains that change, (supports,)
    Array<const double, 2> wall_part;  // strain at each wall at factor 1, (strains, supports)
    Index place;  // place of their work in the list of works
    Array<double, 2> factor;  // rows: factors a step ago and now, ∂U/∂factor [J] a step ago and now, (4, strains)
    Array<Index, 2> power;  // exact sums of ∂U/∂factor [J], zero between steps, (strains, exact_word::count)
    Array<Byte, 1> due;  // flags by `strain_due`: ∂U/∂factor is needed; levers have changed, (2,)
};
// Time at which walls are placed.
struct WallTime {
    double time;  // [s]
};
// Vectors, and their rotations by unit quaternions.
struct TurnedVectors {
    Array<const double, 2> quaternion;  // w x y z, (vectors, 4)
    Array<const double, 2> vector;  // (vectors, 3)
    Array<double, 2> turned;  // (vectors, 3)
};
// Forces on elements, and the moments V σ of the elements.
struct MomentsOfForces {
    Array<double, 2> moment;  // xx, yy, zz, xy, yz, zx [J], (*, 6)
    Array<const Index, 1> owner;  // element that each force acts on, (vectors,)
    Array<const double, 2> arm;  // arm of each force from the centre of its element [m], (vectors, 3)
    Array<const double, 2> force;  // [N], (vectors, 3)
    double sign;  // factor of all moments [-]
};

}  // namespace bondem
