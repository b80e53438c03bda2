"""The chapters, a file each, in the order of the book."""

from book.chapter_file import ChapterFile
from book.chapters import (
    andre_tables,
    any_specimen,
    calibration,
    celigueta,
    cells,
    chen_components,
    chen_tables,
    concrete,
    cost,
    dynamic_tests,
    dynamics,
    formulations,
    fracture,
    laws,
    mka3d,
    packings,
    parameters,
    predictions,
    protocol,
    rapid_fracture,
    runs,
    second_order,
    strength,
    surface,
)

_FILES = (
    andre_tables, protocol, chen_tables, chen_components, calibration, any_specimen, cells, second_order, mka3d,
    strength, concrete, celigueta, laws, predictions, fracture, rapid_fracture, packings, parameters, dynamic_tests,
    surface, formulations, dynamics, cost, runs,
)  # fmt: skip
FILES = tuple(map(ChapterFile, _FILES))
