"""Pictures of objects from Python: `lattice.plot()`, `model.plot()`, `test.plot()` and `run.plot()`."""

import math
from collections.abc import Iterator
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
from bondem._drawing import Coloured, Plotted, Present
from bondem._types import ArrayLike, Floats
from bondem.boundary.conditions import Drive, Fix, Load
from bondem.boundary.loads import Absorbing, BodyForce, Pressure
from bondem.errors import InputError
from bondem.fracture.fragments import fragments
from bondem.geometry.rotations import turned_vectors
from bondem.geometry.surface import Surface
from bondem.io.atomic import require_writable, write_bytes
from bondem.labtests.cracking import CRACKED
from bondem.model.model import Model
from bondem.model.state import State
from bondem.report.column_curves import draw_columns
from bondem.report.crack_pictures import draw_elements, piece_colours
from bondem.report.numbers import with_unit
from bondem.report.overlays import SCALE, draw_arrow, draw_box, draw_walls
from bondem.report.piece_colours import piece_palette
from bondem.report.spheres import View
from bondem.report.strength_figures import reach_of
from bondem.report.style import BLUE, GREEN, ORANGE, PURPLE, SEQUENTIAL, SETTINGS, colour_bar
from bondem.report.surface_picture import draw_patches
from bondem.specimen.lattice import Lattice
from bondem.specimen.tessellation.polyhedra import Polyhedra

_PLAIN = "#d5dbe1"
_DOTS_PER_INCH, _PIXELS = 160, 900
_ENDINGS = (".png", ".pdf", ".svg")


class Drawing(Figure):
    """Figure that Jupyter displays, and that opens a window if a display is available."""

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
    """Draw a lattice, coloured by values, body or size; arguments and errors as for `Lattice.plot`."""
    eye, sides, bodies = _view("Lattice.plot", view), lattice.particles.envelope.bounds, len(lattice.names)
    with _figure("Lattice.plot", path, 1) as (figure, (ax,)):
        if values is None and bodies > 1:
            _body(ax, lattice, piece_palette(bodies)[lattice.body], eye)
        else:
            shown_as = lattice.elements.relative_size if values is None else _given(lattice, values)
            scale = Normalize(float(np.nanmin(shown_as)), float(np.nanmax(shown_as)))
            _body(ax, lattice, colormaps[SEQUENTIAL](scale(shown_as))[:, :3], eye)
            _bar(figure, ax, scale, "size over mean size [-]" if values is None else label)
        draw_box(ax, *sides, eye)
        scene, elements = f", {bodies} bodies" if bodies > 1 else "", lattice.elements
        ax.set_title(f"{len(lattice.particles)} {elements.name}, {len(lattice.pairs)} {elements.bond_name}{scene}")
    return figure


def _given(lattice: Lattice, values: ArrayLike) -> Floats:
    found = array("Lattice.plot", "values", values, wanted="one number per element")
    if found.shape != (len(lattice.particles),):
        raise InputError(f"Lattice.plot: values has shape {found.shape}; give ({len(lattice.particles)},)")
    return found


def draw_surface(surface: Surface, path: Any, *, view: tuple[float, float]) -> Drawing:
    """Draw a surface in a view and from the opposite side; arguments and errors as for `Surface.plot`."""
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
    """Draw a model with its conditions, or in the pose of a solution; arguments and errors as for `Model.plot`."""
    eye, sides, lattice = _view("Model.plot", view), model.lattice.particles.envelope.bounds, model.lattice
    state, moved, turned = _motion(model, solution)
    with _figure("Model.plot", path, 1) as (figure, (ax,)):
        if moved is None:
            colour, handles = _supports(model)
            _body(ax, lattice, colour, eye)
            ax.legend(handles=handles, loc="lower left", bbox_to_anchor=(0.0, 1.0), fontsize=8.5) if handles else None
            for condition in model.boundary:
                for start, along, tint in _arrows(lattice, condition):
                    draw_arrow(ax, start, along, *sides, eye, tint)
        else:
            _moved_body(figure, ax, lattice, moved, turned, reach, eye)
        draw_box(ax, *sides, eye)
        draw_walls(ax, model, state, *sides, eye)
        ax.autoscale_view()
    return figure


def draw_result(result: Plotted, path: Any, *, reach: float | None, view: tuple[float, float]) -> Drawing:
    """Draw the columns and the bodies of a result; arguments and errors as for `Plotted.plot`."""
    who = f"{type(result).__name__}.plot"
    eye, drawn, pictures = _view(who, view), result.drawn, result._pictures
    with _figure(who, path, bool(drawn) + len(pictures)) as (figure, axes):
        if drawn:
            draw_columns(axes[0], drawn, result._outer)
        for ax, picture in zip(axes[bool(drawn) :], pictures, strict=True):
            _draw_picture(figure, ax, picture, reach, eye)
            ax.autoscale_view()
    return figure


def _draw_picture(figure: Figure, ax: Axes, picture: Coloured | Present, reach: float | None, view: View) -> None:
    """Draw a body of a result: coloured by values, by its pieces if broken, or by displacement."""
    if isinstance(picture, Coloured):
        _coloured_body(figure, ax, picture, reach, view)
        return
    state = picture.state
    lower, upper = state.model.lattice.particles.envelope.bounds
    pieces = fragments(state.model.lattice, state, integrity=CRACKED)
    if len(pieces) > 1:
        _broken_body(ax, state, pieces, reach, view)
    else:
        _moved_body(figure, ax, state.model.lattice, state.displacement, state.orientation, reach, view)
    draw_box(ax, lower, upper, view)
    draw_walls(ax, state.model, state, lower, upper, view)


