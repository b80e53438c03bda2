"""Static tension, bending and torsion of a clamped specimen, compared with beam theory.

As in André et al. (2012), the elements at x_min are clamped and those at x_max are loaded. The mean motion of the
loaded elements is compared with theory. A body of cells is clamped, loaded and measured at its walls; its length is
that of the shape.
"""

from dataclasses import dataclass

import numpy as np

from bondem._checks import array, shown
from bondem._progress import staged
from bondem._types import Floats, Ints, PerElement
from bondem.boundary.conditions import Fix, Load
from bondem.errors import InputError
from bondem.interactions.law_catalogue import AnyLaw
from bondem.labtests.arguments import check
from bondem.labtests.beam_tests import Bar, CrossSection
from bondem.labtests.faces import specimen_faces
from bondem.labtests.gauge_length import AffineField, at_generators, curvature, middle_half, profile, twist_rate
from bondem.labtests.outcome import Outcome
from bondem.model.model import Model
from bondem.observables.cell_stress import cell_stress
from bondem.specimen.lattice import Lattice
from bondem.specimen.material import Material, constant
from bondem.specimen.regions import Face
from bondem.statics.static import StaticResult, solve_static


@dataclass(frozen=True, eq=False)
class Cantilever:
    """Specimen as a cantilever, with its face regions and its effective lengths.

    Attributes:
        lattice: the specimen.
        clamped: indices of the elements at x_min, (k,).
        loaded: indices of the elements at x_max, (k,).
        paper: bar of length L_M of eq (12) of André et al. (2012), from wall to wall.
        refined: bar between the mean centres of both sets, for statics; between the walls of a body of cells.
        moving: bar from the mean centre of the clamped set to the face x_max, for dynamics: the elements at x_max
            move with all their mass.
        overhang: distance from the mean centre of the loaded set to the face x_max, on which the loads act [m].
    """

    lattice: Lattice
    clamped: Ints
    loaded: Ints
    paper: Bar
    refined: Bar
    moving: Bar
    overhang: float

    @classmethod
    def of(
        cls, lattice: Lattice, *, E: float, nu: float, rho: float = 1.0, gyration: Floats | None = None,
        density: float | PerElement = 1.0, depth: float = 0.02,
    ) -> "Cantilever":  # fmt: skip
        """Create the cantilever of a specimen with macroscopic E [Pa], ν [-] and ρ [kg/m³].

        With `Tension.gyration` [m²], (2,), `refined` and `moving` have the section that carries the axial force, and
        the mass distribution of the element `density` [kg/m³], a number or (n,). `depth` is the depth of the face
        regions in mean radii [-].

        Raises:
            EmptyRegionError: a face has no connected element.
            InputError: the shape is neither a Cylinder nor a Box, or `gyration` is not two positive numbers.
        """
        envelope = lattice.particles.envelope
        section = CrossSection.of(envelope)
        if gyration is not None:
            wanted = "Tension.gyration, two positive numbers in m²"
            gyration = array("", "gyration", gyration, wanted=wanted)
            if gyration.shape != (2,) or not (gyration > 0.0).all():
                raise InputError(f"gyration = {shown(gyration)}; give {wanted}")
        filled = section if gyration is None else section.filled(gyration, mass_gyration(lattice, density))
        clamped, loaded = (Face(name, depth).select(lattice) for name in ("x_min", "x_max"))
        face = float(envelope.face_centre("x_max")[0])
        faces = specimen_faces(lattice, depth)
        near, far = faces.ends
        return cls(
            lattice=lattice, clamped=clamped, loaded=loaded, paper=Bar(faces.paper_length, section, E, nu, rho),
            refined=Bar(far - near, filled, E, nu, rho), moving=Bar(face - near, filled, E, nu, rho),
            overhang=face - far,
        )  # fmt: skip

    def model_under(self, law: AnyLaw, depth: float, force: tuple[float, ...], moment: float = 0.0) -> Model:
        """Create the model clamped at x_min, with a force [N], (3,), and a moment about x [N·m] on x_max."""
        clamp = Fix(Face("x_min", depth))
        load = Load(Face("x_max", depth), force=(force[0], force[1], force[2]), moment=(moment, 0.0, 0.0))
        return Model(self.lattice, law, density=1.0, boundary=[clamp, load])  # statics do not depend on the density

    def stressed(
        self, law: AnyLaw, depth: float, solution: StaticResult, *, force: tuple[float, ...]
    ) -> dict[str, Floats]:
        """Evaluate axial stress [Pa], (n,), displacement [m] and rotation [rad], (n, 3), of cells; {} for spheres."""
        if self.lattice.cells is None:
            return {}
        stress = cell_stress(self.model_under(law, depth, force), solution)
        return {"axial_stress": stress[:, 0, 0], "displacement": solution.displacement, "rotation": solution.rotation}

    def respond(
        self, law: AnyLaw, depth: float, *, force: tuple[float, ...] = (0, 0, 0), moment: float = 0.0
    ) -> tuple[StaticResult, Floats]:
        """Solve for the equilibrium under a force [N] and a moment about x [N·m] on x_max.

        Returns the solution, and the rigid motion of the face x_max [m, rad], (6,).
        """
        model = self.model_under(law, depth, force, moment)
        solution = solve_static(model)
        return solution, specimen_faces(self.lattice, depth).motion(model, solution, "x_max")

    def profile(self, displacement: Floats, component: int) -> dict[str, Floats]:
        """Evaluate "x" [m] and "profile", a component (0 … 5) of the motion of sections [m or rad], (k,) each."""
        chosen = self.lattice.connected
        x, motion = profile(self.lattice.centre[chosen], displacement[chosen])
        return {"x": x, "profile": motion[:, component]}


