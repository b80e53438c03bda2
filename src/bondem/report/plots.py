"""Pictures of objects from Python: `lattice.plot()`, `model.plot()`, `test.plot()` and `run.plot()`."""

import math
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from io import BytesIO
from typing import Any

import matplotlib
import numpy as np
from matplotlib import colormaps, pyplot, rc_context
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize, to_rgb
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from bondem._checks import array, number, place, shown
from bondem._types import ArrayLike, Floats
from bondem.boundary.conditions import Drive, Fix, Load
from bondem.boundary.loads import Absorbing, BodyForce, Pressure
from bondem.dynamics.history import History
from bondem.dynamics.plan import ExplicitResult
from bondem.errors import InputError
from bondem.fracture.fragments import fragments
from bondem.geometry.rotations import turned_vectors
from bondem.geometry.surface import Surface
from bondem.io.atomic import replacing, require_writable
from bondem.labtests.cracking import HALF
from bondem.labtests.outcome import Outcome
from bondem.labtests.vibration import FreeVibration
from bondem.model.model import Model
from bondem.model.state import State
from bondem.report.cell_pictures import draw_cells
from bondem.report.overlays import SCALE, draw_arrow, draw_box, draw_walls
from bondem.report.piece_colours import piece_palette
from bondem.report.spheres import View, render
from bondem.report.strength_figures import reach_of
from bondem.report.style import BLUE, GREEN, GREY, ORANGE, PURPLE, SEQUENTIAL, SETTINGS
from bondem.report.surface_picture import draw_patches
from bondem.specimen.lattice import Lattice
from bondem.specimen.tessellation.polyhedra import polyhedra

_PLAIN = "#d5dbe1"
_DOTS_PER_INCH, _PIXELS = 160, 900
_ENDINGS = (".png", ".pdf", ".svg")


class Drawing(Figure):
    """A figure that Jupyter shows, and that opens a window where there is a display."""

    def _repr_png_(self) -> bytes:
        stream = BytesIO()
        self.savefig(stream, format="png", dpi=_DOTS_PER_INCH)
        return stream.getvalue()

    def show(self, warn: bool = True) -> None:
        """Open a window.

        Raises:
            InputError: there is no display.
        """
        if matplotlib.get_backend().lower() == "agg":
            raise InputError("plot: no display is available to open a window; give plot a path, such as 'model.png'")
        manager = pyplot.figure().canvas.manager
        assert manager is not None
        manager.canvas.figure = self
        self.set_canvas(manager.canvas)
        pyplot.show()


def draw_lattice(
    lattice: Lattice, path: Any, *, values: ArrayLike | None, label: str, view: tuple[float, float]
) -> Drawing:  # fmt: skip
    """Draw a lattice for `Lattice.plot`."""
    eye, sides = _view("Lattice.plot", view), _bounds(lattice)
    if values is None:
        cells = lattice.cells
        shown_as = lattice.particles.radius / lattice.particles.mean_radius
        if cells is not None:
            shown_as = np.cbrt(cells.volume / cells.volume.mean())
        label = "size over mean size [-]"
    else:
        shown_as = array("Lattice.plot", "values", values, wanted="one number per element")
        if shown_as.shape != (len(lattice.particles),):
            raise InputError(f"Lattice.plot: values has shape {shown_as.shape}; give ({len(lattice.particles)},)")
    with _figure("Lattice.plot", path, 1) as (figure, (ax,)):
        scale = Normalize(float(np.nanmin(shown_as)), float(np.nanmax(shown_as)))
        _body(ax, lattice, colormaps[SEQUENTIAL](scale(shown_as))[:, :3], eye)
        draw_box(ax, *sides, eye)
        _bar(figure, ax, scale, label)
        cell = "elements" if lattice.cells is None else "cells"
        bonds = "bonds" if lattice.cells is None else "facets"
        ax.set_title(f"{len(lattice.particles)} {cell}, {len(lattice.pairs)} {bonds}")
    return figure


def draw_surface(surface: Surface, path: Any, *, view: tuple[float, float]) -> Drawing:
    """Draw a surface for `Surface.plot`."""
    eye = _view("Surface.plot", view)
    opposite = View(azimuth=eye.azimuth + math.pi, elevation=-eye.elevation)
    with _figure("Surface.plot", path, 2) as (figure, axes):
        for ax, here, words in zip(axes, (eye, opposite), ("in this view", "from the opposite side"), strict=True):
            ax.set_title(f"{draw_patches(ax, surface, here)} {words}")
            draw_box(ax, *surface.bounds, here)
    return figure


