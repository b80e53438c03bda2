"""Campaigns: what they vary, on a local cluster whose workers die, run again, in a table."""

import contextlib
import json
import os
import shlex
import signal
import subprocess
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import psutil
import pytest
from click.testing import CliRunner

import bondem as bd
from bondem._extras import needed
from bondem.campaign.cluster import _require_protected, connected, slurm_cluster
from bondem.campaign.sweep import parse_campaign
from bondem.campaign.work import carry_out, scalars
from bondem.cli.campaign import command
from bondem.cli.check import command as check
from bondem.errors import InputError, MissingDependencyError, StudyError, UnprotectedClusterWarning
from bondem.study.pipeline import run_study
from bondem.study.programme import read
from bondem.study.study_file import parse_study

EXAMPLE = Path("examples/campaign.toml")
# Packed and checked only: a fraction of a second each.
PACKED: dict[str, Any] = {
    "name": "packings", "seed": 3, "output": {"figures": False},
    "specimen": {"shape": "cell", "size": [0.01, 0.01, 0.01], "count": 100},
    "campaign": {"seeds": 2, "vary": {"specimen.count": [100, 120]}},
}  # fmt: skip


def campaign(**changed: Any) -> bd.Campaign:
    return parse_campaign(PACKED | {"campaign": PACKED["campaign"] | changed})


def test_every_value_goes_with_every_other_and_every_seed() -> None:
    asked = bd.read_campaign(EXAMPLE)
    assert asked.keys == ("specimen.count", "failure.tension", "seed")
    assert len({one.name for one in asked.specimens}) == 2 * 2 * 5
    one = asked.specimens[7]
    assert dict(one.varied) == {"specimen.count": 200, "failure.tension": "4 MPa", "seed": 3}
    study = parse_study(one.document)
    assert (study.packings, study.seed, study.specimen.count) == (1, 3, 200)  # type: ignore[union-attr]
    assert isinstance(study.failure, bd.Rankine)
    assert study.failure.tension == 4e6


def test_names_follow_the_input_and_the_code() -> None:
    """Another value of what is not varied makes other specimens, that of the others does not."""
    names = [one.name for one in campaign().specimens]
    assert [one.name for one in campaign(seeds=[3, 4]).specimens] == names
    assert [one.name for one in campaign(seeds=[3]).specimens] == names[::2]
    other = parse_campaign(PACKED | {"specimen": PACKED["specimen"] | {"spread": 0.1}})
    assert not set(names) & {one.name for one in other.specimens}


@pytest.mark.parametrize(("changed", "words"), [
    ({"seeds": 0}, "'campaign.seeds' = 0; give how many, or a list"),
    ({"seeds": [1, 1]}, "contains a seed twice"),
    ({"seeds": [1, True]}, "give how many"),
    ({"seed": 3}, "did you mean 'campaign.seeds'"),
    ({"vary": {"specimen.count": 3}}, "give a list of values of 'specimen.count'"),
    ({"vary": {"specimen": {"count": [100, 100]}}}, "contains a value twice"),
    ({"vary": {"specimen.radius": [3e-3, "3 mm"]}}, "contains a value twice"),
    ({"vary": {"specimen.cuont": [100]}}, "did you mean 'specimen.count'"),
    ({"vary": {"specimen.count": [100, -1]}}, r"= -1.*\(specimen of specimen.count = -1, seed = 3\)"),
    ({"vary": {"seed": [1]}}, "give seeds as 'campaign.seeds'"),
    ({"vary": {"name.x": [1]}}, "'name' is not a table"),
    ({"slurm": {"cores": 0}}, "'campaign.slurm.cores' = 0"),
    ({"slurm": {"directives": ["a\nb"]}}, "a list of texts of one line each"),
    ({"seeds": 10_000_000}, "give at most 1000000"),
])  # fmt: skip
def test_a_wrong_campaign_is_refused_before_any_work(changed: dict[str, Any], words: str) -> None:
    with pytest.raises(StudyError, match=words):
        campaign(**changed)


def test_other_files_are_no_campaigns() -> None:
    for data, words in (
        ({key: PACKED[key] for key in ("name", "specimen")}, ".campaign. is missing"),
        (PACKED | {"packings": 2}, "'packings' is not an option"),
        (PACKED | {"specimens": []}, "belong to a test programme"),
    ):
        with pytest.raises(StudyError, match=words):
            parse_campaign(data)


