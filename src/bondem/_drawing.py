"""The way from objects to their pictures: all drawing is in `bondem.report`, which is loaded at the first picture."""

import importlib
from pathlib import Path
from typing import Any


class Plotted:
    """A result that can be drawn."""

    def plot(
        self, path: str | Path | None = None, *, reach: float | None = None, view: tuple[float, float] = (28.0, 24.0)
    ) -> Any:
        """Draw the result: its curve or energies, and the specimen where it is, with walls and coordinates.

        Args:
            path: PNG, PDF or SVG to write; nothing is written when None.
            reach: factor on displacements [-]; chosen such that they are seen unless given.
            view: azimuth and elevation of the camera [degree].

        Returns:
            A `matplotlib.figure.Figure`, which Jupyter shows; its `show()` opens a window.

        Raises:
            InputError: a file that cannot be written, or a view that is not two angles.
        """
        return draw("draw_result", self, path, reach=reach, view=view)


def draw(drawing: str, *what: Any, **options: Any) -> Any:
    """Call a function of `bondem.report.plots`."""
    return getattr(importlib.import_module("bondem.report.plots"), drawing)(*what, **options)
