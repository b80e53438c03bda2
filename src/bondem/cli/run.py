"""`bondem run STUDY.toml --out DIR`: run a study."""

from pathlib import Path

import click

from bondem.cli.terminal import on_threads, progress_bars, show_programme, show_results
from bondem.study.pipeline import run_study
from bondem.study.programme import Programme, read
from bondem.study.programme_run import run_programme


@click.command("run")
@click.argument("study_file", metavar="STUDY.toml", type=click.Path(path_type=Path))
@click.option("--out", required=True, metavar="DIR", type=click.Path(path_type=Path), help="Folder for results.")
@click.option("--packings", type=click.IntRange(min=1), help="Number of packings; overrides the study.")
@click.option("--seed", type=click.IntRange(min=0), help="Seed of the first packing; overrides the study.")
@click.option("--threads", "count", type=click.IntRange(min=1), help="Number of threads; all cores by default.")
@click.option("--log", metavar="FILE", type=click.Path(path_type=Path),
              help="Log file for progress, written in addition to the terminal.")  # fmt: skip
@click.option("--fresh", is_flag=True, help="Run all specimens of a programme again, also those finished in DIR.")
def command(
    study_file: Path, out: Path, packings: int | None, seed: int | None, count: int | None, fresh: bool,
    log: Path | None,
) -> None:
    """Run a study: pack, check, connect, calibrate, test and report.

    A file with several [[specimens]] gives a folder for each specimen and one common report. Called again with the
    same DIR, the command continues with the unfinished specimens.
    """
    asked = read(study_file).changed(packings=packings, seed=seed)
    with on_threads(count), progress_bars(log) as progress:
        if isinstance(asked, Programme):
            results = run_programme(asked, out, fresh=fresh, progress=progress)
        else:
            results = run_study(asked, out, progress=progress)
    if isinstance(asked, Programme):
        show_programme(results, out)
    else:
        show_results(asked, results, out)
