"""André et al. (2012), figures 11 and 13 to 18: what the bonds' parameters and the number of elements do."""

from book.chapter import Chapter, Figure, Section
from book.forms import GPA, PERCENT, ROUNDING, SIGNED, Form
from book.results import study
from book.row import Row
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
LAWS = {"EulerBernoulli": "Euler–Bernoulli", "Timoshenko": "Timoshenko", "ParallelBond": "parallel",
    "Obermayr": "Obermayr"}


def chapter() -> Chapter:
    """The chapter."""
    return Chapter(
        name="parameters",
        title="André et al. (2012): figures 11 and 13 to 18",
        summary=(
            "The chapter shows the effect of ν_μ, E_μ and r̃ on E and ν, the calibration curves, and the effect of "
            "the number of elements, in periodic cells (without walls) and in the paper's cylinder."
        ),
        misses=(
            "E is not a quadratic function of r̃: its local exponent is larger than two. The calibrated E_μ "
            "differs from the paper, because the packing differs."
        ),
        sections=(_nu_mu(), _bond_modulus(), _bond_radius(), _abacus(), _assembly()),
    )


def _nu_mu() -> Section:
    rows = []
    for place, where in PLACES.items():
        for law, words in (("EulerBernoulli", "Euler–Bernoulli"), ("Timoshenko", "Timoshenko")):
            found = INFLUENCE.at("verdicts", place, "nu_mu", law)
            paper = law == "EulerBernoulli"
            rows += [
                Row(case=f"{where}, {words}: change of E over ν_μ = 0 … 0.49", form=SIGNED, source="fig. 11" * paper,
                    paper="not significant" if paper else None, tolerance=AtMost(0.01) if paper else None,
                    ours=INFLUENCE.of(found["E_change_low"], found["E_change_high"])),
                Row(case=f"{where}, {words}: change of ν", form=Form(style="+.4f"), source="fig. 11" * paper,
                    paper="not significant" if paper else None, tolerance=AtMost(0.002) if paper else None,
                    ours=INFLUENCE.of(found["nu_change_low"], found["nu_change_high"])),
            ]  # fmt: skip
    return Section(
        title="Figure 11: ν_μ",
        before=(
            "Changes are relative to ν_μ = 0.3. The paper states \"not significant\"; 1 % is taken as its meaning. "
            "The shear of Timoshenko bonds depends on ν_μ."
        ),
        rows=tuple(rows),
        figures=(Figure("influence_nu_mu.png", "E and ν over ν_μ (figure 11)"),),
    )


def _bond_modulus() -> Section:
    rows = []
    for place, where in PLACES.items():
        found = INFLUENCE.at("verdicts", place, "E_mu")
        rows += [
            Row(case=f"{where}: E/E_μ over E_μ, largest change", source="fig. 13a", paper="linear", form=ROUNDING,
                ours=INFLUENCE.of(found["E"]), tolerance=AtMost(1e-9)),
            Row(case=f"{where}: ν over E_μ, largest change", source="fig. 13b", paper="constant", form=ROUNDING,
                ours=INFLUENCE.of(found["nu"]), tolerance=AtMost(1e-9)),
        ]  # fmt: skip
    moduli, radii = (INFLUENCE.at(name) for name in ("moduli", "radius_ratios"))
    return Section(
        title="Figure 13: E_μ",
        before=(
            f"The rows show changes over {len(moduli)} E_μ of {1e-9 * moduli[0]:g} … {1e-9 * moduli[-1]:g} GPa at"
            f" each of {len(radii)} r̃ of {radii[0]:g} … {radii[-1]:g}, each computed separately on the first"
            " packing."
        ),
        rows=tuple(rows),
        figures=(Figure("influence_E_mu.png", "E and ν over E_μ, a curve for each r̃ (figure 13)"),),
    )


