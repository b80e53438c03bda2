"""Speed: the same bonds in bondem and in other codes, and what makes a step slow."""

from collections.abc import Iterator

from book.chapters.cost import CALLBACK, FAILING, KRATOS, PEERS
from book.chapters.runs import OUTPUT
from book.forms import Form
from book.quoting import Quoted

RATIO, FINE = Form(style=".0f"), Form(style=".2f")
MILLISECONDS, SHARE = Form("ms", 1e-3, ".0f"), Form("%", 1e-2, ".1f")


def quoted() -> Iterator[Quoted]:
    """All quoted speeds."""
    sizes = "{elements} spheres, {bonds} bonds, one thread"
    peers, kratos = (record.at("specimens", 0) for record in (PEERS, KRATOS))
    for code, words in (
        ("lammps", "LAMMPS bpm/rotational"), ("yade", "Yade CohFrictMat"), ("kratos", "Kratos DEM_KDEM"),
    ):  # fmt: skip
        yield Quoted(f"speed.{code}", f"speed of bondem over that of {words}", sizes.format(**peers), PEERS,
            (peers["codes"][code]["ratio_median"],), RATIO)  # fmt: skip
    theirs, ours = (kratos["codes"][code]["ratio_median"] for code in ("kratos", "non-local"))
    yield Quoted("speed.kratos_non_local", "speed of the non-local law of bondem over that of Kratos",
        sizes.format(**kratos), KRATOS, (theirs / ours,), RATIO)  # fmt: skip
    cases = {one["kind"]: one for one in OUTPUT.at("cases")}
    cells, body = cases["cells"], f"{cases['cells']['elements']} elements"
    yield Quoted("slow.size", "elements of the bodies whose steps are timed", body, OUTPUT, (cells["elements"],),
        Form("elements", style=",.0f"))  # fmt: skip
    for kind in ("cells", "beams"):
        yield Quoted(f"slow.{kind}_step", f"time of a step of {kind}, one thread", body, OUTPUT,
            (cases[kind]["step"]["median"],), MILLISECONDS)  # fmt: skip
    share = cells["snapshot"]["median"] / (2000 * cells["step"]["median"])
    yield Quoted("slow.cells_cost", "cost of a snapshot each 2000 steps, over the run", body, OUTPUT, (share,), SHARE)
    failing = f"{FAILING.at('elements')} cells, one thread"
    yield Quoted("slow.failing", "cells of the bodies that fail", failing, FAILING, (FAILING.at("elements"),),
        Form("cells", style=",.0f"))  # fmt: skip
    for name, kind, words in (
        ("brittle", "MohrCoulomb", "brittle facets"),
        ("rankine", "Rankine", "a criterion on the stress of cells"),
        ("softening", "MohrCoulomb, softening", "yielding cells and softening facets"),
    ):
        yield Quoted(f"slow.{name}", f"step with {words}, in elastic steps", failing, FAILING,
            (FAILING.at(kind, "median_ratio"),), FINE)  # fmt: skip
    yield Quoted("slow.callback", "time of a callback over that of the 100 steps between two",
        f"{CALLBACK.at('many', 'elements')} elements, one thread", CALLBACK,
        (CALLBACK.at("share of an output in the steps between two"),), SHARE)  # fmt: skip
