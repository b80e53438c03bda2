"""Chen et al. (2022), eqs (9) to (12): what each coefficient of damping does, and how fast cases 1 and 2 rest.

    python benchmarks/chen_damping.py [--out FILE]          some minutes

1. γ_b of the particles, eqs (11) and (12), from the paper's 0.001 to 0.5, with the paper's ramp of 1 s and stop rule,
   by `bd.solve_explicit`. The tip should not depend on it. A free oscillation keeps √((1 - γ)/(1 + γ)) of its
   amplitude every half period, so that the time is inverse to ln((1 + γ)/(1 - γ)).
2. What eq (11) can be read as. Printed is F_i U_i/U_i, which is F_i; with the sign of U_i alone it takes as much
   energy as it gives over a swing; with |F_i| it is local damping by component; |F| U/|U| is that of the vectors.
3. η_b of the bonds, eqs (9) and (10), a coefficient a component: "in general, the damping coefficients in axial,
   shear, twisting and bending are not necessarily equal". As printed, forces have √(kn m̄) in both directions and
   moments √(2 kt Ī): where each has its own k, η √(kn/ks) for shear, η √(2 kt/kb) for bending, η √2 for twisting.
   A mode of frequency ω decays as exp(-ζ ω t) with

       ζ = ω Σ η_c √(m_c / k_c) s_c,        s_c the share of its elastic energy in component c.

Leaves benchmarks/results/chen_damping.json, SI.
"""

import math
from pathlib import Path

import numpy as np

import bondem as bd
from bondem._threads import threads
from chen_one_sided import READINGS, run_to_rest
from chen_specimens import CASES, bond, cantilever
from kept import commit, keep, place

COMMAND = "python benchmarks/chen_damping.py"
RESULTS = Path(__file__).parent / "results" / "chen_damping.json"
LOAD = 1e3
LATTICE, RADIUS, _ = CASES["1"][10]
COMPONENTS = ("normal", "shear", "bending", "twisting")
ETA = 0.05
#: Three stocky bonds, whose shear counts, and between which times the decay is taken [s].
SHORT, SPAN = CASES["2"][3][0], (0.2, 2.2)


def statics(law: str) -> float:
    return float(bd.solve_static(cantilever(LATTICE, bond(law, RADIUS), LOAD)).displacement[-1, 1])


def particles() -> list[dict]:
    """1. Time to rest over γ."""
    rows = []
    for law in ("TBBM", "PBM"):
        tip = statics(law)
        for gamma in (0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 0.5):
            model = cantilever(LATTICE, bond(law, RADIUS), LOAD, ramp=1.0)
            run = bd.solve_explicit(
                model, duration=900.0, damping=bd.LocalDamping(gamma), until=(bd.AtRest(1e-9, after=1.0),)
            )
            found = float(run.state.displacement[-1, 1])
            rows.append(
                {"law": law, "gamma": gamma, "status": run.status.name, "steps": run.steps, "time": run.state.time,
                 "tip": found, "error": found / tip - 1.0}
            )  # fmt: skip
    return rows


def readings() -> list[dict]:
    """2. γ = 0.1 in each reading of eq (11), for at most 6 s."""
    rows = []
    for reading in READINGS:
        found = run_to_rest(LATTICE, bond("PBM", RADIUS), load=LOAD, gamma=0.1, reading=reading, duration=6.0)
        rows.append(
            {"reading": reading, "status": found.status, "time": found.time,
             "error": float(found.displacement[-1, 1]) / statics("PBM") - 1.0 if found.status == "STOPPED" else None}
        )  # fmt: skip
    return rows


