"""Static tension, bending and torsion of a clamped specimen against strength of materials.

As in André et al. (2012): the elements at x_min are held, those at x_max loaded, and the mean motion of the
loaded elements is compared with theory. A body of cells is held and loaded at its walls, whose motion is compared:
its length is the shape's.
"""

from dataclasses import dataclass

import numpy as np

from bondem._checks import array, shown
from bondem._progress import staged
from bondem._types import Floats, Ints, PerElement
from bondem.errors import InputError
from bondem.labtests.arguments import AnyLaw, check
from bondem.labtests.beams import Bar, CrossSection
from bondem.labtests.faces import ends, face_motion
from bondem.labtests.gauge_length import AffineField, curvature, middle_half, profile, twist_rate
from bondem.labtests.outcome import Outcome
from bondem.labtests.tension import paper_length
from bondem.model.boundary import Fix, Load
from bondem.model.model import Model
from bondem.observe.cell_stress import cell_stress
from bondem.solve.static import StaticResult, solve_static
from bondem.specimen.lattice import Lattice
from bondem.specimen.regions import Face


@dataclass(frozen=True, eq=False)
class Cantilever:
    """A specimen as a bar: its face sets, and the two lengths one may give it.

    Attributes:
        lattice: the specimen.
        held: elements at x_min, (k,).
        loaded: elements at x_max, (k,).
        paper: the bar with L_M of eq (12), from wall to wall.
        refined: the bar between the mean centres of the two sets, for statics; between the walls of a body of cells.
        moving: the bar from the mean centre of the held set to the face x_max, for dynamics: the elements at
            x_max move with all their mass.
        overhang: distance of the face x_max, through whose centre loads act, beyond the loaded centres [m].
    """

    lattice: Lattice
    held: Ints
    loaded: Ints
    paper: Bar
    refined: Bar
    moving: Bar
    overhang: float

    @classmethod
    def of(
        cls,
        lattice: Lattice,
        *,
        E: float,
        nu: float,
        rho: float = 1.0,
        gyration: Floats | None = None,
        density: float | PerElement = 1.0,
        depth: float = 0.02,
    ) -> "Cantilever":
        """The bar of a specimen whose macroscopic moduli are E [Pa] and ν.

        With `gyration`, that of its `Tension`, the refined bars have the section the axial force fills, and the mass
        is where elements of this `density` [kg/m³], a number or (n,), have it.

        Raises:
            EmptyRegionError: no connected element at a face.
            InputError: the specimen is no Cylinder or Box.
        """
        envelope = lattice.particles.envelope
        section = CrossSection.of(envelope)
        if gyration is not None:
            wanted = "Tension.gyration, two positive numbers in m²"
            gyration = array("", "gyration", gyration, wanted=wanted)
            if gyration.shape != (2,) or not (gyration > 0.0).all():
                raise InputError(f"gyration = {shown(gyration)}; give {wanted}")
        filled = section if gyration is None else section.filled(gyration, mass_gyration(lattice, density))
        held, loaded = (Face(name, depth).select(lattice) for name in ("x_min", "x_max"))
        face = float(envelope.face_centre("x_max")[0])
        near, far = ends(lattice, depth)
        return cls(
            lattice=lattice,
            held=held,
            loaded=loaded,
            paper=Bar(paper_length(lattice, depth), section, E, nu, rho),
            refined=Bar(far - near, filled, E, nu, rho),
            moving=Bar(face - near, filled, E, nu, rho),
            overhang=face - far,
        )

    def model_under(self, law: AnyLaw, depth: float, force: tuple[float, ...], moment: float = 0.0) -> Model:
        """The specimen clamped at x_min, under a force on x_max and a moment about x."""
        held = Fix(Face("x_min", depth))
        load = Load(Face("x_max", depth), force=(force[0], force[1], force[2]), moment=(moment, 0.0, 0.0))
        return Model(self.lattice, law, density=1.0, boundary=[held, load])  # statics do not depend on the density

    def stressed(
        self, law: AnyLaw, depth: float, solution: StaticResult, *, force: tuple[float, ...]
    ) -> dict[str, Floats]:
        """Axial stress [Pa], (n,), and motion [m, rad], (n, 3) each, of cells at rest; nothing of spheres."""
        if self.lattice.cells is None:
            return {}
        stress = cell_stress(self.model_under(law, depth, force), solution)
        return {"axial_stress": stress[:, 0, 0], "displacement": solution.displacement, "rotation": solution.rotation}

    def respond(
        self, law: AnyLaw, depth: float, *, force: tuple[float, ...] = (0, 0, 0), moment: float = 0.0
    ) -> tuple[StaticResult, Floats]:
        """The equilibrium under a force on x_max and a moment about x, and the motion of x_max [m, rad], (6,)."""
        model = self.model_under(law, depth, force, moment)
        solution = solve_static(model)
        return solution, face_motion(model, solution, "x_max", depth)

    def profile(self, displacement: Floats, component: int) -> dict[str, Floats]:
        """One component of the rigid motion of the cross-sections along x, for figures."""
        chosen = self.lattice.connected
        x, motion = profile(self.lattice.centre[chosen], displacement[chosen])
        return {"x": x, "profile": motion[:, component]}


