"""The energy of facets and cells, its gradient and its parts.

Elements are rigid, at the centres of mass of their cells; a facet has two faces, one on each cell. With R the
rotation of a cell, b the lever of its face and s = A w M⁻¹n its share in the swelling V θ (both in the reference)

    δ = x_j + R_j b_j - x_i - R_i b_i             gap of the two faces
    V_p θ_p = Σ facets (R_p s_p)·δ
    U = Σ facets [½ k |δ|² + 2 v·H v] + Σ cells ½ V λ θ²,      v = vector part of q_i* q_j

2 v·H v is the energy of a facet whose points do not open alike: with H = (2 G / L)(tr S 1 - S) it is exactly
(2 G / L) tr((1 - R_iᵀ R_j) S), and ½ ρ·H ρ for small rotations. With the stress σ = λ θ of a cell and g = σ R s,

    f = k δ + g_i + g_j,     F_i += f,  T_i += (R_i b_i) × f + δ × g_i,     F_j -= f,  T_j -= (R_j b_j) × f - δ × g_j

where δ × g comes from normals that turn with their cells. Tension positive. No square root, no local frame, and no
change under rigid motion.
"""

from bondem._compile import device

# n·H n over the trace of H below which a facet does not resist that its cells twist: rounding.
_FREE = 1e-5


@device
def cross(a, b):
    """Return the vector product of two triples."""
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


