"""Pipeline of `bondem run`: pack → check → connect → calibrate → test → report."""

import json
import time
import warnings
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any, cast

import numpy as np

from bondem._progress import reported
from bondem.calibration.elastic import Calibration, Trial
from bondem.damage.criteria.criterion import Criterion
from bondem.dynamics.history import History
from bondem.dynamics.plan import Plan, settled
from bondem.errors import ReportWarning, RunFileError
from bondem.interactions.cells.cell_bond import CellBond
from bondem.interactions.law_catalogue import AnyLaw
from bondem.io.atomic import make_folder, write_text
from bondem.io.folder import only_writer
from bondem.io.particles_file import save_particles
from bondem.io.runfile import RunFile
from bondem.io.vtk import write_vtkhdf
from bondem.labtests.elastic_tests import ELASTIC_TESTS, ElasticBar
from bondem.labtests.failure_tests import FAILURE_TESTS, failure_outcome
from bondem.labtests.outcome import Outcome
from bondem.labtests.requirements import broken_only
from bondem.labtests.tension import static_tension, tension_model
from bondem.model.model import Model
from bondem.model.state import State
from bondem.observables.cell_stress import stress_fields
from bondem.report.curve_files import write_curves
from bondem.report.findings import Bonding, Examined, Findings
from bondem.report.page import write_report
from bondem.specimen.aggregates import Aggregates
from bondem.specimen.fabric import fabric
from bondem.specimen.lattice import Lattice
from bondem.study.results import collect
from bondem.study.specimen_step import SpecimenPlan
from bondem.study.study_file import Reference, Study

#: Function of the name of a stage and its completed share, 0 … 1.
Progress = Callable[[str, float], None]


def run_study(study: Study, out: str | Path, *, progress: Progress | None = None) -> dict[str, Any]:
    """Run a study and write `results.json`, `report.html` and `figures/` into a folder.

    Args:
        study: the study.
        out: folder for the results, created with the first result.
        progress: callback, called with the stage and its completed share [-], or None.

    Returns:
        Contents of `results.json`.

    Raises:
        InputError: the folder cannot be written to, or another process writes to it (both are checked before any
            work), or the study is not feasible.
        PackingError: a packing did not reach its target.
        DisconnectedError: a specimen consists of two large pieces.
        UnstableRunError: the run of a test became unstable or lost its energy balance.
        RunFileError: a file cannot be written, such as on a full disk.
        RunInterrupted: Ctrl-C was pressed during the run of a test.
        UnreachableTargetError: neither the bond law nor any recommended law gives the material's Poisson's ratio.
    """
    with only_writer(Path(out), "output folder"), reported(progress) as on_stage:
        return _carry_out(study, Path(out), on_stage)


def _carry_out(study: Study, out: Path, on_stage: Progress) -> dict[str, Any]:
    if study.material is not None:
        study.bond.require_law(study.material)
    marks = [time.perf_counter()]
    bodies = tuple(packed(study, k, on_stage) for k in range(study.packings))
    lattices = tuple(body.lattice for body in bodies)
    marks.append(time.perf_counter())
    bonds = None
    if study.material is not None:
        bonds = study.bond.of_material(study.material, lattices[: study.calibrating], on_stage)
    fit = bonds.fit if bonds is not None else None
    marks.append(time.perf_counter())
    specimens = tuple(examined(study, k, body, bonds, on_stage) for k, body in enumerate(bodies))
    marks.append(time.perf_counter())
    timing = zip(("pack_s", "calibrate_s", "tests_s"), np.diff(marks).round(3).tolist(), strict=True)
    results = collect(study, bonds, specimens, dict(timing))
    known = study.reference or Reference(citation="")
    findings = Findings(
        title=study.name, material=study.material, bonds=bonds, calibrating=study.calibrating, specimens=specimens,
        chart=calibration_chart(lattices[0], fit) if study.figures and fit is not None else (),
        results=results, citation=known.citation, published=known.errors, peaks=known.peaks,
        failures=study.failures, source=study.source,
    )  # fmt: skip
    make_folder(out)
    results["curves"] = write_curves(findings, out)
    write_text(out / "results.json", json.dumps(results, indent=2, allow_nan=False) + "\n")
    if study.vtk:
        write_vtkhdf(out / "specimen.vtkhdf", lattices[0], elements=pulled(specimens[0]))
    if study.packing_files:
        for one in specimens:
            provenance = {"study": study.name, "seed": one.seed}
            save_particles(out / f"packing_{one.seed}.h5", one.lattice, provenance=provenance)
    if study.run_files and bonds is not None:
        for one in specimens:
            keep_specimen(out / f"specimen_{one.seed}.h5", one.lattice, one.law, bonds.density)
    report_last(out, lambda: write_report(
        findings, out, figures=study.figures, progress=lambda share: on_stage("report", share)
    ))  # fmt: skip
    return results


def report_last(out: Path, write: Callable[[], None]) -> None:
    """Write a report after all results; an unexpected error gives a warning, as the results are complete.

    Args:
        out: folder of `results.json` and the report.
        write: function that writes the report.

    Raises:
        RunFileError: a file of the report cannot be written, as on a full disk.

    Warns:
        ReportWarning: the report was not written.
    """
    try:
        write()
    except RunFileError:
        raise
    except Exception as error:
        (out / "report.html").unlink(missing_ok=True)  # that of an earlier run would mislead
        warnings.warn(f"the report was not written ({type(error).__name__}: {error}); all numbers are in"
                      f" '{out / 'results.json'}'", ReportWarning, stacklevel=2)  # fmt: skip


