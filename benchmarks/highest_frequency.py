"""Accuracy and time of `highest_frequency`, ω_max of a lattice, compared with the exact value by `eigsh`.

python benchmarks/highest_frequency.py [--elements 100000] [--repeat 3]          a minute
"""

import json
import math

import numpy as np
from scipy.sparse import diags_array
from scipy.sparse.linalg import eigsh

import bondem as bd
from bondem.model.highest_frequency import highest_frequency
from bondem.model.stiffness_matrices import mass_diagonal
from kept import Record, clocked, run
from tiled import specimen


def exact(model: bd.Model) -> float:
    """Return the highest angular frequency from the stored matrix, to 1e-6 [rad/s]."""
    scale = diags_array(1.0 / np.sqrt(mass_diagonal(model)))
    start = np.random.default_rng(0).standard_normal(scale.shape[0])
    matrix = scale @ model.interaction.stiffness().tocsc() @ scale
    return math.sqrt(eigsh(matrix, k=1, tol=1e-6, v0=start, return_eigenvectors=False)[0])


def measure(record: Record, *, elements: int = 100_000, repeat: int = 3) -> None:
    lattice = specimen(elements)
    laws = {
        "EulerBernoulli": bd.EulerBernoulli(E=265e9, nu=0.3, radius_ratio=0.71),
        "ParallelBond": bd.ParallelBond(E=265e9, nu=0.3, radius_ratio=0.71),
    }
    models = {name: bd.Model(lattice, law, 2500.0) for name, law in laws.items()}
    ratios = {name: highest_frequency(model) / exact(model) for name, model in models.items()}
    model = models["EulerBernoulli"]
    result = {
        "elements": len(lattice.particles), "bonds": len(lattice.pairs), "over exact": ratios,
        "seconds": clocked(lambda: highest_frequency(model), repeat),
        "seconds of eigsh": clocked(lambda: exact(model), repeat),
    }  # fmt: skip
    record.keep(**result)
    print(json.dumps(result, indent=2))


if __name__ == "__main__":
    run()
