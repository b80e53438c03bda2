"""`bondem run STUDY.toml --out DIR`."""

from pathlib import Path

import click

from bondem.cli.terminal import on_threads, progress_bars, show_programme, show_results
from bondem.study.pipeline import run_study
from bondem.study.programme import Programme, read
from bondem.study.programme_run import run_programme


@click.command("run")
@click.argument("study_file", metavar="STUDY.toml", type=click.Path(path_type=Path))
@click.option("--out", required=True, metavar="DIR", type=click.Path(path_type=Path), help="Where results go.")
@click.option("--packings", type=click.IntRange(min=1), help="Number of packings, instead of the study's.")
@click.option("--seed", type=click.IntRange(min=0), help="Seed of the first packing, instead of the study's.")
@click.option("--threads", "count", type=click.IntRange(min=1), help="Number of threads; all cores unless given.")
@click.option("--log", metavar="FILE", type=click.Path(path_type=Path), help="Where progress is written to, too.")
@click.option("--fresh", is_flag=True, help="Of several specimens, run those again too that are finished in DIR.")
def command(
    study_file: Path, out: Path, packings: int | None, seed: int | None, count: int | None, fresh: bool,
    log: Path | None,
) -> None:
    """Do everything a study names: pack, check, connect, calibrate, test, report.

    A file with several [[specimens]] leaves a folder for each and one report of all. Run again with the same DIR, it
    goes on with the specimens that are not finished there.
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
