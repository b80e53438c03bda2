"""What the surface study found, in numbers: means over packings, and how well others are predicted."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from validation.frame.study import Row
from validation.measures.surface_fit import STUBBY, CurveFit, Fit, bulk_means, column, law_name, relative_miss

# Targets whose bodies are compared with the periodic cells of another.
_BULK_OF = {"carved": "contacts"}


def bodies(rows: Sequence[Row]) -> list[dict[str, Any]]:
    """E and ν of the bodies in tension over those of their own bulk, for one law.

    The bulk of a target is that of the periodic cells of this target; of bodies cut out, that of the packing they
    were cut from.
    """
    found = []
    for target in ("contacts", "jamming", "carved"):
        bulk = list(bulk_means(rows, _BULK_OF.get(target, target)).values())
        own = [row for row in rows if row["target"] == target and row["form"] != "cell"]
        for form, count in dict.fromkeys((row["form"], row["count"]) for row in own):
            group = [row for row in own if (row["form"], row["count"]) == (form, count)]
            line: dict[str, Any] = {"target": target, "form": form, "count": count, "packings": len(group)}
            line["surface_ratio"] = float(column(group, "surface_ratio").mean())
            for name in ("E", "nu"):
                line |= _mean_std(name, column(group, name) / bulk[0][name] if bulk else np.array([]))
            found.append(line)
    return found


def ends(rows: Sequence[Row], bulk: dict[str, float], fits: dict[str, Fit]) -> list[dict[str, Any]]:
    """The same specimens in tension, between plates and under uniform stress, over the bulk, for one law.

    Beside it what the model predicts: for a bar, or under uniform stress for the whole body.
    """
    found = []
    for row in rows:
        if row["test"] == "tension":
            continue
        same = [
            one for one in rows
            if one["test"] == "tension" and all(one[k] == row[k] for k in ("form", "count", "target", "seed"))
        ]  # fmt: skip
        line: dict[str, Any] = {name: row[name] for name in ("form", "count", "seed", "test", "surface_ratio")}
        for name in ("E", "nu"):
            line[name] = row[name] / bulk[name]
            miss = relative_miss([row], name, fits[name].coefficients).item()
            line[f"{name}_predicted"] = line[name] * (1.0 + miss)
            line[f"{name}_tension"] = same[0][name] / bulk[name] if same else None
        found.append(line)
    return found


def predicted(fit: Fit, bulk: dict[str, dict[str, float]]) -> dict[str, list[Any]]:
    """E of every body and fitted law over the bulk at z = 6.2: as measured, and by a fit without its shape."""
    found: dict[str, list[Any]] = {name: [] for name in ("law", "form", "target", "measured", "predicted")}
    for row, miss in zip(fit.rows, fit.held_out, strict=True):
        if row["form"] != "cell":
            measured = row["E"] / bulk[law_name(row)]["E"]
            numbers = (round(measured, 5), round(measured * (1.0 + float(miss)), 5))
            values = (law_name(row), row["form"], row["target"], *numbers)
            for name, value in zip(found, values, strict=True):
                found[name].append(value)
    return found


def accuracy(fits: dict[str, Fit], curves: dict[str, CurveFit], others: Sequence[Row]) -> list[dict[str, Any]]:
    """Root mean square miss of what was left out of the fit: shapes, laws, and shapes by the curve over R̄S/V."""
    found = []
    for name, fit in fits.items():
        inside = np.array([row["form"] != "cell" for row in fit.rows])
        for target in ("contacts", "jamming", "carved"):
            for count in sorted({row["count"] for row in fit.rows}):
                chosen = np.array([row["target"] == target and row["count"] == count for row in fit.rows]) & inside
                if chosen.any():
                    found.append(_line(name, "shape left out", target, count, fit.held_out[chosen]))
        laws = [row for row in others if row["form"] != "cell" and (name == "E" or row["form"] not in STUBBY)]
        if laws:
            found.append(_line(name, "law left out", "all", None, relative_miss(laws, name, fit.coefficients)))
        curve = curves[name]
        for count in sorted({row["count"] for row in curve.rows}):
            chosen = np.array([row["count"] == count for row in curve.rows])
            found.append(_line(name, "shape left out, R̄S/V only", "contacts", count, curve.held_out[chosen]))
    return found


def _line(quantity: str, what: str, target: str, count: int | None, miss: Any) -> dict[str, Any]:
    return {"quantity": quantity, "what": what, "target": target, "count": count,
            "rms": float(np.sqrt(np.mean(miss**2))), "mean": float(np.mean(miss)),
            "largest": float(np.abs(miss).max()), "rows": len(miss)}  # fmt: skip


def _mean_std(name: str, values: Any) -> dict[str, float | None]:
    return {
        name: float(values.mean()) if len(values) else None,
        f"{name}_std": float(values.std(ddof=1)) if len(values) > 1 else None,
    }