def _bond_radius() -> Section:
    stiffer = (
        "the stiffness in elongation grows with r̃², in shear and bending with r̃⁴: the local exponent is 2 + 2 × the"
        " share of the energy that is not in elongation"
    )
    rows = []
    for place, where in PLACES.items():
        found = INFLUENCE.at("verdicts", place, "radius_ratio")
        rows += [
            Row(case=f"{where}: local exponent of E in r̃, 0.2 … 0.9", source="fig. 14a", paper=2.0,
                printed="quadratic", form=EXPONENT, tolerance=Near(absolute=0.1), reason=stiffer,
                ours=INFLUENCE.of(found["exponent_low"], found["exponent_high"])),
            Row(case=f"{where}: E off any parabola in r̃, of the largest E", source="fig. 14a", paper="quadratic",
                form=PERCENT, tolerance=AtMost(0.02), ours=INFLUENCE.of(found["E_parabola_misfit"])),
            Row(case=f"{where}: ν off a parabola in r̃", source="fig. 14b", paper="quadratic", form=POISSON,
                tolerance=AtMost(0.005), ours=INFLUENCE.of(found["nu_parabola_misfit"])),
        ]  # fmt: skip
    return Section(
        title="Figure 14: r̃",
        before=(
            "The paper calls E an increasing and ν a decreasing quadratic function of r̃. E/E_μ and ν do not "
            "depend on E_μ (figure 13), so one curve represents a family. The stiffness of the cylinder relative "
            "to the cell depends on r̃."
        ),
        rows=tuple(rows),
        figures=(
            Figure(
                "influence_radius_ratio.png",
                "E and ν over r̃, a curve for each E_μ (figure 14); those of ν coincide, so rings stand in one"
                " another",
            ),
            Figure("influence_exponent.png", "Local exponent of E in r̃"),
        ),
    )


def _abacus() -> Section:
    denser = "the packing decides, as for Table 2"
    rows = []
    for place, where in PLACES.items():
        found = ABACUS.at("silica", place, "EulerBernoulli")
        rows += [
            Row(case=f"{where}: r̃ for ν = 0.17", source="fig. 15", paper=0.71, printed="0.71",
                form=Form(style=".3f"), ours=ABACUS.of(found["value"]), tolerance=Near(relative=0.02)),
            Row(case=f"{where}: E_μ for E = 72.5 GPa", source="fig. 16", paper=265e9, printed="265 GPa", form=GPA,
                ours=ABACUS.of(found["E_mu"]), tolerance=Near(relative=0.02), reason=denser),
        ]  # fmt: skip
    return Section(
        title="Figures 15 and 16: calibration curves",
        before="The curves are part of bondem as data. Laws without a value for ν = 0.17 cannot have this ν.",
        rows=tuple(rows),
        figures=(
            Figure("abacus_silica.png", "Fused silica on the curves (figures 15 and 16)"),
            Figure("abacus_curves.png", "Calibration curves of four laws"),
            Figure("abacus_reach.png", "E and ν that each law can represent"),
        ),
    )


def _assembly() -> Section:
    rows = []
    names = {"contacts": "6.2 contacts", "jamming": "onset of jamming"}
    for target, found in ASSEMBLY.at("targets").items():
        words = names[target]
        for name, symbol, paper, hentz, liao in (("E", "E", 0.07, 0.12, 0.28), ("nu", "ν", 0.05, 0.10, 0.16)):
            scatter = found["scatter"][name]
            for printed, who, source in (
                (paper, "the paper's bonds", "§5.4, fig. 17"), (hentz, "Hentz's energy criterion", "§5.4, ref. 7"),
                (liao, "Liao's calibration of springs", "§5.4, ref. 39"),
            ):  # fmt: skip
                rows.append(Row(case=f"{symbol}, {words}: standard deviation above 7500 elements, against {who}",
                                source=source, paper=printed, printed=f"{100 * printed:.0f} %", form=PERCENT,
                                tolerance=AtMost(), ours=ASSEMBLY.of(scatter["std"])))  # fmt: skip
            rows += [
                Row(case=f"{symbol}, {words}: largest less smallest above 7500", source="§5.4, fig. 17", paper=paper,
                    printed=f"{100 * paper:.0f} %", form=PERCENT, tolerance=AtMost(),
                    ours=ASSEMBLY.of(scatter["peak_to_peak"])),
                Row(case=f"{symbol}, {words}: exponent of N in the standard deviation", form=EXPONENT,
                    ours=ASSEMBLY.of(scatter["exponent"], scatter=scatter["exponent_error"]),
                    tolerance=Near(target=-0.5, absolute=2.0 * scatter["exponent_error"]),
                    note="± one standard error; within two of −1/2, that of independent parts"),
            ]  # fmt: skip
    return Section(
        title="Figures 17 and 18: the number of elements",
        before=(
            "The paper's bonds are used in cylinders with increasing numbers of elements, four packings each; the "
            "scatter is relative to the mean."
        ),
        rows=tuple(rows),
        figures=(
            Figure("assembly_moduli.png", "E and ν over the number of elements (figure 17)"),
            Figure("assembly_fineness.png", "Specimens of increasing fineness (figure 18)"),
            Figure("assembly_scatter.png",
                "Scatter over the number of elements, with the paper's, Hentz's and Liao's"),
        ),
    )
