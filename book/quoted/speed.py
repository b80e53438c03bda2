"""Speed: the same bonds in bondem and in other codes."""

from collections.abc import Sequence
from typing import Any

from book.chapters.cost import CALLBACK, FAILING, KRATOS, PEERS
from book.chapters.runs import OUTPUT
from book.forms import Form
from book.quoting import Quoted

RATIO, FINE = Form(style=".0f"), Form(style=".2f")
MILLISECONDS, SHARE = Form("ms", 1e-3, ".0f"), Form("%", 1e-2, ".1f")
_NAMES = {"lammps": "LAMMPS bpm/rotational", "yade": "Yade CohFrictMat", "kratos": "Kratos DEM_KDEM"}


def quoted() -> Sequence[Quoted]:
    """All quoted speeds."""
    specimen = PEERS.at("specimens", 0)
    found = [
        Quoted(name=f"speed.{code}", says=f"speed of bondem over that of {words}", size=_size(specimen), record=PEERS,
               form=RATIO, values=(specimen["codes"][code]["ratio_median"],))
        for code, words in _NAMES.items()
    ]  # fmt: skip
    specimen = KRATOS.at("specimens", 0)
    ratio = {code: one["ratio_median"] for code, one in specimen["codes"].items()}
    found.append(Quoted(
        name="speed.kratos_non_local", says="speed of the non-local law of bondem over that of Kratos",
        size=_size(specimen), record=KRATOS, form=RATIO, values=(ratio["kratos"] / ratio["non-local"],),
    ))  # fmt: skip
    return [*found, *_slow()]


def _size(specimen: Any) -> str:
    return f"{specimen['elements']} spheres, {specimen['bonds']} bonds, one thread"


def _slow() -> Sequence[Quoted]:
    """What a step takes, and what makes it slow."""
    cases = {one["kind"]: one for one in OUTPUT.at("cases")}
    body = f"{cases['cells']['elements']} elements"
    failing = f"{FAILING.at('elements')} cells, one thread"
    step = "time of a step of {}, one thread"
    return [
        Quoted(name="slow.size", says="elements of the bodies whose steps are timed", size=body, record=OUTPUT,
               form=Form("elements", style=",.0f"), values=(cases["cells"]["elements"],)),
        *(Quoted(name=f"slow.{kind}_step", says=step.format(kind), size=body, record=OUTPUT, form=MILLISECONDS,
                 values=(cases[kind]["step"]["median"],)) for kind in ("cells", "beams")),
        Quoted(name="slow.cells_cost", says="cost of a snapshot each 2000 steps, over the run", size=body,
               record=OUTPUT, form=SHARE, values=(_snapshots(cases["cells"]),)),
        Quoted(name="slow.failing", says="cells of the bodies that fail", size=failing, record=FAILING,
               form=Form("cells", style=",.0f"), values=(FAILING.at("elements"),)),
        *(Quoted(name=f"slow.{name}", says=f"step with {words}, in elastic steps", size=failing, record=FAILING,
                 form=FINE, values=(FAILING.at(kind, "median_ratio"),))
          for name, kind, words in (("brittle", "MohrCoulomb", "brittle facets"),
                                    ("rankine", "Rankine", "a criterion on the stress of cells"),
                                    ("softening", "MohrCoulomb, softening", "yielding cells and softening facets"))),
        Quoted(name="slow.callback", says="time of a callback over that of the 100 steps between two",
               size=f"{CALLBACK.at('many', 'elements')} elements, one thread", record=CALLBACK, form=SHARE,
               values=(CALLBACK.at("share of an output in the steps between two"),)),
    ]  # fmt: skip


def _snapshots(case: Any) -> float:
    """Time of a snapshot over that of 2000 steps."""
    return case["snapshot"]["median"] / (2000 * case["step"]["median"])
