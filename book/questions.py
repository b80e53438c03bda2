"""What a reader decides with the validation, and the chapters that answer it, in the order of the first page."""

from collections.abc import Mapping, Sequence

from book.chapter import Chapter
from book.errors import BookError

STIFFNESS = "Are stiffness and stress those of the material?"
WAVES = "Do waves and vibrations have the right speed and frequency?"
STRENGTH = "Does a body break at its strength, with its fracture energy?"
CRACKS = "Do cracks and fragments agree with published tests?"
PACKINGS = "Are packings those of the literature?"
TRUST = "Can runs be trusted, and how fast are they?"

#: Chapters of each question by name, each with the few words that a chart has room for.
QUESTIONS: Mapping[str, Mapping[str, str]] = {
    STIFFNESS: {
        "cells": "Cells: E, ν, waves", "second_order": "Thin bodies", "mka3d": "Beside Mka3D",
        "calibration": "Calibration", "any_specimen": "Other shapes", "surface": "Surface correction",
        "andre_tables": "André, Tables 1–4", "protocol": "André's protocol", "parameters": "André, figs 11–18",
        "chen_tables": "Chen, cantilevers", "chen_components": "Chen, components", "formulations": "Formulations",
    },
    WAVES: {"dynamic_tests": "André, figs 10–22"},
    STRENGTH: {
        "strength": "Strength as entered", "concrete": "Tests of concrete", "predictions": "Predictions",
        "laws": "Calibrated strength", "celigueta": "Celigueta et al.",
    },
    CRACKS: {"fracture": "Fracture tests", "rapid_fracture": "Branching, spalling"},
    PACKINGS: {"packings": "Packings"},
    TRUST: {"dynamics": "Energy, dynamics", "runs": "Killed runs", "cost": "Time and memory"},
}  # fmt: skip


def by_question(chapters: Sequence[Chapter]) -> dict[str, list[Chapter]]:
    """The chapters of each question.

    Raises:
        BookError: a chapter answers no question.
    """
    known = {chapter.name: chapter for chapter in chapters}
    found = {question: [known[name] for name in names if name in known] for question, names in QUESTIONS.items()}
    if lost := set(known) - {chapter.name for some in found.values() for chapter in some}:
        raise BookError(f"'{min(lost)}' is a chapter of no question; name it in book/questions.py")
    return {question: some for question, some in found.items() if some}
