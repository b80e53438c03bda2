"""Errors of bodies of cells under uniform stress: moduli, tractions of every facet, stress of every cell.

Uniform stress is an exact solution of elasticity in every homogeneous body, so that every error is one of the cells.
Packings of spheres (κ = 25 %, seeds 21 to 25, at E = 1) are cut into cells:

    bar, cylinder    pulled between smooth platens
    ball, bracket    uniform pressure over the whole surface; the bracket is examples/bracket.stl
    confined         cube between six smooth platens, three of which move alike
    oedometer        the same with one platen that moves
    sheared          cube under the tractions of a pure shear stress
    turned           cube with edges in no axis of the stress, under the tractions of uniaxial tension
    periodic         periodic cell under six unit strains

The largest errors are compared for three sets of shares of the facets in the dilatation of their cells:

    balanced         those of a tessellation
    inverse          A w M⁻¹n, of run files before schema 9
    plain            A w n, of Mka3D (Mariotti 2007)

Solutions are iterated to a residual of 1e-12 of the load. `solver` is the largest error of `bd.solve_static`, which
ends at 1e-10, with balanced shares.
"""

import warnings
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from types import SimpleNamespace
from typing import Any

import numpy as np

import bondem as bd
from bondem.errors import BondemError
from bondem.interactions.cells.cell_strain import CellStrain
from bondem.io.older_bodies import with_corrected_normals
from bondem.labtests.gauge_length import AffineField, at_generators
from bondem.observables.cell_forces import CellForces
from bondem.observables.surface_displacement import surface_displacement
from bondem.statics.linear import Iteration, System
from validation.frame.record import Record
from validation.frame.sources import REPOSITORY

NU = (-0.3, 0.0, 0.2, 0.4, 0.49, 0.499, 0.4999)
LAWS = ("balanced", "inverse", "plain")
#: Strain of driven bodies and stress of loaded ones, over E [-].
SIZE = 1e-3
#: Largest error allowed with balanced shares, which are stored in single precision [-].
TARGET = 1e-6
#: Residual over load at which iterations end [-].
RESIDUAL = 1e-12
#: Errors other than those of moduli.
PLACES = ("traction", "stress")
Conditions = Sequence[bd.Fix | bd.Drive | bd.Load | bd.Pressure]


@dataclass(frozen=True, eq=False)
class Case:
    """A body under uniform stress.

    Attributes:
        shape: shape to pack and to cut into cells.
        conditions: boundary conditions of a body.
        stress: stress of a law under these conditions [Pa], (3, 3).
        moduli: names of the errors of moduli that the case has.
    """

    shape: bd.Shape
    conditions: Callable[[bd.Lattice], Conditions]
    stress: Callable[[bd.CellBond], np.ndarray]
    moduli: tuple[str, ...]


def pulled(body: bd.Lattice) -> Conditions:
    """Smooth platens at both ends; one cell in the middle keeps the body from moving rigidly."""
    lower, upper = body.particles.envelope.bounds
    middle = int(np.linalg.norm(body.centre - 0.5 * (lower + upper), axis=1).argmin())
    return [
        bd.Fix(bd.Face("x_min"), translation="x", rotation=""),
        bd.Drive(bd.Face("x_max"), x=SIZE * body.particles.envelope.extent),
        bd.Fix(bd.Index([middle]), translation="yz", rotation="x"),
    ]


def pressed(body: bd.Lattice) -> Conditions:
    """Uniform pressure on every face."""
    return [bd.Pressure(bd.Face(face), SIZE) for face in body.particles.envelope.faces]


def confined(driven: str) -> Callable[[bd.Lattice], Conditions]:
    """Six smooth platens; those at the far ends of the axes `driven` move."""

    def conditions(body: bd.Lattice) -> Conditions:
        still = [f"{a}_min" for a in "xyz"] + [f"{a}_max" for a in "xyz" if a not in driven]
        fixed = [bd.Fix(bd.Face(face), translation=face[0], rotation="") for face in still]
        return [*fixed, *(bd.Drive(bd.Face(f"{a}_max"), **{a: SIZE}) for a in driven)]

    return conditions


def loaded(stress: np.ndarray) -> Callable[[bd.Lattice], Conditions]:
    """Tractions σ·n of a stress [Pa], (3, 3), on every face of a box."""

    def conditions(body: bd.Lattice) -> Conditions:
        assert body.cells is not None
        free = body.cells.free
        area = free.area[:, None] * free.normal
        forces = {face: area[body.on_face(face)].sum(axis=0) @ stress for face in body.particles.envelope.faces}
        return [bd.Load(bd.Face(face), force=tuple(force)) for face, force in forces.items()]

    return conditions


CUBE = bd.Box((1.0, 1.0, 1.0))
TENSION = SIZE * np.diag([1.0, 0.0, 0.0])
SHEAR = SIZE * np.array([[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 0.0]])
PRESSURE = -SIZE * np.eye(3)
BRACKET = bd.Surface(REPOSITORY / "examples" / "bracket.stl", unit="mm")


