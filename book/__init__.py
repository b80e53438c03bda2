"""Pages with measured numbers, written from `benchmarks/results`: the validation, README and other pages of prose.

    python -m book                        write docs/validation.md, docs/validation/*.md, tables of docs/studies.md,
                                          the pages of book/texts, docs/numbers.md, and what code of pages prints
    python -m book --check                list pages that differ from the results, and figures that are missing
    python -m book --rows                 count rows by verdict, before and after the rule, and check the misses
    python -m book --list                 list the measurements and their commands
    python -m book --measure [NAME ...]   repeat measurements: benchmarks/results/NAME.json and docs/figures; all
                                          that a page quotes, if its name is given: python -m book --measure README.md

A chapter is a text in `book/chapters`, NAME.md, with NAME.py beside it (`book/chapter_file.py`). Its rows read
numbers from JSON files in `benchmarks/results`, also those of tests (`book/outcomes.py`). Python holds published
values and tolerances only.
A verdict is computed; a missing number is an error. Rows that are met for one requirement share a line
(`book/shown.py`).

The first page is `book/front.md`. A page of prose is a text in `book/texts` with the path of its page. In it
`{{ subject.name }}` is a number that a file of `book/quoted` reads from a record, and `{{ 30 }}` one that was not
measured. A test finds all others.
"""
