"""Command-line options that are physical quantities: plain numbers in SI, or numbers with a unit ("72.5 GPa")."""

import click

from bondem._checks import number
from bondem._units import quantity
from bondem.errors import InputError


class Quantity(click.ParamType):
    """Type of an option that is a finite number in SI, or a text with a unit of the same dimension.

    Args:
        unit: SI unit; "-" for plain numbers, whose text may be a percentage; "%" for numbers in percent.
        above: exclusive lower limit, or None.
        least: inclusive lower limit, or None.
        below: exclusive upper limit, or None.
    """

    def __init__(
        self, unit: str, *, above: float | None = None, least: float | None = None, below: float | None = None
    ) -> None:
        self.unit = unit
        self.name = "number" if unit == "-" else unit
        self._bounds = {"above": above, "least": least, "below": below}

    def convert(self, value: object, param: click.Parameter | None, ctx: click.Context | None) -> float:
        name = param.opts[0] if param is not None else "the value"
        try:
            given: object = float(value) if isinstance(value, str) else value
        except ValueError:
            given = None
        try:
            found = given if given is not None else quantity(name, str(value), self.unit)
            return number("", name, found, **self._bounds)
        except InputError as error:
            self.fail(str(error), param, ctx)
