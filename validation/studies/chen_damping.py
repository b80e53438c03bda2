"""Chen et al. (2022), eqs (9) to (12): what each coefficient of damping does, and how fast cases 1 and 2 rest."""

import math

import numpy as np

import bondem as bd
from bondem._threads import threads
from validation.frame.record import Record
from validation.measures.chen_one_sided import READINGS, run_to_rest
from validation.measures.chen_specimens import CASES, bond, cantilever

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
                {"law": law, "gamma": gamma, "status": run.status.name, "time": run.state.time,
                 "error": found / tip - 1.0}
            )  # fmt: skip
    return rows


def readings() -> list[dict]:
    """2. γ = 0.1 in each reading of eq (11), for at most 6 s."""
    rows = []
    for reading in READINGS:
        found = run_to_rest(LATTICE, bond("PBM", RADIUS), load=LOAD, gamma=0.1, reading=reading, duration=6.0)
        rows.append(
            {"reading": reading, "status": found.status}
        )
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
            entry |= {"status": rest.status, "error": float(rest.displacement[-1, 1]) / tip - 1.0}
        rows.append(entry)
    return rows


def measure(record: Record) -> None:
    """Measure particles, readings of the equations, and bonds."""
    with threads(1):
        record.keep(load=LOAD, particles=particles(), readings=readings(), bonds=bonds())
