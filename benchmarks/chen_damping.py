"""Chen et al. (2022), eqs (9) to (12): what each coefficient of damping does to case 1, and how fast it comes to rest.

    python benchmarks/chen_damping.py [--out FILE]          about two minutes

1. γ_b of the particles, eqs (11) and (12), from the paper's 0.001 to 0.5, with the paper's ramp of 1 s and stop rule, by
   `bd.solve_explicit`. The tip should not depend on it. A free oscillation loses √((1 - γ)/(1 + γ)) of its amplitude
   every half period, so that the time is inverse to ln((1 + γ)/(1 - γ)).
2. What eq (11) can be read as. Printed is F_i U_i/U_i, which is F_i; with the sign of U_i alone it takes as much energy as
   it gives over a swing; with |F_i| it is local damping by component; |F| U/|U| is that of the vectors.
3. η_b of the bonds, eqs (9) and (10), a coefficient a component: "in general, the damping coefficients in axial, shear,
   twisting and bending are not necessarily equal". As printed, forces have √(kn m̄) in both directions and moments
   √(2 kt Ī), which is η √(kn/ks) for shear, η √(2 kt/kb) for bending and η √2 for twisting where each has its own k.
   A mode of frequency ω decays as exp(-ζ ω t) with

       ζ = ω Σ η_c √(m_c / k_c) s_c,        s_c the share of its elastic energy in component c.

Leaves benchmarks/results/chen_damping.json, SI.
"""

import argparse
import json
import math
from pathlib import Path

import numpy as np

import bondem as bd
from bondem._compile import threads
from chen_one_sided import READINGS, run_to_rest
from chen_specimens import CASES, bond, cantilever
from validation.frame.sources import commit

COMMAND = "python benchmarks/chen_damping.py"
RESULTS = Path(__file__).parent / "results" / "chen_damping.json"
LOAD = 1e3
LATTICE, RADIUS, _ = CASES["1"][10]
COMPONENTS = ("normal", "shear", "bending", "twisting")
ETA = 0.2


def statics(law: str) -> float:
    return float(bd.solve_static(cantilever(LATTICE, bond(law, RADIUS), LOAD)).displacement[-1, 1])


def particles() -> list[dict]:
    """1. Time to rest over γ."""
    rows = []
    for law in ("TBBM", "EBBM", "PBM"):
        tip = statics(law)
        for gamma in (0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 0.5):
            model = cantilever(LATTICE, bond(law, RADIUS), LOAD, ramp=1.0)
            run = bd.solve_explicit(
                model, duration=900.0, damping=bd.LocalDamping(gamma), until=(bd.AtRest(1e-9, after=1.0),)
            )
            # the rule at one instant, and over a quarter of a period
            held = run_to_rest(LATTICE, bond(law, RADIUS), load=LOAD, gamma=gamma, ramp=1.0)
            rows.append(
                {"law": law, "gamma": gamma, "status": run.status.name, "steps": run.steps, "time": run.state.time,
                 "tip": float(run.state.displacement[-1, 1]), "error": float(run.state.displacement[-1, 1]) / tip - 1.0,
                 "held_status": held.status, "held_time": held.time,
                 "held_error": float(held.displacement[-1, 1]) / tip - 1.0}
            )  # fmt: skip
    return rows


def readings() -> list[dict]:
    """2. γ = 0.1 in each reading of eq (11), for at most 20 s."""
    rows = []
    for reading in READINGS:
        found = run_to_rest(LATTICE, bond("PBM", RADIUS), load=LOAD, gamma=0.1, reading=reading, duration=20.0)
        rows.append(
            {"reading": reading, "status": found.status, "time": found.time,
             "error": float(found.displacement[-1, 1]) / statics("PBM") - 1.0}
        )  # fmt: skip
    return rows


