"""Numbers that tests record: `python -m pytest --record=FILE`, see tests/recording.py."""

from book.results import Measurement
from book.row import Measured

TESTS = Measurement("tests", "python -m pytest --validate --record=benchmarks/results/tests.json", "6 min")


def largest(name: str) -> Measured:
    """The largest that any test found."""
    return TESTS.number("numbers", name, "largest")


def range_of(name: str) -> Measured:
    """The least and the largest."""
    found = TESTS.at("numbers", name)
    return TESTS.of(found["least"], found["largest"])


def holds(name: str) -> Measured:
    """Whether it was so in every test."""
    return TESTS.of(float(TESTS.at("numbers", name, "least") is True))
