"""The chapters, a file each, in the order of the book."""

from typing import cast

from book.chapter import ChapterFile
from book.chapters import andre_tables, chen_tables, cost, dynamics, formulations, packings
from book.results import Measurement

FILES = tuple(cast(ChapterFile, file) for file in (andre_tables, chen_tables, packings, formulations, dynamics, cost))
MEASUREMENTS: tuple[Measurement, ...] = tuple({one.name: one for file in FILES for one in file.MEASUREMENTS}.values())
