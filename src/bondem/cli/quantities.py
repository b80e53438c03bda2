"""Options of the command line that are physical quantities: plain numbers in SI, or with a unit ("72.5 GPa")."""

import click

from bondem._checks import number
from bondem.errors import InputError
from bondem.specimen.units import quantity


class Quantity(click.ParamType):
    """A finite number in a unit, or a text with a unit of the same kind.

    Args:
        unit: SI unit; "-" for plain numbers, of which text may be a percentage.
    """

    def __init__(self, unit: str) -> None:
        self.unit = unit
        self.name = "number" if unit == "-" else unit

    def convert(self, value: object, param: click.Parameter | None, ctx: click.Context | None) -> float:
        name = param.opts[0] if param is not None else "the value"
        try:
            given: object = float(value) if isinstance(value, str) else value
        except ValueError:
            given = None
        try:
            return number("", name, given if given is not None else quantity(name, str(value), self.unit))
        except InputError as error:
            self.fail(str(error), param, ctx)
