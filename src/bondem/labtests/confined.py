"""Triaxial compression: the strength of a specimen under a pressure on its sides."""

from collections.abc import Callable
from dataclasses import dataclass

from bondem._checks import number
from bondem._drawing import Plotted
from bondem._progress import staged
from bondem._types import Floats
from bondem.labtests.compression import uniaxial_compression
from bondem.labtests.rig import StrengthTest
from bondem.model.cell_constants import CellAssignment
from bondem.model.failure_assignment import FailureAssignment
from bondem.model.state import State
from bondem.specimen.lattice import Lattice


@dataclass(frozen=True, eq=False)
class TriaxialTest(Plotted):
    """Result of a triaxial test.

    Attributes:
        test: of compression under the pressure.
        pressure: on the sides, σ3 of rock mechanics, positive [Pa].
    """

    test: StrengthTest
    pressure: float

    @property
    def peak(self) -> float:
        """Largest axial stress, σ1 of rock mechanics, positive [Pa]."""
        return self.test.peak

    @property
    def deviator(self) -> float:
        """Largest difference of the axial stress and the pressure, σ1 - σ3 [Pa]."""
        return self.test.peak - self.pressure

    @property
    def E(self) -> float:
        """Slope of the curve between a tenth and half of the peak [Pa]."""
        return self.test.E

    @property
    def curve(self) -> Floats:
        """Axial strain of the platens [-] and axial stress σ1 [Pa], positive in compression, (k, 2)."""
        return self.test.curve

    @property
    def work(self) -> float:
        """Of platens and pressure until the end over the section [J/m²]."""
        return self.test.work

    @property
    def state(self) -> State:
        """The broken specimen."""
        return self.test.state


@staged("triaxial")
def triaxial(
    body: Lattice,
    law: CellAssignment,
    failure: FailureAssignment,
    *,
    pressure: float,
    density: float | None = None,
    traverses: float = 100.0,
    reach: float = 2.0,
    progress: Callable[[float], None] | None = None,
) -> TriaxialTest:
    """Compress a body of cells along x between smooth platens, its sides under a pressure held by a membrane.

    `uniaxial_compression` under that pressure, which grows while the platens get up to speed, in the first fifth of
    the time to the expected peak, and is constant from then on. Where several confinements are wanted, call it for
    each.

    Args:
        body: cut into cells.
        law: its material, or laws by region; their moduli and the weakest criterion set the speed of the test.
        failure: `bd.MohrCoulomb` or `bd.DruckerPrager`, with a fracture energy; or by region.
        pressure: on the sides, positive [Pa]; the membrane turns with the cells.
        density: of the material [kg/m³]; no result depends on it.
        traverses: how often sound runs along the specimen until the expected peak; the more, the slower.
        reach: strain at which it ends at the latest, over that of the expected peak [-].
        progress: called now and then with the share done, 0 … 1.

    Raises:
        InputError: a pressure that is not positive, a lattice without cells, or a criterion by which cells do not
            yield.
        UnstableRunError: the run became unstable.
    """
    advice = "a positive pressure; without one it is labtests.uniaxial_compression"
    around = number("labtests.triaxial", "pressure", pressure, unit="Pa", above=0.0, advice=advice)
    test = uniaxial_compression(
        body, law, failure, pressure=around, density=density, traverses=traverses, reach=reach, progress=progress
    )
    return TriaxialTest(test, around)
