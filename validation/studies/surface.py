"""How E and ν of a body differ from those of the bulk, and their prediction."""

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

import numpy as np

from bondem import __version__
from bondem.interactions.beams.bond_law import BondLaw
from bondem.interactions.law_catalogue import LAWS, PARAMETERS
from bondem.io.atomic import write_text
from validation.figures.surface import draw_surface
from validation.frame.limits import numbers
from validation.frame.study import Row, Stages, Study
from validation.measures.surface_fit import CurveFit, Fit, bulk_means, column, fitted_range, law_name
from validation.measures.surface_tables import accuracy, bodies, ends, predicted
from validation.rows.surface import ModuliRequest, SpecimenRequest

_COMMON: dict[str, Any] = {"E": 1e9, "nu": 0.3}

#: Laws whose rows the coefficients are fitted to, from shear-soft to shear-stiff.
FITTED: tuple[BondLaw, ...] = tuple(law.at(value, **_COMMON) for law in LAWS.values() for value in law.free.fitted)

#: Laws held out, to test them on; the first is used for what is measured once only.
HELD_OUT: tuple[BondLaw, ...] = tuple(
    law.at(value, **_COMMON, radius_ratio=0.7) for law in LAWS.values() for value in law.free.held_out
)

_BARS = ("cube", "beam", "plate", "cylinder")
_BODIES = ("cube", "cylinder", "ball", "bracket")


@dataclass(frozen=True)
class SurfaceStudy(Study):
    """How E and ν of a body differ from those of the bulk, and how well its lattice predicts that.

    Attributes:
        counts: elements of a body packed with 6.2 contacts a sphere, ascending.
        seeds: packings of each; of the largest number, where there are several, one less, but at least one.
        other_count: elements of bodies packed to jamming or cut from a larger packing.
        cell_count: elements of a periodic cell.
        laws: bond laws the correction is fitted to; all of `FITTED` unless given.
    """

    limits: ClassVar = {
        "counts": numbers(least=300, advice="300 or more"), "seeds": numbers(least=1),
        "other_count": numbers(least=300), "cell_count": numbers(least=300),
    }  # fmt: skip

    counts: tuple[int, ...] = (2000, 5000, 20_000)
    seeds: int = 3
    other_count: int = 4000
    cell_count: int = 5000
    laws: tuple[BondLaw, ...] = FITTED

    @property
    def specimens(self) -> list[SpecimenRequest]:
        """Every body and cell."""
        found = [
            SpecimenRequest(form, count, "contacts", seed)
            for count in self.counts
            for form in (*_BARS, "ball", "bracket")
            for seed in range(1, (1 if form not in _BARS else self._seeds(count)) + 1)
        ]
        fewer = range(1, max(1, self.seeds - 1) + 1)
        found += [
            SpecimenRequest(form, self.other_count, target, seed)
            for target in ("jamming", "carved")
            for form in _BARS
            for seed in fewer
        ]
        return found + [
            SpecimenRequest("cell", self.cell_count, target, seed)
            for target in ("contacts", "dense", "jamming")
            for seed in (range(1, self.seeds + 1) if target == "contacts" else fewer)
        ]

    def _seeds(self, count: int) -> int:
        fewer = len(self.counts) > 1 and count == max(self.counts)
        return max(1, self.seeds - fewer)

    def stages(self, out: Path) -> Stages:
        specimens = self.specimens
        pulled = [one for one in specimens if one.form in (*_BARS, "cell")]
        found = [ModuliRequest(one, law) for one in pulled for law in (*self.laws, *HELD_OUT)]
        once = HELD_OUT[0]
        contacts = [one for one in specimens if one.target == "contacts" and one.seed == 1]
        found += [ModuliRequest(one, once, "plates") for one in contacts if one.form in ("cube", "cylinder")]
        found += [ModuliRequest(one, once, "stress") for one in contacts if one.form in _BODIES]
        yield "pack", specimens
        yield "solve", found

    def results(self, out: Path, rows: Sequence[Row]) -> dict[str, Any]:
        """See `Study`: the model as in `surface.json`, how well it predicts, and means over packings."""
        good = [row for row in rows if not row["error"]]
        pulled = [row for row in good if row["test"] == "tension"]
        fitted = [row for row in pulled if law_name(row) in {_name(law) for law in self.laws}]
        others = [row for row in pulled if law_name(row) in {_name(law) for law in HELD_OUT}]
        bulk = bulk_means(pulled)
        if not fitted or not bulk:
            empty: list[Any] = []
            return {"model": None, "accuracy": empty, "bodies": empty, "ends": empty, "predicted": None, "bulk": bulk}
        fits = {name: Fit(fitted, name) for name in ("E", "nu")}
        curves = {name: CurveFit(fitted, bulk, name) for name in ("E", "nu")}
        once = [row for row in good if law_name(row) == _name(HELD_OUT[0])]
        return {
            "model": self._model(fits, curves, pulled),
            "accuracy": accuracy(fits, curves, others),
            "bodies": bodies([row for row in once if row["test"] == "tension"]),
            "ends": ends(once, bulk[_name(HELD_OUT[0])], fits),
            "predicted": predicted(fits["E"], bulk),
            "bulk": bulk,
        }

    def _model(self, fits: dict[str, Fit], curves: dict[str, CurveFit], pulled: Sequence[Row]) -> dict[str, Any]:
        cells = [row for row in pulled if row["form"] == "cell" and row["target"] == "contacts"]
        found: dict[str, Any] = {}
        for name in ("E", "nu"):
            found[name] = [[float(f"{c:.6g}") for c in line] for line in fits[name].coefficients.reshape(4, 5)]
            found[f"{name}_error"] = [float(f"{value:.3g}") for value in fits[name].scatter]
            found[f"{name}_curve"] = [float(f"{c:.5g}") for c in curves[name].coefficients]
            found[f"{name}_curve_error"] = float(f"{np.sqrt(np.mean(curves[name].held_out ** 2)):.3g}")
        return found | {
            "length": [round(float(column(cells, name).mean()), 6) for name in ("bond_length", "bond_length_std")],
            "number": round(float(column(cells, "bond_number").mean()), 6),
            "coordination": round(float(column(cells, "coordination").mean()), 5),
            "looseness": round(float(column(cells, "looseness").mean()), 6),
            "fitted": fitted_range([row for row in pulled if row in fits["E"].rows]),
            "version": __version__,
        }

    def draw(self, out: Path, rows: Sequence[Row], results: Mapping[str, Any]) -> None:
        """See `Study`; the coefficients are written to `surface.json` as the package has them."""
        if results["model"] is None:
            return
        write_text(out / "surface.json", json.dumps(results["model"], indent=1, allow_nan=False) + "\n")
        draw_surface(out / "figures" / "surface.png", results)


def _name(law: BondLaw) -> str:
    return law_name({"law": type(law).__name__} | {name: getattr(law, name, None) for name in PARAMETERS})
