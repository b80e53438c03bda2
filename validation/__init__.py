"""The papers' tests done again: studies of many packings, each a row kept as soon as it is there.

`python -m validation NAME --out DIR` carries one out; it resumes in a folder where it was stopped, and works on all
cores. Not part of the package that users install.
"""
