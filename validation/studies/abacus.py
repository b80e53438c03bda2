"""Calibration curves of every law (André et al. 2012, §5.3, figs 15 and 16)."""

import csv
import io
import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

from bondem import __version__
from bondem.calibration.abacus import Curve
from bondem.interactions.beams.bond_law import BondLaw
from bondem.interactions.law_catalogue import DEFAULT, LAWS, PARAMETERS
from bondem.io.atomic import write_text
from bondem.packing.sizes import SPREAD
from validation.figures.abacus import draw_abacus, draw_reach, draw_silica
from validation.frame.limits import numbers, words
from validation.frame.study import Row, Stages, Study
from validation.frame.tables import summary
from validation.rows.elastic import MEASURED, SHAPES, ElasticRequest, cells_and_bars

#: Fused silica of the paper's Tables 1 and 2: E [Pa], ν, r̃ and E_μ [Pa].
SILICA = {"E": 72.5e9, "nu": 0.17, "radius_ratio": 0.71, "E_mu": 265e9}

_NU_MU = 0.3
# Nothing depends on it but E, in proportion.
_E_MU = SILICA["E_mu"]


@dataclass(frozen=True)
class Sweep:
    """One law over the parameter that sets ν.

    Attributes:
        law: its class.
    """

    law: type[BondLaw]

    @property
    def parameter(self) -> str:
        """Name of what varies."""
        return self.law.free.name

    @property
    def values(self) -> tuple[float, ...]:
        """Of the parameter, ascending [-]."""
        return self.law.free.curve

    @property
    def fixed(self) -> dict[str, float]:
        """Parameters that do not vary."""
        return self.law.with_radius({})

    @property
    def laws(self) -> list[BondLaw]:
        """The law at every value."""
        return [self.law.at(value, E=_E_MU, nu=_NU_MU) for value in self.values]


#: Those of the laws that declare a curve, by name.
SWEEPS = {name: Sweep(law) for name, law in LAWS.items() if law.free.curve}


@dataclass(frozen=True)
class Abacus(Study):
    """Calibration curves of every law: figures 15 and 16 of André et al. (2012), as data to use again.

    Attributes:
        count: elements of a packing.
        packings: periodic cells, seeds 1 … packings.
        bars: cylinders of 10 x 40 mm, seeds 1 … bars; 0 for none.
        spread: κ [-].
        laws: some of `SWEEPS`.
    """

    limits: ClassVar = {
        "count": numbers(least=100), "packings": numbers(least=1), "bars": numbers(least=0), "laws": words(SWEEPS),
    }  # fmt: skip

    count: int = 10_000
    packings: int = 3
    bars: int = 3
    spread: float = SPREAD
    laws: tuple[str, ...] = tuple(SWEEPS)

    def stages(self, out: Path) -> Stages:
        packings = cells_and_bars(self.count, self.spread, cells=self.packings, bars=self.bars)
        bonds = [law for name in self.laws for law in SWEEPS[name].laws]
        yield "pack", packings
        yield "solve", [ElasticRequest(one, law) for one in packings for law in bonds]

    def results(self, out: Path, rows: Sequence[Row]) -> dict[str, Any]:
        """See `Study`; the curves of cells and of bars, and fused silica with each law."""
        by = ("periodic", "law", *PARAMETERS)
        groups = summary(rows, by, MEASURED)
        curves = {
            shape: {name: found for name in self.laws if (found := _curve(SWEEPS[name], groups, periodic))}
            for periodic, shape in SHAPES.items()
        }
        curves = {shape: found for shape, found in curves.items() if found}
        return {
            "nu_mu": _NU_MU,
            "paper": SILICA,
            "curves": curves,
            "silica": {shape: {law: _silica(law, data) for law, data in found.items()}
                       for shape, found in curves.items()},
            "summary": groups,
        }  # fmt: skip

    def draw(self, out: Path, rows: Sequence[Row], results: Mapping[str, Any]) -> None:
        """Figures 15 and 16 of every law, and the curves as data."""
        read = {
            shape: {law: Curve.read(law, data) for law, data in curves.items()}
            for shape, curves in results["curves"].items()
        }
        figures = out / "figures"
        draw_abacus(figures / "abacus.png", read, SILICA)
        draw_reach(figures / "reach.png", read)
        paper = DEFAULT.__name__
        if paper in self.laws:
            draw_silica(figures / "silica.png", {shape: curves[paper] for shape, curves in read.items()}, SILICA)
        self._write_data(out, rows, results["curves"])

    def _write_data(self, out: Path, rows: Sequence[Row], curves: Mapping[str, Any]) -> None:
        for periodic, shape in SHAPES.items():
            if shape not in curves:
                continue
            seeds = sorted({row["seed"] for row in rows if row["periodic"] is periodic})
            data = {
                "packing": {"shape": shape, "count": self.count, "packings": len(seeds), "spread": self.spread,
                            "z": 6.2, "seeds": seeds},
                "nu_mu": _NU_MU,
                "laws": curves[shape],
                "version": __version__,
            }  # fmt: skip
            name = "abacus.json" if periodic else "abacus_cylinder.json"
            write_text(out / name, json.dumps(data, indent=1, allow_nan=False) + "\n")
            if periodic:
                _write_curves(out / "curves", data)
        text = io.StringIO()
        writer = csv.writer(text, lineterminator="\n")
        columns = ("values", "nu", "nu_std", "stiffness_ratio", "stiffness_ratio_std")
        writer.writerow(["shape", "law", "parameter", "value", *columns[1:]])
        for shape, found in curves.items():
            for law, data in found.items():
                for line in zip(*(data[name] for name in columns), strict=True):
                    writer.writerow([shape, law, data["parameter"], *line])
        write_text(out / "abacus.csv", text.getvalue())


def _write_curves(folder: Path, data: Mapping[str, Any]) -> None:
    """Each law in a file of its own, as the package has them."""
    folder.mkdir(exist_ok=True)
    shared = {name: value for name, value in data.items() if name != "laws"}
    for law, own in data["laws"].items():
        write_text(folder / f"{law}.json", json.dumps(shared | own, indent=1, allow_nan=False) + "\n")


def _curve(sweep: Sweep, groups: Sequence[Mapping[str, Any]], periodic: bool) -> dict[str, Any] | None:
    """A law in an abacus.json, or None where nothing was measured."""
    own = [
        one for one in groups
        if one["periodic"] is periodic and one["law"] == sweep.law.__name__ and one["nu"]["mean"] is not None
    ]  # fmt: skip
    if not own:
        return None
    own.sort(key=lambda one: one[sweep.parameter])
    found: dict[str, Any] = {
        "parameter": sweep.parameter,
        "fixed": dict(sweep.fixed),
        "values": [one[sweep.parameter] for one in own],
    }
    for name in ("nu", "stiffness_ratio"):
        found[name] = [float(f"{one[name]['mean']:.8g}") for one in own]
        found[f"{name}_std"] = [None if one[name]["std"] is None else float(f"{one[name]['std']:.3g}") for one in own]
    return found


def _silica(law: str, data: Mapping[str, Any]) -> dict[str, float | None]:
    """Value of the parameter and E_μ [Pa] of fused silica, None beyond the reach; ν that the law reaches."""
    found = Curve.read(law, data)
    value = found.value_for(SILICA["nu"])
    ratio = None if value is None else found.stiffness_ratio_at(value)
    low, high = found.reach
    return {"value": value, "E_mu": None if ratio is None else SILICA["E"] / ratio, "nu_low": low, "nu_high": high}
