"""Messages about wrong names of arguments and attributes, which suggest the right name.

This module imports the standard library only, as `import bondem` does.
"""

import difflib
import sys
import warnings
from collections.abc import Collection, Iterable, Mapping

# Names of arguments in other programs and papers, with their possible names in bondem.
_SYNONYMS: dict[str, tuple[str, ...]] = {
    "height": ("length",), "h": ("length",), "l": ("length",), "diameter": ("radius",), "r": ("radius",),
    "radii": ("radius",), "centers": ("position",), "centres": ("position",), "positions": ("position",),
    "n": ("count",), "number": ("count",), "num": ("count",), "density": ("rho",), "rho": ("density",),
    "young": ("E",), "youngs_modulus": ("E",), "modulus": ("E",), "poisson": ("nu",), "poissons_ratio": ("nu",),
    "time": ("duration",), "t_end": ("duration",), "tmax": ("duration",), "steps": ("duration", "traverses"),
    "n_steps": ("duration",), "nsteps": ("duration",), "end_time": ("duration",), "total_time": ("duration",),
    "output": ("out",), "path": ("out",), "file": ("out", "path"), "filename": ("out", "path"), "bond": ("law",),
    "law": ("bond",), "bonds": ("pairs",), "dimensions": ("size",), "edges": ("size",), "k": ("count",),
    "cohesion": ("shear",), "phi": ("friction_angle",), "Gf": ("fracture_energy",), "G_f": ("fracture_energy",),
    "bc": ("boundary",), "boundary_conditions": ("boundary",), "loads": ("boundary",), "timestep": ("dt",),
    "gravity": ("boundary",), "criterion": ("failure",), "strength": ("failure", "tension"),
    "displacements": ("displacement",), "velocities": ("velocity",), "damage": ("integrity", "bond_integrity"),
}  # fmt: skip
# Least similarity of a misspelt name to a suggested one: objects have many members, and a wrong guess misleads.
_CLOSE = 0.75
# Functions for quantities that are no attributes of a run, a state or an equilibrium.
_OF_OBJECTS = {
    "stress": "bd.cell_stress(model, state) for cells, or bd.element_stress(model, state)",
    "stresses": "bd.cell_stress(model, state) for cells, or bd.element_stress(model, state)",
    "forces": "bd.bond_forces(model, state)", "fragments": "bd.fragments(lattice, state)",
    "cracks": "bd.cracks(lattice, state)", "save": "bd.write_vtkhdf, bd.save_particles or out= of a solver",
    "to_vtk": "bd.write_vtkhdf", "volume_fraction": "bd.fabric(lattice)", "broken": ".events",
    "broken_bonds": "run.events or state.bond_integrity",
    "to_csv": "bd.export('body.csv', lattice, state=state), or pandas.DataFrame({'time': events.time}).to_csv(file)",
    "run": "bd.solve_explicit(model, duration=...)", "solve": "bd.solve_static(model) or bd.solve_explicit",
}  # fmt: skip


def meant(name: str, known: Iterable[str]) -> str:
    """Suggest the known name nearest to a wrong one, as the end of a message: "; did you mean 'length'?", or ""."""
    if name.startswith("_"):  # tools ask every module for such names, and the search takes a millisecond
        return ""
    names = [one for one in known if not one.startswith("_")]
    by_case = {one.lower(): one for one in names}
    near: Collection[str] = [one for one in _SYNONYMS.get(name, ()) if one in names]
    near = near or difflib.get_close_matches(name, names, n=1)
    near = near or [by_case[one] for one in difflib.get_close_matches(name.lower(), by_case, n=1)]
    return f"; did you mean '{next(iter(near))}'?" if near else ""


def no_attribute(module: str, name: str, known: Iterable[str], instead: Mapping[str, str] | None = None) -> str:
    """Return the message for a name that a module does not have.

    Args:
        module: name of the module as users write it, such as "bd.materials".
        name: requested name.
        known: names of the module.
        instead: replacements of names of other packages.
    """
    other = (instead or {}).get(name)
    hint = f"; use {other}" if other else meant(name, known)
    return f"{module} has no attribute '{name}'{hint}" + ("" if hint else f"; dir({module}) lists its names")


def no_member(thing: object, name: str) -> str:
    """Return the message for a missing attribute, with a suggestion unless its name is private.

    The suggestion is the attribute of this name of a member, else a function for the quantity, else a similar name.
    """
    message = f"{type(thing).__name__} has no attribute '{name}'"
    if name.startswith("_"):
        return message
    fields = getattr(thing, "__dataclass_fields__", getattr(thing, "__dict__", {}))
    members = ((key, getattr(thing, "__dict__", {}).get(key)) for key in fields if not key.startswith("_"))
    inside = [(f".{key}", one) for key, one in members if type(one).__module__.startswith("bondem.")]
    same = [f"{path}.{name}" for path, member in inside if name in dir(member)]
    if name == "to_csv" and hasattr(thing, "to_pandas"):
        return f"{message}; use .to_pandas().to_csv(file)"
    if not same and name in _OF_OBJECTS:
        return f"{message}; use {_OF_OBJECTS[name]}"
    near = same or [
        f"{path}.{one}" if path else one for find in (_other_words, _misspelt)
        for path, member in (("", thing), *inside) for one in find(name, dir(member))
    ]  # fmt: skip
    return f"{message}; did you mean '{near[0]}'?" if near else message


def _other_words(name: str, names: Iterable[str]) -> list[str]:
    """Return the names in bondem of a term that other programs call `name`."""
    return [one for one in _SYNONYMS.get(name, ()) if one in names]


def _misspelt(name: str, names: Iterable[str]) -> list[str]:
    """Return a public name that differs by few letters, if there is one."""
    return difflib.get_close_matches(name, [one for one in names if not one.startswith("_")], n=1, cutoff=_CLOSE)


def users_line() -> int:
    """Return the `stacklevel` with which a warning of the caller names the line of the user outside the package."""
    level, frame = 1, sys._getframe(1)
    while frame is not None and is_internal(str(frame.f_globals.get("__name__"))):
        level, frame = level + 1, frame.f_back
    return level if frame is not None else 2


def warn_user(text: str, category: type[Warning]) -> None:
    """Give a warning at the line of the user outside the package."""
    warnings.warn(text, category, stacklevel=users_line())


def is_internal(module: str) -> bool:
    """Return True for modules of bondem, and of libraries whose frames lie between it and the user."""
    return module.partition(".")[0] in ("bondem", "contextlib", "functools", "numpy", "scipy")
