"""Triaxial compression: strength of a specimen under a confining pressure."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from bondem._checks import number
from bondem._progress import staged
from bondem.damage.failure_assignment import FailureAssignment
from bondem.interactions.contact.contact_law import ContactLaw
from bondem.interactions.law_catalogue import AnyLaw
from bondem.labtests.failure.uniaxial_compression import compressed
from bondem.labtests.one_test import OfOneTest
from bondem.labtests.quasi_static_rig import RunOptions
from bondem.specimen.lattice import Lattice
from bondem.specimen.material import Material


@dataclass(frozen=True, eq=False)
class TriaxialTest(OfOneTest):
    """Result of a triaxial test.

    Attributes:
        test: result of the compression under the confining pressure. Its curve has the strain of the platens [-] and
            the axial stress σ1 of rock mechanics [Pa], positive in compression. E of bonded spheres uses the strain
            in the middle half. The work is that of platens and pressure.
        pressure: confining pressure on the sides, σ3 of rock mechanics, positive [Pa].
    """

    pressure: float

    @property
    def deviator(self) -> float:
        """Largest deviator stress σ1 - σ3, axial stress less pressure [Pa]."""
        return self.peak - self.pressure


@staged("triaxial")
def triaxial(
    body: Lattice,
    law: AnyLaw,
    failure: FailureAssignment,
    *,
    pressure: float,
    platen_friction: float = 0.0,
    density: float | Material | None = None,
    contact: ContactLaw | None = None,
    traverses: float | None = None,
    reach: float | None = None,
    out: str | Path | None = None,
    progress: Callable[[float], None] | None = None,
) -> TriaxialTest:
    """Compress a specimen along x between platens, under a confining pressure.

    On cells the pressure acts on the side facets and rotates with them, like that of a membrane. On bonded spheres
    smooth servo walls apply it: a cylinder around a `bd.Cylinder`, planes around a `bd.Box`.

    The pressure rises while the platens accelerate, in the first fifth of the time to the expected peak, and is
    constant afterwards. Call the function once for each confining pressure.

    Args:
        body: specimen of cells, of bonded spheres, or of the non-local law.
        law: cell law, bond law, or laws by region, or the non-local law.
        failure: for cells `bd.MohrCoulomb` or `bd.DruckerPrager` with a fracture energy; for bonded spheres a
            criterion of bonds such as `bd.PeripheralStress`; or criteria by region.
        pressure: confining pressure on the sides, positive [Pa].
        platen_friction: coefficient of friction between platens and body [-]; 0 for smooth platens, as with grease or
            brushes, which leave the ends free to expand.
        density: density of the material [kg/m³], or a `bd.Material`; results do not depend on it. None for 2000.
        contact: contact law of fragments and walls, for bonded spheres; None for the stiffness of the median bond and
            a friction of 0.4 between fragments.
        traverses: number of passes of sound along the specimen before the expected peak [-]; more is slower. None as
            in `uniaxial_compression`.
        reach: limit of the strain, over the strain at the expected peak [-]; None for 2, or 20 for bonded spheres.
        out: run file (HDF5) from which the same call resumes a test or evaluates a complete one; None for no file.
        progress: callback, called at intervals with the completed share of the run [-], 0 … 1.

    Raises:
        InputError: a pressure that is not positive, a criterion by which cells do not yield, no criterion, a shape
            that walls cannot confine, or a value out of range.
        UnstableRunError: the run became unstable or lost its energy balance.
        RunInterrupted: Ctrl-C was pressed. The `.result` of the error has the test so far, None for a short run.

    Warns:
        NotQuasistaticWarning: `.test.unbalance` is above 0.02 for bonded spheres; for cells as in `solve_explicit`.
        StrengthWarning: the load of bonded spheres still rises at the limit of the motion.
    """
    advice = "a positive pressure; without one it is labtests.uniaxial_compression"
    around = number("labtests.triaxial", "pressure", pressure, unit="Pa", above=0.0, advice=advice)
    test = compressed(
        "triaxial", body, law, failure, pressure=around, platen_friction=platen_friction,
        contact=contact, reach=reach, options=RunOptions.of(density, traverses, out, progress),
    )  # fmt: skip
    return TriaxialTest(test, around)
