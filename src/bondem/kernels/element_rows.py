"""What a boundary condition does to the motion of an element that owns a row (`bondem.kernels.tables.Rows`).

Velocities are two triples, v of the centre and w of the rotation. The loops of the CPU and of CUDA share them.
"""

from bondem._compile import device


@device
def prescribed(fixed, velocity, r, v, w):
    """Velocities with the prescribed components of row r put in."""
    return (
        (
            velocity[r, 0] if fixed[r, 0] else v[0],
            velocity[r, 1] if fixed[r, 1] else v[1],
            velocity[r, 2] if fixed[r, 2] else v[2],
        ),
        (
            velocity[r, 3] if fixed[r, 3] else w[0],
            velocity[r, 4] if fixed[r, 4] else w[1],
            velocity[r, 5] if fixed[r, 5] else w[2],
        ),
    )


@device
def free(fixed, r, v, w):
    """Velocities, zero in the prescribed components of row r: nothing resists these."""
    return (
        (0.0 if fixed[r, 0] else v[0], 0.0 if fixed[r, 1] else v[1], 0.0 if fixed[r, 2] else v[2]),
        (0.0 if fixed[r, 3] else w[0], 0.0 if fixed[r, 4] else w[1], 0.0 if fixed[r, 5] else w[2]),
    )


@device
def loaded(fixed, load, r, f, t):
    """Force and torque with the loads of row r, zero in its prescribed components."""
    return free(
        fixed, r,
        (f[0] + load[r, 0], f[1] + load[r, 1], f[2] + load[r, 2]),
        (t[0] + load[r, 3], t[1] + load[r, 4], t[2] + load[r, 5]),
    )  # fmt: skip


@device
def gripped(grip, r, f, t):
    """Force and torque with those of walls that hold the facets of a cell."""
    if len(grip) == 0:
        return f, t
    return (
        (f[0] + grip[r, 0], f[1] + grip[r, 1], f[2] + grip[r, 2]),
        (t[0] + grip[r, 3], t[1] + grip[r, 4], t[2] + grip[r, 5]),
    )


@device
def react(reaction, r, f, t):
    """Keep minus the force and torque of the bonds on row r."""
    reaction[r, 0], reaction[r, 1], reaction[r, 2] = -f[0], -f[1], -f[2]
    reaction[r, 3], reaction[r, 4], reaction[r, 5] = -t[0], -t[1], -t[2]


@device
def row_power(fixed, force, reaction, r, v, w):
    """Power of loads and reactions on row r [W]."""
    return (
        (reaction[r, 0] if fixed[r, 0] else force[r, 0]) * v[0]
        + (reaction[r, 1] if fixed[r, 1] else force[r, 1]) * v[1]
        + (reaction[r, 2] if fixed[r, 2] else force[r, 2]) * v[2]
        + (reaction[r, 3] if fixed[r, 3] else force[r, 3]) * w[0]
        + (reaction[r, 4] if fixed[r, 4] else force[r, 4]) * w[1]
        + (reaction[r, 5] if fixed[r, 5] else force[r, 5]) * w[2]
    )


@device
def switched_energy(fixed, velocity, r, m, u, v, w):
    """Kinetic energy [J] brought in where prescribed velocities replace the present ones; m = 1/mass, u = 1/I."""
    translation = (
        (velocity[r, 0] ** 2 - v[0] * v[0] if fixed[r, 0] else 0.0)
        + (velocity[r, 1] ** 2 - v[1] * v[1] if fixed[r, 1] else 0.0)
        + (velocity[r, 2] ** 2 - v[2] * v[2] if fixed[r, 2] else 0.0)
    )
    rotation = (
        (velocity[r, 3] ** 2 - w[0] * w[0] if fixed[r, 3] else 0.0)
        + (velocity[r, 4] ** 2 - w[1] * w[1] if fixed[r, 4] else 0.0)
        + (velocity[r, 5] ** 2 - w[2] * w[2] if fixed[r, 5] else 0.0)
    )
    return 0.5 * (translation / m + rotation / u)
