"""The validation pages: `docs/validation.md` and `docs/validation/`, written from the files in `benchmarks/results`.

    python -m book                        write docs/validation.md, docs/validation/*.md, tables of docs/studies.md
    python -m book --check                list pages that differ from the results, and figures that are missing
    python -m book --rows                 count rows by verdict, before and after the rule, and check the misses
    python -m book --list                 list the measurements and their commands
    python -m book --measure [NAME ...]   repeat measurements: benchmarks/results/NAME.json and docs/figures
    python -m book --fast [DIR]           measure a small part from nothing and check its tolerances; a minute

A chapter is a file in `book/chapters` with a function `chapter()`. Its rows read numbers from JSON files in
`benchmarks/results`, also those of tests (`book/outcomes.py`). Python holds published values and tolerances only.
A verdict is computed; a missing number is an error. Pages print the rows that have a verdict (`book/shown.py`).
"""
