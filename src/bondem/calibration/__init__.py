"""From a material to bond parameters: targets in, laws out."""

from bondem.calibration.elastic import Calibration, Trial, calibrate

__all__ = ["Calibration", "Trial", "calibrate"]
