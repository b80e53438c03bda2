"""Rigid walls around a packing: what they bear of the spheres' forces, and how they keep spheres inside.

See `kernels.tables.PackingWalls`: flat walls, a round wall, and for any other shape its depth on a grid.
"""

import math

from bondem._compile import device

# A sphere this near a wall of the grid, over its radius, touches it.
_TOUCH = 1e-6
# Walls that meet at a right angle need one round, at 45° about 30.
_ROUNDS = 30


@device
def has_grid(walls):
    """Whether the shape is given by its depth on a grid."""
    return walls.depth.size > 0


@device
def plain_walls(walls):
    """Corners of the box, weights and radius of the round wall as numbers, taken out once for many spheres."""
    lower, upper, weight = walls.lower, walls.upper, walls.weight
    box = (lower[0], lower[1], lower[2]), (upper[0], upper[1], upper[2])
    return box[0], box[1], (weight[0], weight[1], weight[2]), walls.radius


@device
def _round_distance(x, y, z, weight):
    return math.sqrt(weight[0] * x * x + weight[1] * y * y + weight[2] * z * z)


@device
def _grid_depth(x, y, z, walls, enough):
    """Depth at a point and its gradient, smooth over the grid; some depth above `enough` where it is more."""
    corner, h = walls.corner, walls.spacing
    nx, ny, nz = walls.depth.shape
    u, v, w = (x - corner[0]) / h, (y - corner[1]) / h, (z - corner[2]) / h
    i = min(max(int(u + 0.5), 1), nx - 2)
    j = min(max(int(v + 0.5), 1), ny - 2)
    k = min(max(int(w + 0.5), 1), nz - 2)
    depth = walls.depth[i, j, k]
    gx, gy, gz = 0.0, 0.0, 0.0
    if depth <= enough + 2.0 * h:
        # Quadratic B-splines: without a jump in the gradient no sphere is driven to and fro between two normals.
        u, v, w = min(max(u - i, -0.5), 0.5), min(max(v - j, -0.5), 0.5), min(max(w - k, -0.5), 0.5)
        depth = 0.0
        for a in range(3):
            fa, da = _spline(a, u)
            for b in range(3):
                fb, db = _spline(b, v)
                for c in range(3):
                    fc, dc = _spline(c, w)
                    value = walls.depth[i + a - 1, j + b - 1, k + c - 1]
                    depth += fa * fb * fc * value
                    gx += da * fb * fc * value
                    gy += fa * db * fc * value
                    gz += fa * fb * dc * value
        gx, gy, gz = gx / h, gy / h, gz / h
    return depth, gx, gy, gz


@device
def _spline(which, t):
    """Weight of the node before, at or after the nearest one, t in -0.5 … 0.5 from it, and its slope."""
    if which == 0:
        return 0.5 * (0.5 - t) * (0.5 - t), t - 0.5
    if which == 1:
        return 0.75 - t * t, -2.0 * t
    return 0.5 * (0.5 + t) * (0.5 + t), t + 0.5


@device
def borne(plain, x, y, z, r, fx, fy, fz):
    """The force on a sphere, less what plain walls that it touches bear of it."""
    lower, upper, weight, radius = plain
    near = r * (1.0 + 1e-12)
    if (x - lower[0] <= near and fx < 0.0) or (upper[0] - x <= near and fx > 0.0):
        fx = 0.0
    if (y - lower[1] <= near and fy < 0.0) or (upper[1] - y <= near and fy > 0.0):
        fy = 0.0
    if (z - lower[2] <= near and fz < 0.0) or (upper[2] - z <= near and fz > 0.0):
        fz = 0.0
    rho = _round_distance(x, y, z, weight)
    if radius - rho <= near:
        nx, ny, nz = weight[0] * x / rho, weight[1] * y / rho, weight[2] * z / rho
        out = max(fx * nx + fy * ny + fz * nz, 0.0)
        fx -= out * nx
        fy -= out * ny
        fz -= out * nz
    return fx, fy, fz


