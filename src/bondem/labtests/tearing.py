"""Direct tension: the tensile strength of a specimen, and the work it takes to tear it apart."""

from collections.abc import Callable

from bondem._progress import staged
from bondem.labtests.loading import Loading, load_to_failure
from bondem.labtests.rig import Moduli, StrengthTest, softenings_of
from bondem.model.cell_constants import CellAssignment
from bondem.model.failure_assignment import FailureAssignment
from bondem.specimen.lattice import Lattice


@staged("direct tension")
def direct_tension(
    body: Lattice,
    law: CellAssignment,
    failure: FailureAssignment,
    *,
    density: float | None = None,
    traverses: float = 60.0,
    progress: Callable[[float], None] | None = None,
) -> StrengthTest:
    """Pull a body of cells apart along x, between platens that hold its ends along x only.

    The work over the section is the fracture energy of the specimen, where a single crack takes all of it.

    Args:
        body: cut into cells.
        law: its material, or laws by region, the first of which, of the matrix, sets the speed of the test.
        failure: `bd.Rankine` or another criterion of the stress, or `bd.MohrCoulomb` with a fracture
            energy; or by region.
        density: of the material [kg/m³]; no result depends on it.
        traverses: how often sound runs along the specimen until the expected peak; the more, the slower.
        progress: called now and then with the share done, 0 … 1.

    Raises:
        InputError: a lattice without cells, or a criterion that knows no tensile strength.
        UnstableRunError: the run became unstable.
    """
    moduli = Moduli.of("direct_tension", body, law, density)
    found = softenings_of("direct_tension", body, failure, "bd.Rankine, or bd.MohrCoulomb with a fracture_energy")
    weakest = min(found, key=lambda one: one.tension)
    opening = max(one.last * one.fracture_energy / one.tension for one in (found[0], weakest))
    loading = Loading(
        sign=1.0, expected=weakest.tension, reach=1.3 * found[0].tension / moduli.soft, opening=1.5 * opening,
        ending=0.002, pressure=0.0, traverses=traverses,
    )  # fmt: skip
    return load_to_failure("direct_tension", body, law, failure, loading, density=density, progress=progress)
