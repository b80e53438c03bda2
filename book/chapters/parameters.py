"""André et al. (2012), figures 11 and 13 to 18: what the bonds' parameters and the number of elements do."""

from book.forms import GPA, PERCENT, RATIO, ROUNDING, SIGNED, Form
from book.results import study
from book.row import Row, Rows
from book.tolerances import AtMost, Near

INFLUENCE = study(
    "influence", {name: f"influence_{name}" for name in ("nu_mu", "E_mu", "radius_ratio", "exponent")},
    without=("summary",),
)  # fmt: skip
ABACUS = study("abacus", {"abacus": "abacus_curves", "reach": "abacus_reach", "silica": "abacus_silica"})
ASSEMBLY = study(
    "assembly", {"assembly": "assembly_moduli", "scatter": "assembly_scatter", "fineness": "assembly_fineness"}
)
MEASUREMENTS = (INFLUENCE, ABACUS, ASSEMBLY)

PLACES = {"periodic cell": "cell", "cylinder 10 x 40 mm": "cylinder"}
EXPONENT = Form(style=".2f")
POISSON = Form(style=".4f")


def nu_mu() -> Rows:
    for place, where in PLACES.items():
        found = INFLUENCE.at("verdicts", place, "nu_mu", "EulerBernoulli")
        yield Row(f"{where}, Euler–Bernoulli: change of E over ν_μ = 0 … 0.49",
            INFLUENCE.of(found["E_change_low"], found["E_change_high"]), AtMost(0.01), SIGNED, source="fig. 11",
            paper="not significant")  # fmt: skip
        yield Row(f"{where}, Euler–Bernoulli: change of ν",
            INFLUENCE.of(found["nu_change_low"], found["nu_change_high"]), AtMost(0.002), Form(style="+.4f"),
            source="fig. 11", paper="not significant")  # fmt: skip


def bond_modulus() -> Rows:
    for place, where in PLACES.items():
        found = INFLUENCE.at("verdicts", place, "E_mu")
        yield Row(f"{where}: E/E_μ over E_μ, largest change", INFLUENCE.of(found["E"]), AtMost(1e-9), ROUNDING,
            source="fig. 13a", paper="linear")  # fmt: skip
        yield Row(f"{where}: ν over E_μ, largest change", INFLUENCE.of(found["nu"]), AtMost(1e-9), ROUNDING,
            source="fig. 13b", paper="constant")  # fmt: skip


def bond_radius() -> Rows:
    stiffer = (
        "the stiffness in elongation grows with r̃², in shear and bending with r̃⁴: the local exponent is 2 + 2 × the"
        " share of the energy that is not in elongation"
    )
    for place, where in PLACES.items():
        found = INFLUENCE.at("verdicts", place, "radius_ratio")
        yield Row(f"{where}: local exponent of E in r̃, 0.2 … 0.9",
            INFLUENCE.of(found["exponent_low"], found["exponent_high"]), Near(absolute=0.1), EXPONENT,
            source="fig. 14a", paper=2.0, printed="quadratic", reason=stiffer)  # fmt: skip
        yield Row(f"{where}: E off any parabola in r̃, of the largest E", INFLUENCE.of(found["E_parabola_misfit"]),
            AtMost(0.02), PERCENT, source="fig. 14a", paper="quadratic")  # fmt: skip
        yield Row(f"{where}: ν off a parabola in r̃", INFLUENCE.of(found["nu_parabola_misfit"]), AtMost(0.005),
            POISSON, source="fig. 14b", paper="quadratic")  # fmt: skip


def abacus() -> Rows:
    denser = "the packing decides, as for Table 2"
    for place, where in PLACES.items():
        found = ABACUS.at("silica", place, "EulerBernoulli")
        yield Row(f"{where}: r̃ for ν = 0.17", ABACUS.of(found["value"]), Near(relative=0.02), RATIO,
            source="fig. 15", paper=0.71, printed="0.71")  # fmt: skip
        yield Row(f"{where}: E_μ for E = 72.5 GPa", ABACUS.of(found["E_mu"]), Near(relative=0.02), GPA,
            source="fig. 16", paper=265e9, printed="265 GPa", reason=denser)  # fmt: skip


def assembly() -> Rows:
    names = {"contacts": "6.2 contacts", "jamming": "onset of jamming"}
    for target, found in ASSEMBLY.at("targets").items():
        words = names[target]
        for name, symbol, paper, hentz, liao in (("E", "E", 0.07, 0.12, 0.28), ("nu", "ν", 0.05, 0.10, 0.16)):
            scatter = found["scatter"][name]
            for printed, who, source in (
                (paper, "the paper's bonds", "§5.4, fig. 17"), (hentz, "Hentz's energy criterion", "§5.4, ref. 7"),
                (liao, "Liao's calibration of springs", "§5.4, ref. 39"),
            ):  # fmt: skip
                yield Row(f"{symbol}, {words}: standard deviation above 7500 elements, against {who}",
                    ASSEMBLY.of(scatter["std"]), AtMost(), PERCENT, source=source, paper=printed,
                    printed=f"{100 * printed:.0f} %")  # fmt: skip
            yield Row(f"{symbol}, {words}: largest less smallest above 7500", ASSEMBLY.of(scatter["peak_to_peak"]),
                AtMost(), PERCENT, source="§5.4, fig. 17", paper=paper, printed=f"{100 * paper:.0f} %")  # fmt: skip
            yield Row(f"{symbol}, {words}: exponent of N in the standard deviation",
                ASSEMBLY.of(scatter["exponent"], scatter=scatter["exponent_error"]),
                Near(target=-0.5, absolute=2.0 * scatter["exponent_error"]), EXPONENT,
                note="± one standard error; within two of −1/2, that of independent parts")  # fmt: skip
