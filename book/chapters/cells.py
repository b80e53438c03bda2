"""Bodies of cells: E, ν, waves, bodies of other shapes and the stress at a hole, with nothing calibrated."""

from book.chapter import Chapter, Figure, Section
from book.forms import PERCENT, PLAIN, SIGNED, Form
from book.results import record
from book.row import Row
from book.tolerances import AtMost, Tolerance

MODULI = record("cell_moduli")
UNIFORM = record("uniform_stress", takes="15 min")
WAVES = record("cell_waves")
RAYLEIGH = record("cell_rayleigh", takes="10 min")
HOLE = record("cell_hole", takes="40 min")
INERTIA = record("cell_inertia", takes="10 min")
BODIES = record("cell_bodies", takes="1 h")
BEAMS = record("beam_bodies", takes="40 min")
MEASUREMENTS = (MODULI, UNIFORM, WAVES, RAYLEIGH, HOLE, INERTIA, BODIES, BEAMS)

#: Required tolerances [-].
E_LIMIT, NU_LIMIT, WAVE_LIMIT, RAYLEIGH_LIMIT, HOLE_LIMIT = 1e-6, 1e-6, 5e-3, 1e-2, 5e-2
UNIFORM_LIMIT = 1e-6
#: Waves of so many elements or more are judged; with the corrected mass also shorter ones.
LONG, LONG_CORRECTED, LONG_RAYLEIGH = 20.0, 10.0, 10.0
#: Bodies of so many elements or more are shown; those of FINE have a limit of their own.
COARSE, FINE, FINE_LIMIT = 10_000, 40_000, 5e-3
SMALL = Form(style="+.0e")
RATIO = Form(style=".3f")


def chapter() -> Chapter:
    """The chapter."""
    return Chapter(
        name="cells",
        title="Bodies of cells: E, ν, waves and stresses as entered",
        summary=(
            "`bd.CellBond(E, nu)` takes the constants of the material; nothing is calibrated. Every packing that "
            "was run is in the results. The law and its limits are described in [cell_law.md](cell_law.md)."
        ),
        misses=(
            "One wave at the shortest length with a limit is too slow. In coarse bodies the worst of the highest "
            "stressed cells at a hole exceed the limit. Bodies of 40 000 elements were not measured with this law."
        ),
        sections=(_moduli(), _uniform(), _waves(), _rayleigh(), *_bodies(), _beams(), _hole(), _inertia()),
    )


def _moduli() -> Section:
    rows = []
    found = MODULI.at("rows")
    for nu in sorted({one["nu"] for one in found}):
        mine = [one for one in found if one["nu"] == nu]
        for part, words in (("bulk", "periodic cell"), ("bar", "bar, 8 cells across")):
            where = f"{words}, ν = {PLAIN.bare(nu)}"
            rows += [
                Row(case=f"{where}: error of E", form=SMALL, tolerance=AtMost(E_LIMIT),
                    ours=MODULI.of(*(one[part]["E"] - 1.0 for one in mine))),
                Row(case=f"{where}: ν less that entered", form=SMALL, tolerance=AtMost(NU_LIMIT),
                    ours=MODULI.of(*(one[part]["nu"] - nu for one in mine))),
            ]  # fmt: skip
    seeds = len({one["seed"] for one in found})
    return Section(
        title="E and ν",
        before=f"All packings have {_spaced(MODULI.at('count'))} elements; the seeds are 1 to {seeds}.",
        rows=tuple(rows),
    )


def _uniform() -> Section:
    found, rows = UNIFORM.at("zeros"), []
    words = {"moduli": "E, K or ν", "traction": "traction of the worst facet over σ",
             "stress": "worst component of the stress of a cell over σ"}  # fmt: skip
    for body in dict.fromkeys(one["body"] for one in found):
        mine = [one for one in found if one["body"] == body]
        rows += [
            Row(case=f"{body}, ν = {mine[0]['nu']:g} to {mine[-1]['nu']:g}: error of {what}", form=SMALL,
                tolerance=AtMost(UNIFORM_LIMIT), ours=UNIFORM.of(*(one["balanced"][key] for one in mine)))
            for key, what in words.items()
        ]  # fmt: skip
    return Section(
        title="Uniform stresses",
        before=(
            f"Five packings of each body, {_spaced(UNIFORM.at('count'))} elements, seven Poisson's ratios: the "
            "largest error. [The law's page](cell_law.md) has those of the former law and of Mka3D."
        ),
        rows=tuple(rows),
    )


def _waves() -> Section:
    rows = []
    for one in WAVES.at("rows"):
        lumped = one["mass"] == "lumped"
        kind = "" if lumped else ", corrected mass" + (", half the step" if one["step"] < 1.0 else "")
        long = one["elements"] > (LONG if lumped else LONG_CORRECTED) - 0.1
        rows.append(
            Row(case=f"{one['wave']}{kind}, ν = {one['nu']:g}, {one['elements']:.1f} elements per wave: error of the"
                " celerity", form=SIGNED, ours=WAVES.of(one["ratio"] - 1.0), tolerance=_if(long, WAVE_LIMIT))
        )  # fmt: skip
    return Section(
        title="Plane waves in the infinite medium",
        before=(
            f"The packing has {_spaced(WAVES.at('count'))} elements and seed {WAVES.at('seed')}. Waves of "
            f"{LONG:.0f} elements or more must have the celerity of the material, with the corrected mass "
            f'(`mass_matrix="dispersion-corrected"`) those of {LONG_CORRECTED:.0f} or more.'
        ),
        rows=tuple(rows),
        figures=(Figure("cell_dispersion.png", "Celerity of P, S and Rayleigh waves over their length"),),
    )


