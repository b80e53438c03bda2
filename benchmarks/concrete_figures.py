"""Figures of the laboratory's tests of one concrete: the broken specimen, and the curve of all seeds."""

from pathlib import Path


def draw_all(rows: Path, out: Path) -> None:
    """Draw what is kept."""
    raise NotImplementedError(f"{rows}, {out}")
