"""The frequency of a free vibration, from a record of a few periods."""

import numpy as np
from scipy.optimize import minimize_scalar

from bondem._types import Floats
from bondem.errors import InputError


def spectrum(time: Floats, signal: Floats, *, padding: int = 8) -> tuple[Floats, Floats]:
    """Amplitude spectrum of a uniformly sampled signal under a Hann window.

    Args:
        time: uniform [s], (s,).
        signal: (s,).
        padding: zeros appended, in lengths of the signal, for a smooth curve.

    Returns:
        Frequencies [Hz] and amplitudes in the unit of the signal.
    """
    window = np.hanning(len(signal))
    count = len(signal) * (1 + padding)
    amplitude = 2.0 / window.sum() * np.abs(np.fft.rfft((signal - signal.mean()) * window, count))
    return np.asarray(np.fft.rfftfreq(count, float(time[1] - time[0])), dtype=float), amplitude


def dominant_frequency(time: Floats, signal: Floats) -> float:
    """Frequency of the strongest oscillation [Hz].

    The highest peak of the FFT under a Hann window tells where to look; there the frequency is the one whose
    sinusoid and constant fit the signal best in the same window, which a pure tone meets exactly however few
    periods there are.

    Args:
        time: uniform [s], (s,); at least 1.5 periods.
        signal: (s,).

    Raises:
        InputError: fewer than 16 samples, or a constant signal.
    """
    if len(signal) < 16 or not np.ptp(signal) > 0.0:
        raise InputError("a frequency takes 16 samples or more of a signal that moves; record longer")
    frequency, amplitude = spectrum(time, signal)
    duration = float(time[-1] - time[0])
    # below one cycle a record the window cannot tell an oscillation from drift
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
