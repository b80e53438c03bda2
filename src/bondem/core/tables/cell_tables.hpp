// What the passes over facets and cells take. Named once more in `bondem/interactions/cells/cell_tables.py`.
//
// A pose has the stress λ θ of its cell in its spare column [Pa]: the pass over forces finds it with the rest of the row.
#pragma once
#include "../array.hpp"

namespace bondem {

using Byte = uint8_t;

// Facets that are bonded, m of them, sorted by j; a few may follow that have no force, so that lanes can be filled.
//
// Levers are whole multiples of a pitch, shares and H single precision: what is computed from them is exact, and passes
// read half as much.
struct ElasticFacets {
    Array<const Short, 1> i, j;
    Array<double, 1> integrity;  // 1 intact … 0 broken [-]
    Array<const double, 1> k;  // 2 G A / L [N/m]
    Array<const double, 1> pitch;  // unit of the levers along x, y, z [m], (3,)
    Array<int32_t, 2> lever_i, lever_j;  // from the centres of mass to the facet [pitch], (3, m)
    Array<const float, 2> share_i, share_j;  // A w m [m²], (3, m)
    Array<const float, 2> H;  // resistance to relative rotation, xx, yy, zz, xy, xz, yz [N·m], (6, m)
    Array<const double, 2> normal;  // from i to j in the reference [-], (3, m)
    Array<const double, 1> period;  // edges of the periodic cell and their inverses, zero where there is none, (6,)
};
// Cells, n of them, and the dilatation that their facets add up.
struct CellDilatation {
    Array<double, 1> weight;  // λ / V [Pa/m³], (n,)
    Array<double, 1> given;  // part of V θ from tractions on free facets [m³], (n,)
    Array<double, 1> swelling;  // the rest of V θ [m³], zero between passes: of n cells, then of shared cells by domains
    Array<const Short, 1> to_i;  // where in `swelling` a facet adds to its cell i, (m,)
};
// Gradients of the dilatation: springs between the stresses λ θ of neighbouring cells, and bending of layers one cell
// thick (`laws/cell.hpp`). Cells without springs, and bodies without layers, have empty lists.
struct DilatationGradients {
    Array<const Index, 1> start;  // springs of cell p are start[p] … start[p + 1] - 1, (n + 1,)
    Array<const Short, 1> other;  // cell on the other side, (springs,)
    Array<const double, 1> spring;  // c [m³/Pa], (springs,)
    Array<double, 1> difference;  // Σ c (σ_p - σ_q) of each cell [m³], (n,)
    Array<const Index, 1> layer;  // facets of cell p within its layer, (layered + 1,); layered is n, or 0
    Array<const Short, 1> next;  // cell on the other side, (turns,)
    Array<const double, 2> way;  // n × s of the cell and of the other, for both directions across, turned to the cell
                                 // as i [m²], (turns, 12)
    Array<const Index, 1> hold;  // walls that hold cell p of a layer, (layered + 1,)
    Array<const Index, 1> wall;  // number of the wall, (layer_walls,)
    Array<const double, 2> wall_way;  // n × s of the wall for both directions, in space [m²], (layer_walls, 6)
    Array<const double, 2> weight;  // J λ / V² for both directions [Pa/m], (layered, 2)
    Array<double, 2> bend;  // J λ χ / V, for both directions [Pa·m], (layered, 2)
    Array<double, 2> torque;  // on each cell by bent layers [N·m], (layered, 3)
    Array<double, 1> energy;  // of both in portions of cells [J]
};
// The mass that waves of pressure lack in cells of finite size (`passes/cells/dilatation_rates.hpp`).
struct CorrectedMass {
    Array<const Index, 1> in_start, out_start;  // facets of each cell, as in `FacetsOfCells`, (n + 1,)
    Array<const Short, 1> out_bond;
    Array<const double, 1> factor;  // ρ β / V of each cell [kg/m⁶], (n,)
    Array<const Index, 1> wall_start;  // walls of cell p are wall[wall_start[p]] …, (n + 1,)
    Array<const Index, 1> wall;  // (held,)
    Array<double, 2> acceleration;  // of each element by its loads [m/s², rad/s²], (n, 6)
    Array<double, 1> inertia;  // ρ β θ̈ of each cell [Pa], (n,)
    Array<double, 2> force;  // force and torque of the correction on each element [N, N·m], (n, 6)
};
// Energy of dilatation in portions of cells [J].
struct DilatationEnergy {
    Array<double, 1> energy;  // (element portions,)
};
// Normal, shear, bending and twisting energy of all facets, cells and walls.
struct CellEnergies {
    Array<double, 1> energy;  // [J], (4,)
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
    Array<double, 2> moment;  // V σ of each cell, of its facets alone, in space, xx, yy, zz, xy, xz, yz [J], and Σ of
                              // `bending_square` [Pa²], (n, 7)
    Array<double, 2> sums;  // what is being added up of it, in rows as `StepCut.sums`, (rows, 8)
};
// Facets of each cell: first those of which it is j, then those of which it is i.
struct FacetsOfCells {
    Array<const Index, 1> in_start;  // facets in_start[p] … in_start[p + 1] have j = p, (n + 1,)
    Array<const Index, 1> out_start;  // those with i = p are in out_bond[out_start[p]] …, (n + 1,)
    Array<const Short, 1> out_bond;
};
// What the failure of a facet of integrity s changes: its missing part 1 - s is a free facet of both cells, so that they
// weigh dilatation less. The facets of each cell are those of `FacetsOfCells`.
struct FacetRelease {
    Array<const double, 1> whole;  // λ / V of each cell with all its facets [Pa/m³], (n,)
    Array<double, 1> weight;  // with those it has left: the array of `CellDilatation`
    Array<const double, 1> given;  // that of `CellDilatation` too
    Array<const double, 1> slack_i, slack_j;  // what 1 / weight of each side gains where a facet fails [m³/Pa], (bonds,)
    Array<const Index, 1> in_start, out_start;  // (n + 1,)
    Array<const Short, 1> out_bond;
    Array<const Index, 1> wall_start;  // walls of each cell: wall(wall_start(p)) … wall(wall_start(p + 1) - 1), (n + 1,)
    Array<const Index, 1> wall;  // ascending, (held,)
    Array<Short, 1> changed;  // cells of the facets that fail in a step, then their neighbours, (n,)
    Array<Index, 1> changes;  // how many, (1,)
};

// Facets on the surface that walls hold, g of them, each by the half facet of its cell. A wall keeps its orientation.
struct WallConstraints {
    Array<const Index, 1> cell;  // (g,)
    Array<const Index, 1> row;  // of the boundary, that the cell owns, (g,)
    Array<const double, 1> k;  // 2 G A / d [N/m], (g,)
    Array<const double, 2> lever;  // from the centre of the cell to the facet in the reference [m], (g, 3)
    Array<double, 2> arm;  // the same with stress-free and plastic strains of the cell [m], (g, 3)
    Array<const double, 2> share;  // A m along the held axes [m²], (g, 3)
    Array<const double, 2> H;  // resistance to rotation, xx, yy, zz, xy, xz, yz [N·m], (g, 6)
    Array<double, 2> base;  // where the motion of the wall counts from [m], and the quaternion of the cell there, (g, 7)
    Array<const double, 2> axes;  // 1 where held, along x, y, z, (g, 3)
    Array<const Index, 2> drive;  // schedule that moves the wall along x, y, z, or -1, (g, 3)
    Array<const Byte, 1> rate;  // whether a schedule is a velocity
    Array<const double, 1> times, values;  // schedules, as `Timeline` has them
    Array<const Index, 1> start;
    Index place;  // of the walls in the list of works
    Array<double, 2> wall;  // displacement of the wall now [m], (g, 3)
    Array<double, 2> came;  // by how much it has come in this step [m], (g, 3)
    Array<double, 2> load;  // force and torque on the cell [N, N·m], (g, 6)
    Array<const double, 1> friction;  // μ of a wall on which the facet may slide, NaN for one that holds it, (g,)
    Array<const double, 2> inward;  // axis along which such a wall presses on the cell, (g, 3)
};
// Tractions on free facets, l of them, which change the dilatation of their cells.
struct FacetTractions {
    Array<const double, 2> value;  // what each adds to V θ at full load [m³], (l, n)
    Array<const Index, 1> schedule;  // (l,)
    Index place;  // in the list of works
    Array<double, 1> factor;  // present factors, (l,)
    Array<double, 1> came;  // by how much they have changed in this step, (l,)
};
// Stress-free strains of cells that change in time, g of them: levers of facets and of walls are 1 + ε* times as long.
struct CellStrains {
    Array<const Index, 1> schedule;  // (g,)
    Array<const double, 2> base_i, base_j;  // levers of the reference [m], (3, facets)
    Array<const double, 1> still;  // 1 + ε* of the state, (facets,)
    Array<const double, 2> part;  // strain of each facet at factor 1, (g, facets)
    Array<const double, 2> wall_base;  // levers of walls [m], (w, 3)
    Array<const double, 1> wall_still;  // (w,)
    Array<const double, 2> wall_part;  // (g, w)
    Index place;  // of their work in the list of works
    Array<double, 2> factor;  // of each strain: now, by how much it came, ∂U/∂factor before and now [J], (4, g)
    Array<double, 2> power;  // ∂U/∂factor of portions of facets [J], (portions, g)
    Array<double, 1> cracked;  // ∂U/∂factor of cracks, where there are any [J], (g,)
    Array<Byte, 1> due;  // whether ∂U/∂factor is needed, and whether levers have changed, (2,)
};
// The time that walls are placed at.
struct WallTime {
    double time;  // [s]
};
// Vectors, k of them, and the same turned by unit quaternions w x y z.
struct TurnedVectors {
    Array<const double, 2> quaternion;  // (k, 4)
    Array<const double, 2> vector;  // (k, 3)
    Array<double, 2> turned;  // (k, 3)
};
// Forces on elements, k of them, and V σ of the elements.
struct MomentsOfForces {
    Array<double, 2> moment;  // xx, yy, zz, xy, yz, zx [J], (n, 6)
    Array<const Index, 1> owner;  // element that each force acts on, (k,)
    Array<const double, 2> arm;  // from its centre [m], (k, 3)
    Array<const double, 2> force;  // [N], (k, 3)
    double sign;
};

}  // namespace bondem
