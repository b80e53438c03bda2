"""Parts of the elastic energy of bonds or cells."""

from dataclasses import dataclass


@dataclass(frozen=True)
class EnergyParts:
    """Elastic energy stored in all bonds or cells, by parts.

    Attributes:
        normal: energy of elongation [J]; for cells, of the normal gaps of facets and of dilatation.
        shear: energy of slip at the contact point [J]; other authors call its sum with `bending` the bending energy.
        bending: energy of relative rotation across the bond [J].
        twisting: energy of relative rotation about the bond [J].
    """

    normal: float
    shear: float
    bending: float
    twisting: float

    @property
    def total(self) -> float:
        """Sum of all parts [J]."""
        return self.normal + self.shear + self.bending + self.twisting