def shares(law: str, lattice: bd.Lattice = LATTICE) -> tuple[float, np.ndarray, np.ndarray]:
    """ω of the first bending mode [rad/s], and of normal, shear, bending, twisting s_c [-] and √(m_c / k_c) [s]."""
    model = cantilever(lattice, bond(law, RADIUS), LOAD)
    modes, s = bd.solve_modes(model, count=2, prestress=False), model.stiffness
    # transverse along y, of the two that are alike
    shape = modes.shape[int(np.argmax(np.abs(modes.shape[:2, -1, 1])))]
    y, angle = shape[:, 1], shape[:, 5]
    # the two alike may be mixed; the shares of either plane are the same
    slip = np.diff(y) - s.lever * angle[:-1] - (lattice.length - s.lever) * angle[1:]
    energy = np.array([0.0, (s.ks * slip**2).sum(), (s.kb * np.diff(angle) ** 2).sum(), 0.0])
    m, I = 0.5 * model.mass[0], 0.5 * model.inertia[0]
    lag = np.sqrt(np.array([m / s.kn[0], m / s.ks[0], I / s.kb[0], I / s.kt[0]]))
    return 2.0 * math.pi * float(modes.frequency[0]), energy / energy.sum(), lag


def printed(law: str, eta: float) -> tuple[float, float, float, float]:
    """η of normal, shear, bending and twisting that make eqs (9) and (10) as they are printed; case 1 and 2 alike."""
    s = cantilever(SHORT, bond(law, RADIUS), LOAD).stiffness
    kn, ks, kb, kt = (float(k[0]) for k in (s.kn, s.ks, s.kb, s.kt))
    return eta, eta * math.sqrt(kn / ks), eta * math.sqrt(2.0 * kt / kb), eta * math.sqrt(2.0)


def bonds() -> list[dict]:
    """3. Parallel bonds: rates of decay of case 2 with η in one component, in all, as printed; case 1 at rest."""
    rows = []
    law, tip = bond("PBM", RADIUS), statics("PBM")
    omega, share, lag = shares("PBM", SHORT)
    cases = {name: tuple(ETA * (other == name) for other in COMPONENTS) for name in COMPONENTS}
    cases |= {"all": (ETA,) * 4, "printed": printed("PBM", ETA)}
    for name, eta in cases.items():
        early, late = (run_to_rest(SHORT, law, load=LOAD, eta=eta, duration=end, slow=0.0) for end in SPAN)
        entry = {
            "component": name, "share": share.tolist(), "eta": dict(zip(COMPONENTS, eta, strict=True)),
            "rate": math.log(early.speed / late.speed) / (late.time - early.time),
            "theory": omega**2 * float((np.array(eta) * lag * share).sum()),
        }  # fmt: skip
        if name == "printed":
            rest = run_to_rest(LATTICE, law, load=LOAD, eta=printed("PBM", 0.5), duration=180.0)
            entry |= {"status": rest.status, "time": rest.time, "steps": rest.steps,
                      "error": float(rest.displacement[-1, 1]) / tip - 1.0}  # fmt: skip
        rows.append(entry)
    return rows


def main(arguments: list[str] | None = None) -> None:
    out = place(__doc__, RESULTS, arguments)
    with threads(1):
        results = {
            "command": COMMAND, "commit": commit(), "version": bd.__version__, "load": LOAD,
            "particles": particles(), "readings": readings(), "bonds": bonds(),
        }  # fmt: skip
    keep(out, results)
    for row in results["particles"]:
        print(
            f"{row['law']:5} gamma {row['gamma']:5}: {row['status']} after {row['steps']:8} steps,"
            f" {row['time']:8.3f} s, tip {row['error']:+.1e}"
        )
    for row in results["readings"]:
        print(f"{row['reading']:10} {row['status']} {row['time']:.3f} s, tip off by {row['error']}")
    for row in results["bonds"]:
        print(
            f"{row['component']:9} rate {row['rate']:.5g} / {row['theory']:.5g} 1/s"
            + (f"; case 1: {row['status']} after {row['time']:.2f} s, {row['error']:+.1e}" if "status" in row else "")
        )


if __name__ == "__main__":
    main()