def mass_gyration(lattice: Lattice, density: float | PerElement = 1.0) -> Floats:
    """Compute the squared radii of gyration of the mass in the section, ⟨y²⟩ and ⟨z²⟩ about its centre [m²], (2,).

    Elements are solid balls or cells. Cells, and spheres of `balanced_density`, have the result of the shape. Spheres
    of uniform density have less, as the skin of their packing is less dense than its core.

    Args:
        lattice: the specimen.
        density: density of the elements [kg/m³], a number or (n,); a common factor cancels.
    """
    moving = lattice.connected
    mass = (density * lattice.element_volume)[moving]
    weight = mass / mass.sum()
    place = lattice.centre[moving, 1:]
    own = lattice.elements.mean_spread(weight, moving)[1:]
    return weight @ place**2 - (weight @ place) ** 2 + own


@staged("clamped tension")
def clamped_tension(
    lattice: Lattice, law: AnyLaw, *, E: float | Material, nu: float | Material, gyration: Floats | None = None,
    stress: float = 1e6, depth: float = 0.02,
) -> Outcome:  # fmt: skip
    """Compare the mean axial displacement of the face x_max under an axial force with F L / (E S).

    Args:
        lattice: the specimen.
        law: bond law, cell law or non-local law of the specimen.
        E: Young's modulus of the specimen, as `static_tension` measures it [Pa].
        nu: Poisson's ratio of the specimen [-].
        gyration: `Tension.gyration` of the specimen [m²], (2,), for `theory_refined`; None for that of the shape.
        stress: axial stress F / S [Pa].
        depth: depth of the two face regions, in mean radii [-].

    Raises:
        EmptyRegionError: a face has no connected element.
        InputError: a specimen that is neither a Cylinder nor a Box or is too coarse, or a value out of range.
    """
    E, nu = constant("E", E), constant("nu", nu)
    check("clamped_tension", lattice, E=E, nu=nu, stress=stress, depth=depth)
    bar = Cantilever.of(lattice, E=E, nu=nu, gyration=gyration, depth=depth)
    force = stress * bar.paper.section.area
    solution, moved = bar.respond(law, depth, force=(force, 0.0, 0.0))
    u, chosen = solution.displacement, middle_half(lattice)
    position, motion = at_generators(lattice, u, solution.rotation)
    strain = AffineField.fit(position[chosen], motion[chosen]).strain[0, 0]
    return Outcome(
        name="static_tension", measured=float(moved[0]), theory=bar.paper.extension(force),
        theory_refined=bar.refined.extension(force), unit="m",
        curves=bar.profile(u, 0) | {"gauge_error": np.array(strain * E / stress - 1.0)},
    )  # fmt: skip


