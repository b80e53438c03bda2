"""Concrete as mortar, aggregates and the interface between them: stiffness, strengths, and where its cracks run.

The materials of examples/mesoscale.toml: mortar with f_t = 4 MPa and 50 MPa in compression, aggregates of 8 to 16 mm
by a grading curve with 20 % of the volume, an interface with 2 MPa. A prism of 80 × 40 × 40 mm is pulled and pressed,
a disc Ø60 × 30 mm is split; beside it the mortar alone. Each packing has aggregates of its own.

Run: python benchmarks/mesoscale.py [--seeds 1 2 3] [--fractions 0 0.2] [--out DIR]
     python benchmarks/mesoscale.py --summary
Every test is kept in --out as soon as it is done.
"""

import argparse
import json
import time
import tomllib
from pathlib import Path
from typing import Any

from bondem.specimen.material import Material
from bondem.study.pipeline import run_study
from bondem.study.study_file import parse_study
from kept import RESULTS, commit, keep, origin

STUDY = Path(__file__).parents[1] / "examples" / "mesoscale.toml"
TESTS = ("direct_tension", "ucs", "brazilian")


def asked(test: str, seed: int, fraction: float) -> dict[str, Any]:
    """The study of one test on one packing."""
    document = tomllib.loads(STUDY.read_text(encoding="utf-8"))
    specimens = {one["name"]: one for one in document.pop("specimens")}
    specimen = specimens["disc" if test == "brazilian" else "prism"]
    inside = {key: value for key, value in specimen.items() if key not in ("name", "tests")}
    document |= {"specimen": inside, "tests": [test], "seed": seed}
    if fraction:
        document["aggregates"]["fraction"] = fraction
    else:
        del document["aggregates"]
    return document


def bounds(matrix: Material, grains: dict[str, float]) -> tuple[float, float]:
    """Of Hashin and Shtrikman (1963) on E of a matrix with stiffer balls at random, lower and upper [Pa]."""
    share = grains["fraction"]
    both = (matrix.E, matrix.nu, share), (grains["E"], grains["nu"], 1.0 - share)
    found = []
    for (E1, nu1, c), (E2, nu2, _) in (both, both[::-1]):
        (K1, G1), (K2, G2) = (
            (E / (3.0 * (1.0 - 2.0 * nu)), 0.5 * E / (1.0 + nu)) for E, nu in ((E1, nu1), (E2, nu2))
        )  # fmt: skip
        K = K1 + c / (1.0 / (K2 - K1) + 3.0 * (1.0 - c) / (3.0 * K1 + 4.0 * G1))
        beta = 6.0 * (K1 + 2.0 * G1) / (5.0 * G1 * (3.0 * K1 + 4.0 * G1))
        G = G1 + c / (1.0 / (G2 - G1) + (1.0 - c) * beta)
        found.append(9.0 * K * G / (3.0 * K + G))
    return found[0], found[1]


def measured(test: str, seed: int, fraction: float, folder: Path) -> dict[str, Any]:
    """Results of one test."""
    begun = time.perf_counter()
    study = parse_study(asked(test, seed, fraction))
    results = run_study(study, folder)
    one = results["packings"][0]
    there = results["specimen"].get("aggregates")
    row = {
        "test": test, "seed": seed, "fraction": fraction, "cells": results["specimen"]["elements"],
        "E": one["E"], "peak": one["tests"][test]["measured"], "aggregates": there,
        "lost": one["tests"][test]["failure"].get("lost_area"), "seconds": round(time.perf_counter() - begun, 1),
    }  # fmt: skip
    if there is not None and study.material is not None:
        row["bounds"] = bounds(study.material, there)
    return row


def main(arguments: list[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seeds", type=int, nargs="+", default=[1, 2, 3])
    parser.add_argument("--fractions", type=float, nargs="+", default=[0.0, 0.2])
    parser.add_argument("--tests", nargs="+", default=list(TESTS), choices=list(TESTS))
    parser.add_argument("--out", type=Path, default=Path("out/mesoscale"))
    parser.add_argument("--summary", action="store_true", help="bring what is in --out into the results")
    given = parser.parse_args(arguments)
    if given.summary:
        rows = [json.loads(file.read_text()) for file in given.out.glob("*/row.json")]
        rows.sort(key=lambda one: (TESTS.index(one["test"]), one["fraction"], one["seed"]))
        begun = origin() | {"command": "python benchmarks/mesoscale.py"}
        keep(RESULTS / "mesoscale.json", begun | {"cases": rows})
        return
    for seed in given.seeds:
        for fraction in given.fractions:
            for test in given.tests:
                folder = given.out / f"{test}-{fraction:g}-seed{seed}"
                if (folder / "row.json").exists():
                    continue
                row = measured(test, seed, fraction, folder)
                (folder / "row.json").write_text(json.dumps(row | {"commit": commit()}))
                print(f"{test}, {fraction:g} of aggregates, packing {seed}: {row}", flush=True)


if __name__ == "__main__":
    main()
