// What contacts of elements and walls take. Named once more in `bondem/dynamics/contact_tables.py`.
//
// Pairs stand once, sorted by their later element and then by their earlier one, as bonds are. A portion of elements
// (`steps.hpp`) owns the pairs whose later element is in it.
#pragma once
#include "damage_tables.hpp"
#include "packing_tables.hpp"
#include "step_tables.hpp"
#include "wall_rows.hpp"

namespace bondem {

// The law of a contact.
struct ContactRow {
    double modulus;  // [Pa]
    double soft;  // ks / kn [-]
    double friction;  // μ [-]
    double damping;  // β [-]
    double rolling, twisting;  // μ_r and μ_w [-]
    double deep;  // overlap over the radius at which the stiffness against rolling is taken [-]
    double strength, reach;  // of adhesion, 0 for none [Pa, m]
};
// The laws of contacts by kinds of elements, and the radii of the elements.
struct ContactConstants {
    Array<const double, 3> between;  // `ContactRow` of pairs of each two kinds, (kinds, kinds, 9)
    Array<const double, 3> at_walls;  // that of each kind at each wall, (kinds, walls, 9)
    Array<const Byte, 1> kind;  // of each element, (n,)
    Index hertzian;  // whether they are those of Hertz and Mindlin
    Array<const double, 1> radius;  // [m], (n,)

