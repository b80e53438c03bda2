"""Frequency of a free vibration from a record of a few periods."""

import numpy as np
from scipy.optimize import minimize_scalar

from bondem._types import Floats
from bondem.errors import InputError


def spectrum(time: Floats, signal: Floats, *, padding: int = 8) -> tuple[Floats, Floats]:
    """Compute the amplitude spectrum of a uniformly sampled signal under a Hann window.

    Args:
        time: equidistant sample times [s], (s,).
        signal: samples, (s,).
        padding: number of appended zeros, in lengths of the signal [-], for a smooth curve.

    Returns:
        Frequencies [Hz] and amplitudes in the unit of the signal, (f,) each.
    """
    window = np.hanning(len(signal))
    count = len(signal) * (1 + padding)
    amplitude = 2.0 / window.sum() * np.abs(np.fft.rfft((signal - signal.mean()) * window, count))
    return np.asarray(np.fft.rfftfreq(count, float(time[1] - time[0])), dtype=float), amplitude


def dominant_frequency(time: Floats, signal: Floats) -> float:
    """Compute the frequency of the strongest oscillation of a signal [Hz].

    The highest peak of the FFT under a Hann window is the initial guess. The frequency is then fitted: a sinusoid and
    a constant are closest to the signal under the same window. The fit is exact for a pure tone, however few its
    periods.

    Args:
        time: equidistant sample times over at least 1.5 periods [s], (s,).
        signal: samples, (s,).

    Raises:
        InputError: fewer than 16 samples, or a constant signal.
    """
    if len(signal) < 16 or not np.ptp(signal) > 0.0:
        raise InputError(
            f"signal: {len(signal)} samples, constant or too few for a frequency; record at least 16 samples"
        )
    frequency, amplitude = spectrum(time, signal)
    duration = float(time[-1] - time[0])
    # below one cycle per record the window cannot distinguish an oscillation from drift
    amplitude[frequency * duration < 1.0] = 0.0
    peak = float(frequency[np.argmax(amplitude)])
    weight = np.hanning(len(signal))[:, None]

    def unexplained(f: float) -> float:
        phase = 2.0 * np.pi * f * time
        basis = weight * np.stack([np.ones_like(phase), np.cos(phase), np.sin(phase)], axis=1)
        target = weight[:, 0] * signal
        rest = target - basis @ np.linalg.lstsq(basis, target, rcond=None)[0]
        return float(rest @ rest)

    half = 0.5 / duration
    bounds = (max(peak - half, 0.25 * peak), peak + half)
    found = minimize_scalar(unexplained, bounds=bounds, method="bounded", options={"xatol": 1e-7 * peak})
    return float(found.x)
