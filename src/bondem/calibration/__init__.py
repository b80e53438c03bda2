"""Calibration of bond parameters to the properties of a material."""

from bondem.calibration.elastic import Calibration, Trial, calibrate
from bondem.calibration.strength import StrengthCalibration, calibrate_strength

__all__ = ["Calibration", "StrengthCalibration", "Trial", "calibrate", "calibrate_strength"]
