"""`bondem check STUDY.toml`: check a study without running it."""

from pathlib import Path

import click
from rich.table import Table

from bondem.campaign.sweep import is_campaign, read_campaign
from bondem.cli.terminal import TABLE, wide_console
from bondem.study.forecast import forecast
from bondem.study.programme import Programme, read
from bondem.study.rehearsal import rehearse
from bondem.study.study_file import parse_study


@click.command("check")
@click.argument("study_file", metavar="STUDY.toml", type=click.Path(path_type=Path))
def command(study_file: Path) -> None:
    """Check a study and print what it will compute, without running it.

    A first specimen of up to 20 000 elements is packed, and its tests to failure begin without a time step, to find
    errors before a run. Element sizes, time steps and memory are estimated. The exit status of errors is 2.
    """
    console = wide_console(markup=False)
    differ = ""
    if is_campaign(study_file):
        campaign = read_campaign(study_file)
        first = campaign.specimens[0]
        title, studies = campaign.name, [("first specimen", parse_study(first.document, folder=first.folder))]
        differ = f"{len(campaign.specimens)} specimens, varied by {', '.join(campaign.keys)}"
    else:
        asked = read(study_file)
        title = asked.name
        studies = [(one.name, one.study) for one in asked.series] if isinstance(asked, Programme) else [("", asked)]
    done = [rehearse(study) for _, study in studies]
    console.print(f"{title}: {study_file} is valid")
    if differ:
        console.print(differ)
    for (name, study), rehearsed in zip(studies, done, strict=True):
        table = Table(show_header=False, title=name or None, title_justify="left", **TABLE)
        for what, words in forecast(study):
            table.add_row(f"  {what}", words)
        table.add_row("  checked", rehearsed)
        console.print()
        console.print(table, soft_wrap=False)