@staged("static bending")
def static_bending(
    lattice: Lattice, law: AnyLaw, *, E: float | Material, nu: float | Material, gyration: Floats | None = None,
    stress: float = 1e6, depth: float = 0.02,
) -> Outcome:  # fmt: skip
    """Compare the mean deflection along y of the face x_max under a transverse force with beam theory.

    Theory is F L³ / (3 E I), plus F L / (k G S) with shear. `theory_refined` is Timoshenko's beam, with the force at
    the face x_max and the deflection at the measured elements.

    Args:
        lattice: the specimen.
        law: bond law, cell law or non-local law of the specimen.
        E: Young's modulus of the specimen [Pa].
        nu: Poisson's ratio of the specimen [-].
        gyration: `Tension.gyration` of the specimen [m²], (2,), for `theory_refined`; None for that of the shape.
        stress: mean shear stress F / S [Pa].
        depth: depth of the two face regions, in mean radii [-].

    Raises:
        EmptyRegionError: a face has no connected element.
        InputError: a specimen that is neither a Cylinder nor a Box or is too coarse, or a value out of range.
    """
    E, nu = constant("E", E), constant("nu", nu)
    check("static_bending", lattice, E=E, nu=nu, stress=stress, depth=depth)
    bar = Cantilever.of(lattice, E=E, nu=nu, gyration=gyration, depth=depth)
    force = stress * bar.paper.section.area
    solution, moved = bar.respond(law, depth, force=(0.0, force, 0.0))
    u, chosen = solution.displacement, middle_half(lattice)
    middle, face = (lattice.particles.envelope.face_centre(name)[0] for name in ("x_min", "x_max"))
    middle = 0.5 * (middle + face)
    bent = curvature(lattice.centre[chosen], u[chosen], middle)
    error = np.array(bent * bar.paper.EI / (force * (face - middle)) - 1.0)
    return Outcome(
        name="static_bending", measured=float(moved[1]), theory=bar.paper.deflection(force),
        theory_timoshenko=bar.paper.deflection(force, shear=True),
        theory_refined=bar.refined.deflection(force, overhang=bar.overhang, shear=True), unit="m",
        curves=bar.profile(u, 1) | {"gauge_error": error}
        | bar.stressed(law, depth, solution, force=(0.0, force, 0.0)),
    )  # fmt: skip


@staged("static torsion")
def static_torsion(
    lattice: Lattice, law: AnyLaw, *, E: float | Material, nu: float | Material, gyration: Floats | None = None,
    stress: float = 1e6, depth: float = 0.02,
) -> Outcome:  # fmt: skip
    """Compare the rotation of the face x_max under a moment about x with T L / (G J).

    The rotation of the face is the rigid rotation closest to the displacements of its elements.

    Args:
        lattice: the specimen.
        law: bond law, cell law or non-local law of the specimen.
        E: Young's modulus of the specimen [Pa].
        nu: Poisson's ratio of the specimen [-].
        gyration: `Tension.gyration` of the specimen [m²], (2,), for `theory_refined`; None for that of the shape.
        stress: T √S / J [Pa], approximately the largest shear stress.
        depth: depth of the two face regions, in mean radii [-].

    Raises:
        EmptyRegionError: a face has no connected element.
        InputError: a specimen that is neither a Cylinder nor a Box or is too coarse, or a value out of range.
    """
    E, nu = constant("E", E), constant("nu", nu)
    check("static_torsion", lattice, E=E, nu=nu, stress=stress, depth=depth)
    bar = Cantilever.of(lattice, E=E, nu=nu, gyration=gyration, depth=depth)
    section = bar.paper.section
    moment = stress * section.torsion_constant / section.area**0.5
    solution, moved = bar.respond(law, depth, moment=moment)
    u, chosen = solution.displacement, middle_half(lattice)
    rate = twist_rate(lattice.centre[chosen], u[chosen])
    error = np.array(rate * bar.paper.G * section.torsion_constant / moment - 1.0)
    return Outcome(
        name="static_torsion", measured=float(moved[3]), theory=bar.paper.twist(moment),
        theory_refined=bar.refined.twist(moment), unit="rad", curves=bar.profile(u, 3) | {"gauge_error": error},
    )  # fmt: skip
