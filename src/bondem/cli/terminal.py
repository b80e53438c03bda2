"""Shared parts of the commands: threads, progress on a terminal and the table of results."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import closing, contextmanager, suppress
from datetime import datetime
from pathlib import Path
from typing import Any

from rich.console import Console
from rich.markup import escape
from rich.table import Table

from bondem._progress import stages
from bondem._threads import most_threads, threads
from bondem.dynamics.progress import RunProgress, listening
from bondem.errors import InputError
from bondem.interactions.law_catalogue import LAWS
from bondem.labtests.failure_tests import FAILURE_TESTS
from bondem.report.numbers import many, percent, signed_percent, with_unit
from bondem.study.study_file import TESTS, Study

_EXPLANATION = (
    "error = measured / theory − 1, mean over the packings. Theory uses E and ν of each specimen and the length"
    " between walls.",
    "refined: a consistency check, not a validation. Theory uses the length between the held and the loaded elements",
    "and the section that carries the axial force in the tension test.",
)


#: Options of tables without lines.
TABLE: dict[str, Any] = {"box": None, "padding": (0, 2, 0, 0)}


def wide_console(width: int = 120, *, markup: bool = True) -> Console:
    """Create a console that does not wrap the lines of results; outside a terminal it is `width` columns wide."""
    console = Console(highlight=False, markup=markup, soft_wrap=True)
    if not console.is_terminal:
        console.width = width
    return console


@contextmanager
def progress_bars(log: Path | None = None) -> Iterator[Callable[[str, float], None]]:
    """Yield a function of a stage and its completed share, which shows bars on a terminal, else lines on stderr.

    Args:
        log: file for one line per twentieth of a stage, or None.

    Raises:
        InputError: the log file cannot be written.
    """
    if log is None:
        with stages(at_once=True) as show:
            yield show
        return
    with closing(_Log(log)) as lines, listening(lines.store), stages(at_once=True) as show:

        def progress(stage: str, share: float) -> None:
            show(stage, share)
            lines.report(stage, share)

        yield progress


class _Log:
    """Log file with lines of time, stage and completed share."""

    def __init__(self, path: Path) -> None:
        try:
            self._file = path.open("a", encoding="utf-8", buffering=1)
        except OSError as error:
            raise InputError(f"--log = '{path}': cannot be written ({error.strerror}); give another file") from None
        self._written: dict[str, int] = {}
        self._latest = ""
        self._write("started")

    def report(self, stage: str, share: float) -> None:
        """Write a line if another twentieth of the stage is complete."""
        step = int(20.0 * share + 1e-9)
        if step > self._written.get(stage, -1):
            self._written[stage] = step
            self._write(f"{stage} {5 * step:3d} %{self._latest}")
            self._latest = ""

    def store(self, progress: RunProgress) -> None:
        """Store the progress of a run, as text for the next line."""
        self._latest = f": {progress.words}"

    def close(self) -> None:
        """Write the last line and close the file."""
        self._write("ended")
        with suppress(OSError):
            self._file.close()

    def _write(self, words: str) -> None:
        with suppress(OSError):  # a full disk must not end the run
            self._file.write(f"{datetime.now().astimezone().isoformat(timespec='seconds')} {words}\n")


@contextmanager
def on_threads(count: int | None) -> Iterator[None]:
    """Use `count` threads, or all available threads for None, within the context.

    Raises:
        InputError: more threads than the machine has.
    """
    if count is not None and count > most_threads():
        raise InputError(f"--threads = {count}: this machine has {most_threads()} threads; give at most that number")
    with threads(count):
        yield


def show_results(study: Study, results: Mapping[str, Any], out: Path) -> None:
    """Print the results of a study, and the paths of its files in the folder `out`."""
    console = wide_console()
    micro, macro, specimen = results["micro"], results["macro"], results["specimen"]
    title = f"[bold]{escape(study.name)}[/bold]"
    first, *others = study.bond.heading(study.packings, specimen)
    lines = [f"{title}, {first}", *others]
    if micro is not None:
        spread = (
            "" if macro["E_std"] is None else
            f"  (over all packings ± {percent(macro['E_std'] / macro['E'])} of E,"
            f" ± {percent(macro['nu_std'] / abs(macro['nu']))} of ν)"
        )  # fmt: skip
        elastic = "" if macro["E"] is None else f"E = {with_unit(macro['E'], 'Pa')}, ν = {macro['nu']:.4f}, "
        lines += [_law(micro), f"  {elastic}ρ = {with_unit(macro['rho'], 'kg/m³')}{spread}"]
    console.print("\n".join(["", *lines, ""]))
    for one in results["packings"]:
        for reason in one["fabric_reasons"]:
            console.print(f"  [yellow]packing of seed {one['seed']}: {reason}[/yellow]")
    if results["tests"]:
        console.print(_tests(study, results))
        for line in _EXPLANATION if any(name in TESTS for name in results["tests"]) else ():
            console.print(f"  [dim]{line}[/dim]")
        for line in _broken(results):
            console.print(f"  {line}", markup=False)
    _show_files(console, out)


def _broken(results: Mapping[str, Any]) -> Iterator[str]:
    """Yield a line on the failure mode, pieces and energies of each test to failure of the first packing."""
    for name, test in results["packings"][0]["tests"].items():
        one = test["failure"]
        if one is None:
            continue
        energy = "" if one["single_crack"] is None else (
            f"; per section {with_unit(one['dissipated_per_section'], 'J/m²')}, entered"
            f" {with_unit(one['fracture_energy'], 'J/m²')}; stored at the peak"
            f" {one['stored_over_one_crack']:.3g} times the energy of one crack"
        )  # fmt: skip
        yield f"{name} {one['mode']}: {many(one['pieces'], 'piece')}, {many(one['crumbs'], 'crumb')}{energy}"


def _show_files(console: Console, out: Path) -> None:
    """Print the paths of the results; the report is last, as users open it next."""
    console.print(f"\n  {out / 'results.json'}", markup=False)
    if (out / "report.html").exists():
        console.print(f"  {out / 'report.html'}", markup=False)


def show_programme(results: Mapping[str, Any], out: Path) -> None:
    """Print the results of a test programme, measured values with targets and closed forms."""
    console = wide_console(140)
    console.print(f"\n[bold]{escape(results['programme'])}[/bold], specimens: {len(results['specimens'])}\n")
    table = Table(header_style="bold", **TABLE)
    for name in ("  specimen", "test"):
        table.add_column(name, no_wrap=True)
    for name in ("measured", "± scatter", "target", "off", "closed form", "off"):
        table.add_column(name, justify="right", no_wrap=True)
    for row in results["rows"]:
        table.add_row(
            escape(f"  {row['specimen']}"), escape(row["label"]), with_unit(row["measured"], row["unit"]),
            "–" if row["scatter"] is None else percent(row["scatter"]),
            with_unit(row["target"], row["unit"]), signed_percent(row["off_target"]),
            with_unit(row["theory"], row["unit"]), signed_percent(row["off_theory"]),
        )  # fmt: skip
    console.print(table)
    _show_files(console, out)


def _law(micro: Mapping[str, Any]) -> str:
    if micro["law"] not in LAWS:
        return (
            f"  {micro['law']}, not calibrated: E = {with_unit(micro['E_mu'], 'Pa')},"
            f" ν = {micro['nu_mu']:g}, ρ = {with_unit(micro['rho_mu'], 'kg/m³')} of the material; measured"
        )
    free = LAWS[micro["law"]].free
    varied = "" if free.is_radius else f" {free.symbol} = {micro[free.name]:.4f},"
    return (
        f"  {micro['law']}: E_μ = {with_unit(micro['E_mu'], 'Pa')}, r̃ = {micro['r_mu_ratio']:.4f},{varied}"
        f" ρ_μ = {with_unit(micro['rho_mu'], 'kg/m³')}"
    )


def _tests(study: Study, results: Mapping[str, Any]) -> Table:
    published = study.reference.errors if study.reference else {}
    table = Table(header_style="bold", **TABLE)
    table.add_column("  test", no_wrap=True)
    columns = ("measured", "theory", "error", "± scatter", "Timoshenko", "refined")
    for name in (*columns, *(["paper"] if published else [])):
        table.add_column(name, justify="right", no_wrap=True)
    for name, row in results["tests"].items():
        cells = [
            with_unit(row["measured"], row["unit"]),
            with_unit(row["theory"], row["unit"]),
            signed_percent(row["error"]),
            "–" if row["scatter"] is None else percent(row["scatter"]),
            *(_mean([one["tests"][name][f"error_{theory}"] for one in results["packings"]])
              for theory in ("timoshenko", "refined")),
        ]
        if published:
            cells.append(percent(published[name]) if name in published else "")
        of = f", {FAILURE_TESTS[name].figure.quantity}" if row["unit"] == "-" and name in FAILURE_TESTS else ""
        table.add_row(f"  {name}{of}", *cells)
    return table


def _mean(errors: Sequence[float | None]) -> str:
    known = [error for error in errors if error is not None]
    return signed_percent(sum(known) / len(known)) if known else ""
