"""The calibration and validation book: `docs/validation.md` and its pages, rendered from results that are kept.

    python -m book                        renders docs/validation.md, docs/validation/*.md, tables of docs/studies.md
    python -m book --check                what differs from what the results render to; figures that are missing
    python -m book --list                 what is measured, and how
    python -m book --measure [NAME ...]   measures again: benchmarks/results/NAME.json and docs/figures
    python -m book --fast [DIR]           measures a small part from nothing and holds it to its tolerances; a minute

A chapter is a file in `book/chapters` with a function `chapter()`. Its rows read numbers from JSON in
`benchmarks/results`, those of tests too (`book/outcomes.py`). In Python stand only what papers print, and tolerances.
A verdict is computed; a number that is not there is an error.
"""
