"""Bodies of cells: E, ν, waves, bodies of other shapes and the stress at a hole, with nothing calibrated."""

from book.forms import PERCENT, PLAIN, SIGNED, Form, grid, spaced, span
from book.results import grouped, record
from book.row import Row, Rows
from book.tolerances import AtMost, Near

MODULI = record("cell_moduli")
UNIFORM = record("uniform_stress", takes="15 min")
WAVES = record("cell_waves")
RAYLEIGH = record("cell_rayleigh", takes="10 min")
HOLE = record("cell_hole", takes="40 min")
INERTIA = record("cell_inertia", takes="10 min")
BODIES = record("cell_bodies", takes="1 h")
BEAMS = record("beam_bodies", takes="40 min")
FIELDS, DAMPING = record("eigenstrain_fields"), record("cell_damping", takes="5 min")
MEASUREMENTS = (MODULI, UNIFORM, WAVES, RAYLEIGH, HOLE, INERTIA, BODIES, BEAMS, FIELDS, DAMPING)

#: Required tolerances [-].
E_LIMIT, NU_LIMIT, WAVE_LIMIT, RAYLEIGH_LIMIT, HOLE_LIMIT = 1e-6, 1e-6, 5e-3, 1e-2, 5e-2
UNIFORM_LIMIT = 1e-6
#: Curvature under a linear field of strain and damping of modes over theory, and stress over E ε at the face.
BENT, FIELD_STRESS, DAMPED = 1e-2, 1e-2, 1e-2
#: Waves of so many elements or more are judged; with the corrected mass also shorter ones.
LONG, LONG_CORRECTED, LONG_RAYLEIGH = 20.0, 10.0, 10.0
#: Bodies of so many elements or more are shown; those of FINE have a limit of their own.
COARSE, FINE, FINE_LIMIT = 10_000, 40_000, 5e-3
SMALL, OVER = Form(style="+.0e"), Form(style=".3f")


def moduli() -> Rows:
    for (nu,), mine in sorted(grouped(MODULI.at("rows"), "nu").items()):
        for part, words in (("bulk", "periodic cell"), ("bar", "bar, 8 cells across")):
            where = f"{words}, ν = {PLAIN.bare(nu)}"
            yield Row(f"{where}: error of E", MODULI.of(*(one[part]["E"] - 1.0 for one in mine)), AtMost(E_LIMIT),
                SMALL)  # fmt: skip
            yield Row(f"{where}: ν less that entered", MODULI.of(*(one[part]["nu"] - nu for one in mine)),
                AtMost(NU_LIMIT), SMALL)  # fmt: skip


def uniform() -> Rows:
    words = {"moduli": "E, K or ν", "traction": "traction of the worst facet over σ",
             "stress": "worst component of the stress of a cell over σ"}  # fmt: skip
    for (body,), mine in grouped(UNIFORM.at("zeros"), "body").items():
        for key, what in words.items():
            yield Row(f"{body}, ν = {mine[0]['nu']:g} to {mine[-1]['nu']:g}: error of {what}",
                UNIFORM.of(*(one["balanced"][key] for one in mine)), AtMost(UNIFORM_LIMIT), SMALL)  # fmt: skip


def waves() -> Rows:
    for one in WAVES.at("rows"):
        lumped = one["mass"] == "lumped"
        kind = "" if lumped else ", corrected mass" + (", half the step" if one["step"] < 1.0 else "")
        long = one["elements"] > (LONG if lumped else LONG_CORRECTED) - 0.1
        if long:
            yield Row(f"{one['wave']}{kind}, ν = {one['nu']:g}, {one['elements']:.1f} elements per wave: error of the"
                " celerity", WAVES.of(one["ratio"] - 1.0), AtMost(WAVE_LIMIT), SIGNED)  # fmt: skip


def rayleigh() -> Rows:
    long = [one for one in RAYLEIGH.at("rows") if one["elements"] > LONG_RAYLEIGH - 0.1]
    for (count, nu), mine in sorted(grouped(long, "count", "nu").items()):
        ends = dict.fromkeys(f"{end(one['elements'] for one in mine):.1f}" for end in (min, max))
        yield Row(f"{spaced(count)} elements, ν = {nu:g}, {'–'.join(ends)} elements per wave: error of the celerity",
            RAYLEIGH.of(*(one["ratio"] - 1.0 for one in mine)), AtMost(RAYLEIGH_LIMIT), SIGNED)  # fmt: skip


def bodies() -> Rows:
    """Bodies of 10 000 elements or more."""
    cases = [one for one in BODIES.at("cases") if one["count"] >= COARSE]
    for (count, shape), mine in grouped(cases, "count", "shape").items():
        limit = FINE_LIMIT if count >= FINE else mine[0]["limit"]
        if limit is not None:
            worst = max(abs(error) for one in mine for error in one["errors"].values())
            yield Row(f"{shape.replace('_', ' ')}, {spaced(count)} elements, {mine[0]['thickness']:.1f} thick: worst"
                f" error of {len(mine)} bodies", BODIES.of(worst), AtMost(limit), PERCENT)  # fmt: skip


def hole() -> Rows:
    judged = (
        ("rms", "cells about the hole: rms error of the stress"),
        ("hot_mean", "highest stressed hundredth of cells: mean error of the stress along the load"),
        ("hottest_error", "highest stressed cell over the highest stressed finite elements, less one"),
        ("hot_worst", "highest stressed hundredth of cells: error of the worst cell"),
    )
    signed = ("hot_mean", "hottest_error")
    for (count, nu), mine in sorted(grouped(HOLE.at("rows"), "count", "nu").items()):
        for key, words in judged:
            yield Row(f"{spaced(count)} elements, ν = {nu:g}, {words}", HOLE.of(*(one[key] for one in mine)),
                AtMost(HOLE_LIMIT), SIGNED if key in signed else PERCENT)  # fmt: skip


def fields() -> Rows:
    """Bars under a linear field of stress-free strain."""
    cases = FIELDS.at("cases")
    for (count,), mine in grouped(cases, "count").items():
        yield Row(f"{spaced(count)} elements: curvature over that of the field",
            FIELDS.of(*(one[key] for one in mine for key in ("along", "across"))), Near(target=1.0, absolute=BENT),
            OVER)  # fmt: skip
    yield Row("largest stress of a cell over that of the face if held", FIELDS.each(cases, "stress"),
        AtMost(FIELD_STRESS), PERCENT)  # fmt: skip


def damping() -> Rows:
    found = [one for row in DAMPING.at("cases") for one in row["modes"]]
    yield Row("damping of six modes over β ω / 2", DAMPING.of(*found), Near(target=1.0, absolute=DAMPED), OVER)


def by_size() -> str:
    """Table of the damping of modes by number of cells and ν."""
    lines = [[spaced(count), f"{nu:g}", span([one for row in mine for one in row["modes"]], ".3f")]
             for (count, nu), mine in grouped(DAMPING.at("cases"), "count", "nu").items()]  # fmt: skip
    return grid(("cells", "ν", "damping over β ω / 2"), lines, " --- |")


def of_fields() -> str:
    """Table of curvatures and stresses by number of cells and ν, under a linear field and under a moment."""
    keys = ("along", "across", "moment", "stress")
    lines = [[spaced(count), f"{nu:g}", *(span([one[key] for one in mine], ".3f") for key in keys)]
             for (count, nu), mine in grouped(FIELDS.at("cases"), "count", "nu").items()]  # fmt: skip
    heads = ("cells", "ν", "curvature along", "across", "under a moment", "stress over E ε of the face")
    return grid(heads, lines, " --- |")