def _motion(model: Model, solution: Any) -> tuple[State | None, Floats | None, Floats | None]:
    """Return state, displacements (n, 3), and quaternions or rotation vectors of a solution; None for missing ones.

    Raises:
        InputError: The solution is not one of this model.
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
    """Return colours of the elements, (n, 3), by supports, drives and loads, and the legend of the colours."""
    colour = np.tile(to_rgb(_PLAIN), (len(model.lattice.particles), 1))
    handles: dict[str, Patch] = {}
    for condition in model.boundary:
        effect = _effect(condition)
        if effect is None:
            continue
        words, tint = effect
        colour[condition.region.select(model.lattice)] = to_rgb(tint)
        handles[words] = Patch(color=tint, label=words)
    return colour, list(handles.values())


def _effect(condition: Any) -> tuple[str, str] | None:
    """Return words for the effect of a condition, and its colour; None for conditions that act everywhere."""
    match condition:
        case Fix():
            held = ["xyz"[k - 3] for k in condition.components if k > 2]
            turns = f", rotation {' '.join(held)}" if held else ""
            moves = " ".join(condition.translation)
            return (f"fixed {moves}{turns}" if moves else f"fixed{turns[1:]}"), BLUE
        case Drive():
            names = [("v" if rate else "") + "xyz"[k % 3] + ("" if k < 3 else " (rotation)")
                     for k, _, rate in condition.motion]  # fmt: skip
            return f"driven {', '.join(names)}", GREEN
        case Load():
            return f"load {np.linalg.norm(condition.force):.3g} N", ORANGE
        case Pressure():
            least, most = (condition.pressure * pick(condition.schedule.table[1]) for pick in (min, max))
            over = "" if least == most else f"{with_unit(least, 'Pa', 3)} … "
            return f"pressure {over}{with_unit(most, 'Pa', 3)}", ORANGE
        case Absorbing():
            return "absorbing", PURPLE
    return None


def _arrows(lattice: Lattice, condition: Any) -> list[tuple[Floats, Floats, str]]:
    """Return foot [m], direction and colour of each arrow of a condition."""
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
    """Draw a displaced body, coloured by the displacements of its elements."""
    far = np.linalg.norm(moved, axis=1)
    _coloured_body(figure, ax, Coloured(lattice, far, "displacement [m]", moved, turned), reach, view)


def _coloured_body(figure: Figure, ax: Axes, body: Coloured, reach: float | None, view: View) -> None:
    """Draw a displaced body, coloured by values of its elements."""
    reach = _reach(body.lattice, body.moved, reach)
    scale = Normalize(0.0, float(body.values.max()) or 1.0)
    colour = colormaps[SEQUENTIAL](scale(body.values))[:, :3]
    _body(ax, body.lattice, colour, view, moved=body.moved, turned=body.turned, reach=reach)
    _bar(figure, ax, scale, body.label)
    ax.set_title(body.title.format(reach))


def _broken_body(ax: Axes, state: State, pieces: Any, reach: float | None, view: View) -> None:
    """Draw a displaced, broken body, each piece in its own colour."""
    lattice, moved = state.model.lattice, state.displacement
    reach = _reach(lattice, moved, reach)
    colour = piece_colours(pieces)
    _body(ax, lattice, colour, view, moved=moved, turned=state.orientation, reach=reach, piece=pieces.label)
    cracked = "" if len(fragments(lattice, state)) == len(pieces) else f" (integrity ≤ {CRACKED:g})"
    ax.set_title(f"{len(pieces)} pieces{cracked}, motion × {reach:.3g}")


def _reach(lattice: Lattice, moved: Floats, reach: float | None) -> float:
    if reach is None:
        return reach_of(lattice, moved)
    return number("plot", "reach", reach, least=0.0, advice="a factor on displacements, zero or more")


def _body(
    ax: Axes, lattice: Lattice, colour: Floats, view: View, *, moved: Floats | None = None,
    turned: Floats | None = None, reach: float = 1.0, piece: np.ndarray | None = None,
) -> None:  # fmt: skip
    """Draw the elements of a body, with displacements magnified by `reach`."""
    shift = np.zeros_like(lattice.centre) if moved is None else reach * moved

    def corners(solid: Polyhedra) -> Floats:
        owner = np.repeat(solid.cell, np.diff(solid.start))
        arm = solid.vertex - lattice.centre[owner]
        if turned is not None and turned.shape[1] == 4:
            return shift[owner] + turned_vectors(turned[owner], arm) - arm
        # rotation vectors are small, and magnified like displacements
        return shift[owner] if turned is None else shift[owner] + reach * np.cross(turned[owner], arm)

    draw_elements(ax, lattice, colour, shift, corners, view=view, piece=piece, scale=SCALE)


def _bar(figure: Figure, ax: Axes, scale: Normalize, label: str) -> None:
    colour_bar(figure, ScalarMappable(scale, SEQUENTIAL), label, ax=ax, shrink=0.7, aspect=28, pad=0.03)


def _view(who: str, view: Any) -> View:
    """Convert azimuth and elevation in degrees to a direction of view.

    Raises:
        InputError: not two angles, or an elevation beyond ± 90 degrees.
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
    """Yield a figure and its panels in a row; unless `path` is None, write the figure at the end of the block."""
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
            stream = BytesIO()  # matplotlib leaves files open that it cannot write
            figure.savefig(stream, format=file.suffix[1:].lower())
            write_bytes(file, stream.getbuffer())
