"""Specimens of a campaign, from a study file with a table [campaign]."""

import contextlib
import copy
import hashlib
import math
import re
import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import product
from pathlib import Path
from typing import Any

from bondem._checks import place, shown
from bondem._units import quantity
from bondem.errors import InputError, StudyError
from bondem.io.text_file import read_text
from bondem.study.declared import KeyTable, Number
from bondem.study.keys import STUDY
from bondem.study.programme import document_hash
from bondem.study.programme_run import code_hash
from bondem.study.study_file import Study, parse_study, read_toml
from bondem.study.toml_table import TomlTable

# Largest number of specimens of a campaign; more are probably a mistake in [campaign].
_MOST = 1_000_000


@dataclass(frozen=True)
class CampaignSpecimen:
    """Specimen of a campaign, as a study of one packing.

    Attributes:
        name: name of its folder, from varied values and a hash.
        varied: varied values by dotted key, with the seed.
        document: study as a TOML document.
        folder: folder of the files that the study names.
        inputs: hash of the study, of its files and of the code of bondem.
    """

    name: str
    varied: Mapping[str, Any]
    document: Mapping[str, Any]
    folder: Path
    inputs: str


@dataclass(frozen=True)
class Slurm:
    """Options of SLURM jobs for dask-jobqueue; None selects the default of dask-jobqueue.

    Attributes:
        queue: partition.
        account: account to charge.
        cores: number of cores per job, each a worker.
        memory: memory per job, in the notation of Dask, such as "16GB".
        walltime: time limit per job, "HH:MM:SS".
        jobs: number of jobs.
        directives: further options, each written after #SBATCH in a line of the script.
    """

    queue: str | None = None
    account: str | None = None
    cores: int = 1
    memory: str = "4GB"
    walltime: str = "01:00:00"
    jobs: int = 1
    directives: tuple[str, ...] = ()


@dataclass(frozen=True)
class Campaign:
    """Campaign: specimens, each a study of one packing.

    Attributes:
        name: name of the study.
        keys: dotted keys of the varied values, in the order of the columns, "seed" last.
        specimens: specimens, in the order of the file.
        slurm: SLURM jobs to request; None for a local cluster, or an existing one.
    """

    name: str
    keys: tuple[str, ...]
    specimens: tuple[CampaignSpecimen, ...]
    slurm: Slurm | None = None


def read_campaign(path: str | Path) -> Campaign:
    """Read a study file with a table [campaign].

    Every specimen is read like a study of `bondem run`, so that wrong values are found before any work.

    Raises:
        StudyError: no such file, invalid TOML, or a key of any specimen that is unknown, missing or out of range.
        InputError: `path` is neither text nor a path.
    """
    path = place("path", path)
    return read_toml(path, lambda data: parse_campaign(data, folder=path.parent))


def is_campaign(path: str | Path) -> bool:
    """Return True if a file has a table [campaign]; False if it has none or cannot be read."""
    try:
        return "campaign" in tomllib.loads(read_text(Path(path)))
    except (OSError, ValueError, RecursionError):
        return False


def parse_campaign(data: Mapping[str, Any], *, folder: Path = Path()) -> Campaign:
    """Create the campaign of a TOML document.

    Args:
        data: the document.
        folder: folder of the files that it names.

    Raises:
        StudyError: a key that is unknown, missing or out of range.
    """
    if "campaign" not in data:
        raise StudyError("[campaign] is missing; give one with 'seeds' or [campaign.vary], or use bondem run")
    if "specimens" in data:
        raise StudyError("[[specimens]] belong to a test programme; give one [specimen], which the campaign varies")
    if data.get("packings", 1) != 1:
        raise StudyError(
            "'packings' is not an option of a campaign, whose specimens have one packing each; give 'campaign.seeds'"
        )
    shared = {key: value for key, value in data.items() if key != "campaign"}
    first = TomlTable(shared, STUDY).count("seed", default=Study.seed)
    with TomlTable(data, STUDY).section("campaign") as table:
        seeds, vary = _seeds(table, first), _vary(table)
        slurm = table.optional("slurm", _slurm)
    total = len(seeds) * math.prod(len(values) for _, values in vary)
    if total > _MOST:
        raise StudyError(f"'campaign' has {total} specimens; give at most {_MOST}")
    code, keys = code_hash(), (*(key for key, _ in vary), "seed")
    specimens = tuple(
        _specimen(shared, dict(zip(keys, chosen, strict=True)), folder, code)
        for chosen in product(*(values for _, values in vary), seeds)
    )
    return Campaign(str(data["name"]), keys, specimens, slurm)