def bulk(law: bd.CellBond) -> np.ndarray:
    return SIZE * (3.0 * law.lame + 2.0 * law.G) * np.eye(3)


def one_way(law: bd.CellBond) -> np.ndarray:
    return SIZE * (law.lame * np.eye(3) + np.diag([2.0 * law.G, 0.0, 0.0]))


CASES = {
    "bar": Case(bd.Box((4.0, 1.0, 1.0)), pulled, lambda _: TENSION, ("E", "nu")),
    "cylinder": Case(bd.Cylinder(radius=0.5, length=3.0), pulled, lambda _: TENSION, ("E", "nu")),
    "ball": Case(bd.Ball(0.5), pressed, lambda _: PRESSURE, ("volume",)),
    "bracket": Case(BRACKET, pressed, lambda _: PRESSURE, ("volume",)),
    "confined": Case(CUBE, confined("xyz"), bulk, ("K",)),
    "oedometer": Case(CUBE, confined("x"), one_way, ("M",)),
    "sheared": Case(CUBE, loaded(SHEAR), lambda _: SHEAR, ("strain",)),
    "turned": Case(CUBE.rotated("z", 0.5).rotated("x", 0.3), loaded(TENSION), lambda _: TENSION, ("strain",)),
}
PERIODIC = "periodic"


def bodies_of(body: bd.Lattice, conditions: Conditions) -> dict[str, bd.Lattice]:
    """Return the body with each set of shares."""
    facets = body.facets
    assert facets is not None
    vector = facets.area[:, None] * facets.normal
    shares = {f"share_{side}": (getattr(facets, f"depth_{side}") / facets.span)[:, None] * vector for side in "ij"}
    plain = bd.Lattice(body.particles, body.pairs, facets=replace(facets, **shares), cells=body.cells)
    return dict(zip(LAWS, (body, with_corrected_normals(body, conditions), plain), strict=True))


def equilibrium(model: bd.Model) -> SimpleNamespace:
    """Return displacements and rotations [m, rad] in the equilibrium of a model to a residual of `RESIDUAL`."""
    system, n = System.of(model), len(model.layout.order)
    motion = model.constraints.final_motion(n).ravel()
    strained = model.interaction.strain_load(model.constraints.final_strain(), model.pressed)
    load = (model.constraints.final_load(n) + strained).ravel()
    change, _ = Iteration(system).solve(load - system.matrix @ motion, rtol=RESIDUAL)
    values = (motion + change).reshape(n, 6)[model.layout.rank]
    return SimpleNamespace(displacement=values[:, :3], rotation=values[:, 3:])


def errors(model: bd.Model, motion: Any, case: Case, law: bd.CellBond) -> dict[str, float]:
    """Return the errors of moduli over their values, of ν, and of tractions and stresses over the largest stress.

    Of tractions and of components of stress it is the largest.
    """
    body, stress = model.lattice, case.stress(law)
    assert body.facets is not None
    scale, area = np.abs(stress).max(), body.facets.area
    forces = CellForces.of(model, motion)
    traction = np.linalg.norm(forces.force / area[:, None] - body.facets.normal @ stress, axis=1) / scale
    cell = np.abs(bd.cell_stress(model, motion) - stress) / scale
    found = {name: moduli_error(name, model, motion, forces, stress, law) for name in case.moduli}
    return found | {"traction": float(traction.max()), "stress": float(cell.max())}


def moduli_error(
    name: str, model: bd.Model, motion: Any, forces: CellForces, stress: np.ndarray, law: bd.CellBond
) -> float:
    """Return the error of the modulus of a name."""
    body, strain = model.lattice, strain_of(model.lattice, motion)
    exact = ((1.0 + law.nu) * stress - law.nu * np.trace(stress) * np.eye(3)) / law.E
    match name:
        case "strain":
            return float(np.abs(strain - exact).max() / np.abs(exact).max())
        case "nu":
            return float(-0.5 * (strain[1, 1] + strain[2, 2]) / strain[0, 0] - law.nu)
        case "volume":
            assert body.cells is not None
            free = body.cells.free
            traction = forces.load / free.area[:, None]
            moved = surface_displacement(model, motion.displacement, motion.rotation, traction=traction)
            swelling = (free.area[:, None] * free.normal * moved).sum() / body.cells.volume.sum()
            return float(swelling / np.trace(exact) - 1.0)
    supports = model.cell_constants.supports
    normal = (forces.wall * supports.normal).sum(axis=1)
    ends = np.abs(supports.normal[:, 0]) > 0.5 if name in "EM" else np.ones(len(normal), dtype=bool)
    mean = normal[ends].sum() / supports.area[ends].sum()
    return float(mean / (np.trace(stress) / 3.0 if name == "K" else stress[0, 0]) - 1.0)