def test_other_commands_know_a_campaign(tmp_path: Path) -> None:
    with pytest.raises(StudyError, match="use bondem campaign"):
        read(EXAMPLE)
    outcome = CliRunner().invoke(check, [str(EXAMPLE)])
    assert outcome.exception is None
    assert "20 specimens, varied by specimen.count, failure.tension, seed" in outcome.output
    assert "200 cells" in outcome.output


def test_a_worker_dies_and_all_arrive_once(tmp_path: Path) -> None:
    killed: list[int] = []

    def kill(stage: str, share: float) -> None:
        if not killed and share < 1.0:
            (record, *_) = tmp_path.glob("specimens/*/specimen.json")
            killed.append(int(json.loads(record.read_text())["worker"].rpartition(":")[2]))
            os.kill(killed[0], signal.SIGKILL)

    found = bd.run_campaign(campaign(seeds=2), tmp_path, workers=1, progress=kill)
    assert len(killed) == 1
    assert (found["specimens"], found["finished"], found["failed"]) == (4, 4, [])
    folders = sorted(path.name for path in (tmp_path / "specimens").iterdir())
    assert folders == sorted(one.name for one in campaign(seeds=2).specimens)
    table = bd.campaign_table(tmp_path)
    assert list(table["seed"]) == [3, 4, 3, 4]
    data = bd.campaign_dataset(tmp_path)
    assert data["specimen.coordination_number"].dims == ("count", "seed")
    assert data.sizes == {"count": 2, "seed": 2}
    np.testing.assert_array_equal(data["specimen.elements"].sel(count=120), 120)


@pytest.mark.validate
def test_of_more_seeds_only_those_are_done(tmp_path: Path) -> None:
    bd.run_campaign(campaign(seeds=2), tmp_path, workers=1)
    again = bd.run_campaign(campaign(seeds=3), tmp_path, workers=1)
    assert (again["finished"], again["before"]) == (6, 4)
    assert bd.campaign_dataset(tmp_path).sizes == {"count": 2, "seed": 3}


def test_values_with_units_are_numbers_of_the_table(tmp_path: Path) -> None:
    document = PACKED | {"specimen": PACKED["specimen"] | {"shape": "box"}, "packings": 1}
    varied = {"seeds": 1, "vary": {"specimen.spread": ["40 %", 0.5, "8 %"]}}
    few = parse_campaign(document | {"campaign": varied})
    assert few.specimens[0].varied["specimen.spread"] == "40 %"
    bd.run_campaign(few, tmp_path, workers=1)
    assert bd.campaign_table(tmp_path)["specimen.spread"].tolist() == [0.4, 0.5, 0.08]
    assert bd.campaign_dataset(tmp_path)["spread"].values.tolist() == [0.08, 0.4, 0.5]


def test_specimens_that_cannot_be_done_are_told_with_their_input(tmp_path: Path) -> None:
    # no packing of spheres has as many contacts
    more = campaign(seeds=[4], vary={"specimen.coordination_number": [6.0, 11.95]})
    failed = bd.run_campaign(more, tmp_path, workers=1)
    assert failed["finished"] == 1
    assert [row["varied"] for row in failed["failed"]] == [{"specimen.coordination_number": 11.95, "seed": 4}]
    assert all("11.95" in row["error"] for row in failed["failed"])


def test_a_specimen_is_what_bondem_run_makes(tmp_path: Path) -> None:
    one = campaign().specimens[1]
    (tmp_path / "specimens").mkdir()
    row = carry_out(one, tmp_path)
    left = scalars(json.loads((tmp_path / "specimens" / one.name / "results.json").read_text()))
    alone = scalars(run_study(parse_study(one.document), tmp_path / "alone"))
    for values in (left, alone, row["values"]):
        assert values["specimen.coordination_number"] == alone["specimen.coordination_number"]
        assert values["seed"] == 4
    kept = tmp_path / "specimens" / one.name
    curves = json.loads((kept / "results.json").read_text())["curves"]
    assert curves["distribution"] == ["curves/distribution.csv"]
    for (file,) in curves.values():
        assert (kept / file).read_bytes() == (tmp_path / "alone" / file).read_bytes()
    assert carry_out(one, tmp_path) == row  # as it is there
    assert len(list((tmp_path / "specimens").iterdir())) == 1