def draw_model(
    model: Model, path: Any, *, solution: Any, reach: float | None, view: tuple[float, float]
) -> Drawing:  # fmt: skip
    """Draw a model for `Model.plot`."""
    eye, sides, lattice = _view("Model.plot", view), _bounds(model.lattice), model.lattice
    state, moved, turned = _motion(model, solution)
    with _figure("Model.plot", path, 1) as (figure, (ax,)):
        if moved is None:
            colour, handles = _supports(model)
            _body(ax, lattice, colour, eye)
            ax.legend(handles=handles, loc="upper left", bbox_to_anchor=(0.0, 0.0), fontsize=8.5) if handles else None
            for condition in model.boundary:
                for start, along, tint in _arrows(lattice, condition):
                    draw_arrow(ax, start, along, *sides, eye, tint)
        else:
            _moved_body(figure, ax, lattice, moved, turned, reach, eye)
        draw_box(ax, *sides, eye)
        draw_walls(ax, model, state, *sides, eye)
        ax.autoscale_view()
    return figure


def draw_result(result: Any, path: Any, *, reach: float | None, view: tuple[float, float]) -> Drawing:
    """Draw a result for `Plotted.plot`."""
    who = f"{type(result).__name__}.plot"
    eye, curves, state = _view(who, view), _curves_of(result), getattr(result, "state", None)
    with _figure(who, path, 1 + (state is not None)) as (figure, axes):
        _draw_curves(axes[0], *curves)
        if state is not None and isinstance(state.model, Model):
            model, ax = state.model, axes[1]
            sides = _bounds(model.lattice)
            pieces = fragments(model.lattice, state, integrity=HALF)
            if len(pieces) > 1:
                _broken_body(ax, state, pieces, reach, eye)
            else:
                _moved_body(figure, ax, model.lattice, state.displacement, state.orientation, reach, eye)
            draw_box(ax, *sides, eye)
            draw_walls(ax, model, state, *sides, eye)
            ax.autoscale_view()
    return figure


def _curves_of(result: Any) -> tuple[list[tuple[str, Floats, Floats]], str, str]:
    """Named curves of a result, and what their axes are called."""
    if isinstance(result, ExplicitResult):
        return _energies(result.history)
    if isinstance(result, FreeVibration):
        kinds = [(kind, 1e6 * result.time, values / np.abs(values).max()) for kind, values in result.signal.items()]
        return kinds, "time [µs]", "motion of the free end / largest [-]"
    if isinstance(result, Outcome):
        return _outcome(result)
    if hasattr(result, "load"):  # a path of equilibria
        return [("", 1e3 * result.displacement, 1e-3 * result.load)], "displacement [mm]", "load [kN]"
    if hasattr(result, "velocity") and hasattr(result, "bar"):
        return [("", 1e6 * result.time, result.velocity)], "time [µs]", "velocity of the free end [m/s]"
    if hasattr(result, "force") and hasattr(result, "time"):
        return [("", 1e6 * result.time, 1e-3 * result.force)], "time [µs]", "force on the plane [kN]"
    curve = result.curve
    return [("", 1e3 * curve[:, 0], 1e-6 * curve[:, 1])], "strain [10$^{-3}$]", "stress [MPa]"


def _energies(history: History) -> tuple[list[tuple[str, Floats, Floats]], str, str]:
    """The parts of the ledger that are not zero, in time."""
    energy, time = history.energy, 1e6 * history.time
    kinetic = energy["translation"] + energy["rotation"]
    elastic = sum(energy[name] for name in ("normal", "shear", "bending", "twisting", "contact"))
    parts: Mapping[str, Any] = {
        "work": energy["work"], "kinetic": kinetic, "elastic": elastic, "fracture": energy["fracture"],
        "plastic": energy["plastic"], "friction": energy["friction"], "damping": energy["loss"],
    }  # fmt: skip
    known = [(name, time, np.asarray(values)) for name, values in parts.items() if np.any(values)]
    return known, "time [µs]", "energy [J]"