def shares(law: str) -> tuple[float, np.ndarray, np.ndarray]:
    """ω of the first bending mode [rad/s], s_c of normal, shear, bending, twisting, and √(m_c / k_c) of a bond [s]."""
    model = cantilever(LATTICE, bond(law, RADIUS), LOAD)
    modes, s = bd.solve_modes(model, count=2), model.stiffness
    # transverse along y, of the two that are alike
    shape = modes.shape[int(np.argmax(np.abs(modes.shape[:2, -1, 1])))]
    y, angle = shape[:, 1], shape[:, 5]
    # the two alike may be mixed; the shares of either plane are the same
    slip = np.diff(y) - s.lever * angle[:-1] - (LATTICE.length - s.lever) * angle[1:]
    energy = np.array([0.0, (s.ks * slip**2).sum(), (s.kb * np.diff(angle) ** 2).sum(), 0.0])
    m, I = 0.5 * model.mass[0], 0.5 * model.inertia[0]
    lag = np.sqrt(np.array([m / s.kn[0], m / s.ks[0], I / s.kb[0], I / s.kt[0]]))
    return 2.0 * math.pi * float(modes.frequency[0]), energy / energy.sum(), lag


def printed(law: str, eta: float) -> tuple[float, float, float, float]:
    """η of normal, shear, bending and twisting that make eqs (9) and (10) as they are printed."""
    s = cantilever(LATTICE, bond(law, RADIUS), LOAD).stiffness
    kn, ks, kb, kt = (float(k[0]) for k in (s.kn, s.ks, s.kb, s.kt))
    return eta, eta * math.sqrt(kn / ks), eta * math.sqrt(2.0 * kt / kb), eta * math.sqrt(2.0)


def bonds() -> list[dict]:
    """3. Rates of decay with η in one component, in all, and as printed; the tip at rest."""
    rows = []
    for law in ("PBM", "TBBM"):
        omega, share, lag = shares(law)
        tip = statics(law)
        cases = {name: tuple(ETA * (other == name) for other in COMPONENTS) for name in COMPONENTS}
        cases |= {"all": (ETA,) * 4, "printed": printed(law, ETA)}
        for name, eta in cases.items():
            theory = omega**2 * float((np.array(eta) * lag * share).sum())
            runs = [
                run_to_rest(LATTICE, bond(law, RADIUS), load=LOAD, eta=eta, slow=slow, duration=180.0 if theory else 5.0)
                for slow in (1e-8, 1e-9)
            ]
            stopped = all(run.status == "STOPPED" for run in runs)
            rate = math.log(10.0) / (runs[1].time - runs[0].time) if stopped else None
            rows.append(
                {"law": law, "eta": dict(zip(COMPONENTS, eta, strict=True)), "component": name, "omega": omega,
                 "shares": dict(zip(COMPONENTS, share.tolist(), strict=True)), "status": runs[1].status, "rate": rate,
                 "theory": theory, "time": runs[1].time, "steps": runs[1].steps,
                 "error": float(runs[1].displacement[-1, 1]) / tip - 1.0}
            )  # fmt: skip
    return rows


def main(arguments: list[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, default=RESULTS)
    out = parser.parse_args(arguments).out
    with threads(1):
        results = {
            "command": COMMAND, "commit": commit(), "version": bd.__version__, "load": LOAD,
            "particles": particles(), "readings": readings(), "bonds": bonds(),
        }  # fmt: skip
    out.write_text(json.dumps(results, indent=1, allow_nan=False) + "\n")
    for row in results["particles"]:
        print(
            f"{row['law']:5} gamma {row['gamma']:5}: {row['status']} after {row['steps']:8} steps, {row['time']:8.3f} s,"
            f" tip {row['error']:+.1e}; at rest for a quarter period after {row['held_time']:8.3f} s,"
            f" tip {row['held_error']:+.1e}"
        )
    for row in results["readings"]:
        print(f"{row['reading']:10} {row['status']} {row['time']:.3f} s, tip {row['error']:+.1e}")
    for row in results["bonds"]:
        print(
            f"{row['law']:5} {row['component']:9} {row['status']} after {row['steps']} steps, {row['time']:.3f} s, rate"
            f" {row['rate'] or 0.0:.5g} / {row['theory']:.5g} 1/s, tip {row['error']:+.1e}"
        )


if __name__ == "__main__":
    main()