@dataclass(frozen=True, eq=False)
class _Body:
    """Packing with its bonds, and the aggregates in it or None."""

    lattice: Lattice
    aggregates: Aggregates | None


def packed(study: Study, k: int, on_stage: Progress) -> _Body:
    """Create packing k of a study with its bonds.

    Raises:
        DisconnectedError: the specimen consists of two large pieces.
        PackingError: the packing did not reach its target.
        StudyError: the shape in a file of particles does not suit the tests.
    """
    stage, seed = f"pack {k + 1} of {study.packings}", study.seed + k
    balls = None
    if study.aggregates is not None and isinstance(study.specimen, SpecimenPlan):
        on_stage(f"{stage}: aggregates", 0.0)
        balls = study.aggregates.placed(study.specimen.shape, study.specimen.count, seed)
    particles = study.specimen.particles(seed, lambda share: on_stage(stage, share), balls)
    study.require_testable(particles.envelope)
    return _Body(study.bond.connect(particles), balls)


def examined(study: Study, k: int, body: _Body, bonds: Bonding | None, on_stage: Progress) -> Examined:
    """Evaluate packing k of a study: its fabric and, with the law of the study, its moduli and tests."""
    lattice = body.lattice
    stage = f"test {k + 1} of {study.packings}"
    on_stage(stage, 0.0)
    quality = fabric(lattice) if lattice.cells is None else None  # cells do not keep their original packing
    specimen = Examined(seed=study.seed + k, lattice=lattice, quality=quality)
    if bonds is None:
        on_stage(stage, 1.0)
        return specimen
    law, density = _law(study, bonds, body), bonds.density
    known = bonds.fit.tensions[: study.calibrating] if bonds.fit is not None else ()
    whole = broken_only(lattice.particles.envelope) is None
    tension = None if not whole else known[k] if k < len(known) else static_tension(lattice, law)
    mass = density * lattice.element_volume[lattice.connected].sum()
    rho = float(mass / lattice.particles.envelope.volume)
    specimen = replace(specimen, tension=tension, rho=rho, law=law, aggregates=body.aggregates)
    # a ball, or a specimen with a notch or borings, is broken only
    bar = None if tension is None else ElasticBar(lattice, law, tension, density, rho)
    if bar is not None and any(name in ELASTIC_TESTS and ELASTIC_TESTS[name].vibrates for name in study.tests):
        specimen = replace(specimen, frequencies=bar.frequencies)
        on_stage(stage, 0.3)
    outcomes: dict[str, Outcome] = {}
    for done, name in enumerate(study.tests):
        if bar is not None:
            on_stage(stage, 0.6 + 0.4 * done / len(study.tests))
        if bar is None or name in FAILURE_TESTS:
            outcomes[name] = to_failure(name, study, body, bonds, partial(on_stage, f"{name}, {stage}"))
        else:
            outcomes[name] = ELASTIC_TESTS[name].perform(bar)
    on_stage(stage, 1.0)
    return replace(specimen, outcomes=outcomes)


def _law(study: Study, bonds: Bonding, body: _Body) -> AnyLaw:
    """Return the law of a body, by region if it has aggregates."""
    if study.aggregates is None or body.aggregates is None:
        return bonds.law
    return study.aggregates.laws(cast(CellBond, bonds.law), body.aggregates)


def to_failure(name: str, study: Study, body: _Body, bonds: Bonding, progress: Callable[[float], None]) -> Outcome:
    """Run the named test to failure on a body, with the law, criterion and options of the study."""
    law, failure = _law(study, bonds, body), cast(Criterion, study.failure)
    if study.aggregates is not None and body.aggregates is not None:
        failure = study.aggregates.criteria(failure, body.aggregates)
    options = study.options.get(name)
    return failure_outcome(
        name, body.lattice, law, failure, density=bonds.density, options=options, progress=progress
    )


def pulled(specimen: Examined) -> dict[str, Any]:
    """Collect fields of a body of cells for ParaView, without those that the specimen does not have.

    The fields are displacement [m], (n, 3), and stress [Pa] in the tension test, and 1 for cells of aggregates, (n,).
    """
    tension, lattice, balls = specimen.tension, specimen.lattice, specimen.aggregates
    parts = {} if balls is None else {"aggregate": balls.mask(lattice).astype(float)}
    if specimen.law is None or tension is None or lattice.cells is None:
        return parts
    model = tension_model(lattice, specimen.law, stress=tension.stress)
    return parts | {"displacement": tension.solution.displacement} | stress_fields(model, tension.solution)


def calibration_chart(lattice: Lattice, fit: Calibration) -> tuple[Trial, ...]:
    """Compute E / E_μ and ν over the free parameter of the law on one packing, for the calibration curve."""
    chosen = getattr(fit.law, fit.parameter)
    trials = []
    for share in (0.6, 0.8, 1.0, 1.2, 1.4):
        law = replace(fit.law, **{fit.parameter: share * chosen})
        tension = static_tension(lattice, law)
        trials.append(Trial(share * chosen, tension.E / law.E, tension.nu))
    return tuple(trials)


def keep_specimen(path: Path, lattice: Lattice, law: AnyLaw | None, density: float) -> None:
    """Write an unconstrained specimen of a density [kg/m³] at rest as a run file, from which later runs can start."""
    model = Model(lattice, law, density=density)
    with RunFile(path, model, settled(model, Plan(duration=0.0))) as file:
        file.checkpoint(State(model), History.empty(()))
