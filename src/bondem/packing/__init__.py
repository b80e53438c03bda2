"""Packings: spheres that fill a shape, dense, random and isotropic."""

from collections.abc import Callable, Sequence
from typing import Literal, cast, get_args

import numpy as np

from bondem._checks import choice, instance, shown
from bondem._checks import count as whole
from bondem._progress import staged
from bondem._types import Floats
from bondem.errors import InputError, PackingError
from bondem.geometry.elementary_shapes import Shape
from bondem.geometry.shape import Placed
from bondem.io.packing_cache import PackingCache, wanted
from bondem.packing.even import even
from bondem.packing.graded import graded
from bondem.packing.grading import SizeField, cells_of, sizes_by
from bondem.packing.growth import grow
from bondem.packing.inclusions import aggregates, around_balls
from bondem.packing.isotropic_compression import compress
from bondem.packing.quench import quench
from bondem.packing.separated import parting, separated
from bondem.packing.shear import sheared
from bondem.packing.sizes import SPREAD, SizeLaw, Uniform
from bondem.packing.soft_spheres import SoftSpheres
from bondem.packing.targets import Target, chosen
from bondem.packing.two_sided import Around, around_surfaces
from bondem.specimen.aggregates import Aggregates
from bondem.specimen.particles import Particles, filled

__all__ = ["EVEN", "METHOD", "METHODS", "SEED", "Method", "aggregates", "pack"]

_METHODS = {"quench": quench, "growth": grow, "compression": compress, "shear": sheared}
# Number of relaxation steps at which progress is reported as one half, because the final number is unknown.
_USUAL_STEPS = 2000
#: Names of the methods, the default method, the method for cells, which has neither sizes nor targets, and the
#: default seed, for Python, studies and the command line.
Method = Literal["quench", "growth", "compression", "shear", "even"]
METHOD: Method = "quench"
EVEN: Method = "even"
METHODS: tuple[Method, ...] = get_args(Method)
SEED = 1

# Largest number of spheres; more would take a day and exceed the memory of a machine.
MOST = 100_000_000


