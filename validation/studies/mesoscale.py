"""Concrete as mortar, aggregates and the interface between them: stiffness, strengths, and where its cracks run.

The materials of examples/mesoscale.toml: mortar with f_t = 4 MPa and 50 MPa in compression, aggregates of 8 to 16 mm
by a grading curve with 20 % of the volume, an interface with 2 MPa. A prism of 80 × 40 × 40 mm is pulled and pressed,
a disc Ø60 × 30 mm is split; beside it the mortar alone. Each packing has aggregates of its own.
"""

import tomllib
from functools import partial
from itertools import product
from pathlib import Path
from typing import Any

from bondem.specimen.material import Material
from bondem.study.pipeline import run_study
from bondem.study.study_file import parse_study
from validation.frame.record import Record
from validation.frame.sources import REPOSITORY

STUDY = REPOSITORY / "examples" / "mesoscale.toml"
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
    study = parse_study(asked(test, seed, fraction))
    results = run_study(study, folder)
    one = results["packings"][0]
    there = results["specimen"].get("aggregates")
    row = {
        "cells": results["specimen"]["elements"], "E": one["E"], "peak": one["tests"][test]["measured"],
    }  # fmt: skip
    if there is not None and study.material is not None:
        row["bounds"] = bounds(study.material, there)
    return row


def measure(
    record: Record, *, seeds: tuple[int, ...] = (1, 2, 3), fractions: tuple[float, ...] = (0.0, 0.2),
    tests: tuple[str, ...] = TESTS,
) -> None:  # fmt: skip
    """Carry out tests with several fractions of aggregates."""
    for seed, fraction, test in product(seeds, fractions, tests):
        folder = record.beside(f"{test}-{fraction:g}-seed{seed}")
        record.add(partial(measured, test, seed, fraction, folder), test=test, seed=seed, fraction=fraction)
    record.rows().sort(key=lambda one: (TESTS.index(one["test"]), one["fraction"], one["seed"]))
    record.keep()
