"""Speed: the same bonds in bondem and in other codes, and what makes a step slow."""

from collections.abc import Iterator

from book.chapters.cost import CALLBACK, FAILING, GPU, KRATOS, PEERS
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
    yield from gpu()


#: Bodies of the benchmark of a GPU by the name of their numbers.
_ON_GPU = {
    "beams4": "beams, 10000", "beams5": "beams, 100000", "beams6": "beams, 1000000", "cells4": "cells, 10000",
    "cells5": "cells, 100000", "contact": "contact", "break6": "beams that break",
    "cells_break": "cells that break", "cells_crack": "cells that crack",
}  # fmt: skip


def gpu() -> Iterator[Quoted]:
    """Speed on a GPU, and agreement with the CPU."""
    rate = Form(scale=1e9, style=".2f")
    for name, body in _ON_GPU.items():
        found = GPU.at(body)
        size = f"{found['elements']} elements, {found['bonds']} bonds"
        yield Quoted(f"gpu.{name}", f"10⁹ bond-steps per second on a GPU: {body}", size, GPU,
            (found["bond-steps/s"]["median"],), rate)  # fmt: skip
        yield Quoted(f"gpu.{name}_ratio", f"bond-steps on a GPU over those on all its cores: {body}", size, GPU,
            (found["ratio"],), Form(style=".1f"))  # fmt: skip
    batch, cracked, compared = (GPU.at(name) for name in ("batch", "cells that crack", "agreement"))
    yield Quoted("gpu.batch", "10⁹ bond-steps per second on a GPU: many specimens at once",
        f"{batch['specimens']} specimens of {batch['elements']} elements", GPU, (batch["bond-steps/s"],),
        rate)  # fmt: skip
    yield Quoted("gpu.threads", "cores of the machine with the GPU", "16 threads", GPU,
        (cracked["cpu"]["threads"],))  # fmt: skip
    yield Quoted("gpu.cracks", "facets that crack on the GPU", f"{cracked['bonds']} facets", GPU,
        (cracked["cracks"],), Form("cracks", style=",.0f"))  # fmt: skip
    runs = f"{compared['runs']} small runs"
    yield Quoted("gpu.runs", "runs on a GPU that are compared with the CPU", runs, GPU, (compared["runs"],))
    yield Quoted("gpu.deviation", "largest difference of these runs from the CPU", runs, GPU,
        (compared["largest"],), Form(style=".1e"))  # fmt: skip
    yield Quoted("gpu.within", "runs that differ from the CPU by less than 1e-15", runs, GPU,
        (compared["runs"] - len(compared["above 1e-15"]),))  # fmt: skip
