"""The section that forces fill, and bending with it (André et al. 2012, fig. 22)."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

import bondem as bd
from bondem.labtests.beam_tests import Bar, CrossSection
from bondem.labtests.cantilever import Cantilever, mass_gyration
from validation.figures.section import draw_section, draw_section_errors
from validation.frame.files import mean_and_scatter, plain
from validation.frame.study import Row
from validation.measures.effective_section import SectionProfile, SectionRadii, implied_radius, section_profile
from validation.rows.bar import BarStudy, BarTest, CalibratedBar
from validation.rows.packings import PackingRequest, kept_lattice

# Annuli a third of a mean radius wide at 10 000 spheres: fine enough for the layers at the wall.
_ANNULI = 40

#: Theories of a bar, by what its section is taken to be.
SECTIONS = {
    "walls": "max section, the walls",
    "effective": "effective section of the paper: hull of the centres, R_M − R̄",
    "centres": "⟨y²⟩ of that hull, E S and ρ S as measured",
    "force": "⟨y²⟩ of the axial force",
    "refined": "⟨y²⟩ of the axial force, refined length",
}
#: What is compared.
TESTS = {
    "static_bending": "static bending, Euler–Bernoulli",
    "static_bending_timoshenko": "static bending, Timoshenko",
    "bending_frequency": "bending frequency, Euler–Bernoulli",
    "bending_frequency_timoshenko": "bending frequency, Timoshenko",
    "static_torsion": "static torsion",
    "torsional_frequency": "torsional frequency",
}
#: Unsigned: bending frequency with the max and with the effective section, whichever reading of it.
PAPER = {"walls": 0.0663, "effective": 0.018, "force": 0.018}


@dataclass(frozen=True)
class SectionTest(BarTest):
    """Sections of a bar, bent and twisted."""

    def tested(self, bar: CalibratedBar, folder: Path) -> dict[str, Any]:
        """Radii and errors; the profile of the axial stress is kept."""
        self.keep(folder, section_profile(bd.Model(bar.lattice, bar.law, 1.0), bar.tension.solution, annuli=_ANNULI))
        return _measured(bar)


@dataclass(frozen=True)
class SectionStudy(BarStudy):
    """The section that forces fill, and bending with it: figure 22 of André et al. (2012).

    Attributes:
        count: spheres of a packing.
        seed: of the first packing, on which the bonds are calibrated.
        packings: how many, seeds in sequence; the picture shows the first.
    """

    packings: int = 8

    def tests(self, packings: Sequence[PackingRequest], law: bd.BondLaw, density: float) -> Sequence[SectionTest]:
        return [SectionTest(one, law, density) for one in packings]

    def results(self, out: Path, rows: Sequence[Row]) -> dict[str, Any]:
        return rows[0]["bar"] | {
            "summary": _summary(rows),
            "paper": {"bending_frequency": PAPER, "radius": implied_radius(PAPER["walls"], PAPER["effective"])},
            "profile": _profile([test.kept(out) for test in self.calibrated_tests(out)]),
        }

    def draw(self, out: Path, rows: Sequence[Row], results: Mapping[str, Any]) -> None:
        """Figure 22, and the errors by the section."""
        figures, one = out / "figures", results["summary"]
        radii = {name: value["mean"] for name, value in one["radius"].items()}
        first = kept_lattice(self.bars[0], out)
        draw_section(figures / "section_face.png", first, rows[0]["radius"], radii, results["profile"])
        draw_section_errors(figures / "section_errors.png", one["error"], SECTIONS, TESTS, PAPER)


def theories(bar: CalibratedBar) -> dict[str, tuple[Bar, Bar, float]]:
    """The bar of each idea of the section, for statics and for dynamics, and the overhang of its load [m]."""
    beam = Cantilever.of(bar.lattice, **bar.own, gyration=bar.tension.gyration)
    paper, mass = beam.paper, mass_gyration(bar.lattice)
    radii = SectionRadii.of(bar.lattice, force=bar.tension.gyration, mass=mass)
    hull = np.full(2, 0.25 * radii.centres**2)
    effective = replace(paper, section=CrossSection.of(bd.Cylinder(radii.centres, paper.length)))
    force = replace(paper, section=paper.section.filled(bar.tension.gyration, mass))
    centres = replace(paper, section=paper.section.filled(hull, mass))
    return {
        "walls": (paper, paper, 0.0),
        "effective": (effective, effective, 0.0),
        "centres": (centres, centres, 0.0),
        "force": (force, force, 0.0),
        "refined": (beam.refined, beam.moving, beam.overhang),
    }


def _measured(bar: CalibratedBar) -> dict[str, Any]:
    E, nu = bar.tension.E, bar.tension.nu
    bent = bd.labtests.static_bending(bar.lattice, bar.law, E=E, nu=nu)
    twisted = bd.labtests.static_torsion(bar.lattice, bar.law, E=E, nu=nu)
    modes = bd.labtests.natural_frequencies(bar.lattice, bar.law, density=bar.density)
    plain_bar = Cantilever.of(bar.lattice, **bar.own).paper
    # the loads behind the deflection and the twist, which the tests chose
    force, moment = bent.theory / plain_bar.deflection(1.0), twisted.theory / plain_bar.twist(1.0)
    errors = {}
    for name, (static, moving, overhang) in theories(bar).items():
        ratio = {
            "static_bending": bent.measured / static.deflection(force, overhang=overhang),
            "static_bending_timoshenko": bent.measured / static.deflection(force, overhang=overhang, shear=True),
            "bending_frequency": modes.bending / moving.bending_frequency,
            "bending_frequency_timoshenko": modes.bending / moving.bending_frequency_timoshenko,
            "static_torsion": twisted.measured / static.twist(moment),
            "torsional_frequency": modes.torsion / moving.torsional_frequency,
        }
        errors[name] = {test: value - 1.0 for test, value in ratio.items()}
    radii = SectionRadii.of(bar.lattice, force=bar.tension.gyration, mass=mass_gyration(bar.lattice))
    return {"radius": vars(radii), "errors": errors}


def _summary(rows: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    return {
        "packings": len(rows),
        "radius": {name: mean_and_scatter([row["radius"][name] for row in rows]) for name in rows[0]["radius"]},
        "error": {
            section: {test: mean_and_scatter([row["errors"][section][test] for row in rows]) for test in TESTS}
            for section in SECTIONS
        },
    }


def _profile(profiles: Sequence[SectionProfile]) -> dict[str, Any]:
    def spread(name: str) -> dict[str, Any]:
        values = np.array([getattr(one, name) for one in profiles])
        scatter = values.std(axis=0, ddof=1) if len(values) > 1 else np.zeros(values.shape[1])
        return {"mean": values.mean(axis=0), "std": scatter}

    first = profiles[0]
    return plain({
        "edge": first.edge, "stress": spread("stress"), "solid": spread("solid"), "carried": spread("carried"),
    })  # fmt: skip
