"""André et al. (2012), figures 10, 12 and 19 to 22: energies, inertia, waves, the effective section."""

from book.forms import PERCENT, ROUNDING, SIGNED
from book.results import record, study
from book.row import Row, Rows
from book.tolerances import AtMost


def _drawn(name: str, *figures: str) -> dict[str, str]:
    return {f"{name}_{figure}": f"{name}_{figure}" for figure in figures}


QUASISTATIC = study("quasistatic", _drawn("quasistatic", "energy", "breakdown", "settling"))
VIBRATION = study("vibration", _drawn("vibration", "breakdown", "energy", "inertia"))
WAVE = study("wave", _drawn("wave", "faces", "snapshots", "travel", "arrival"))
SECTION = study("section", _drawn("section", "face", "errors"))
MASS = record("mass_moments", "--count 10000 --packings 4")
MEASUREMENTS = (QUASISTATIC, VIBRATION, WAVE, SECTION, MASS)

#: What "negligible" may mean of a quantity and "negligible" or "minor" of a share of an energy; no number is printed.
NEGLIGIBLE, MINOR = 0.01, 0.05


def quasistatic() -> Rows:
    last = QUASISTATIC.at("explicit", -1)
    shares, static = (QUASISTATIC.at("energy", name) for name in ("shares", "shares_static"))
    off = max(abs(shares[name] - static[name]) for name in ("paper_tension", "paper_bending", "paper_torsion"))
    yield Row("largest kinetic over elastic energy", QUASISTATIC.number("energy", "kinetic_over_elastic"),
        AtMost(NEGLIGIBLE), ROUNDING, source="fig. 10, §5.1.2", paper="negligible")  # fmt: skip
    yield Row(f"E after {last['steps']} steps, off the static solution", QUASISTATIC.of(1e-6 * last["E_ppm"]),
        AtMost(1e-3), ROUNDING)  # fmt: skip
    yield Row(f"ν after {last['steps']} steps, off the static solution", QUASISTATIC.of(1e-6 * last["nu_ppm"]),
        AtMost(1e-3), ROUNDING)  # fmt: skip
    yield Row("elastic energy in torsion of the bonds", QUASISTATIC.of(shares["paper_torsion"]), AtMost(MINOR),
        PERCENT, source="fig. 12, §5.2.1", paper="minor")  # fmt: skip
    yield Row("largest difference of the shares of elastic energy from the static solution", QUASISTATIC.of(off),
        AtMost(1e-3), ROUNDING)  # fmt: skip


def vibration() -> Rows:
    shares = VIBRATION.at("run", "shares")
    yield Row("elastic energy in torsion of the bonds, mean", VIBRATION.of(shares["paper_torsion"]), AtMost(MINOR),
        PERCENT, source="fig. 19, §6", paper="negligible")  # fmt: skip
    yield Row("kinetic energy in the rotation of the elements, mean",
        VIBRATION.number("run", "rotational_share_mean"), AtMost(MINOR), PERCENT, source="§6",
        paper="negligible")  # fmt: skip
    yield Row("imbalance of the energies over the work of the loads", VIBRATION.number("run", "energy_error"),
        AtMost(1e-2), ROUNDING)  # fmt: skip
    yield Row("drift of the energy over the free vibration", VIBRATION.number("run", "total_drift"), AtMost(1e-3),
        ROUNDING)  # fmt: skip
    for kind, found in VIBRATION.at("run", "frequency").items():
        yield Row(f"{kind}: frequency of the signal, off the mode's",
            VIBRATION.of(found["signal"] / found["mode"] - 1.0), AtMost(1e-3), ROUNDING)  # fmt: skip


def inertia() -> Rows:
    skin = "the skin between rigid walls has less mass, so the specimen's moments are smaller than the continuum's"
    for words, name in (("about", "axial_excess"), ("across", "lateral_excess")):
        yield Row(f"moment of inertia {words} the axis, specimen over continuum, less one", VIBRATION.summary(name),
            AtMost(NEGLIGIBLE), SIGNED, source="§6, after eq (19)", paper="negligible", reason=skin)  # fmt: skip
    for kind in ("tension", "bending", "torsion"):
        yield Row(f"frequency in {kind}: what the mass does to it", VIBRATION.summary("frequency", kind, "mass"),
            AtMost(NEGLIGIBLE), SIGNED, source="§6, after eq (19)", paper="negligible", reason=skin)  # fmt: skip
    yield Row("mass of the specimen, less the continuum's", VIBRATION.summary("mass_excess"), AtMost(NEGLIGIBLE),
        SIGNED, source="eq (19)", paper="equal",
        note="eq (19) holds for the calibrating packing; others differ by their volume fraction")  # fmt: skip


def balanced() -> Rows:
    for way, words in (("one", "one density"), ("balanced", "balanced")):
        found = MASS.at("summary", way)
        if way == "balanced":
            for k, axis in enumerate(("about the axis", "across it")):
                yield Row(f"{words}: moment of inertia {axis}, off the continuum's",
                    MASS.of(found["inertia_error"]["mean"][k]), AtMost(1e-9), ROUNDING)  # fmt: skip
        for k, kind in enumerate(MASS.at("kinds")):
            yield Row(f"{words}, {kind}: frequency, theory with the paper's lengths",
                MASS.of(found["error"]["mean"][k], scatter=found["error"]["std"][k]), AtMost(0.035),
                SIGNED)  # fmt: skip


def wave() -> Rows:
    levels = WAVE.at("levels")
    low, high = (WAVE.at("summary", "held", "error", levels.index(level))["mean"] for level in (0.9, 0.05))
    moment = (
        "the paper does not define when a wave has arrived: from 5 to 90 % of the plateau the celerity goes from"
        f" {100 * high:+.0f} to −{abs(100 * low):.0f} %"
    )
    yield Row("celerity off √(E/ρ), arrival at half the plateau", WAVE.summary("error"), AtMost(), SIGNED,
        source="Table 4, figs 20, 21", paper=0.0040, reason=moment)  # fmt: skip
    yield Row("celerity off √(E/ρ), arrival at half the plateau: required of specimens", WAVE.summary("error"),
        AtMost(0.03), SIGNED)  # fmt: skip


def section() -> Rows:
    paper = SECTION.at("paper", "bending_frequency")
    walls, hull = (
        SECTION.at("summary", "error", name, "bending_frequency")["mean"] for name in ("walls", "effective")
    )
    unsaid = "the paper does not define how its effective section is measured"
    yield Row("bending frequency, max section", SECTION.summary("error", "walls", "bending_frequency"), AtMost(),
        SIGNED, source="Table 4", paper=paper["walls"])  # fmt: skip
    yield Row("bending frequency, the paper's effective section: hull of the centres",
        SECTION.summary("error", "effective", "bending_frequency"), AtMost(), SIGNED, source="§6, fig. 22",
        paper=paper["effective"],
        reason=f"{unsaid}; this reading adds {100.0 * (hull - walls):.1f} % to the error with the max section,"
        " and ours starts nearer to zero than the paper's")  # fmt: skip
    yield Row("bending frequency, another reading: section of the axial force",
        SECTION.summary("error", "force", "bending_frequency"), AtMost(), SIGNED, source="§6, fig. 22",
        paper=paper["force"], reason=unsaid)  # fmt: skip
