"""Direct tension: tensile strength and work of fracture of a specimen."""

from collections.abc import Callable
from pathlib import Path

from bondem._progress import staged
from bondem.damage.failure_assignment import FailureAssignment
from bondem.interactions.cells.cell_constants import CellAssignment
from bondem.labtests.loading import Loading, load_to_failure
from bondem.labtests.quasi_static_rig import Moduli, StrengthTest, softenings_of
from bondem.specimen.lattice import Lattice
from bondem.specimen.material import Material, constant


@staged("direct tension")
def direct_tension(
    body: Lattice,
    law: CellAssignment,
    failure: FailureAssignment,
    *,
    density: float | Material | None = None,
    traverses: float = 60.0,
    out: str | Path | None = None,
    progress: Callable[[float], None] | None = None,
) -> StrengthTest:
    """Pull a body of cells apart along x, between platens that constrain its ends along x only.

    The work per area of the section is the fracture energy of the specimen if one crack takes it: `cracking.single`.
    A bar longer than 2 E G_f / f_t² stores more than one crack takes. Its load snaps back, and several sections tear.

    Args:
        body: specimen of cells.
        law: cell law, or cell laws by region; the first one is the matrix and sets the loading rate.
        failure: `bd.Rankine` or another criterion of the stress, `bd.MohrCoulomb` with a fracture energy, or criteria
            by region.
        density: density of the material [kg/m³], or a `bd.Material`; results do not depend on it.
        traverses: number of passes of sound along the specimen before the expected peak [-]; more is slower.
        out: run file (HDF5) with checkpoints and snapshots, from which the same call continues a test that was
            killed or interrupted, and evaluates a complete one; None for no file.
        progress: callback, called at intervals with the completed share of the run [-], 0 … 1.

    Raises:
        InputError: a lattice without cells, or a criterion without a tensile strength.
        UnstableRunError: the run became unstable.
        RunInterrupted: Ctrl-C was pressed; its `.result` is that of the curve so far.

    Warns:
        FractureEnergyWarning: the work per section is not a fracture energy.
    """
    density = constant("density", density)
    moduli = Moduli.of("direct_tension", body, law, density)
    found = softenings_of("direct_tension", body, failure, "bd.Rankine, or bd.MohrCoulomb with a fracture_energy")
    weakest = min(found, key=lambda one: one.tension)
    opening = max(one.last * one.fracture_energy / one.tension for one in (found[0], weakest))
    loading = Loading(
        sign=1.0, expected=weakest.tension, reach=1.3 * found[0].tension / moduli.soft, opening=1.5 * opening,
        ending=0.002, pressure=0.0, traverses=traverses,
    )  # fmt: skip
    return load_to_failure("direct_tension", body, law, failure, loading, density=density, out=out, progress=progress)