def _rayleigh() -> Section:
    found, rows = RAYLEIGH.at("rows"), []
    for count in sorted({one["count"] for one in found}):
        for nu in sorted({one["nu"] for one in found}):
            mine = [one for one in found if (one["count"], one["nu"]) == (count, nu)]
            length = sorted({round(one["elements"], 6) for one in mine}, reverse=True)
            long = [one for one in length if one > LONG_RAYLEIGH - 0.1]
            for group in [long] + [[one] for one in length if one not in long]:
                ends = dict.fromkeys((f"{min(group):.1f}", f"{max(group):.1f}"))
                errors = [one["ratio"] - 1.0 for one in mine if round(one["elements"], 6) in group]
                rows.append(
                    Row(case=f"{_spaced(count)} elements, ν = {nu:g}, {'–'.join(ends)} elements per wave: error of"
                        " the celerity", form=SIGNED, ours=RAYLEIGH.of(*errors),
                        tolerance=_if(group is long, RAYLEIGH_LIMIT))
                )  # fmt: skip
    seeds = " and ".join(str(seed) for seed in sorted({one["seed"] for one in found}))
    return Section(
        title="Rayleigh waves",
        before=(
            f"The waves run on the free surface of a slab between smooth walls, seeds {seeds}, with at least two "
            "wavelengths of material below. The reference is the root of the Rayleigh function. Waves of "
            f"{LONG_RAYLEIGH:.0f} elements or more have a limit; shorter waves do not."
        ),
        rows=tuple(rows),
    )


def _bodies() -> tuple[Section, ...]:
    """Bodies of 10 000 elements or more, once they are measured."""
    cases = [one for one in BODIES.at("cases") if one["count"] >= COARSE]
    rows = []
    for count, shape in dict.fromkeys((one["count"], one["shape"]) for one in cases):
        mine = [one for one in cases if (one["count"], one["shape"]) == (count, shape)]
        limit = FINE_LIMIT if count >= FINE else mine[0]["limit"]
        rows.append(
            Row(case=f"{shape.replace('_', ' ')}, {_spaced(count)} elements, {mine[0]['thickness']:.1f} thick: worst"
                f" error of {len(mine)} bodies", form=PERCENT, tolerance=_if(limit is not None, limit or 0.0),
                ours=BODIES.of(max(abs(error) for one in mine for error in one["errors"].values())))
        )  # fmt: skip
    if not rows:
        return ()
    return (
        Section(
            title="Seven shapes beside finite elements",
            before=(
                "The quantities are E, ν, free frequencies and the response of the clamped body to loads; the "
                "error of ν is the difference itself. The limit is 1 % where the thinnest part is 8 elements thick "
                f"or more, 2 % where it is 4, and {100*FINE_LIMIT:g} % for {_spaced(FINE)} elements."
            ),
            rows=tuple(rows),
        ),
    )


def _beams() -> Section:
    """Beam bonds in the same shapes, each beside the cells of the same packing and the same Poisson's ratios."""
    found = BEAMS.at("cases")
    return Section(
        title="Beam bonds in the same shapes",
        before=(
            f"Euler–Bernoulli bonds were calibrated once for each of {len({one['material'] for one in found})}"
            f" materials, in {BEAMS.at('cells')} periodic cells of {_spaced(BEAMS.at('cell'))} spheres. They were"
            " used as calibrated, and with E_μ and r̃ changed for each body by the surface correction. Quantities and"
            f" packings are those of the cells ({_spaced(found[0]['count'])} elements, seed {found[0]['seed']})."
            " The response to loads is compared with the continuum between the centres of the spheres that are held"
            " and loaded, in favour of the beams."
        ),
    )


def _hole() -> Section:
    found, rows = HOLE.at("rows"), []
    judged = (
        ("rms", "cells about the hole: rms error of the stress"),
        ("hot_mean", "highest stressed hundredth of cells: mean error of the stress along the load"),
        ("hottest_error", "highest stressed cell over the highest stressed finite elements, less one"),
        ("hot_worst", "highest stressed hundredth of cells: error of the worst cell"),
    )
    signed = ("hot_mean", "hottest_error")
    for count in sorted({one["count"] for one in found}):
        for nu in sorted({one["nu"] for one in found}):
            mine = [one for one in found if (one["count"], one["nu"]) == (count, nu)]
            where = f"{_spaced(count)} elements, ν = {nu:g}"
            rows += [
                Row(case=f"{where}, {words}", form=SIGNED if key in signed else PERCENT, tolerance=AtMost(HOLE_LIMIT),
                    ours=HOLE.of(*(one[key] for one in mine)))
                for key, words in judged
            ]  # fmt: skip
    peaks = ", ".join(f"{one['largest']:.2f} for ν = {nu}" for nu, one in HOLE.at("peaks").items())
    return Section(
        title="Stress at a hole",
        before=(
            "A plate of 40 × 20 × 4 mm with a hole of radius 4 mm is pulled between smooth platens. The stress of "
            "cells is compared with the mean stress of finite elements over the same cells, both in units of the "
            "mean stress at the end. The peak of the continuum, at the edge of the hole in the middle of the "
            f"thickness, is {peaks}. A cell represents the mean over its volume and approaches this peak as it "
            "becomes smaller."
        ),
        rows=tuple(rows),
        figures=(Figure("cell_convergence.png", "Errors of frequencies and of the stress at the hole"),),
    )


def _inertia() -> Section:
    return Section(
        title="Choice of the inertia",
        before=(
            "The first six free frequencies of a beam of 40 × 5 × 5 mm were computed with several inertias of the "
            "cells, for seeds 1 and 2 and ν = 0.2 and 0.4."
        ),
    )


def _if(judged: bool, limit: float) -> Tolerance | None:
    return AtMost(limit) if judged else None


def _spaced(count: int) -> str:
    return f"{count:,}".replace(",", " ")
