// Tables of the passes over contacts of elements and walls.
//
// Each pair is listed once, sorted by the larger number of its two elements and then by the smaller one, as bonds
// are. A portion of elements is a range of consecutive numbers, with the pairs whose larger number is in the range.
#pragma once
#include "damage_tables.hpp"
#include "packing_tables.hpp"
#include "step_tables.hpp"
#include "wall_rows.hpp"

namespace bondem {

// Parameters of the law of a contact.
struct ContactRow {
    double modulus;  // effective modulus [Pa]
    double soft;  // ks / kn [-]
    double friction;  // μ [-]
    double damping;  // β [-]
    double rolling;  // coefficient μ_r of the resistance to rolling [-]
    double twisting;  // coefficient μ_w of the resistance to twisting [-]
    double deep;  // overlap over the radius at which the stiffness against rolling is taken [-]
    double strength;  // strength of adhesion, 0 for none [Pa]
    double reach;  // reach of adhesion, 0 for none [m]
};
// The laws of contacts by kinds of elements, and the radii of the elements.
struct ContactConstants {
    Array<const double, 3> between;  // rows of `ContactRow` of pairs of each two kinds, (kinds, kinds, 9)
    Array<const double, 3> at_walls;  // rows of `ContactRow` of each kind at each wall, (kinds, walls, 9)
    Array<const Byte, 1> kind;  // kind of each element, (n,)
    Index hertzian;  // 1 for the law of Hertz and Mindlin, 0 for linear contact
    Array<const double, 1> radius;  // [m], (n,)
    const ContactRow &of(Short a, Short b) const { return between.row<const ContactRow>(kind(a), kind(b)); }
    const ContactRow &at_wall(Short p, Index w) const { return at_walls.row<const ContactRow>(kind(p), w); }
};
// Pairs that may touch before their list is renewed.
struct ContactPairs {
    Array<const Short, 1> first;  // earlier element of each pair, (pairs,)
    Array<const Short, 1> second;  // later element of each pair, (pairs,)
    Array<const Index, 1> start;  // start of the pairs of each later element, (n + 1,)
    Array<double, 1> reach;  // distance of the centres at which a pair touches [m], (pairs,)
    // the same at rest; `reach` is less from a failure under less pressure until the two are farther apart [m]
    Array<double, 1> whole;  // (pairs,)
    Array<const double, 1> own;  // kn of a pair with a stiffness of its own, else 0 [N/m], (pairs,)
    // tangential stretch [m] and force of the dashpots [N]; of faces the overlap u0 [m] and kn a step ago [N/m]
    Array<double, 2> memory;  // (pairs, 8)
    Array<Byte, 1> touch;  // `TouchState`, (pairs,)
    Array<const Index, 1> bond;  // bond of each pair, or -1; a pair does not touch while its bond joins it, (pairs,)
    Array<double, 1> joined;  // above 0 for bonds that join their elements, which then do not touch, (*,)
    Array<const Index, 1> of_bond;  // the pair of each bond, or -1, (*,)
    Array<const double, 1> period;  // edges of the periodic cell and their inverses, zero where there is none, (6,)
};
// Pairs that every step examines, until distances are measured again.
struct NearPairs {
    Array<Short, 1> near;  // pairs that may touch, (pairs + 1,)
    Array<Short, 1> close;  // pairs that touch or have just parted, (pairs + 1,)
    // of close pairs: force on the later element [N], dashpot loss [J], torque over radius [N], friction loss [J]
    Array<double, 2> output;  // (pairs, 8)
    Array<Index, 2> counts;  // numbers of near and of close pairs of each portion of elements, (element_portions, 2)
    double width;  // motion of an element after which distances are measured again [m]
    double beyond;  // largest gap at which pairs act on each other without touching [m]
};
// Adhesion of near pairs.
struct AdheringPairs {
    Array<double, 2> force;  // on the later element [N], (pairs, 3)
};
// Resistance of pairs to rolling.
struct RolledPairs {
    Array<double, 2> rolled;  // R̄ times the rotation that the spring of each pair stores [m], (pairs, 3)
    Array<double, 2> output;  // moment on the later element [N·m], lost to friction [J], (pairs, 4)
};
// Resistance of elements at walls to rolling.
struct RolledWalls {
    Array<double, 2> rolled;  // R times the rotation that the spring of each contact stores [m], (wall_contacts, 3)
};
// Faces of cells on material planes whose facet has cracked, and the pairs that touch by them.
struct FacePairs {
    Array<const Index, 1> in_start;  // facets of each cell, as `FacetsOfCells` has them, (n + 1,)
    Array<const Index, 1> out_start;  // facets of each cell, as `FacetsOfCells` has them, (n + 1,)
    Array<const Short, 1> out_bond;  // facets of each cell, as `FacetsOfCells` has them, (*,)
    Array<const int32_t, 2> lever_i;  // levers as in `ElasticFacets`, (3, m)
    Array<const int32_t, 2> lever_j;  // levers as in `ElasticFacets`, (3, m)
    Array<const double, 1> pitch;  // unit of the levers [m], (3,)
    Array<const double, 2> normal;  // normals as in `ElasticFacets`, (3, m)
    Array<const Short, 1> j;  // later cell, (m,)
    Array<const double, 1> k;  // stiffness of the facet [N/m], (m,)
    Array<const double, 1> area;  // [m²], (m,)
    Array<const Byte, 1> listed;  // `listed` of `CohesiveCracks`, (m,)
    Array<const double, 1> plane;  // 1 for facets of material planes, (m,)
    Array<Byte, 1> open;  // 1 for facets whose faces have parted, 2 in the step in which they do, (m,)
    Array<Byte, 1> faced;  // 1 for cells with such a facet, 2 in the step in which it parts, (n,)
    Array<const double, 1> outer;  // distance within which two cells touch by faces, as a sum of both [m], (n,)
    Array<const Index, 1> earlier_start;  // start of the pairs whose earlier element each element is, (n + 1,)
    Array<const Short, 1> earlier;  // numbers of the pairs, by their earlier elements, (pairs,)
    Array<double, 1> chosen;  // the two faces by which each pair touches as one number, 0 for none, (pairs,)
    // pairs that touch by faces or did a step ago, ascending, each portion from its first pair; on devices 1 or 0
    Array<Short, 1> close;  // (pairs,)
    // of pair k: force on the later element [N], loss to dashpots [J], torque on it [N·m], loss to friction [J],
    // torque on the earlier one [N·m]
    Array<double, 2> output;  // (pairs, 12)
    Array<double, 1> gained;  // energy taken over from facets that part [J], (pairs,)
    Array<Index, 2> gained_sum;  // exact sum of `gained`, zero between steps, (1, exact_word::count)
    Array<Index, 1> count;  // number of close pairs of each portion of elements, (element_portions,)
};
// Motion of the elements since their distances were measured, and since the list was made.
struct Travel {
    Array<const double, 2> listed;  // centres when the list was made [m], (n, 3)
    Array<double, 2> measured;  // centres when distances were measured [m], (n, 3)
    // squares of the largest motions since measuring and since listing [m²], and the deepest overlap [-]
    Array<double, 2> portion;  // (element_portions, 3)
    Array<double, 1> far;  // both largest motions; the second is below 0 before the first measurement [m], (2,)
    double reach;  // motion of an element or a wall for which the list is made [m]
};
// Forces and losses of contacts of elements, zero between steps.
struct ContactSums {
    Array<double, 2> sums;  // force [N], lost to dashpots [J], torque [N·m], lost to friction [J], (n, 8)
};

// Contacts of elements with walls.
struct WallContacts {
    Array<const Index, 1> start;  // start of the contacts of each element, (n + 1,)
    Array<const Short, 1> element;  // (wall_contacts,)
    Array<const Short, 1> wall;  // (wall_contacts,)
    Array<const double, 1> gap;  // gap from which the overlap counts [m], (wall_contacts,)
    Array<double, 2> memory;  // memory as in `ContactPairs`, (wall_contacts, 6)
    Array<Byte, 1> touch;  // `TouchState`, (wall_contacts,)
    Array<double, 2> output;  // rows of `WallLoad`, (wall_contacts, 7)
    Array<Index, 2> sums;  // exact sums of `WallLoad` of each wall by `wall_sum`, zero between steps, (*, exact_word::count)
};
// Shapes, positions and loads of walls.
struct Walls {
    Array<const double, 2> shape;  // rows of `WallShape`, (walls, 12)
    Array<double, 2> body;  // positions, velocities and loads of the walls, as `State.walls`, (walls, 27)
    Array<const double, 2> inertia;  // rows of `WallInertia`, (walls, 8)
    Array<double, 2> listed;  // where the walls were when the list was made, rows of `WallListed`, (walls, 8)
};
// Prescribed motions of walls, servos, and free walls.
struct WallMotions {
    Array<const double, 1> times;  // times of the schedules, as in `Timeline` [s], (wall_times,)
    Array<const double, 1> values;  // values of the schedules, as in `Timeline`, (wall_times,)
    Array<const Index, 1> start;  // start of each schedule, (wall_schedules + 1,)
    Array<const Index, 1> drive_wall;  // (wall_drives,)
    Array<const Index, 1> drive_component;  // 0, 1, 2 for x, y, z, 3 for growth, else rotation, (wall_drives,)
    Array<const Index, 1> drive_schedule;  // (wall_drives,)
    Array<const Byte, 1> drive_rate;  // 1 for a velocity, 0 for a displacement, (wall_drives,)
    Array<const double, 2> drive_axis;  // axis of a rotation, zero for other components, (wall_drives, 3)
    Array<const Index, 1> servo_wall;  // (servos,)
    Array<const Index, 1> servo_schedule;  // (servos,)
    Array<const double, 1> servo_speed;  // largest speed [m/s], (servos,)
    Array<const double, 1> servo_mass;  // [kg], (servos,)
    Array<const double, 1> servo_damping;  // share of the missing force that resists the motion [-], (servos,)
    Array<const Index, 1> free_wall;  // (free_walls,)
    Array<const double, 1> free_mass;  // [kg], (free_walls,)
    Array<const double, 2> free_force;  // force on each wall without that of elements [N], (free_walls, 3)
    Array<const double, 2> free_torque;  // torque on each wall without that of elements [N·m], (free_walls, 3)
};

// ---- the search

// Bonds and memories of contacts, from which the list of pairs is made.
struct PairSources {
    Array<const Index, 1> bond_start;  // start of the bonds of each later element, (n + 1,)
    Array<const Short, 1> bond_first;  // earlier elements of the bonds, (m,)
    Array<const Byte, 1> wanted;  // 1 for bonds whose pair is listed at any distance, (m,)
    // start of the pairs of each later element that overlap in the reference
    Array<const Index, 1> rest_start;  // (n + 1,)
    Array<const Short, 1> rest_first;  // earlier elements of pairs that overlap in the reference, (rest,)
    Array<const double, 1> rest_gap;  // gaps of pairs that overlap in the reference [m], (rest,)
    Array<const Index, 1> touching_start;  // start of the pairs of each later element that touch, (n + 1,)
    Array<const Short, 1> touching_first;  // earlier elements of pairs that touch, (touching,)
    Array<const double, 2> touching_memory;  // memories of pairs that touch, as in `ContactPairs`, (touching, 8)
};
// The list of pairs, sorted by the later element, then by the earlier one.
struct FoundPairs {
    Array<Short, 1> first;  // earlier element of each pair, (room,)
    Array<Short, 1> second;  // later element of each pair, (room,)
    Array<Index, 1> bond;  // the bond of each pair, or -1, (room,)
    Array<Index, 1> start;  // start of the pairs of each later element, (n + 1,)
    Array<double, 1> gap;  // gap from which the overlap counts, at most 0 [m], (room,)
    Array<double, 2> memory;  // memory as in `State.stretch`, (room, 8)
    Array<Byte, 1> touch;  // `TouchState`, (room,)
};
// Memories of contacts with walls, from which their list is made.
struct WallSources {
    Array<const double, 1> radius;  // radii of the elements [m], (n,)
    Array<const Index, 1> rest_start;  // start of the contacts of each element that overlap in the reference, (n + 1,)
    Array<const Short, 1> rest_wall;  // walls of contacts that overlap in the reference, (rest,)
    Array<const double, 1> rest_gap;  // gaps of contacts that overlap in the reference [m], (rest,)
    Array<const Index, 1> touching_start;  // start of the contacts of each element that touch, (n + 1,)
    Array<const Short, 1> touching_wall;  // walls of contacts that touch, (touching,)
    Array<const double, 2> touching_memory;  // memories of contacts that touch, as in `WallContacts`, (touching, 6)
    double skin;  // largest gap [m]
    Array<Index, 1> start;  // start of the found contacts of each element, (n + 1,)
};
// The list of contacts with walls, sorted by element, then by wall.
struct FoundWalls {
    Array<Short, 1> element;  // (room,)
    Array<Short, 1> wall;  // (room,)
    Array<double, 1> gap;  // gap from which the overlap counts, at most 0 [m], (room,)
    Array<double, 1> now;  // present gap [m], (room,)
    Array<double, 2> memory;  // tangential stretch [m] and force of the dashpots [N], (room, 6)
    Array<Byte, 1> touch;  // `TouchState`, (room,)
};

}  // namespace bondem
