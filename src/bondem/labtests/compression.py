"""Compression between platens, with or without confining pressure: UCS and triaxial strength."""

from collections.abc import Callable
from pathlib import Path

from bondem._checks import number
from bondem._progress import staged
from bondem.damage.failure_assignment import FailureAssignment
from bondem.errors import InputError
from bondem.interactions.cells.cell_constants import CellAssignment
from bondem.labtests.loading import Loading, load_to_failure
from bondem.labtests.quasi_static_rig import Moduli, StrengthTest, softenings_of
from bondem.specimen.lattice import Lattice
from bondem.specimen.material import Material, constant


@staged("uniaxial compression")
def uniaxial_compression(
    body: Lattice,
    law: CellAssignment,
    failure: FailureAssignment,
    *,
    pressure: float = 0.0,
    platen_friction: float = 0.0,
    density: float | Material | None = None,
    traverses: float = 100.0,
    reach: float = 2.0,
    out: str | Path | None = None,
    progress: Callable[[float], None] | None = None,
) -> StrengthTest:
    """Compress a body of cells along x between platens, until the stress has dropped to half of the peak.

    Smooth platens leave the stress uniform, so that the peak is a strength of the material. Rough platens restrain
    the ends of the body: squat bodies are then stronger than slender ones.

    Args:
        body: specimen of cells.
        law: cell law, or cell laws by region; their moduli and the weakest criterion set the loading rate.
        failure: `bd.MohrCoulomb` or `bd.DruckerPrager` with a fracture energy, or criteria by region.
        pressure: confining pressure on the sides, of a membrane that rotates with the cells [Pa]; 0 for uniaxial
            compression.
        platen_friction: coefficient of friction between platens and body [-]; 0 for smooth platens, as with grease or
            brushes, which leave the ends free to expand.
        density: density of the material [kg/m³], or a `bd.Material`; results do not depend on it.
        traverses: number of passes of sound along the specimen before the expected peak [-]; more is slower.
        reach: limit of the strain, over the strain at the expected peak [-].
        out: run file (HDF5) with checkpoints and snapshots, from which the same call continues a test that was
            killed or interrupted, and evaluates a complete one; None for no file.
        progress: callback, called at intervals with the completed share of the run [-], 0 … 1.

    Returns:
        Result with a positive `.peak`. Under pressure, stress and peak are those of the platens, σ1 of soil
        mechanics.

    Raises:
        InputError: a lattice without cells, or a criterion without yielding of cells.
        UnstableRunError: the run became unstable.
        RunInterrupted: Ctrl-C was pressed; its `.result` is that of the curve so far.
    """
    density = constant("density", density)
    number("labtests.uniaxial_compression", "pressure", pressure, unit="Pa", least=0.0)
    number("labtests.uniaxial_compression", "reach", reach, above=0.0)
    rough = number("labtests.uniaxial_compression", "platen_friction", platen_friction, least=0.0)
    moduli = Moduli.of("uniaxial_compression", body, law, density)
    wanted = "bd.MohrCoulomb or bd.DruckerPrager with a fracture_energy"
    found = [one.slip for one in softenings_of("uniaxial_compression", body, failure, wanted)]
    strengths = [slip.compressive(pressure) for slip in found if slip is not None]
    if not strengths:
        raise InputError(f"labtests.uniaxial_compression: the criterion has no shear strength; give {wanted}")
    loading = Loading(
        sign=-1.0, expected=min(strengths), reach=reach * strengths[0] / moduli.soft, opening=0.0, ending=0.5,
        pressure=pressure, traverses=traverses, friction=rough,
    )  # fmt: skip
    return load_to_failure(
        "uniaxial_compression", body, law, failure, loading, density=density, out=out, progress=progress
    )
