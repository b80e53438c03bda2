"""Strengths of bonds between spheres by `bd.calibrate`: targets are met on the packings, wrong input is refused."""

from typing import Any

import numpy as np
import pytest

import bondem as bd
from bondem.errors import InputError
from tests.specimens import spheres

PIN = bd.Cylinder(radius=3e-3, length=9e-3)


def calibrated(seeds: tuple[int, ...], **given: Any) -> bd.Calibration:
    packings = [spheres(PIN, 250, seed=seed) for seed in seeds]
    return bd.calibrate(packings, bd.materials.granite, law=bd.ParallelBond, **given)


@pytest.mark.validate
def test_strengths_come_out_as_targets_on_the_packings() -> None:
    fit = calibrated((1, 2), ucs=60e6, tension=8e6)
    assert fit.strength is not None
    measured: dict[str, list[float]] = {"ucs": [], "tension": []}
    for one in fit.responses:
        given = one.lattice, fit.law, fit.failure
        measured["ucs"].append(bd.labtests.uniaxial_compression(*given, density=fit.density).peak)
        measured["tension"].append(bd.labtests.direct_tension(*given, density=fit.density).peak)
    for name, target in (("ucs", 60e6), ("tension", 8e6)):
        assert np.mean(measured[name]) == pytest.approx(target, rel=0.04)
        np.testing.assert_allclose(fit.strength.strengths(name).values, measured[name], rtol=1e-12)
        low, high = fit.strength.strengths(name).interval(kind="prediction")
        assert low < target < high
    low, high = fit.strength.interval("tension")
    assert low < fit.failure.tension < high


def test_strengths_that_cannot_be_are_refused_in_a_line() -> None:
    with pytest.raises(InputError, match="belong together"):
        calibrated((1,), ucs=60e6)
    with pytest.raises(InputError, match="not above tension"):
        calibrated((1,), ucs=6e6, tension=8e6)
    cell = spheres(bd.Cell((6e-3, 6e-3, 6e-3)), 250)
    with pytest.raises(InputError, match="periodic cell") as caught:
        bd.calibrate(cell, bd.materials.granite, law=bd.ParallelBond, ucs=60e6, tension=8e6)
    assert "\n" not in str(caught.value)
    with pytest.raises(InputError, match="ucs= and tension="):
        _ = calibrated((1,)).failure
