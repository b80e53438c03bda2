"""Wrong names: messages that suggest the right one, for arguments and attributes of modules and objects.

It imports nothing but the standard library, as `import bondem` does.
"""

import difflib
import sys
from collections.abc import Collection, Iterable, Mapping

# What other programs and papers call an argument, and what it may be called here.
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
# What is evaluated by a function, and no attribute of a run, a state or an equilibrium.
_OF_OBJECTS = {
    "stress": "bd.cell_stress(model, run) for cells, or bd.element_stress(model, run)",
    "stresses": "bd.cell_stress(model, run) for cells, or bd.element_stress(model, run)",
    "forces": "bd.bond_forces(model, run)", "fragments": "bd.fragments(lattice, state)",
    "cracks": "bd.cracks(model, state)", "save": "bd.write_vtkhdf, bd.save_particles or out= of a solver",
    "to_vtk": "bd.write_vtkhdf",
}  # fmt: skip


def meant(name: str, known: Iterable[str]) -> str:
    """Return the known name nearest to a wrong one, as the end of a message: "; did you mean 'length'?", or ""."""
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
        module: name of the module as users write it, "bd.materials".
        name: requested name.
        known: names of the module.
        instead: replacements of names of other packages.
    """
    other = (instead or {}).get(name)
    hint = f"; use {other}" if other else meant(name, known)
    return f"{module} has no attribute '{name}'{hint}" + ("" if hint else f"; dir({module}) lists its names")


def no_member(thing: object, name: str) -> str:
    """Return the message for an attribute that an object does not have: the attribute of a member, or a near name."""
    owner = type(thing).__name__
    inside = [
        f"{key}.{name}" for key, member in vars(thing).items()
        if not key.startswith("_") and type(member).__module__.startswith("bondem.") and hasattr(type(member), name)
    ] if hasattr(thing, "__dict__") and not name.startswith("_") else []  # fmt: skip
    elsewhere = f"; use {_OF_OBJECTS[name]}" if name in _OF_OBJECTS else ""
    hint = f"; did you mean '.{inside[0]}'?" if inside else elsewhere or meant(name, dir(thing))
    return f"{owner} has no attribute '{name}'{hint}"


def users_line() -> int:
    """Return the `stacklevel` with which a warning of the caller names the line of the user outside the package."""
    level, frame = 1, sys._getframe(1)
    while frame is not None and is_internal(str(frame.f_globals.get("__name__"))):
        level, frame = level + 1, frame.f_back
    return level if frame is not None else 2


def is_internal(module: str) -> bool:
    """Return True if code belongs to the package, or to what it puts between itself and its users."""
    return module.partition(".")[0] in ("bondem", "contextlib", "functools", "numpy", "scipy")
