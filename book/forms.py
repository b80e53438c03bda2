"""How numbers are printed: unit, scale and digits of a row."""

import re
from dataclasses import dataclass


@dataclass(frozen=True)
class Form:
    """A number with a unit.

    Attributes:
        unit: printed behind the number.
        scale: what the number is divided by, 1e9 for GPa.
        style: as in `format`; "+.2f" gives every number a sign.
    """

    unit: str = ""
    scale: float = 1.0
    style: str = ".4g"

    def bare(self, value: float, *, signed: bool = True) -> str:
        """The number alone, with a true minus sign and a space between thousands."""
        style = self.style if signed else self.style.replace("+", "")
        text = format(value / self.scale, style).replace(",", " ")
        text = re.sub(r"e([+-])0*(\d)", lambda power: f"e{power[1].strip('+')}{power[2]}", text)
        if float(text.replace(" ", "")) == 0.0:
            return text.lstrip("+-")  # what rounds to zero has no sign
        return f"−{text[1:]}" if text.startswith("-") else text

    def text(self, value: float, *, signed: bool = True) -> str:
        """The number and its unit."""
        return f"{self.bare(value, signed=signed)} {self.unit}".rstrip()


@dataclass(frozen=True)
class Said:
    """Something that is so or is not."""

    yes: str = "yes"
    no: str = "no"

    def bare(self, value: float, *, signed: bool = True) -> str:
        del signed
        return self.yes if value else self.no

    text = bare


PLAIN = Form()
COUNT = Form(style=",.0f")
PERCENT = Form("%", 1e-2, ".2f")
SIGNED = Form("%", 1e-2, "+.2f")
ROUNDING = Form(style=".1g")
GPA = Form("GPa", 1e9, ".1f")
SECONDS = Form("s", style=".3g")