def strain_of(body: bd.Lattice, motion: Any) -> np.ndarray:
    """Return the strain of the affine field closest to the motion of the tessellation's centres [-], (3, 3)."""
    return AffineField.fit(*at_generators(body, motion.displacement, motion.rotation)).strain


def periodic_errors(body: bd.Lattice, law: bd.CellBond) -> dict[str, float]:
    """Return the errors of E, ν and the stiffness matrix of a periodic cell, and of its tractions and dilatations.

    The error of the matrix is over its largest entry. Tractions and λ θ of cells are those of a unit strain along x,
    over the largest stress.
    """
    found, model = bd.bulk_moduli(body, law), bd.Model(body, law, 1.0)
    exact = law.lame * np.pad(np.ones((3, 3)), (0, 3)) + law.G * np.diag([2.0, 2.0, 2.0, 1.0, 1.0, 1.0])
    assert body.facets is not None
    axis, motion, area = np.array([1.0, 0.0, 0.0]), found.motions[0], body.facets.area
    slip, constants = body.branch[:, :1] * axis, model.cell_constants
    strain = CellStrain.of(body, constants, motion[:, :3], motion[:, 3:], slip=slip)
    force = body.facets.normal * exact[0, :3] - strain.forces(body, constants) / area[:, None]
    traction = np.linalg.norm(force, axis=1) / exact.max()
    return {
        "E": found.E / law.E - 1.0, "nu": found.nu - law.nu,
        "stiffness": float(np.abs(found.stiffness - exact).max() / exact.max()),
        "traction": float(traction.max()),
        "stress": float(np.abs(strain.stress(constants) - law.lame).max() / exact.max()),
    }  # fmt: skip


def rows_of(name: str, count: int, seed: int) -> list[dict[str, Any]]:
    """Return the errors of one packing, one row per ν, or its failure."""
    case, begun = CASES.get(name), dict[str, Any](body=name, seed=seed)
    shape = bd.Cell((1.0, 1.0, 1.0)) if case is None else case.shape
    rows = []
    try:
        body = bd.connect(bd.pack(shape, count=count, spread=0.25, seed=seed), method="laguerre")
        conditions = [] if case is None else case.conditions(body)
        assert body.cells is not None
        begun["remainder"] = float(body.cells.remainder.max())
        for nu in NU:
            law, row = bd.CellBond(E=1.0, nu=nu), begun | {"nu": nu}
            for shares, other in bodies_of(body, conditions).items():
                if case is None:
                    row[shares] = periodic_errors(other, law)
                    continue
                model = bd.Model(other, law, 1.0, boundary=conditions)
                row[shares] = errors(model, equilibrium(model), case, law)
                if shares == "balanced":
                    row["solver"] = largest(errors(model, bd.solve_static(model), case, law))
            rows.append(row)
    except BondemError as error:
        rows.append(begun | {"failure": f"{type(error).__name__}: {error}"})
    return rows


def largest(found: dict[str, float]) -> float:
    """Return the largest error."""
    return max(map(abs, found.values()))


def rounded(found: Any) -> Any:
    """Return results with numbers of three digits."""
    if isinstance(found, dict):
        return {key: rounded(value) for key, value in found.items()}
    if isinstance(found, list):
        return [rounded(value) for value in found]
    return float(f"{found:.3g}") if isinstance(found, float) and found not in NU else found


def zeros(rows: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Return the largest errors of moduli, tractions and stresses over the seeds, one line per body and ν."""
    table = []
    for name in dict.fromkeys(row["body"] for row in rows):
        for nu in NU:
            alike = [row for row in rows if row["body"] == name and row.get("nu") == nu]
            if not alike:
                continue
            line = {"body": name, "nu": nu, "seeds": len(alike)}
            for shares in LAWS:
                found = [row[shares] for row in alike]
                line[shares] = {
                    "moduli": max(abs(one[key]) for one in found for key in one if key not in PLACES),
                    **{key: max(one[key] for one in found) for key in PLACES},
                }
            if "solver" in alike[0]:
                line["solver"] = max(row["solver"] for row in alike)
            table.append(line)
    return table


def measure(
    record: Record, *, count: int = 600, seeds: tuple[int, ...] = (21, 22, 23, 24, 25),
    bodies: tuple[str, ...] = (*CASES, PERIODIC),
) -> None:  # fmt: skip
    """Measure all bodies."""
    warnings.filterwarnings("ignore", message=".*nearly incompressible")
    rows: list[dict[str, Any]] = []
    for name in bodies:
        for seed in seeds:
            new = rows_of(name, count, seed)
            rows += new
            failures = [row["failure"] for row in new if "failure" in row]
            worst = max((largest(row["balanced"]) for row in new if "nu" in row), default=np.nan)
            print(f"{name}, seed {seed}: largest error {worst:.1e}", *failures, sep="; ", flush=True)
    record.keep(count=count, target=TARGET, zeros=rounded(zeros(rows)), rows=rounded(rows))
