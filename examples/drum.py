"""A drum with lifters: a charge of loose spheres is carried up, avalanches, and holds the motor back.

Physics: a cylinder of 0.3 m in diameter and six bars on its inside turn as one body about the y axis, at 40 % of the
speed n_c = 42.3 / √D [rpm, m] at which the outermost layer would stay on the wall. 300 spheres with friction fall
from their packing and reach a steady motion within a turn. Both ends of the drum are smooth planes.

Expected: the mean torque of the drum is that of the weight of the charge about the axis, M g x̄, and the power that
the drum takes is torque by angular velocity: both to less than 1 % over a turn. Takes about 20 s of a core.
Run it with:  python examples/drum.py [FOLDER]
"""

import math
import sys
from pathlib import Path

import numpy as np

import bondem as bd

DIAMETER, LENGTH, LIFTERS = 0.3, 0.05, 6  # m, m
SPIN = 0.4 * 42.3 / math.sqrt(DIAMETER) * math.pi / 30.0  # rad/s
TURN = 2.0 * math.pi / SPIN  # s
CONTACT = bd.LinearContact(E=1e6, friction=0.5, damping=0.2)


def main(turns: float = 2.0, folder: Path | None = None) -> bd.ExplicitResult:
    """The run; into a folder goes its file with 25 snapshots a turn, for ParaView."""
    drum = {"motion": bd.Driven(spin=SPIN, axis=(0, 1, 0)), "axis": (0, 1, 0)}
    shell = bd.CylinderWall(DIAMETER / 2, **drum)
    bars = [
        bd.CylinderWall(8e-3, (0.15 * math.cos(a), 0, 0.15 * math.sin(a)), outside=True, **drum)
        for a in 2.0 * math.pi * np.arange(LIFTERS) / LIFTERS
    ]
    ends = [bd.PlaneWall((0, s * LENGTH / 2, 0), (0, -s, 0), friction=0.0, outer=0.16) for s in (-1, 1)]
    charge = bd.pack(bd.Box((0.2, LENGTH, 0.085)).moved((-0.1, -LENGTH / 2, -0.095)), count=300, seed=1)
    model = bd.Model(
        bd.Lattice(charge, np.zeros((0, 2), dtype=int)), None, density=2500.0, contact=CONTACT,
        walls=[shell, *bars, *ends], boundary=[bd.Gravity()],
    )  # fmt: skip
    turning = range(1 + LIFTERS)
    gauges = {f"{name} {k}": bd.WallGauge(k, name) for k in turning for name in ("torque", "power")}
    gauges["place"] = bd.Gauge(bd.Everything(), "displacement")
    file = {} if folder is None else {"out": folder / "drum.h5", "snapshot_every": 1000}
    run = bd.solve_explicit(model, duration=turns * TURN, every=20, gauges=gauges, state=model.state(), **file)

    last = run.history.time > (turns - 1.0) * TURN
    mean = {name: sum(run.history[f"{name} {k}"][last].mean(axis=0) for k in turning) for name in ("torque", "power")}
    torque, power = mean["torque"][1], mean["power"][2]
    lever = (model.lattice.centre[:, 0].mean() + run.history["place"][last, 0]).mean()
    weight = 9.81 * model.mass.sum()
    print(f"{weight:.2f} N of charge, {1e3 * lever:.2f} mm beside the axis")
    print(f"torque {torque:.4f} N m, M g x̄ {weight * lever:.4f} N m, power {power:.4f} W")
    print(f"imbalance of the energy {run.residual:.1e}")
    assert abs(torque / (weight * lever) - 1.0) < 0.01
    assert abs(power / -(torque * SPIN) - 1.0) < 0.01
    return run


if __name__ == "__main__":
    main(folder=Path(sys.argv[1]) if len(sys.argv) > 1 else None)
