"""Table of a campaign: one row per specimen, one column per varied value and per result."""

import json
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

from bondem._checks import place
from bondem._extras import needed
from bondem.campaign.sweep import in_si
from bondem.errors import InputError
from bondem.io.atomic import replacing

TABLE = "table.parquet"


def require_tables() -> None:
    """Check that the libraries which write tables are installed.

    Raises:
        MissingDependencyError: pandas or pyarrow is not installed.
    """
    for module in ("pandas", "pyarrow"):
        needed(module, "campaign")


def write_tables(rows: Iterable[dict[str, Any]], keys: Sequence[str], out: Path) -> None:
    """Write `table.parquet` and `table.csv`, each by one atomic move.

    Args:
        rows: rows of the finished specimens.
        keys: dotted keys of the varied values, the first columns after the name.
        out: folder of the campaign.
    """
    flat = [
        {"name": row["name"], **{key: _plain(in_si(key, row["varied"][key])) for key in keys}, **row["values"]}
        for row in rows
    ]
    frame = needed("pandas", "campaign").DataFrame(flat)
    frame = frame.loc[:, ~frame.columns.duplicated()]
    frame.attrs["varied"] = list(keys)
    with replacing(out / TABLE) as path:
        frame.to_parquet(path)
    with replacing(out / "table.csv") as path:
        frame.to_csv(path, index=False)


def campaign_table(out: str | Path) -> Any:
    """Read the table of a campaign, finished or running.

    Args:
        out: folder of the campaign.

    Returns:
        A pandas.DataFrame with one row per finished specimen. Its columns are the name, varied values (3e6 for
        "3 MPa"), and numbers and texts of its `results.json` by dotted names such as "macro.E" [Pa] and
        "tests.ucs.measured" [Pa].

    Raises:
        InputError: the folder has no table.
        MissingDependencyError: pandas or pyarrow is not installed.
    """
    require_tables()
    path = place("out", out) / TABLE
    try:
        return needed("pandas", "campaign").read_parquet(path)
    except (OSError, ValueError) as error:
        raise InputError(f"'{path}' cannot be read ({error}); give the folder of a campaign") from None


def campaign_dataset(out: str | Path) -> Any:
    """Read the table of a campaign as arrays over the varied values, as for `dataset["macro.E"].mean("seed")`.

    Args:
        out: folder of the campaign.

    Returns:
        An xarray.Dataset with a dimension for each varied value; NaN for specimens that are unfinished or failed.

    Raises:
        InputError: the folder has no table, or the table has no row yet.
        MissingDependencyError: pandas, pyarrow or xarray is not installed.
    """
    frame = campaign_table(out)
    needed("xarray", "campaign")  # imported by to_xarray
    if frame.empty:
        raise InputError(f"'{out}/{TABLE}' has no row yet; try again once a specimen is finished")
    keys = list(frame.attrs["varied"])
    dataset = frame.set_index(keys).to_xarray()
    return dataset.rename({key: key.rpartition(".")[2] for key in keys if _alone(key, keys)})


def _alone(key: str, keys: Sequence[str]) -> bool:
    last = key.rpartition(".")[2]
    return last != key and sum(other.rpartition(".")[2] == last for other in keys) == 1


def _plain(value: Any) -> Any:
    """Return a value for a column of the table; tables and lists as JSON text."""
    return value if isinstance(value, str | int | float | bool) else json.dumps(value, default=str)
