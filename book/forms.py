"""How numbers are printed: unit, scale and digits of a row."""

import re
from collections.abc import Iterable, Sequence
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


def spaced(count: float) -> str:
    """A whole number with a space between thousands."""
    return COUNT.text(count)


def listed(values: Iterable[object]) -> str:
    """Some things in a row, "1, 2, 3"."""
    return ", ".join(map(str, values))


def seeds(values: Sequence[int]) -> str:
    """Seeds in words, "seed 1" or "seeds 1, 2"."""
    return f"seed{'s' * (len(values) > 1)} {listed(values)}"


def grid(heads: Sequence[str], lines: Iterable[Sequence[str]], rule: str = "---|") -> str:
    """A table of texts, with a rule below each head."""
    first, *others = (f"| {' | '.join(line)} |" for line in (heads, *lines))
    return "\n".join([first, f"|{rule * len(heads)}", *others])


def span(values: Iterable[float], style: str) -> str:
    """The least and the largest of some numbers, "1.2 to 1.4"."""
    found = sorted(values)
    return f"{found[0]:{style}} to {found[-1]:{style}}"


def worst(ratios: Iterable[float]) -> float:
    """Largest distance of some ratios from one."""
    return max(abs(ratio - 1.0) for ratio in ratios)


def text(value: float, form: Form | Said) -> str:
    """A number in a form."""
    return form.text(value)


PLAIN = Form()
COUNT = Form(style=",.0f")
PERCENT = Form("%", 1e-2, ".2f")
SIGNED = Form("%", 1e-2, "+.2f")
ROUNDING = Form(style=".1g")
GPA = Form("GPa", 1e9, ".1f")
MPA = Form("MPa", 1e6, ".2f")
RATIO = Form(style=".3f")
SECONDS = Form("s", style=".3g")
