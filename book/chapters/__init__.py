"""The chapters, a text and a module each, in the order of the pages."""

from importlib import import_module

from book.chapter_file import ChapterFile

_NAMES = (
    "andre_tables", "protocol", "chen_tables", "chen_components", "calibration", "any_specimen", "cells",
    "second_order", "mka3d", "strength", "concrete", "celigueta", "laws", "predictions", "fracture", "rapid_fracture",
    "packings", "parameters", "dynamic_tests", "surface", "formulations", "dynamics", "cost", "runs",
)  # fmt: skip
FILES = tuple(ChapterFile(import_module(f"{__name__}.{name}")) for name in _NAMES)
