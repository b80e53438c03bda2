"""Numbers that pages of prose quote, a file for each subject."""

from book.quoted import beams, cells, fracture, speed
from book.quoting import Quoted
from book.results import Measurement

MEASUREMENTS: tuple[Measurement, ...] = (*cells.MEASUREMENTS, *fracture.MEASUREMENTS)


def quoted() -> list[Quoted]:
    """All quoted numbers."""
    return [one for file in (cells, fracture, beams, speed) for one in file.quoted()]
