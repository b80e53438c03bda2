"""From a material to bond parameters: targets in, laws out."""

from bondem.calibration.elastic import Calibration, Trial, calibrate
from bondem.calibration.strength import StrengthCalibration, calibrate_strength

__all__ = ["Calibration", "StrengthCalibration", "Trial", "calibrate", "calibrate_strength"]
