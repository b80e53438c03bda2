"""Chen et al. (2022), cases 1 to 5: every bond law against exact beam theory, statically and by explicit dynamics."""

import math
from pathlib import Path

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

import bondem as bd
from bondem._threads import threads
from bondem.dynamics.plan import ExplicitResult
from bondem.report.style import GREY, INK, sheet
from validation.frame.record import Record
from validation.measures.chen_shear import draw_shear, shear_cases
from validation.measures.chen_specimens import CASES, FORCE, LAWS, MARKS, E, G, beam, bond, cantilever, exact, row

DISTANCE = "distance from Timoshenko theory [%]"


def reissner(F: float, L: float, r: float, *, shear: bool) -> float:
    """Tip deflection of a geometrically exact cantilever [m]."""
    A, I = math.pi * r**2, math.pi * r**4 / 4.0

    def end(X: float) -> np.ndarray:
        def along(s: float, state: np.ndarray) -> list[float]:
            x, _, angle = state
            stretch = 1.0 + F * math.sin(angle) / (E * A)
            slip = F * math.cos(angle) / (0.9 * G * A) if shear else 0.0
            return [
                stretch * math.cos(angle) - slip * math.sin(angle),
                stretch * math.sin(angle) + slip * math.cos(angle),
                F * (X - x) / (E * I),
            ]

        return solve_ivp(along, (0.0, L), np.zeros(3), rtol=1e-11, atol=1e-12).y[:, -1]

    return float(end(brentq(lambda X: end(X)[0] - X, 0.2 * L, L, xtol=1e-12))[1])


# ---- runs


def at_rest(model: bd.Model, *, gamma: float, after: float) -> ExplicitResult:
    """Explicit dynamics until the fastest element is slower than 1e-9 m/s, the paper's rule."""
    stop = bd.AtRest(1e-9, after=after)
    return bd.solve_explicit(model, duration=900.0, damping=bd.LocalDamping(gamma), until=(stop,))


def static_cases() -> list[dict]:
    rows = []
    for case, variants in CASES.items():
        for parameter, (lattice, r, kappa) in variants.items():
            L = lattice.particles.position[-1, 0]
            timoshenko = float(beam(np.array([L]), L, r, shear=True)[0])
            for law in LAWS:
                model = cantilever(lattice, bond(law, r, kappa), FORCE)
                tip = float(bd.solve_static(model).displacement[-1, 1])
                own = float(exact(law, lattice, r, kappa)[-1])
                rows.append(
                    {"case": case, "parameter": parameter, "law": law, "tip": tip, "exact": own,
                     "error": tip / own - 1.0, "timoshenko": timoshenko, "error_timoshenko": tip / timoshenko - 1.0}
                )  # fmt: skip
    return rows


def dynamic_cases() -> list[dict]:
    """At 1 kN: case 1 with the paper's ramp and γ = 0.001, the others with γ = 0.5."""
    rows = []
    for case, variants in CASES.items():
        ramp, gamma = (1.0, 0.001) if case == "1" else (0.1, 0.5)
        for parameter, (lattice, r, kappa) in variants.items():
            for law in LAWS:
                run = at_rest(cantilever(lattice, bond(law, r, kappa), 1e3, ramp), gamma=gamma, after=ramp)
                y, own = run.state.displacement[:, 1], exact(law, lattice, r, kappa, 1e3)
                rows.append(
                    {"case": case, "parameter": parameter, "law": law, "gamma": gamma, "status": run.status.name,
                     "tip": float(y[-1]), "error": float(y[-1] / own[-1] - 1.0),
                     "deflection": y.tolist() if case == "1" else []}
                )  # fmt: skip
    return rows


def large_rotations() -> list[dict]:
    """Case 4's beam of 1 to 40 bonds at 100 kN and 1 MN, against the geometrically exact beam."""
    rows = []
    for force in (100e3, 1e6):
        for law, shear in (("EBBM", False), ("TBBM", True)):
            reference = reissner(force, 4.0, 0.1, shear=shear)
            for n in (1, 2, 4, 5, 10, 20, 40):
                model = cantilever(row(4.0, np.full(n + 1, 2.0 / n)), bond(law, 0.1), force, ramp=0.5)
                tip = float(at_rest(model, gamma=0.5, after=0.5).state.displacement[-1, 1])
                rows.append({"force": force, "law": law, "bonds": n, "error": tip / reference - 1.0})
    return rows


# ---- figures


