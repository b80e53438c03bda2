"""The calibration and validation book: `docs/validation.md` and its pages, rendered from results that are kept.

    python -m book                      renders docs/validation.md, docs/validation/*.md and the tables of docs/studies.md
    python -m book --check              says what differs from what the results render to, and whether a figure is missing
    python -m book --list               chapters, and what is measured how
    python -m book --measure [NAME ...] measures again: benchmarks/results/NAME.json and docs/figures
    python -m book --fast [DIR]         measures a small part anew, in less than a minute, and holds it to its tolerances

A chapter is a file in `book/chapters` with a function `chapter()`. Its rows read numbers from JSON in
`benchmarks/results` or, where a test or a long run has none, from `book/recorded.toml`. In Python stand only what papers
print, and tolerances. A verdict is computed; a number that is not there is an error.
"""
