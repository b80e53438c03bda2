"""The section that forces fill, and bending with it (André et al. 2012, fig. 22)."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, ClassVar

import numpy as np

from bondem.geometry.elementary_shapes import Cylinder
from bondem.interactions.beams.bond_law import BondLaw
from bondem.labtests.beam_tests import Bar, CrossSection
from bondem.labtests.cantilever import Cantilever, mass_gyration, static_bending, static_torsion
from bondem.labtests.modal import natural_frequencies
from bondem.model.model import Model
from validation.figures.section import draw_section, draw_section_errors
from validation.frame.files import in_percent, mean_and_scatter, plain, table
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

_CAPTIONS = {
    "section_face": """Figure 22. The paper draws its effective section and calls it that in which internal forces
        exist; how it is measured it does not say. Left: the face x_max of the first packing with the walls, with the
        most literal reading, the hull of the centres between which bonds run (R_M of eq (13) without R̄), and with
        another, the uniform disc of the ⟨r²⟩ of the axial force in tension. Right: axial stress and volume fraction
        over their means, over the distance from the axis, mean and scatter over the packings; the layers at the wall
        show.""",
    "section_errors": """Measured over theory, less one, with each idea of the section: (a) the bending frequency of
        which the paper speaks, orange what it prints, unsigned; (b) the other tests. Mean and scatter over the
        packings. The paper's section takes the place of R_M everywhere while E and ρ stay those of the calibration:
        frequencies know √(E/ρ) alone, but statics go with E I.""",
}


@dataclass(frozen=True)
class SectionTest(BarTest):
    """Sections of a bar, bent and twisted."""

    def tested(self, bar: CalibratedBar, folder: Path) -> dict[str, Any]:
        """Radii and errors; the profile of the axial stress is kept."""
        self.keep(folder, section_profile(Model(bar.lattice, bar.law, 1.0), bar.tension.solution, annuli=_ANNULI))
        return _measured(bar)


@dataclass(frozen=True)
class SectionStudy(BarStudy):
    """The section that forces fill, and bending with it: figure 22 of André et al. (2012).

    Attributes:
        count: spheres of a packing.
        seed: of the first packing, on which the bonds are calibrated.
        packings: how many, seeds in sequence; the picture shows the first.
    """

    name: ClassVar[str] = "section"
    captions: ClassVar[Mapping[str, str]] = _CAPTIONS
    note: ClassVar[str] = (
        "E S and ρ S are those measured, whatever the section is called, so only ⟨y²⟩ differs; but with the paper's"
        " effective section the radius changes and E and ρ stay. Lengths are L_M of eq (12) but in the last row, that"
        " is between the centres of the sets that are held and loaded."
    )

    packings: int = 8

    def tests(self, packings: Sequence[PackingRequest], law: BondLaw, density: float) -> Sequence[SectionTest]:
        """See `BarStudy`."""
        return [SectionTest(one, law, density) for one in packings]

    def results(self, out: Path, rows: Sequence[Row]) -> dict[str, Any]:
        """See `Study`."""
        return rows[0]["bar"] | {
            "summary": _summary(rows),
            "paper": {"bending_frequency": PAPER, "radius": implied_radius(PAPER["walls"], PAPER["effective"])},
            "profile": _profile([test.kept(out) for test in self.calibrated_tests(out)]),
        }

    def table(self, results: Mapping[str, Any]) -> str:
        """See `Study`."""
        return _tables(results)

    def draw(self, out: Path, rows: Sequence[Row], results: Mapping[str, Any]) -> None:
        """Figure 22, and the errors by the section."""
        figures, one = out / "figures", results["summary"]
        radii = {name: value["mean"] for name, value in one["radius"].items()}
        first = kept_lattice(self.bars[0], out)
        draw_section(figures / "section_face.png", first, rows[0]["radius"], radii, results["profile"])
        draw_section_errors(figures / "section_errors.png", one["error"], SECTIONS, TESTS, PAPER)

    def about(self) -> str:
        """See `BarStudy`."""
        return f"André et al. (2012), §6, fig. 22 · {self.count} spheres, {self.packings} packings"

    def verdict(self, results: Mapping[str, Any]) -> str:
        """See `BarStudy`."""
        return _verdict(results)


def theories(bar: CalibratedBar) -> dict[str, tuple[Bar, Bar, float]]:
    """The bar of each idea of the section, for statics and for dynamics, and the overhang of its load [m]."""
    beam = Cantilever.of(bar.lattice, **bar.own, gyration=bar.tension.gyration)
    paper, mass = beam.paper, mass_gyration(bar.lattice)
    radii = SectionRadii.of(bar.lattice, force=bar.tension.gyration, mass=mass)
    hull = np.full(2, 0.25 * radii.centres**2)
    effective = replace(paper, section=CrossSection.of(Cylinder(radii.centres, paper.length)))
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
    bent = static_bending(bar.lattice, bar.law, E=E, nu=nu)
    twisted = static_torsion(bar.lattice, bar.law, E=E, nu=nu)
    modes = natural_frequencies(bar.lattice, bar.law, density=bar.density)
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
    return {"radius": vars(radii), "errors": errors, "carried_over": carried_over(radii)}


def carried_over(radii: SectionRadii) -> dict[str, float]:
    """What two readings of the effective section make of the paper's own error with the max section, −6.63 % [-]."""
    return {
        name: (1.0 - PAPER["walls"]) * radii.paper / radius - 1.0
        for name, radius in (("effective", radii.centres), ("force", radii.force))
    }