def _outcome(result: Outcome) -> tuple[list[tuple[str, Floats, Floats]], str, str]:
    """The curve of an outcome of a test.

    Raises:
        InputError: it has none.
    """
    curves = result.curves
    if "strain" in curves:
        return [(result.name, 1e3 * curves["strain"], 1e-6 * curves["stress"])], "strain [10$^{-3}$]", "stress [MPa]"
    if "far" in curves:
        both = [(name, 1e6 * curves["time"], curves[name]) for name in ("near", "far")]
        return both, "time [µs]", "mean velocity of a face [m/s]"
    if "signal" in curves:
        return [(result.name, 1e6 * curves["time"], curves["signal"])], "time [µs]", "mean motion of the free end"
    if "profile" in curves:
        return [(result.name, 1e3 * curves["x"], curves["profile"])], "x [mm]", "motion of the section [m or rad]"
    raise InputError(f"Outcome.plot: {result.name} has no curve; draw another test")


def _draw_curves(ax: Axes, curves: Sequence[tuple[str, Floats, Floats]], across: str, up: str) -> None:
    colours = (BLUE, ORANGE, GREEN, PURPLE, GREY, "#1f2933", "#b5a400")
    for (name, x, y), colour in zip(curves, colours, strict=False):
        ax.plot(x, y, color=colour, label=name or None)
    ax.set(xlabel=across, ylabel=up)
    if any(name for name, _, _ in curves):
        ax.legend(loc="best")


def _motion(model: Model, solution: Any) -> tuple[State | None, Floats | None, Floats | None]:
    """State, displacements, and quaternions or rotation vectors of a solution.

    Raises:
        InputError: it is no solution of this model.
    """
    if solution is None:
        return None, None, None
    state = solution if isinstance(solution, State) else getattr(solution, "state", None)
    given = state if state is not None else solution
    moved = getattr(given, "displacement", None)
    if not isinstance(moved, np.ndarray) or moved.shape != (len(model.lattice.particles), 3):
        raise InputError(
            f"Model.plot: solution = {shown(solution)} has no displacement of"
            f" {len(model.lattice.particles)} elements; give a state, a run or an equilibrium of this model"
        )
    turned = getattr(given, "orientation", None)
    return state, moved, turned if turned is not None else getattr(given, "rotation", None)


def _supports(model: Model) -> tuple[Floats, list[Patch]]:
    """Colours of the elements by what holds, drives or loads them, and what they mean."""
    colour = np.tile(to_rgb(_PLAIN), (len(model.lattice.particles), 1))
    handles: dict[str, Patch] = {}
    for condition in model.boundary:
        told = _told(condition)
        if told is None:
            continue
        words, tint = told
        colour[condition.region.select(model.lattice)] = to_rgb(tint)
        handles[words] = Patch(color=tint, label=words)
    return colour, list(handles.values())


def _told(condition: Any) -> tuple[str, str] | None:
    """What a condition does, in words, and its colour; None of those that act everywhere."""
    match condition:
        case Fix():
            turns = f", rotation {' '.join(condition.rotation)}" if condition.rotation else ""
            moves = " ".join(condition.translation)
            return (f"fixed {moves}{turns}" if moves else f"fixed{turns[1:]}"), BLUE
        case Drive():
            names = [("v" if rate else "") + "xyz"[k % 3] + ("" if k < 3 else " (rotation)")
                     for k, _, rate in condition.motion]  # fmt: skip
            return f"driven {', '.join(names)}", GREEN
        case Load():
            return f"load {np.linalg.norm(condition.force):.3g} N", ORANGE
        case Pressure():
            return f"pressure {condition.pressure:.3g} Pa", ORANGE
        case Absorbing():
            return "absorbing", PURPLE
    return None


def _arrows(lattice: Lattice, condition: Any) -> list[tuple[Floats, Floats, str]]:
    """Foot, direction and colour of the arrows of a condition."""
    match condition:
        case Load() if any(condition.force):
            return [(condition.region.anchor(lattice), np.array(condition.force), ORANGE)]
        case Drive():
            along = np.zeros(3)
            for k, schedule, _ in condition.motion:
                if k < 3:
                    along[k] = schedule.table[1][-1]
            return [(condition.region.anchor(lattice), along, GREEN)] if along.any() else []
        case BodyForce() if not callable(condition.acceleration):
            along = np.asarray(condition.acceleration, dtype=float)
            return [(lattice.centre.mean(axis=0), along, PURPLE)] if along.shape == (3,) and along.any() else []
    return []


