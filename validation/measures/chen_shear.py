"""Chen et al. (2022), section 4: what the shear of a bond does to a beam (figs 17, 19; case 3 with Obermayr's bond).

Run by `chen.py`. All is static, at 100 kN.

With n equal bonds, the bending springs of a chain are at the midpoints of the bonds, and the midpoint rule of
∫ (L - x)² dx falls short by L³/12n². Obermayr's shear with α_s = 9/10 is that of Timoshenko theory, so that

    tip / tip of Timoshenko - 1 = -(1 - ε) / 4n²,        ε = 1 / (1 + 12 λ0² / 5(1 + ν)),  eq (35)

which is second order in the length of a bond, and no error is left in the limit. Parallel bonds have α_s = 1: they
tend to -ε/10 instead.
"""

from pathlib import Path

import numpy as np
from matplotlib.ticker import PercentFormatter

import bondem as bd
from bondem.report.style import BLUE, GREEN, GREY, INK, ORANGE, sheet
from validation.measures.chen_specimens import CASES, FORCE, LAWS, MARKS, NU, beam, bond, cantilever, row

# Fig 17 from the stiffnesses printed in Table 5
PRINTED_RATIOS = {
    "PBM": (6.283 / 2.416, 12.56 / 4.833, 25.13 / 9.66, 37.69 / 14.50, 50.26 / 19.33, 62.83 / 24.17),
    "EBBM": (6.283 / 0.04712, 12.56 / 0.3769, 25.13 / 3.016, 37.69 / 10.18, 50.26 / 24.13, 62.83 / 47.12),
    "TBBM": (6.283 / 0.04612, 12.56 / 0.3469, 25.13 / 2.240, 37.69 / 5.718, 50.26 / 10.11, 62.83 / 14.88),
}


def ratio_theory(law: str, slenderness: float) -> float:
    """kn/ks of a bond of slenderness λ_b = L/2r [-]: eqs (32) to (34), and that of Obermayr's bond, unrounded."""
    square = 4.0 / 3.0 * slenderness**2
    return {
        "PBM": 2.0 * (1.0 + NU), "EBBM": square, "TBBM": square + 20.0 / 9.0 * (1.0 + NU),
        "Obermayr": 2.0 * (1.0 + NU) / 0.9,
    }[law]  # fmt: skip


def shear_share(slenderness: np.ndarray | float, nu: float) -> np.ndarray:
    """ε, how much Euler–Bernoulli theory misses of a cantilever's deflection [-]: eq (35), unrounded."""
    return np.asarray(1.0 / (1.0 + 12.0 * np.square(slenderness) / (5.0 * (1.0 + nu))))


def ratios() -> list[dict]:
    """Fig 17: axial over shear stiffness in case 3."""
    rows = []
    for law in LAWS:
        for k, (n, (lattice, radius, _)) in enumerate(CASES["3"].items()):
            stiffness = bd.Model(lattice, bond(law, radius), 1000.0).stiffness
            printed = PRINTED_RATIOS[law][k] if law in PRINTED_RATIOS else None
            rows.append(
                {"law": law, "bonds": int(n), "ratio": float(stiffness.kn[0] / stiffness.ks[0]),
                 "theory": ratio_theory(law, 10.0 / n), "paper": printed}
            )  # fmt: skip
    return rows


def slenderness() -> list[dict]:
    """Fig 19: one bond of either law for a beam of slenderness λ0, with the paper's ν and one close to a half."""
    rows = []
    for nu in (NU, 0.499999):
        for ratio in (1.0, 1.5, 2.0, 3.0, 5.0, 10.0):
            length = 0.4 * ratio
            lattice = row(length, np.full(2, 0.5 * length))
            tips = {}
            for name in ("EBBM", "TBBM"):
                model = cantilever(lattice, LAWS[name](E=200e9, nu=nu, radius=0.2), FORCE)
                tips[name] = float(bd.solve_static(model).displacement[-1, 1])
            rows.append(
                {"nu": nu, "slenderness": ratio, "EBBM": tips["EBBM"], "TBBM": tips["TBBM"],
                 "missing": 1.0 - tips["EBBM"] / tips["TBBM"], "theory": float(shear_share(ratio, nu))}
            )  # fmt: skip
    return rows


def refinement() -> list[dict]:
    """Case 3 with up to 160 bonds: error of the tip against Timoshenko theory, and what it should be."""
    timoshenko = float(beam(np.array([4.0]), 4.0, 0.2, shear=True)[0])
    share = float(shear_share(10.0, NU))
    rows = []
    for law, limit in (("Obermayr", 0.0), ("PBM", -0.1 * share)):
        for n in (1, 2, 4, 5, 8, 10, 20, 40, 80, 160):
            spheres = np.full(n + 1, min(0.2, 2.0 / n))  # with equal ones, the radius makes no difference
            model = cantilever(row(4.0, spheres), bond(law, 0.2), FORCE)
            error = float(bd.solve_static(model).displacement[-1, 1]) / timoshenko - 1.0
            rows.append({"law": law, "bonds": n, "error": error, "theory": limit - (1.0 - share) / (4.0 * n**2)})
    return rows