    const ContactRow &of(Short a, Short b) const { return between.row<const ContactRow>(kind(a), kind(b)); }
    const ContactRow &at_wall(Short p, Index w) const { return at_walls.row<const ContactRow>(kind(p), w); }
};
// Pairs that may touch before their list is made anew, c of them.
struct ContactPairs {
    Array<const Short, 1> first, second;  // (c,)
    Array<const Index, 1> start;  // where the pairs of each later element begin, (n + 1,)
    Array<double, 1> reach;  // distance of the centres at which a pair touches [m], (c,)
    Array<const double, 1> own;  // kn of a pair that does not have that of the law, or 0 [N/m], (c,)
    // tangential stretch [m] and force of the dashpots [N]; of faces the overlap u0 [m] and kn a step ago [N/m], (c, 8)
    Array<double, 2> memory;
    Array<Byte, 1> touch;  // `TouchState`, (c,)
    Array<const Index, 1> bond;  // the bond of each pair, or -1; while it joins them they do not touch, (c,)
    Array<double, 1> joined;  // above 0 of bonds that join their elements
    Array<const Index, 1> of_bond;  // the pair of each bond, or -1, (m,)
    Array<const double, 1> period;  // edges of the periodic cell and their inverses, zero where there is none, (6,)
};
// Pairs that are looked at in every step, until an element has moved so far that distances are measured anew. Those of a
// portion stand from its first pair on.
struct NearPairs {
    Array<Short, 1> near;  // pairs that may touch, ascending, (c,)
    Array<Short, 1> close;  // those of them that touch or have just parted, (c,)
    // of these: force on the later element [N], lost to dashpots [J], torque over the radius [N], lost to friction [J]
    Array<double, 2> output;  // (c, 8)
    Array<Index, 2> counts;  // of near and of close pairs of each portion, (portions, 2)
    double width;  // motion of an element after which distances are measured anew [m]
    double beyond;  // gap up to which pairs that do not touch act [m]
};
// Adhesion of near pairs: force on the later element [N], (c, 3).
struct AdheringPairs {
    Array<double, 2> force;
};
// What resists rolling: R̄ times the rotation that the spring of each pair stores [m], (c, 3), and the moment on its later
// element [N·m] and the energy lost to friction [J], (c, 4).
struct RolledPairs {
    Array<double, 2> rolled, output;
};
// The same at walls, (b, 3).
struct RolledWalls {
    Array<double, 2> rolled;
};
// Faces of cells on material planes whose facet has cracked, and the pairs that touch by them (`laws/face_contact.hpp`).
struct FacePairs {
    Array<const Index, 1> in_start, out_start;  // facets of each cell, as `FacetsOfCells` has them, (n + 1,)
    Array<const Short, 1> out_bond;
    Array<const int32_t, 2> lever_i, lever_j;  // as `ElasticFacets` has them, (3, m)
    Array<const double, 1> pitch;
    Array<const double, 2> normal;
    Array<const Short, 1> j;  // later cell, (m,)
    Array<const double, 1> k, area;  // [N/m, m²], (m,)
    Array<const Byte, 1> listed;  // that of `CohesiveCracks`: 0 for whole facets, (m,)
    Array<const double, 1> plane;  // 1 for facets of material planes, (m,)
    Array<Byte, 1> open;  // 1 for facets whose faces have parted, 2 in the step in which they do, (m,)
    Array<Byte, 1> faced;  // the same of cells that have such a facet, (n,)
    Array<const double, 1> outer;  // distance within which two cells touch by faces, as a sum of both [m], (n,)
    Array<const Index, 1> earlier_start;  // pairs whose earlier element is p, (n + 1,)
    Array<const Short, 1> earlier;  // (c,)
    Array<double, 1> chosen;  // the two faces by which each pair touches (`ChosenFaces`), 0 for none, (c,)
    Array<double, 1> whole;  // reach of the spheres of pairs whose faces have not lain between them [m], (c,)
    Array<Short, 1> close;  // pairs that touch by faces or did a step ago, ascending, those of a portion from its first on, (c,)
    // of pair k: force on the later element [N], lost to dashpots [J], torque on it [N·m], lost to friction [J], torque on
    // the earlier one [N·m], (c, 12)
    Array<double, 2> output;
    Array<double, 1> gained;  // energy taken over from facets that part in this step [J], (c,)
    Array<Index, 1> count;  // of close pairs of each portion, (portions,)
};
// How far elements have moved since their distances were measured, and since the list was made.
struct Travel {
    Array<const double, 2> listed;  // centres when the list was made [m], (n, 3)
    Array<double, 2> measured;  // centres when distances were measured [m], (n, 3)
    // squares of both largest distances [m²], and the deepest overlap over the smaller radius [-], (portions, 3)
    Array<double, 2> portion;
    // largest distance since distances were measured, and when they were since the list was made, below 0 before that [m]
    Array<double, 1> far;  // (2,)
    double reach;  // motion of an element or a wall for which the list is made [m]
};
// What contacts do to elements, zero between steps.
struct ContactSums {
    Array<double, 2> sums;  // force [N], lost to dashpots [J], torque [N·m], lost to friction [J], (n, 8)
};
// Elastic energy of contacts.
struct ContactEnergies {
    Array<double, 1> energy;  // of each portion [J], (portions,)
};

// Contacts of elements with walls, b of them, sorted by element.
struct WallContacts {
    Array<const Index, 1> start;  // where those of each element begin, (n + 1,)
    Array<const Short, 1> element, wall;  // (b,)
    Array<const double, 1> gap;  // from which the overlap counts [m], (b,)
    Array<double, 2> memory;  // as that of pairs, (b, 6)
    Array<Byte, 1> touch;  // (b,)
    Array<double, 2> output;  // `WallLoad`, (b, 7)
};
// Walls, w of them.
struct Walls {
    Array<const double, 2> shape;  // `WallShape`, (w, 12)
    Array<double, 2> body;  // `WallRow`, (w, 27)
    Array<const double, 2> inertia;  // `WallInertia`, (w, 8)
    Array<double, 2> listed;  // `WallListed`, (w, 8)
};
// Prescribed motions of walls, servos, and free walls.
struct WallMotions {
    Array<const double, 1> times, values;  // schedules, as those of `Timeline`
    Array<const Index, 1> start;
    Array<const Index, 1> drive_wall, drive_component, drive_schedule;
    Array<const Byte, 1> drive_rate;  // 1 for a velocity, 0 for a displacement
    Array<const double, 2> drive_axis;  // of what turns, zero for other components, (d, 3)
    Array<const Index, 1> servo_wall, servo_schedule;
    Array<const double, 1> servo_speed, servo_mass, servo_damping;  // largest speed [m/s], mass [kg], damping [-]
    Array<const Index, 1> free_wall;
    Array<const double, 1> free_mass;  // [kg]
    Array<const double, 2> free_force, free_torque;  // beside those of elements [N, N·m], (f, 3)
};

// ---- the search

// Bonds and memories that the list of pairs is made of; partners of each element are the earlier ones, ascending.
struct PairSources {
    Array<const Index, 1> bond_start;  // bonds whose later element is p, (n + 1,)
    Array<const Short, 1> bond_first;
    Array<const Byte, 1> wanted;  // whether the pair of a bond is listed, however far apart
    Array<const Index, 1> rest_start;  // pairs that overlap in the reference, (n + 1,)
    Array<const Short, 1> rest_first;
    Array<const double, 1> rest_gap;  // [m]
    Array<const Index, 1> kept_start;  // pairs that touch, (n + 1,)
    Array<const Short, 1> kept_first;
    Array<const double, 2> kept_memory;  // (…, 8)
};
// The list, with room for all pairs.
struct FoundPairs {
    Array<Short, 1> first, second;
    Array<Index, 1> bond;  // or -1
    Array<Index, 1> start;  // (n + 1,)
    Array<double, 1> gap;  // from which the overlap counts [m]
    Array<double, 2> memory;  // (room, 8)
    Array<Byte, 1> touch;
};
// Memories that the list of contacts with walls is made of.
struct WallSources {
    Array<const double, 1> radius;  // of elements [m], (n,)
    Array<const Index, 1> rest_start;  // contacts that overlap in the reference, (n + 1,)
    Array<const Short, 1> rest_wall;
    Array<const double, 1> rest_gap;  // [m]
    Array<const Index, 1> kept_start;  // contacts that touch, (n + 1,)
    Array<const Short, 1> kept_wall;
    Array<const double, 2> kept_memory;  // (…, 6)
    double skin;  // largest gap [m]
    Array<Index, 1> start;  // where those found of each element begin, (n + 1,)
};
struct FoundWalls {
    Array<Short, 1> element, wall;
    Array<double, 1> gap, now;  // from which the overlap counts, and the present one [m]
    Array<double, 2> memory;  // (room, 6)
    Array<Byte, 1> touch;
};

}  // namespace bondem