@staged("packing")
def pack(
    shape: Shape, *, count: int | None = None, size: SizeField | None = None,
    around: Around | Sequence[Around] | None = None, spread: float | None = None, sizes: SizeLaw | None = None,
    method: Method = METHOD, seed: int = SEED, coordination_number: float | None = None,
    volume_fraction: float | None = None, jamming: bool = False, cache: bool = True,
    progress: Callable[[float], None] | None = None,
) -> Particles:  # fmt: skip
    """Fill a shape with spheres: dense, random and isotropic.

    Spheres lie inside the walls to rounding, except those of "even". The radii follow from count, shape and target.
    The same arguments give the same packing, bit for bit, for any number of threads.

    The `method` makes the packing, and a target defines its final state:

    - "quench" (fastest): random soft spheres, overlapping far above jamming (just above, for jamming=True), are
      relaxed and then decompressed.
    - "growth": moving hard spheres collide and grow (Lubachevsky and Stillinger).
    - "compression": a dilute gas of soft spheres is compressed in small strains, without gravity.
    - "shear" (slowest): grains on a grid are compressed while walls shear them back and forth (André et al. 2012,
      §4.1).
    - "even": centres for bodies of cells, `bd.connect(particles, method="laguerre")`. Equal spheres are spread
      evenly, none nearer to a wall than a third of its radius. The spheres hardly touch, so the method has no target,
      spread or sizes. With `size` in place of `count`, all cells have one size, or sizes vary in space (`bd.Graded`).

    All other methods reach every target; a target above jamming is reached by compressing soft spheres. A
    coordination number beyond jamming requires overlaps. For 6.2 the overlaps are on average 0.2 % of the mean radius
    in a periodic cell. Between the walls of a cylinder of 10 000 spheres the overlaps are 0.8 %, and 5 % for the
    worst pair, as spheres at walls have fewer neighbours. `bd.fabric(lattice).largest_overlap` reports the largest.

    Spheres of two very different sizes, at least 1 : 2, often do not come to rest with "quench". The large ones are
    then separated first, and the small ones fill the rest.

    Args:
        shape: any shape. Walls of Cylinder, Box, Ball and Cell are exact, as are planes normal to an axis of other
            shapes; their further walls are depths on a grid.
        count: number of spheres.
        size: size of cells, the cube root of their volume, for "even", in place of `count`. Give one size [m],
            `bd.Graded`, or a function of points (k, 3) [m] that returns sizes (k,) [m]. Sizes at two points may
            differ by no more than the distance of the points. The number of cells follows.
        around: surfaces on which cells of "even" end, so that an interface between materials is smooth. Give
            `bd.Plane`s, shapes or `bd.Surface`s, one or a sequence, at least 1.6 cells apart (none that cross), or
            balls from `bd.aggregates`. All cells then have one size, with balls at most 0.8 of their smallest radius.
            Cells end exactly on plane faces, and on a polyhedron of the same volume around curved ones. At edges
            within one face of a `bd.Surface`, and where shapes meet walls obliquely, cells end approximately.
        spread: κ = (R_max - R_min) / R̄ [-], radii uniform in R̄ (1 ± κ/2) (André et al. 2012, eq 10); 0.25 unless
            `sizes` is given. Equal spheres (0) order at walls.
        sizes: law of the radii, in place of `spread`: Uniform, Lognormal or Sieve.
        method: "quench", "growth" (Box, Cylinder, Ball, Cell), "compression", "shear" (Box, Cylinder) or "even".
        seed: number that selects one of the random packings.
        coordination_number: target z = 2 contacts / spheres [-], ± 0.01 or one contact; 6.2 without a target.
            Contacts are counted as by `bd.connect` with tolerance 0, over all spheres, also rattlers and at walls.
        volume_fraction: target φ, volume of the spheres over that of the shape [-]; below jamming these barely touch.
        jamming: True for the density at which the spheres begin to carry load as the target. No overlap exceeds 1e-3
            mean radii, or 1e-3 of the smaller radius of a pair where large spheres were separated first. A periodic
            cell has six contacts per sphere, without rattlers.
        cache: True to reuse an identical packing of 1000 spheres or more from disk, the same to the bit, and to store
            this one there. `BONDEM_PACKING_CACHE=off` in the environment disables the cache.
        progress: function called repeatedly with the completed share, 0 … 1, which never decreases.

    Returns:
        Exactly `count` spheres, or as many as have the given size, with their `shape`.

    Raises:
        InputError: An argument is out of range.
        PackingError: The target was not reached.
    """
    instance("pack", "shape", shape, Shape, "a shape such as bd.Cylinder(radius=5e-3, length=40e-3)")
    choice("pack", "method", method, Method)
    if (count is None) == (size is None):
        raise InputError("pack: give either count=, the number of spheres, or size=, the size of cells")
    if size is not None and method != EVEN:
        raise InputError(f'pack: size= applies to cells; give method="even" with it, or count= for {method!r}')
    if around is not None:
        around = _surfaces(around)
        if method != EVEN or callable(size) or shape.period is not None:
            raise InputError(
                'pack: around= requires cells of one size in a shape with walls; give method="even", and count= or'
                " size= as a number"
            )
    if size is not None and not callable(size):
        count, size = cells_of(size, shape.volume), None
    if count is not None:
        count = whole("pack", "count", count, least=1, advice=f"a whole number of spheres, from 1 to {MOST}")
        if count > MOST:
            raise InputError(f"pack: count = {count}; give at most {MOST} spheres")
    if sizes is not None and spread is not None:
        raise InputError("give spread= or sizes=, not both: spread=κ is short for sizes=bd.Uniform(κ)")
    if sizes is not None:
        instance("pack", "sizes", sizes, SizeLaw, "a law of the radii: bd.Uniform, bd.Lognormal or bd.Sieve")
    seed = whole("pack", "seed", seed, advice="a whole number from 0 up")
    report = progress or (lambda share: None)
    if method == EVEN:
        given = (spread, sizes, coordination_number, volume_fraction, jamming or None)
        if any(value is not None for value in given):
            raise InputError(
                'pack: method="even" makes equal spheres that hardly touch; leave out spread=, sizes= and targets, or'
                " take another method"
            )
        if callable(size) and shape.period is not None:
            raise InputError("pack: a periodic cell requires cells of one size; give size= as a number, or count=")
        request: dict[str, object] = {"shape": shape, "count": count, "method": method, "seed": seed}
        request |= {"size": size} if callable(size) else {} if around is None else {"around": around}
        random = np.random.Generator(np.random.Philox(seed))
        return _saved(request, lambda: _cells(shape, count, size, around, random, report), report, cache=cache)
    assert count is not None
    target = chosen(count, coordination_number, volume_fraction, jamming=jamming)
    size_law = Uniform(SPREAD if spread is None else spread) if sizes is None else sizes

    own = shape.shape if isinstance(shape, Placed) else shape

    def make() -> Particles:
        random, again = (np.random.Generator(np.random.Philox(seed)) for _ in range(2))
        on_step = _counting(report)
        try:
            spheres = _METHODS[method](own, size_law.radii(count, random), target, random, on_step)
            target.reach(spheres)
        except PackingError:
            two = _two_sizes(own, size_law.radii(count, again), target, again, on_step) if method == METHOD else None
            if two is None:
                raise
            spheres = two
        centre = spheres.sphere[:, :3].copy()
        if isinstance(shape, Placed):  # packed before it is moved, so that its place does not change the packing
            centre = shape.place(centre)
        return filled(Particles(centre, spheres.sphere[:, 3].copy(), shape.period), shape)

    request = {"shape": shape, "sizes": size_law, "count": count, "target": target, "method": method, "seed": seed}
    return _saved(request, make, report, cache=cache)


