"""`bondem run STUDY.toml --out DIR`."""

from pathlib import Path

import click

from bondem.cli.terminal import on_threads, progress_bars, show_results
from bondem.study.pipeline import run_study
from bondem.study.study import read_study


@click.command("run")
@click.argument("study_file", metavar="STUDY.toml", type=click.Path(path_type=Path))
@click.option("--out", required=True, metavar="DIR", type=click.Path(path_type=Path), help="Where results go.")
@click.option("--packings", type=click.IntRange(min=1), help="Number of packings, instead of the study's.")
@click.option("--seed", type=click.IntRange(min=0), help="Seed of the first packing, instead of the study's.")
@click.option("--threads", "count", type=click.IntRange(min=1), help="Number of threads; all cores unless given.")
def command(study_file: Path, out: Path, packings: int | None, seed: int | None, count: int | None) -> None:
    """Do everything a study names: pack, check, connect, calibrate, test, report."""
    study = read_study(study_file).changed(packings=packings, seed=seed)
    with on_threads(count), progress_bars() as progress:
        results = run_study(study, out, progress=progress)
    show_results(study, results, out)
