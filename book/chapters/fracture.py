"""Published fracture tests: a scorecard, with inputs that were fixed beforehand."""

from book.chapters import crack_paths, ring, weakest_link
from book.forms import RATIO, Form, listed, seeds
from book.results import Measurement, study
from book.row import Row, Rows
from book.tolerances import AtMost, Between, Near

#: Cases of the scorecard by name: what a caption says.
CASES = {
    "petersson": "Petersson's beam",
    "gregoire": "Grégoire's beam of 50 mm",
    "garcia_alvarez": "García-Álvarez' beam, notch off its middle",
    "l_panel": "Winkler's L-shaped panel",
}
FRACTURE = study("fracture", {name: f"fracture_{name}" for name in CASES}, options="--finer 0.7")
COARSE = study("fracture", {}, options="--finer 0.5 --seeds 1", kept="fracture_coarse")
FINE = study("fracture", {}, options="--seeds 1", kept="fracture_fine")
TOUGHNESS = study("toughness", {"toughness": "fracture_toughness"})
SIZES = study("size_effect", {"size_effect": "fracture_size_effect"})
KALTHOFF = study("kalthoff", {"kalthoff": "fracture_kalthoff"})
BEAMS = study(
    "beam_bonds", {f"beams_{name}": f"fracture_beams_{name}" for name in ("l_panel", "gregoire", "kalthoff")}
)
KALTHOFF_SECONDS = Measurement("kalthoff_seconds", "python benchmarks/kalthoff_seconds.py")
MEASUREMENTS = (
    FRACTURE, COARSE, FINE, BEAMS, TOUGHNESS, SIZES, KALTHOFF, KALTHOFF_SECONDS,
    *weakest_link.MEASUREMENTS, *crack_paths.MEASUREMENTS, *ring.MEASUREMENTS,
)  # fmt: skip

_FORMS = {"peak": Form("kN", 1e3, ".3f"), "work": Form("J", style=".3f")}


def scorecard() -> Rows:
    for measured, size in ((FRACTURE, ""), (COARSE, ", coarser"), (FINE, ", finer")):
        for one in measured.at("cases"):
            claim, counts = one["claim"], one["count"]
            cells = f"{min(counts)} cells" if len(counts) == 1 else f"{min(counts)} to {max(counts)} cells"
            yield Row(f"{one['title']}: {claim['quantity']}{size}; {seeds(one['seeds'])}, {cells}",
                measured.of(*one["values"]), Between(claim["low"], claim["high"]), _FORMS[claim["quantity"]],
                paper=claim["words"])  # fmt: skip


def beams() -> Rows:
    """The same inputs with calibrated beam bonds, beside the cells' values."""
    for one in BEAMS.at("cases"):
        title, values, slow = f"{one['title']}, beams", one["values"], one["quantity"] == "peak"
        known = [value for value in values if value is not None]
        form = _FORMS["peak"] if slow else Form("°", style=".1f")
        if known:
            yield Row(f"{title}: {one['quantity']}; seeds {listed(one['runs']['seed'])},"
                f" {max(one['runs']['count'])} spheres", BEAMS.of(*known), Between(one["low"], one["high"]), form,
                paper=one["words"])  # fmt: skip
        if not slow:
            cracked = Form(f"of {len(values)}", style=".0f")
            yield Row(f"{title}: packings whose crack leaves the notch", BEAMS.of(len(known)), Near(relative=0.0),
                cracked, paper=float(len(values)))  # fmt: skip


def strengths() -> list[float]:
    """Strengths of the bars over f_t."""
    return [one["tension"] / one["strength"] for one in BEAMS.at("cases")]


def toughness() -> Rows:
    for one in TOUGHNESS.at("plates"):
        yield Row(f"{one['kind']}, W = {one['over']:g} l, seeds {listed(one['seed'])},"
            f" {min(one['count'])} cells (crack longer by 0.419 l: {one['expected']:.3f}): K / K_Ic",
            TOUGHNESS.of(*one["values"]), Near(relative=TOUGHNESS.at("limit")), RATIO, paper=1.0)  # fmt: skip


def kalthoff() -> Rows:
    for one in KALTHOFF.at("cases"):
        yield Row(f"f_t = {1e-6 * one['tension']:g} MPa, cells of {one['over']:.2f} h*, {one['count'][0]} of them,"
            f" seeds {listed(one['seed'])}: angle of the crack against the notch",
            KALTHOFF.of(one["mean"]["mean"], scatter=one["mean"]["std"]), Near(absolute=KALTHOFF.at("limit")),
            Form("°", style=".1f"), paper=KALTHOFF.at("angle"))  # fmt: skip
    for one in KALTHOFF_SECONDS.at("cases"):
        threads = f"{one['threads']} thread{'s' * (one['threads'] > 1)}"
        yield Row(
            f"f_t = {1e-6 * one['tension']:g} MPa, {one['cells']} cells, {one['steps']} steps on {threads}: time"
            " of stepping until 90 µs", KALTHOFF_SECONDS.of(one["wall"]["median"]), AtMost(60.0),
            Form("s", style=".1f"))  # fmt: skip