def _seeds(table: TomlTable, first: int) -> list[int]:
    if not table.has("seeds"):
        return [first]
    given = table.whole_numbers("seeds")
    if isinstance(given, int):
        return list(range(first, first + given))
    if len(set(given)) < len(given):
        raise StudyError("'campaign.seeds' contains a seed twice; remove one")
    return list(given)


def _vary(table: TomlTable) -> list[tuple[str, list[Any]]]:
    found = []
    for key, values in flat(table.section("vary").all()):
        where = f"campaign.vary.{key}"
        if key in ("seed", "packings", "name") or key.partition(".")[0] == "campaign":
            raise StudyError(f"'{where}': cannot be varied; give seeds as 'campaign.seeds'")
        if not isinstance(values, list) or not values:
            raise StudyError(f"'{where}' = {shown(values)}: not a list; give a list of values of '{key}'")
        plain = [in_si(key, value) for value in values]
        if any(plain.count(value) > 1 for value in plain):
            raise StudyError(f"'{where}' contains a value twice; remove one")
        found.append((key, values))
    return found


def in_si(key: str, value: Any) -> Any:
    """Return a value of the study's dotted key; a text with a unit as a number in SI units."""
    known: Any = STUDY
    for name in key.split("."):
        known = known.keys.get(name) if isinstance(known, KeyTable) else None
    if isinstance(known, Number) and isinstance(value, str):
        with contextlib.suppress(InputError):  # the study refuses the text, or its criterion has another unit
            return quantity(key, value, known.unit)
    return value


def flat(table: Mapping[str, Any], path: str = "") -> Iterator[tuple[str, Any]]:
    """Yield dotted keys and values of nested tables; `"material.E" = […]` and `material.E = […]` are equivalent."""
    for key, value in table.items():
        name = f"{path}.{key}" if path else key
        if isinstance(value, Mapping):
            yield from flat(value, name)
        else:
            yield name, value


def _slurm(table: TomlTable) -> Slurm:
    with table:
        return Slurm(
            queue=table.text("queue", default="") or None, account=table.text("account", default="") or None,
            cores=table.count("cores", default=Slurm.cores), memory=table.text("memory", default=Slurm.memory),
            walltime=table.text("walltime", default=Slurm.walltime),
            jobs=table.count("jobs", default=Slurm.jobs), directives=table.lines("directives"),
        )  # fmt: skip


def _specimen(shared: Mapping[str, Any], varied: Mapping[str, Any], folder: Path, code: str) -> CampaignSpecimen:
    document: dict[str, Any] = copy.deepcopy(dict(shared)) | {"packings": 1}
    for key, value in varied.items():
        _put(document, key, copy.deepcopy(value))
    values = ", ".join(f"{key} = {shown(value)}" for key, value in varied.items())
    try:
        parse_study(document, folder=folder)
    except StudyError as error:
        raise StudyError(f"{error} (specimen of {values})") from None
    inputs = hashlib.sha256(f"{code} {document_hash(document, folder)}".encode()).hexdigest()
    words = "_".join(f"{key.rpartition('.')[2]}-{_slug(value)}" for key, value in varied.items())
    return CampaignSpecimen(f"{words[:80]}_{inputs[:10]}", dict(varied), document, folder, inputs)


def _put(document: dict[str, Any], key: str, value: Any) -> None:
    *tables, last = key.split(".")
    inner = document
    for name in tables:
        inner = inner.setdefault(name, {})
        if not isinstance(inner, dict):
            raise StudyError(f"'campaign.vary.{key}': '{name}' is not a table of the study; correct the key")
    inner[last] = value


def _slug(value: Any) -> str:
    return re.sub(r"[^A-Za-z0-9.+-]+", "", str(value))[:20] or "x"
