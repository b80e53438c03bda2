"""Compression between platens, with or without confining pressure: UCS and triaxial strength."""

from collections.abc import Callable
from pathlib import Path

from bondem._checks import number
from bondem._progress import staged
from bondem.damage.failure_assignment import FailureAssignment
from bondem.errors import InputError
from bondem.interactions.contact.contact_law import ContactLaw
from bondem.interactions.law_catalogue import AnyLaw
from bondem.labtests.bonded_compression import compress_bonded
from bondem.labtests.bonded_platens import BondedSpecimen, as_cells, is_cells
from bondem.labtests.loading import Loading, load_to_failure
from bondem.labtests.quasi_static_rig import Moduli, RunOptions, StrengthTest, softenings_of
from bondem.specimen.lattice import Lattice
from bondem.specimen.material import Material


@staged("uniaxial compression")
def uniaxial_compression(
    body: Lattice,
    law: AnyLaw,
    failure: FailureAssignment,
    *,
    pressure: float = 0.0,
    platen_friction: float = 0.0,
    density: float | Material | None = None,
    contact: ContactLaw | None = None,
    traverses: float | None = None,
    reach: float | None = None,
    out: str | Path | None = None,
    progress: Callable[[float], None] | None = None,
) -> StrengthTest:
    """Compress a specimen along x between platens, until the stress has dropped to half of the peak.

    Smooth platens leave the stress uniform, so that the peak is a strength of the material. Rough platens restrain
    the ends of the body: squat bodies are then stronger than slender ones.

    Platens of bonded spheres are planes that the outermost spheres touch, and smooth servo walls apply a pressure on
    the sides. `.E` of bonded spheres uses the strain in the middle half of the length.

    Args:
        body: specimen of cells, of bonded spheres, or of the non-local law.
        law: cell law, bond law, or laws by region, or the non-local law.
        failure: for cells `bd.MohrCoulomb` or `bd.DruckerPrager` with a fracture energy; for bonded spheres a
            criterion of bonds such as `bd.PeripheralStress`; or criteria by region.
        pressure: confining pressure on the sides [Pa]; 0 for uniaxial compression.
        platen_friction: coefficient of friction between platens and body [-]; 0 for smooth platens, as with grease or
            brushes, which leave the ends free to expand.
        density: density of the material [kg/m³], or a `bd.Material`; results do not depend on it. None for 2000.
        contact: contact law of fragments and platens, for bonded spheres; None for the stiffness of the median bond
            and a friction of 0.4 between fragments.
        traverses: number of passes of sound along the specimen before the expected peak [-]; more is slower. None for
            100; bonded spheres have 50, and 100 or 200 if the forces of both platens do not balance.
        reach: limit of the strain, over the strain at the expected peak [-]; None for 2, or 20 for bonded spheres.
        out: run file (HDF5) from which the same call resumes a test or evaluates a complete one; None for no file.
        progress: callback, called at intervals with the completed share of the run [-], 0 … 1.

    Returns:
        Result with a positive `.peak`; stress and peak are those of the platens, σ1 of rock mechanics.

    Raises:
        InputError: a criterion by which cells do not yield, no criterion, no flat ends, or a value out of range.
        UnstableRunError: the run became unstable or lost its energy balance.
        RunInterrupted: Ctrl-C was pressed. The `.result` of the error has the test so far, None for a short run.

    Warns:
        NotQuasistaticWarning: `.unbalance` is above 0.02 for bonded spheres; for cells as in `solve_explicit`.
        StrengthWarning: the load of bonded spheres still rises at the limit of the motion.
    """
    return compressed(
        "uniaxial_compression", body, law, failure, pressure=pressure, platen_friction=platen_friction,
        contact=contact, reach=reach, options=RunOptions.of(density, traverses, out, progress),
    )  # fmt: skip


def compressed(
    test: str, body: Lattice, law: AnyLaw, failure: FailureAssignment, *, pressure: float, platen_friction: float,
    contact: ContactLaw | None, reach: float | None, options: RunOptions,
) -> StrengthTest:  # fmt: skip
    """Run the compression test named `test` as `uniaxial_compression` does; its other arguments are in `options`."""
    owner = f"labtests.{test}"
    number(owner, "pressure", pressure, unit="Pa", least=0.0)
    rough = number(owner, "platen_friction", platen_friction, least=0.0)
    for name, given in (("traverses", options.traverses), ("reach", reach)):
        if given is not None:
            number(owner, name, given, above=0.0)
    if not is_cells(body, law):
        specimen = BondedSpecimen.of(test, body, law, failure, density=options.density, contact=contact)
        return compress_bonded(specimen, pressure=pressure, friction=rough, reach=reach, options=options)
    law = as_cells(test, law, contact)
    moduli = Moduli.of(test, body, law, options.density)
    wanted = "bd.MohrCoulomb or bd.DruckerPrager with a fracture_energy"
    found = softenings_of(test, body, failure, wanted)
    strengths = [slip.compressive(pressure) for softening in found for slip in softening.slips]
    if not strengths:
        raise InputError(f"{owner}: the criterion has no shear strength; give {wanted}")
    loading = Loading(
        sign=-1.0, expected=min(strengths), reach=(reach or 2.0) * strengths[0] / moduli.soft, opening=0.0,
        ending=0.5, pressure=pressure, traverses=options.traverses or 100.0, friction=rough,
    )  # fmt: skip
    return load_to_failure(test, body, law, failure, loading, options)