def _summary(rows: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    return {
        "packings": len(rows),
        "radius": {name: mean_and_scatter([row["radius"][name] for row in rows]) for name in rows[0]["radius"]},
        "error": {
            section: {test: mean_and_scatter([row["errors"][section][test] for row in rows]) for test in TESTS}
            for section in SECTIONS
        },
        "carried_over": {
            name: mean_and_scatter([row["carried_over"][name] for row in rows]) for name in rows[0]["carried_over"]
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


def _tables(results: Mapping[str, Any]) -> str:
    one = results["summary"]
    names = {
        "walls": "walls", "paper": "R_M of eq (13): max section", "mass": "of the mass",
        "force": "of the axial force", "centres": "R_M − R̄, hull of the centres: effective section of the paper",
    }  # fmt: skip
    walls = one["radius"]["walls"]["mean"]
    radii = table(
        "Radii of the same cylinder",
        ["radius", "[mm]", "of the walls' [%]"],
        [
            [label, _millimetres(one["radius"][name]), f"{100.0 * one['radius'][name]['mean'] / walls:.2f}"]
            for name, label in names.items()
        ],
    )
    errors = table(
        f"Measured over theory − 1, per cent, {one['packings']} packings",
        ["section", *TESTS.values()],
        [[label, *(in_percent(one["error"][name][test]) for test in TESTS)] for name, label in SECTIONS.items()],
    )
    return "\n".join([radii, errors])


def _millimetres(value: Mapping[str, float | None]) -> str:
    mean, std = value["mean"], value["std"]
    assert mean is not None
    return f"{1e3 * mean:.4f}" if std is None else f"{1e3 * mean:.4f} ± {1e3 * std:.4f}"


def _verdict(results: Mapping[str, Any]) -> str:
    one = results["summary"]
    walls, hull, force = (one["radius"][name]["mean"] for name in ("walls", "centres", "force"))
    before, own, after = (one["error"][name]["bending_frequency"] for name in ("walls", "effective", "force"))
    shear = one["error"]["force"]["bending_frequency_timoshenko"]
    asked = results["paper"]["radius"]
    return (
        f"With the hull of the centres, {1e3 * hull:.3f} mm or {100.0 * hull / walls:.1f} % of the walls' radius, for"
        f" the paper's effective section the error of the bending frequency against Euler–Bernoulli goes from"
        f" {in_percent(before)} % to {in_percent(own)} % (paper, unsigned: 6.63 to about 1.8 %, which asks for"
        f" {100.0 * asked['below']:.1f} % or, if the error changes its sign, {100.0 * asked['above']:.1f} % of the"
        f" radius). In tension the axial force fills a disc of {1e3 * force:.3f} mm, {100.0 * force / walls:.1f} %;"
        f" with that the error is {in_percent(after)} %, and against Timoshenko, who counts shear,"
        f" {in_percent(shear)} %."
    )