def draw_cases(static: list[dict], dynamic: list[dict], large: list[dict], folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    x = np.linspace(0.0, 4.0, 200)
    with sheet(folder / "chen_case1.png", 8.2, 3.2, 1, 2) as (_, (left, right)):
        left.plot(x, 1e3 * beam(x, 4.0, 0.2, shear=True), color=INK, label="Timoshenko, eq (28)")
        nodes = np.linspace(0.0, 4.0, 11)
        theory = beam(nodes, 4.0, 0.2, shear=True)
        for entry in (e for e in dynamic if e["case"] == "1"):
            colour, mark = MARKS[entry["law"]]
            y = 100.0 * np.array(entry["deflection"])
            left.plot(nodes, 1e3 * y, mark, color=colour, mfc="none", label=entry["law"])
            right.plot(nodes[1:], 100 * np.abs(y[1:] / theory[1:] - 1.0), mark + "-", color=colour)
        left.set(xlabel="x [m]", ylabel="deflection [mm]", title="Case 1: explicit, 1 kN × 100")
        right.set(xlabel="x [m]", ylabel=DISTANCE, yscale="log", title="Error along the beam")
        left.legend()
    with sheet(folder / "chen_case2.png", 5.2, 3.4) as (_, ax):
        slender = np.linspace(0.1, 1.0, 100)  # 1/λ0 = 2 r/L
        for shear, style in ((True, "-"), (False, "--")):
            values = [beam(np.array([L]), L, 0.2, shear=shear)[0] / L for L in 0.4 / slender]
            ax.plot(slender, values, style, color=INK, label=f"{'Timoshenko' if shear else 'Euler–Bernoulli'} theory")
        for law, (colour, mark) in MARKS.items():
            rows = [e for e in static if e["case"] == "2" and e["law"] == law]
            ax.plot([1 / e["parameter"] for e in rows], [e["tip"] / (0.4 * e["parameter"]) for e in rows], mark,
                    color=colour, mfc="none", label=law)  # fmt: skip
        ax.set(xlabel="1/λ₀ = 2 r/L [-]", ylabel="tip deflection / length [-]", yscale="log")
        ax.set_title("Case 2: shorter beams")
        ax.legend()
    for case, title, r in (("3", "Case 3: more bonds", 0.2), ("4", "Case 4: more and smaller elements", 0.1)):
        with sheet(folder / f"chen_case{case}.png", 5.2, 3.4) as (_, ax):
            theory = beam(np.array([4.0]), 4.0, r, shear=True)[0]
            ax.axhline(1e3 * theory, color=INK, label="Timoshenko theory")
            for law, (colour, mark) in MARKS.items():
                rows = [e for e in static if e["case"] == case and e["law"] == law]
                ax.plot([e["parameter"] for e in rows], [1e3 * e["tip"] for e in rows], mark + "-", color=colour,
                        mfc="none", lw=0.8, label=law)  # fmt: skip
            ax.set(xlabel="bonds [-]", ylabel="tip deflection [mm]", title=title)
            ax.legend()
    with sheet(folder / "chen_case5.png", 5.2, 3.4) as (_, ax):
        for k, (law, (colour, _)) in enumerate(MARKS.items()):
            rows = [e for e in static if e["case"] == "5" and e["law"] == law]
            heights = [100 * abs(e["error_timoshenko"]) for e in rows]
            ax.bar(np.arange(3) + 0.2 * (k - 1.5), heights, 0.18, color=colour, label=law)
        ax.set(xlabel="dispersion d_f [-]", ylabel=DISTANCE, title="Case 5: unequal spheres")
        ax.set_xticks(range(3), [str(d) for d in CASES["5"]])
        ax.legend()
    with sheet(folder / "chen_elastica.png", 5.2, 3.4) as (_, ax):
        for force, style in ((100e3, "-"), (1e6, "--")):
            for law in ("EBBM", "TBBM"):
                rows = [e for e in large if e["force"] == force and e["law"] == law]
                ax.loglog([e["bonds"] for e in rows], [abs(e["error"]) for e in rows], MARKS[law][1] + style,
                          color=MARKS[law][0], mfc="none", label=f"{law}, {force / 1e3:.0f} kN")  # fmt: skip
        n = np.array([1.0, 40.0])
        ax.loglog(n, 3e-4 / n**2, ":", color=GREY, label="second order")
        ax.set(xlabel="bonds [-]", ylabel="error of the tip deflection [-]", title="Large rotations: exact beam")
        ax.legend(fontsize=8)


def measure(record: Record) -> None:
    """Measure all cases."""
    with threads(1):
        static, dynamic, large, shear = static_cases(), dynamic_cases(), large_rotations(), shear_cases()
    record.keep(static=static, explicit=dynamic, large_rotations=large, shear=shear)


def draw(record: Record, folder: Path) -> None:
    """Figures of all cases."""
    found = record.data
    draw_cases(found["static"], found["explicit"], found["large_rotations"], folder)
    draw_shear(found["shear"], folder)