def listening() -> set[tuple[str, int]]:
    """Addresses on which this process and its children accept connections."""
    me = psutil.Process()
    found = set()
    for one in (me, *me.children(recursive=True)):
        with contextlib.suppress(psutil.Error):
            found |= {tuple(c.laddr) for c in one.net_connections("tcp") if c.status == psutil.CONN_LISTEN}
    return found


def test_a_local_cluster_is_reached_from_this_machine_only() -> None:
    before = listening()
    with connected(workers=1) as client:
        assert client.dashboard_link.startswith("http://127.0.0.1:")
        opened = listening() - before
    assert len(opened) >= 3  # scheduler, dashboard, worker
    assert {host for host, _ in opened} == {"127.0.0.1"}


def test_jobs_of_slurm_speak_tls_with_credentials_of_their_own(tmp_path: Path) -> None:
    """The command of a job, started here, joins the cluster; a client without its credentials does not."""
    pytest.importorskip("cryptography")
    distributed = needed("dask.distributed", "campaign")
    asked = bd.Slurm("long", "glass", cores=1, memory="1GB", walltime="00:10:00")
    before = listening()
    with slurm_cluster(asked, tmp_path) as cluster:
        assert cluster.scheduler_address.startswith("tls://")
        ports = [port for host, port in listening() - before if host != "127.0.0.1"]
        assert set(ports) == {int(cluster.scheduler_address.rpartition(":")[2])}  # and no page of the cluster
        keys = list(tmp_path.glob(".credentials-*/*.pem"))
        assert len(keys) == 3
        assert all(key.stat().st_mode & 0o077 == 0 for key in keys)
        with pytest.raises((OSError, TypeError)):
            distributed.Client(cluster.scheduler_address, timeout="2s")
        job = subprocess.Popen(shlex.split(cluster.job_script().strip().splitlines()[-1]), stderr=subprocess.DEVNULL)
        try:
            with distributed.Client(cluster, timeout="30s") as client:
                assert client.submit(abs, -3).result(timeout=60) == 3
        finally:
            job.terminate()
            job.wait()
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(("address", "unprotected"), [
    ("tcp://node7:8786", True), ("10.0.0.7:8786", True), ("tls://node7:8786", False), ("tcp://127.0.0.1:8786", False),
    ("localhost:8786", False), ("tcp://[::1]:8786", False), ("inproc://x", False),
])  # fmt: skip
def test_schedulers_elsewhere_without_tls_are_doubted(address: str, unprotected: bool) -> None:
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        _require_protected(address)
    assert [one.category is UnprotectedClusterWarning for one in caught] == [True] * unprotected


def test_a_job_of_slurm_is_what_the_file_asks_for(tmp_path: Path) -> None:
    pytest.importorskip("cryptography")
    asked = bd.Slurm("long", "glass", cores=16, memory="32GB", walltime="04:00:00", directives=("--exclusive",))
    with slurm_cluster(asked, tmp_path) as cluster:
        script = cluster.job_script()
    for line in ("#SBATCH -p long", "#SBATCH -A glass", "#SBATCH --cpus-per-task=16", "#SBATCH --mem=30G",
                 "#SBATCH -t 04:00:00", "#SBATCH --exclusive"):  # fmt: skip
        assert line in script.splitlines()
    for option in ("--nworkers 16", "--nthreads 1", "--memory-limit 1.86GiB"):
        assert option in script


def test_no_scheduler_no_table_and_two_clusters_are_one_line_each(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="there is no Dask scheduler at 'nonsense://x'"):
        bd.run_campaign(campaign(), tmp_path, address="nonsense://x")
    with pytest.raises(InputError, match="give the folder of a campaign"):
        bd.campaign_table(tmp_path / "none")
    for wrong in (3, None, "a\0b"):
        for reader in (bd.campaign_table, bd.campaign_dataset, bd.read_campaign):
            with pytest.raises(InputError, match="give a path"):
                reader(wrong)  # type: ignore[arg-type]
    with pytest.raises(InputError, match=r"a campaign from bd.read_campaign"):
        bd.run_campaign(PACKED, tmp_path)  # type: ignore[arg-type]
    with pytest.raises(MissingDependencyError, match=r'clone of bondem, run pip install -e "\.\[campaign\]"'):
        needed("a_library_nobody_has", "campaign")
    both = CliRunner().invoke(command, [str(EXAMPLE), "--out", str(tmp_path), "--workers", "1", "--address", "tcp://x:1"])
    assert isinstance(both.exception, InputError)
