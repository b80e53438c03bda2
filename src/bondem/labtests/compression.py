"""Compression between smooth platens, with a pressure on the sides or without: UCS and triaxial strength."""

from collections.abc import Callable

from bondem._checks import number
from bondem._progress import staged
from bondem.errors import InputError
from bondem.labtests.loading import Loading, load_to_failure
from bondem.labtests.rig import Moduli, StrengthTest, softenings_of
from bondem.model.cell_constants import CellAssignment
from bondem.model.failure_assignment import FailureAssignment
from bondem.specimen.lattice import Lattice


@staged("uniaxial compression")
def uniaxial_compression(
    body: Lattice,
    law: CellAssignment,
    failure: FailureAssignment,
    *,
    pressure: float = 0.0,
    density: float | None = None,
    traverses: float = 100.0,
    reach: float = 2.0,
    progress: Callable[[float], None] | None = None,
) -> StrengthTest:
    """Compress a body of cells along x between smooth platens, until its stress has fallen to half of the peak.

    Args:
        body: cut into cells.
        law: its material, or laws by region; their moduli and the weakest criterion set the speed of the test.
        failure: `bd.MohrCoulomb` or `bd.DruckerPrager`, with a fracture energy; or by region.
        pressure: on the sides, a membrane that turns with the cells [Pa]; 0 is uniaxial compression.
        density: of the material [kg/m³]; no result depends on it.
        traverses: how often sound runs along the specimen until the expected peak; the more, the slower.
        reach: strain at which it ends at the latest, over that of the expected peak [-].
        progress: called now and then with the share done, 0 … 1.

    Returns:
        The test; `.peak` is positive. With a pressure stress and peak are those of the platens, σ1 of soil mechanics.

    Raises:
        InputError: a lattice without cells, or a criterion by which cells do not yield.
        UnstableRunError: the run became unstable.
    """
    number("labtests.uniaxial_compression", "pressure", pressure, unit="Pa", least=0.0)
    number("labtests.uniaxial_compression", "reach", reach, above=0.0)
    moduli = Moduli.of("uniaxial_compression", body, law, density)
    wanted = "bd.MohrCoulomb or bd.DruckerPrager with a fracture_energy"
    found = [one.slip for one in softenings_of("uniaxial_compression", body, failure, wanted)]
    strengths = [slip.compressive(pressure) for slip in found if slip is not None]
    if not strengths:
        raise InputError(f"labtests.uniaxial_compression needs the shear strength of a material; give {wanted}")
    loading = Loading(
        sign=-1.0, expected=min(strengths), reach=reach * strengths[0] / moduli.soft, opening=0.0, ending=0.5,
        pressure=pressure, traverses=traverses,
    )  # fmt: skip
    return load_to_failure("uniaxial_compression", body, law, failure, loading, density=density, progress=progress)