def shear_cases() -> dict:
    """All of it."""
    refined = refinement()
    chain = [r for r in refined if r["law"] == "Obermayr"]
    order = -float(np.polyfit(np.log([r["bonds"] for r in chain]), np.log([-r["error"] for r in chain]), 1)[0])
    off = {
        law: max(abs(r["error"] / r["theory"] - 1.0) for r in refined if r["law"] == law)
        for law in ("Obermayr", "PBM")
    }
    return {
        "stiffness_ratio": ratios(), "slenderness": slenderness(), "refinement": refined,
        "order_obermayr": order, "limit_parallel": -0.1 * float(shear_share(10.0, NU)), "largest_distance": off,
    }  # fmt: skip


def draw_shear(shear: dict, folder: Path) -> None:
    with sheet(folder / "chen_stiffness_ratio.png", 5.2, 3.4) as (_, ax):
        n = np.linspace(1.0, 10.0, 200)
        for law, (colour, mark) in MARKS.items():
            rows = [r for r in shear["stiffness_ratio"] if r["law"] == law]
            ax.semilogy(n, [ratio_theory(law, 10.0 / k) for k in n], color=colour, lw=1.0)
            ax.semilogy([r["bonds"] for r in rows], [r["ratio"] for r in rows], mark, color=colour, mfc="none",
                        label=law)  # fmt: skip
            printed = [(r["bonds"], r["paper"]) for r in rows if r["paper"]]
            if printed:
                ax.semilogy(*np.transpose(printed), "x", color=INK, ms=4, label="paper" if law == "PBM" else None)
        ax.set(xlabel="bonds [-]", ylabel="axial / shear stiffness [-]", title="Case 3: stiffness ratio (fig 17)")
        ax.legend()
    with sheet(folder / "chen_slenderness.png", 8.2, 3.4, 1, 2) as (_, (left, right)):
        fine = np.linspace(1.0, 10.0, 300)
        poisson = sorted({r["nu"] for r in shear["slenderness"]})
        for nu, colour in zip(poisson, (BLUE, ORANGE), strict=True):
            rows = [r for r in shear["slenderness"] if r["nu"] == nu]
            name = f"ν = {nu:.1f}"
            right.plot(fine, shear_share(fine, nu), color=colour, label=f"eq (35), {name}")
            right.plot([r["slenderness"] for r in rows], [r["missing"] for r in rows], "o", color=colour, mfc="none",
                       label=f"one bond, {name}")  # fmt: skip
        lengths = 0.4 * fine
        for shearing, colour, law in ((True, GREEN, "TBBM"), (False, BLUE, "EBBM")):
            tips = np.array([beam(np.array([L]), L, 0.2, shear=shearing)[0] for L in lengths]) / lengths
            label = "Timoshenko" if shearing else "Euler–Bernoulli"
            left.semilogy(fine, tips, color=colour, label=label)
            rows = [r for r in shear["slenderness"] if r["nu"] == NU]
            left.semilogy([r["slenderness"] for r in rows], [r[law] / (0.4 * r["slenderness"]) for r in rows],
                          MARKS[law][1], color=colour, mfc="none", label=f"one bond, {law}")  # fmt: skip
        left.set(xlabel="λ₀ = L / 2r [-]", ylabel="tip deflection / length [-]", title="Cantilever, ν = 0.3 (fig 19)")
        left.legend()
        right.axhline(0.38, color=GREY, lw=0.8, ls=":")
        right.annotate("the paper's 38 %", (9.9, 0.385), color=INK, fontsize=8.5, ha="right")
        right.set(xlabel="λ₀ = L / 2r [-]", ylabel="missing in Euler–Bernoulli", ylim=(0.0, 0.42))
        right.set_title("Share of shear in the deflection")
        right.yaxis.set_major_formatter(PercentFormatter(1.0, decimals=0))
        right.legend(fontsize=8, loc="center right")
    with sheet(folder / "chen_refinement.png", 5.2, 3.4) as (_, ax):
        n = np.geomspace(1.0, 160.0, 200)
        share = float(shear_share(10.0, NU))
        for law, limit in (("Obermayr", 0.0), ("PBM", shear["limit_parallel"])):
            colour, mark = MARKS[law]
            rows = [r for r in shear["refinement"] if r["law"] == law]
            ax.loglog([r["bonds"] for r in rows], [-r["error"] for r in rows], mark, color=colour, mfc="none",
                      label=law)  # fmt: skip
            ax.loglog(n, (1.0 - share) / (4.0 * n**2) - limit, color=colour, lw=1.0)
        ax.loglog([], [], color=GREY, lw=1.0, label="theory of the chain")
        ax.set(xlabel="bonds n [-]", ylabel="tip below Timoshenko theory [-]", title="Case 3 refined")
        ticks = (1, 2, 5, 10, 20, 50, 100)
        ax.set_xticks(ticks, [str(tick) for tick in ticks])
        ax.set_xticks([], minor=True)
        ax.legend()