@device
def borne_by_both(plain, walls, x, y, z, r, fx, fy, fz):
    """The force on a sphere, less what plain walls and the wall of the grid carry of it where it touches them.

    Where it touches both, the rest is the projection of the force onto the free directions of the sphere: the
    carried parts are found in turn, until that of the grid stays. Otherwise a sphere in a wedge is never at rest.
    """
    gx, gy, gz = borne(plain, x, y, z, r, fx, fy, fz)
    d, nx, ny, nz = _grid_depth(x, y, z, walls, r)
    if d <= r * (1.0 + _TOUCH):
        steep = max(nx * nx + ny * ny + nz * nz, 0.01)
        enough = 1e-9 * math.sqrt(fx * fx + fy * fy + fz * fz)
        out = min(gx * nx + gy * ny + gz * nz, 0.0) / steep
        for _ in range(_ROUNDS):
            gx, gy, gz = borne(plain, x, y, z, r, fx - out * nx, fy - out * ny, fz - out * nz)
            more = min((gx * nx + gy * ny + gz * nz) / steep, -out)
            out += more
            if abs(more) <= enough:
                break
    return gx, gy, gz


@device
def _stopped(x, v, lower, upper, r):
    """A coordinate and its velocity; a wall that is reached stops the sphere."""
    if x < lower + r:
        x, v = lower + r, max(v, 0.0)
    if x > upper - r:
        x, v = upper - r, min(v, 0.0)
    return x, v


@device
def kept_within(plain, r, x, y, z, vx, vy, vz):
    """Centre and velocity of a sphere, put back to the plain walls it has passed; its velocity into them is gone."""
    lower, upper, weight, radius = plain
    x, vx = _stopped(x, vx, lower[0], upper[0], r)
    y, vy = _stopped(y, vy, lower[1], upper[1], r)
    z, vz = _stopped(z, vz, lower[2], upper[2], r)
    rho = _round_distance(x, y, z, weight)
    if rho > radius - r:
        nx, ny, nz = weight[0] * x / rho, weight[1] * y / rho, weight[2] * z / rho
        inward = rho - (radius - r)
        out = max(vx * nx + vy * ny + vz * nz, 0.0)
        x -= inward * nx
        y -= inward * ny
        z -= inward * nz
        vx -= out * nx
        vy -= out * ny
        vz -= out * nz
    return x, y, z, vx, vy, vz


@device
def _free_along(x, lower, upper, r, n):
    """A component of a direction, 0 where the sphere touches one of two flat walls across it."""
    near = r * (1.0 + 1e-12)
    return 0.0 if x - lower <= near or upper - x <= near else n


@device
def kept_on_grid(plain, walls, r, x, y, z, vx, vy, vz):
    """Centre and velocity of a sphere, put back to the wall of the grid; its velocity into it is lost.

    A sphere that touches flat walls moves along them, or each wall in turn would push it off the other.
    """
    lower, upper, _, _ = plain
    beyond, steep = False, 1.0
    nx = ny = nz = ax = ay = az = 0.0
    for _ in range(3):  # Newton's steps back to the wall, where need be from either side
        d, nx, ny, nz = _grid_depth(x, y, z, walls, r)
        beyond = beyond or d < r
        if not beyond:
            break
        ax = _free_along(x, lower[0], upper[0], r, nx)
        ay = _free_along(y, lower[1], upper[1], r, ny)
        az = _free_along(z, lower[2], upper[2], r, nz)
        steep = max(ax * ax + ay * ay + az * az, 0.01)
        x += (r - d) * ax / steep
        y += (r - d) * ay / steep
        z += (r - d) * az / steep
    if beyond:
        out = min(vx * nx + vy * ny + vz * nz, 0.0) / steep
        vx -= out * ax
        vy -= out * ay
        vz -= out * az
    return x, y, z, vx, vy, vz