def _cells(
    shape: Shape, count: int | None, size: object, around: object, random: np.random.Generator,
    report: Callable[[float], None],
) -> Particles:  # fmt: skip
    """Pack spheres for cells: of sizes that vary in space, around aggregates or surfaces, or of one size."""
    if callable(size):
        return graded(shape, sizes_by(size), random, report)
    assert count is not None
    if around is None:
        return even(shape, count, random, report)
    if isinstance(around, Aggregates):
        return around_balls(shape, count, around, random, report)
    return around_surfaces(shape, count, cast(Sequence[Around], around), random, report)


def _two_sizes(
    shape: Shape, radii: Floats, target: Target, random: np.random.Generator, on_step: Callable[[int], None]
) -> SoftSpheres | None:
    """Pack spheres of two very different sizes, large ones first; None if this fails, or below a ratio of two."""
    limit = parting(radii)
    if limit is None:
        return None
    try:
        spheres = separated(shape, radii, limit, random, on_step)
        target.reach(spheres)
    except (PackingError, InputError):
        return None
    return spheres


def _counting(report: Callable[[float], None]) -> Callable[[int], None]:
    """Return a function that reports progress from a number of steps, which may restart from zero."""
    before = last = 0

    def on_step(steps: int) -> None:
        nonlocal before, last
        before, last = before + (last if steps < last else 0), steps
        report((before + steps) / (before + steps + _USUAL_STEPS))

    return on_step


def _surfaces(around: object) -> Aggregates | tuple[Around, ...]:
    """Check `around` and return aggregates, or a tuple of the surfaces on which cells end.

    Raises:
        InputError: The value is neither aggregates nor one or several surfaces.
    """
    listed = tuple(around) if isinstance(around, list | tuple) else (around,)
    given = tuple(one for one in listed if isinstance(one, Around))
    periodic = any(isinstance(one, Shape) and one.period is not None for one in given)
    if periodic or not given or len(given) < len(listed):
        raise InputError(
            f"pack: around = {shown(around)}; give bd.Plane(point=, normal=), a shape such as bd.Box(...).moved(...),"
            " bd.Surface(...), a list of them, or balls from bd.aggregates(...)"
        )
    first = given[0]
    return first if len(given) == 1 and isinstance(first, Aggregates) else given


def _saved(
    request: dict[str, object], make: Callable[[], Particles], report: Callable[[float], None], *, cache: bool
) -> Particles:
    """Return the packing of a request, from disk if possible, else newly made."""
    count = request["count"]
    worth = wanted(count if isinstance(count, int) else MOST)
    particles = PackingCache().remembered(request, make) if cache and worth else make()
    report(1.0)
    return particles