@device
def scalar(a, b):
    """Return the scalar product of two triples."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@device
def turned_by(q, a):
    """Return triple a rotated by the unit quaternion q."""
    x, y, z = q[1] + q[1], q[2] + q[2], q[3] + q[3]
    t = y * a[2] - z * a[1], z * a[0] - x * a[2], x * a[1] - y * a[0]
    # sums of products one after the other, each a fused multiply-add
    return (
        a[0] + q[0] * t[0] + q[2] * t[2] - q[3] * t[1],
        a[1] + q[0] * t[1] + q[3] * t[0] - q[1] * t[2],
        a[2] + q[0] * t[2] + q[1] * t[1] - q[2] * t[0],
    )


@device
def opened(d, a, b):
    """Return the gap of a facet, with d from centre i to centre j and the rotated levers a of i and b of j."""
    return d[0] + b[0] - a[0], d[1] + b[1] - a[1], d[2] + b[2] - a[2]


@device
def swellings(d, p, q, lever_i, lever_j, share_i, share_j):
    """Return the contributions of a facet to V θ of cells i and j [m³], with p and q their orientations."""
    gap = opened(d, turned_by(p, lever_i), turned_by(q, lever_j))
    return scalar(turned_by(p, share_i), gap), scalar(turned_by(q, share_j), gap)


@device
def facet_pull(d, p, q, lever_i, lever_j, share_i, share_j, k, stress_i, stress_j):
    """Return the force of a facet on its cell i [N]; arguments as for `facet_force`."""
    gap = opened(d, turned_by(p, lever_i), turned_by(q, lever_j))
    gi, gj = turned_by(p, share_i), turned_by(q, share_j)
    return (
        k * gap[0] + (stress_i * gi[0] + stress_j * gj[0]), k * gap[1] + (stress_i * gi[1] + stress_j * gj[1]),
        k * gap[2] + (stress_i * gi[2] + stress_j * gj[2]),
    )  # fmt: skip


@device
def relative(p, q):
    """Return the rotation p* q: its scalar, its vector in the frame of the reference, and its vector in space."""
    plain = (
        p[0] * q[1] - q[0] * p[1], p[0] * q[2] - q[0] * p[2], p[0] * q[3] - q[0] * p[3]
    )  # fmt: skip
    x, y, z = cross((p[1], p[2], p[3]), (q[1], q[2], q[3]))
    return (
        p[0] * q[0] + p[1] * q[1] + p[2] * q[2] + p[3] * q[3],
        (plain[0] - x, plain[1] - y, plain[2] - z),
        (plain[0] + x, plain[1] + y, plain[2] + z),
    )


@device
def resisted_turn(H, v):
    """Return H v of a symmetric H: xx, yy, zz, xy, xz, yz."""
    return (
        H[0] * v[0] + H[3] * v[1] + H[4] * v[2],
        H[3] * v[0] + H[1] * v[1] + H[5] * v[2],
        H[4] * v[0] + H[5] * v[1] + H[2] * v[2],
    )


@device
def swing_square(w2, v, normal, H):
    """Return cos² of half the relative angle of two cells, without a twist that their facet does not resist.

    Args:
        w2: cos² of half the whole angle.
        v: vector of the rotation in the frame of the reference (`relative`), the frame of the normal too.
        H: resistance [N·m].
    """
    if scalar(normal, resisted_turn(H, normal)) > _FREE * (H[0] + H[1] + H[2]):
        return w2
    return w2 + scalar(v, normal) ** 2


@device
def bending_square(p, q, factor, H):
    """Return the mean square of the traction differences between points of a facet [Pa²].

    It is 2 k / A² times the energy of bending and twisting 2 v·H v; `factor` is 4 k / A² [1/(N m³)].
    """
    _, v, _ = relative(p, q)
    return factor * scalar(v, resisted_turn(H, v))


@device
def facet_force(d, p, q, lever_i, lever_j, share_i, share_j, k, H, stress_i, stress_j):
    """Return force on j and torques on i and j [N, N·m] of one facet; the force on i is the opposite.

    Args:
        d: vector from centre i to centre j [m].
        p, q: orientations of i and j, unit quaternions.
        lever_i, lever_j: levers from the centres to the facet, in the reference [m].
        share_i, share_j: A w M⁻¹n of both sides, in the reference [m²].
        k: stiffness [N/m]; H: resistance [N·m].
        stress_i, stress_j: λ θ of the cells [Pa].
    """
    a, b = turned_by(p, lever_i), turned_by(q, lever_j)
    gap = opened(d, a, b)
    gi, gj = turned_by(p, share_i), turned_by(q, share_j)
    gi = stress_i * gi[0], stress_i * gi[1], stress_i * gi[2]
    gj = stress_j * gj[0], stress_j * gj[1], stress_j * gj[2]
    f = k * gap[0] + (gi[0] + gj[0]), k * gap[1] + (gi[1] + gj[1]), k * gap[2] + (gi[2] + gj[2])
    w, v, space = relative(p, q)
    h = turned_by(p, resisted_turn(H, v))
    c = cross(space, h)
    c = 2.0 * (w * h[0] + c[0]), 2.0 * (w * h[1] + c[1]), 2.0 * (w * h[2] + c[2])
    ti, si = cross(a, f), cross(gap, gi)
    tj, sj = cross(b, f), cross(gap, gj)
    return (
        (-f[0], -f[1], -f[2]),
        (ti[0] + si[0] + c[0], ti[1] + si[1] + c[1], ti[2] + si[2] + c[2]),
        (sj[0] - tj[0] - c[0], sj[1] - tj[1] - c[1], sj[2] - tj[2] - c[2]),
    )


@device
def facet_energy(d, p, q, lever_i, lever_j, normal, k, H):
    """Return normal, shear, bending and twisting energy of a facet, without dilatation [J].

    The normal is that of the reference, from i to j, rotated with both cells and averaged.
    """
    gap = opened(d, turned_by(p, lever_i), turned_by(q, lever_j))
    one, other = turned_by(p, normal), turned_by(q, normal)
    n = one[0] + other[0], one[1] + other[1], one[2] + other[2]
    across = scalar(gap, n) ** 2 / scalar(n, n)
    _, v, _ = relative(p, q)
    whole = 2.0 * scalar(v, resisted_turn(H, v))
    along = scalar(v, normal)
    twist = 2.0 * along * along * scalar(normal, resisted_turn(H, normal))
    return 0.5 * k * across, 0.5 * k * (scalar(gap, gap) - across), whole - twist, twist
