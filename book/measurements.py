"""All measurements: those of the chapters, those that only pages of prose quote, and those of the book itself."""

from book.chapters import FILES
from book.printed import PRINTED
from book.quoted import MEASUREMENTS as QUOTED
from book.results import Measurement

_NAMED = {one.name: one for file in FILES for one in file.measurements} | {one.name: one for one in QUOTED}
MEASUREMENTS: tuple[Measurement, ...] = (*_NAMED.values(), PRINTED)
