"""A crack that is open: sheared along itself, crossed by another one, and closed again."""

import numpy as np

import bondem as bd
from validation.studies.paths.driving import ENERGY, RANKINE, SIDE, TENSION, E, course, cube, torn
from validation.studies.paths.rows import Row

#: Openings, over the last one, at which a crack is held, and the slides then, over the same.
SLIDES: dict[float, tuple[float, ...]] = {1.2: (1.0,), 0.3: (0.3, 0.6, 1.5)}
#: Shear that may be left on a crack that bears nothing [f_t].
SHEAR = 0.05
#: Of a second crack across the first one: limits of strength and of its dissipation over G_f [-].
PEAK, WORK = 0.03, 0.08
#: Opening of a crack that is closed again, over the last one; how often; limits of stiffness and of dissipation [-].
OPENED, TIMES, STIFFNESS = 0.3, 3, 0.03
#: Dissipation that may be taken back in a step between records, over G_f [-].
TAKEN = 1e-6
LAST = 2.0 * ENERGY / TENSION
#: Friction of a crack that is closed, slides from which it is compared, and its length, over the last opening.
FRICTION, SLID = 0.5, (4.0 / 3.0, 2.0)
#: Limits of its friction, of which the test of a small cube had the same [-].
RUBS = 0.1
#: Length of the flat block along x [m].
FLAT = 10e-3


def _opening(share: float, length: float = SIDE) -> float:
    """Displacement at which a crack of a body of this length is open by a share of its last opening [m]."""
    return share * LAST + max(0.0, 1.0 - share) * TENSION / E * length


def slide(seed: int, count: int) -> list[Row]:
    """A crack across x is opened, held open, and slid along y: shear along it and stress across it."""
    return _slide(cube(seed, count), SIDE, "")


def flat(seed: int, count: int) -> list[Row]:
    """The same in a block that is too flat for its halves to turn, as those of a cube do by cracks near its faces."""
    block = bd.pack(bd.Box((FLAT, SIDE, SIDE)), count=2 * count, method="even", seed=seed)
    return _slide(bd.connect(block, method="laguerre"), FLAT, "flat, ")


def _slide(body: bd.Lattice, length: float, told_before: str) -> list[Row]:
    rows: list[Row] = []
    for opening, slides in SLIDES.items():
        reach = _opening(opening, length)
        found = course(body, RANKINE, {"x": (0.0, reach, reach, reach)}, slide=(0.0, 0.0, 0.0, slides[-1] * LAST))
        sliding = int(np.argmax(found.moved["slide"] > 0.0))
        way = found.moved["slide"][sliding:] / LAST
        shear, across = (found.stress[axis][sliding:] / TENSION for axis in ("slide", "x"))
        spent = found.run.history.released / found.section["x"] / ENERGY
        told = f"{told_before}opened by {opening:g}"
        at = {one: min(int(np.searchsorted(way, one * (1.0 - 1e-9))), len(way) - 1) for one in slides}
        note = f"{found.note}, largest shear {np.abs(shear).max():.3f} f_t, dissipated {spent[sliding]:.3f} before"

        def row(name: str, value: float, limit: float | None, note: str = note, told: str = told) -> Row:
            return Row("open", f"{told}{name}", value, 0.0, limit, note=note)

        bears_nothing = opening >= 1.0
        for one, k in at.items():
            limit = SHEAR if bears_nothing else None
            rows += [
                row(f", slid by {one:g}: shear over f_t", float(shear[k]), limit),
                row(f", slid by {one:g}: stress across over f_t", float(across[k]), None),
            ]
        if not bears_nothing:
            first, last = (float(shear[at[one]]) for one in (slides[0], slides[-1]))
            rise = max(0.0, last - first)
            rows.append(row(f", slid from {slides[0]:g} to {slides[-1]:g}: rise of the shear over f_t", rise, 0.0))
        rows.append(row(f", slid by {slides[-1]:g}: dissipated over G_f", float(spent[-1]), None))
    return rows


def crossing(seed: int, count: int) -> list[Row]:
    """A crack across x between held faces across y, and then one across y through both parts, x held apart."""
    found = course(cube(seed, count), RANKINE, {"x": (0.0, torn(), torn()), "y": (0.0, 0.0, torn())}, watch="y")
    spent = found.run.history.released / found.section["y"] / ENERGY
    begin = int(np.argmax(found.moved["y"] > 0.0))
    told, note = "a crack across x, then one across y", f"{found.note}, G_f of the first {spent[begin]:.3f}"
    work = float(spent[-1] - spent[begin])
    return [
        Row("open", f"{told}: peak along y", found.peak("y") / TENSION, 1.0, PEAK, note=note),
        Row("open", f"{told}: G_f of the second", work, 1.0, WORK, note=note),
        Row("open", f"{told}: left along y over f_t", found.left("y") / TENSION, 0.0, SHEAR, note=note),
        Row("open", f"{told}: left along x over f_t", found.left("x") / TENSION, 0.0, SHEAR, note=note),
    ]


def closing(seed: int, count: int) -> list[Row]:
    """A cube that is opened and pressed to half of f_t in turn, and then torn: it closes with all its stiffness."""
    body, half = cube(seed, count), -0.5 * TENSION / E * SIDE
    whole = course(body, RANKINE, {"x": (0.0, half)})
    reach = _opening(OPENED)
    knots = [0.0, reach, half] * TIMES
    found = course(body, RANKINE, {"x": (*knots, torn())})
    strain, stress = found.moved["x"] / SIDE, found.stress["x"]
    end = int(np.flatnonzero(strain <= 0.999 * half / SIDE)[-1])
    begin = int(np.flatnonzero(strain[:end] > 0.25 * half / SIDE)[-1]) + 1
    stiff = float(np.polyfit(strain[begin:end], stress[begin:end], 1)[0]) / whole.modulus("x", 0.5, 0.95)
    spent = found.run.history.released / found.section["x"] / ENERGY
    told = f"{TIMES} times opened by {OPENED:g} and pressed"
    return [
        Row("open", f"{told}: modulus in compression", stiff, 1.0, STIFFNESS, note=found.note),
        Row("open", f"{told}: G_f when torn", float(spent[-1]), 1.0, WORK, note=found.note),
        Row("open", f"{told}: dissipation taken back over G_f", float(-np.diff(spent).min(initial=0.0)), 0.0, TAKEN),
    ]  # fmt: skip


def rubbing(seed: int, count: int) -> list[Row]:
    """A cube that is torn, pressed by f_t and slid: its shear over μ p, and the share of friction in its work."""
    failure = bd.Rankine(tension=TENSION, fracture_energy=ENERGY, friction=FRICTION)
    press = -TENSION / E * SIDE
    found = course(
        cube(seed, count), failure, {"x": (0.0, torn(), press, press)}, slide=(0.0, 0.0, 0.0, SLID[1] * LAST)
    )
    late = found.moved["slide"] > SLID[0] * LAST
    shear, pressure = found.stress["slide"][late], -found.stress["x"][late]
    work = float(np.trapezoid(shear, found.moved["slide"][late])) * found.section["x"]
    rubbed = float(np.ptp(found.run.history.energy["friction"][late]))
    told = f"torn, pressed by f_t and slid by {SLID[1]:g}"
    return [
        Row("open", f"{told}: shear over friction times pressure", float(shear.mean() / (FRICTION * pressure.mean())),
            1.0, RUBS, note=found.note),
        Row("open", f"{told}: friction over the work of the slide", rubbed / work, 1.0, RUBS,
            note=found.note),
    ]  # fmt: skip
