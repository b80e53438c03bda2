// Constants that the core and Python share: sizes of portions, columns of tables, and enumerations.
// `python -m tests.core.tables` writes these constants into `bondem/_tables/columns.py`.
#pragma once
#include "../scalars.hpp"

namespace bondem {

constexpr Index elements_of_portion = 1024;  // elements of a portion
constexpr Index bonds_of_portion = 2048;  // bonds or facets of a portion
constexpr Index terms_of_thread = 32;  // elements, bonds or facets whose terms a thread of a device adds up
constexpr Index stress_column = 3;  // column of a pose, `pose.stress`, with the stress λ θ of a cell [Pa]

// Words of a sum without rounding (`core/exact_sum.hpp`): its limbs, and flags of terms that are not finite.
namespace exact_word { enum : Index { flags = 67, count }; }
// Columns of a record of the history before those of gauges.
namespace history_column {
enum : Index {
    time,  // [s]
    translation,  // kinetic energy [J]
    rotation,  // kinetic energy [J]
    normal,  // elastic energy of bonds [J]
    shear,  // elastic energy of bonds [J]
    bending,  // elastic energy of bonds [J]
    twisting,  // elastic energy of bonds [J]
    contact,  // elastic energy of contacts [J]
    work,  // work of loads, drives and walls [J]
    loss,  // loss to damping [J]
    friction,  // loss to friction [J]
    extra_work,  // work of the extra forces of the non-local law [J]
    released,  // energy that bonds have released [J]
    plastic,  // energy that cells have dissipated by yielding [J]
    crushing,  // part of the released energy beyond the fracture energy [J]
    count
};
}
// Counts of a call of the core: steps, records, bonds beyond safe angles (wide) and beyond valid ones (lost).
namespace step_count { enum : Index { steps, records, wide, lost }; }
// Results of the guard: bonds beyond safe angles (wide) and beyond valid ones (lost), the ending of the call, and 1
// for lists out of date.
namespace guard_number { enum : Index { wide, lost, ending, out_of_date }; }
// Counts of bonds beyond safe angles (wide) and beyond valid ones (lost), and of portions not finite.
namespace turn_count { enum : Index { wide, lost, not_finite }; }
// Sums of the forces on a wall, as `WallLoad` has them.
namespace wall_sum { enum : Index { force, normal = 3, torque, count = 7 }; }
// Energies that bound the kinetic energy for the guard: that at the start, and the largest one supplied since.
namespace guard_energy { enum : Index { start, supplied }; }
// Counts of a log of events: of all, and of those before the present step.
namespace log_count { enum : Index { events, before }; }
// Columns of an event, the failure of a bond.
namespace event_column {
enum : Index {
    time,  // [s]
    step,  // number of the step
    bond,  // number of the bond
    mode,  // `failure_mode`
    gap,  // how far it is open [m]
    energy,  // energy released [J]
    place,  // x of the place [m]; y and z follow
    opening_steps = 9,  // steps since the onset of softening, nan of a bond that failed at once
    count
};
}
// Modes of failure by the largest part of the index; states and run files store the number.
namespace failure_mode { enum : Index { intact, tension, shear, bending, twisting }; }
// Columns of a beam that has begun to soften.
namespace soft_column {
enum : Index {
    bond,  // number of the beam
    first,  // opening λ at the onset [√J]
    last,  // opening λ at which no integrity is left [√J]
    rate,  // -∂U/∂s a step ago [J]
    spent,  // energy dissipated [J]
    mode,  // `failure_mode` of the larger part of the index
    began,  // step of onset
    count
};
}
// Columns of a cell that yields.
namespace plastic_column {
enum : Index {
    deformation,  // P - 1 of its plastic deformation P in its own frame, row by row
    gamma = 9,  // Σ Δγ
    increment,  // last increment of strain in space: xx, yy, zz, xy, xz, yz
    heat = 16,  // energy dissipated [J]
    count
};
}
// Columns of the stress of a cell: xx … yz, Σ T_b² of the bending of facets, and the size of the stress.
namespace tensor_column { enum : Index { bending = 6, size }; }
// Columns of the sums of an element: force, energy lost to damping, torque, energy lost to friction.
namespace load_column { enum : Index { force, damped = 3, torque, rubbed = 7 }; }
// Flags of stress-free strains in a step: ∂U/∂factor is needed; lengths or levers have changed.
namespace strain_due { enum : Index { power, levers }; }
// Counts of the lists of cracks: active cracks, resting cracks, cells of active cracks, cracks parted in this step.
namespace list_count { enum : Index { treated, resting, cells, parted }; }
// Numbers of cohesive cracks: how many there are, and 1 where lists are out of date.
namespace crack_number { enum : Index { cracks, out_of_date }; }
namespace crack {
// Kinds of cracks. A crack of the material has an integrity for each direction. An isotropic one has a single
// integrity: on a material plane, or at a cell without cohesion. `let_go`: a crack of the
// material without grip.
enum CrackKind : int { of_material, isotropic, let_go };
// Statuses of cracks: `active`, evaluated by itself in each step; `resting`, a facet of reduced stiffness; `parted`,
// faces apart, no force.
enum CrackStatus : int { active, resting, parted };
}  // namespace crack

// States of contacts. A contact that has parted in this step still counts its losses. `facing` cells touch by cracked
// faces that face each other, not as spheres. Where such faces turn away within the reach of the spheres, the contact
// is `late`: the spheres touch at the distance of that time, until the cells are apart.
enum TouchState : Byte { separate, touching, parted, facing, late };
// Kinds of walls: a plane, a cylinder around the elements or among them, a sphere around them or among them, a disc.
enum WallKind : Index { plane_wall, cylinder_around, cylinder_among, sphere_around, sphere_among, disc_wall };

// Quantities of elements that gauges record.
namespace gauge_quantity { enum : Index { displacement, velocity, rotation, angular_velocity, force, of_walls }; }
// Quantities of a wall that gauges record, after those of elements. Power is that of the wall on the elements: by its
// velocity and its growth, by its spin, and their sum.
namespace wall_quantity { enum : Index { displacement = 5, force, growth, velocity, torque, rotation, angular_velocity, power }; }
// Reductions by which a gauge makes one number of many.
namespace gauge_reduction { enum : Index { mean, sum, max_abs }; }
// Columns of the report of a relaxation.
namespace relaxation_report {
enum : Index {
    rms_force,  // [m]
    mean_overlap,  // [m]
    contacts,
    largest_overlap,  // [m]
    steps,
    count
};
}
// Columns of the report of a growth.
namespace growth_report {
enum : Index {
    time,  // time that has passed
    virial,  // sum of distance times exchanged momentum [m²]
    collisions,
    count
};
}

}  // namespace bondem
