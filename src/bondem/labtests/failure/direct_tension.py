"""Direct tension: tensile strength and work of fracture of a specimen."""

from collections.abc import Callable
from pathlib import Path

from bondem._progress import staged
from bondem.damage.failure_assignment import FailureAssignment
from bondem.interactions.contact.contact_law import ContactLaw
from bondem.interactions.law_catalogue import AnyLaw
from bondem.labtests.bonded_compression import tear_bonded
from bondem.labtests.bonded_platens import BondedSpecimen, as_cells, is_cells
from bondem.labtests.loading import Loading, load_to_failure
from bondem.labtests.quasi_static_rig import Moduli, RunOptions, StrengthTest, softenings_of
from bondem.specimen.lattice import Lattice
from bondem.specimen.material import Material


@staged("direct tension")
def direct_tension(
    body: Lattice,
    law: AnyLaw,
    failure: FailureAssignment,
    *,
    density: float | Material | None = None,
    contact: ContactLaw | None = None,
    traverses: float | None = None,
    out: str | Path | None = None,
    progress: Callable[[float], None] | None = None,
) -> StrengthTest:
    """Pull a specimen apart along x, between platens that constrain its ends along x only.

    The platens constrain the end faces of cells, or a layer as deep as a mean radius at each end of bonded spheres.

    The work per area of the section is the fracture energy of the specimen if there is one crack: `cracking.single`.
    A bar longer than 2 E G_f / f_t² stores more energy than one crack dissipates. Its load snaps back, and several
    sections tear.

    Args:
        body: specimen of cells, of bonded spheres, or of the non-local law.
        law: cell law, bond law, or laws by region, or the non-local law.
        failure: for cells `bd.Rankine` or another criterion of the stress, or `bd.MohrCoulomb` with a fracture
            energy; for bonded spheres a criterion of bonds such as `bd.PeripheralStress`; or criteria by region.
        density: density of the material [kg/m³], or a `bd.Material`; results do not depend on it. None for 2000.
        contact: contact law of fragments, for bonded spheres; None for the stiffness of the median bond and a
            friction of 0.4.
        traverses: number of passes of sound along the specimen before the expected peak [-]; more is slower. None for
            60; bonded spheres have 50, and 100 or 200 if the forces of both ends do not balance.
        out: run file (HDF5) from which the same call resumes a test or evaluates a complete one; None for no file.
        progress: callback, called at intervals with the completed share of the run [-], 0 … 1.

    Raises:
        InputError: a criterion without a tensile strength, no criterion, no flat ends, or a value out of range.
        UnstableRunError: the run became unstable or lost its energy balance.
        RunInterrupted: Ctrl-C was pressed. The `.result` of the error has the test so far, None for a short run.

    Warns:
        FractureEnergyWarning: the work per section is not a fracture energy.
        NotQuasistaticWarning: `.unbalance` is above 0.02 for bonded spheres; for cells as in `solve_explicit`.
        StrengthWarning: the load of bonded spheres still rises at the limit of the motion.
    """
    options = RunOptions.of(density, traverses, out, progress)
    options.check_traverses("direct_tension")
    if not is_cells(body, law):
        specimen = BondedSpecimen.of("direct_tension", body, law, failure, density=options.density, contact=contact)
        return tear_bonded(specimen, options)
    law = as_cells("direct_tension", law, contact)
    moduli = Moduli.of("direct_tension", body, law, options.density)
    found = softenings_of("direct_tension", body, failure, "bd.Rankine, or bd.MohrCoulomb with a fracture_energy")
    weakest = min(found, key=lambda one: one.tension)
    opening = max(one.last * one.fracture_energy / one.tension for one in (found[0], weakest))
    loading = Loading(
        sign=1.0, expected=weakest.tension, reach=1.3 * found[0].tension / moduli.soft, opening=1.5 * opening,
        ending=0.002, pressure=0.0, traverses=traverses or 60.0,
    )  # fmt: skip
    return load_to_failure("direct_tension", body, law, failure, loading, options)