def _moved_body(
    figure: Figure, ax: Axes, lattice: Lattice, moved: Floats, turned: Floats | None, reach: float | None, view: View
) -> None:  # fmt: skip
    """Draw a body where it is, coloured by how far its elements have moved."""
    far = np.linalg.norm(moved, axis=1)
    reach = _reach(lattice, moved, reach)
    scale = Normalize(0.0, float(far.max()) or 1.0)
    _body(ax, lattice, colormaps[SEQUENTIAL](scale(far))[:, :3], view, moved=moved, turned=turned, reach=reach)
    _bar(figure, ax, scale, "displacement [m]")
    ax.set_title(f"motion × {reach:.3g}")


def _broken_body(ax: Axes, state: State, pieces: Any, reach: float | None, view: View) -> None:
    """Draw a broken body, each piece in a colour of its own."""
    lattice, moved = state.model.lattice, state.displacement
    reach = _reach(lattice, moved, reach)
    colour = piece_palette(len(pieces))[pieces.label]
    _body(ax, lattice, colour, view, moved=moved, turned=state.orientation, reach=reach, piece=pieces.label)
    ax.set_title(f"{len(pieces)} pieces, motion × {reach:.3g}")


def _reach(lattice: Lattice, moved: Floats, reach: float | None) -> float:
    if reach is None:
        return reach_of(lattice, moved)
    return number("plot", "reach", reach, least=0.0, advice="a factor on displacements, zero or more")


def _body(
    ax: Axes, lattice: Lattice, colour: Floats, view: View, *, moved: Floats | None = None,
    turned: Floats | None = None, reach: float = 1.0, piece: np.ndarray | None = None,
) -> None:  # fmt: skip
    """Draw cells as polyhedra, or elements as spheres."""
    if lattice.cells is not None:
        solid = polyhedra(lattice)
        owner = np.repeat(solid.cell, np.diff(solid.start))
        shift = None
        if moved is not None:
            arm = solid.vertex - lattice.centre[owner]
            shift = reach * moved[owner]
            if turned is not None and turned.shape[1] == 4:
                shift = shift + turned_vectors(turned[owner], arm) - arm
            elif turned is not None:
                shift = shift + reach * np.cross(turned[owner], arm)  # small rotations grow with displacements
        draw_cells(ax, solid, colour, view=view, moved=shift, piece=piece, scale=SCALE)
        return
    position, radius = lattice.particles.position, lattice.particles.radius
    centre = position if moved is None else position + reach * moved
    image = render(centre, radius, colour, view=view, width=_PIXELS)
    placed, margin = centre @ view.axes.T, 1.02 * radius.max()
    low, high = SCALE * (placed[:, :2].min(axis=0) - margin), SCALE * (placed[:, :2].max(axis=0) + margin)
    ax.imshow(image, extent=(low[0], high[0], low[1], high[1]), interpolation="lanczos", zorder=1)
    ax.axis("off")


def _bounds(lattice: Lattice) -> tuple[Floats, Floats]:
    lower, upper = lattice.particles.envelope.bounds
    return np.asarray(lower), np.asarray(upper)


def _bar(figure: Figure, ax: Axes, scale: Normalize, label: str) -> None:
    bar = figure.colorbar(ScalarMappable(scale, SEQUENTIAL), ax=ax, shrink=0.7, aspect=28, pad=0.03)
    bar.set_label(label)
    bar.outline.set_visible(False)


def _view(who: str, view: Any) -> View:
    """A camera from azimuth and elevation in degrees.

    Raises:
        InputError: no two angles.
    """
    try:
        azimuth, elevation = (float(angle) for angle in view)
    except (TypeError, ValueError):
        azimuth = elevation = math.nan
    if not (math.isfinite(azimuth) and abs(elevation) <= 90.0):
        raise InputError(f"{who}: view = {shown(view)}; give azimuth and elevation in degrees, such as (28, 24)")
    return View(math.radians(azimuth), math.radians(elevation))


@contextmanager
def _figure(who: str, path: Any, count: int) -> Iterator[tuple[Drawing, list[Axes]]]:
    """A figure of one or two panels, written to a file after the block where there is one."""
    file = None if path is None else place(f"{who}: path", path)
    if file is not None:
        require_writable(file, "picture")
        if file.suffix.lower() not in _ENDINGS:
            raise InputError(f"{who}: path = '{file}'; give a name that ends in {', '.join(_ENDINGS)}")
    with rc_context(SETTINGS):
        figure = Drawing(figsize=(6.4 if count == 1 else 10.4, 4.8), dpi=_DOTS_PER_INCH, layout="constrained")
        axes = figure.subplots(1, count, squeeze=False)
        yield figure, list(axes[0])
        if file is not None:
            with replacing(file) as aside:
                figure.savefig(aside)