def mass_gyration(lattice: Lattice, density: float | PerElement = 1.0) -> Floats:
    """Where in the section the mass is: ⟨y²⟩ and ⟨z²⟩ about its centre [m²], (2,), elements as solid balls or cells.

    With one density this is less than the shape has; with `balanced_density` it is exactly the shape's.

    Args:
        lattice: the specimen.
        density: of the elements [kg/m³], a number or (n,); how large it is cancels.
    """
    moving = lattice.connected
    particles = lattice.particles
    cells = lattice.cells
    mass = (density * (particles.volume if cells is None else cells.volume))[moving]
    weight = mass / mass.sum()
    place = lattice.centre[moving, 1:]
    own = 0.2 * weight @ particles.radius[moving] ** 2 if cells is None else weight @ cells.spread[moving, 1:]
    return weight @ place**2 - (weight @ place) ** 2 + own


@staged("clamped tension")
def clamped_tension(
    lattice: Lattice,
    law: AnyLaw,
    *,
    E: float,
    nu: float,
    gyration: Floats | None = None,
    stress: float = 1e6,
    depth: float = 0.02,
) -> Outcome:
    """Mean displacement along x of the face x_max under an axial force, against F L / (E S).

    Args:
        lattice: the specimen.
        law: its bonds.
        E: its own Young's modulus, as `static_tension` measures it [Pa].
        nu: its own Poisson's ratio, likewise [-].
        gyration: `Tension.gyration`, for `theory_refined`, a consistency check.
        stress: F / S [Pa].
        depth: of the two faces, in mean radii [-].
    """
    check("clamped_tension", lattice, E=E, nu=nu, stress=stress, depth=depth)
    bar = Cantilever.of(lattice, E=E, nu=nu, gyration=gyration, depth=depth)
    force = stress * bar.paper.section.area
    solution, moved = bar.respond(law, depth, force=(force, 0.0, 0.0))
    u, chosen = solution.displacement, middle_half(lattice)
    strain = AffineField.fit(lattice.centre[chosen], u[chosen]).strain[0, 0]
    return Outcome(
        name="static_tension",
        measured=float(moved[0]),
        theory=bar.paper.extension(force),
        theory_refined=bar.refined.extension(force),
        unit="m",
        curves=bar.profile(u, 0) | {"gauge_error": np.array(strain * E / stress - 1.0)},
    )


@staged("static bending")
def static_bending(
    lattice: Lattice,
    law: AnyLaw,
    *,
    E: float,
    nu: float,
    gyration: Floats | None = None,
    stress: float = 1e6,
    depth: float = 0.02,
) -> Outcome:
    """Mean deflection along y of the face x_max under a transverse force.

    Theory is F L³ / (3 E I), and with shear F L / (k G S) more. `theory_refined` is Timoshenko's, with the
    force at the face x_max, where it acts, and the deflection where it is measured.

    Args:
        lattice: the specimen.
        law: its bonds.
        E: its own Young's modulus [Pa].
        nu: its own Poisson's ratio [-].
        gyration: `Tension.gyration`, for `theory_refined`, a consistency check.
        stress: mean shear stress F / S [Pa].
        depth: of the two faces, in mean radii [-].
    """
    check("static_bending", lattice, E=E, nu=nu, stress=stress, depth=depth)
    bar = Cantilever.of(lattice, E=E, nu=nu, gyration=gyration, depth=depth)
    force = stress * bar.paper.section.area
    solution, moved = bar.respond(law, depth, force=(0.0, force, 0.0))
    u, chosen = solution.displacement, middle_half(lattice)
    middle, face = (lattice.particles.envelope.face_centre(name)[0] for name in ("x_min", "x_max"))
    middle = 0.5 * (middle + face)
    bent = curvature(lattice.centre[chosen], u[chosen], middle)
    return Outcome(
        name="static_bending",
        measured=float(moved[1]),
        theory=bar.paper.deflection(force),
        theory_timoshenko=bar.paper.deflection(force, shear=True),
        theory_refined=bar.refined.deflection(force, overhang=bar.overhang, shear=True),
        unit="m",
        curves=bar.profile(u, 1)
        | {"gauge_error": np.array(bent * bar.paper.EI / (force * (face - middle)) - 1.0)}
        | bar.stressed(law, depth, solution, force=(0.0, force, 0.0)),
    )


@staged("static torsion")
def static_torsion(
    lattice: Lattice,
    law: AnyLaw,
    *,
    E: float,
    nu: float,
    gyration: Floats | None = None,
    stress: float = 1e6,
    depth: float = 0.02,
) -> Outcome:
    """Rotation about x of the face x_max under a moment about x, against T L / (G J).

    The rotation of the face is the rigid rotation closest to the displacements of its elements.

    Args:
        lattice: the specimen.
        law: its bonds.
        E: its own Young's modulus [Pa].
        nu: its own Poisson's ratio [-].
        gyration: `Tension.gyration`, for `theory_refined`, a consistency check.
        stress: T √S / J [Pa], about the largest shear stress.
        depth: of the two faces, in mean radii [-].
    """
    check("static_torsion", lattice, E=E, nu=nu, stress=stress, depth=depth)
    bar = Cantilever.of(lattice, E=E, nu=nu, gyration=gyration, depth=depth)
    section = bar.paper.section
    moment = stress * section.torsion_constant / section.area**0.5
    solution, moved = bar.respond(law, depth, moment=moment)
    u, chosen = solution.displacement, middle_half(lattice)
    rate = twist_rate(lattice.centre[chosen], u[chosen])
    return Outcome(
        name="static_torsion",
        measured=float(moved[3]),
        theory=bar.paper.twist(moment),
        theory_refined=bar.refined.twist(moment),
        unit="rad",
        curves=bar.profile(u, 3)
        | {"gauge_error": np.array(rate * bar.paper.G * section.torsion_constant / moment - 1.0)},
    )
