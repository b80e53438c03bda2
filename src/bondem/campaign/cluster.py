"""Workers of a campaign: processes of this machine, SLURM jobs, or any Dask cluster.

A Dask scheduler executes all code that a client sends. A local cluster therefore listens on the loopback interface
only, and a cluster across machines speaks TLS with credentials that end with the campaign.
"""

import logging
import os
import warnings
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, Protocol, TypeVar

from bondem._checks import count
from bondem._extras import needed
from bondem.campaign.sweep import Slurm
from bondem.errors import InputError, UnprotectedClusterWarning

# Number of workers that may die during a task before the task fails.
_DEATHS = 5
# Time limit for the connection to a scheduler.
_PATIENCE = "10s"
# Address of the status pages of a cluster, for users of this machine only.
_LOOPBACK = "127.0.0.1:0"
_ROLES = ("scheduler", "worker", "client")
# Intervals at which Dask monitors itself; its defaults, up to 100 Hz, cost 9 % of two busy cores, these cost 1 %.
_QUIET = {
    "distributed.worker.profile.enabled": False,
    "distributed.worker.memory.monitor-interval": "2s",
    "distributed.admin.tick.interval": "1s",
    "distributed.admin.system-monitor.interval": "5s",
}


class _Named(Protocol):
    @property
    def name(self) -> str: ...


Named = TypeVar("Named", bound=_Named)


@contextmanager
def connected(
    *, workers: int | None = None, address: str | None = None, slurm: Slurm | None = None, shared: Path | None = None
) -> Iterator[Any]:
    """Yield the client of a Dask cluster; a cluster that is started here ends with the block.

    Args:
        workers: number of processes on this machine, with one thread each; None for one per core.
        address: scheduler address of an existing cluster, such as "tls://host:8786".
        slurm: SLURM jobs to request.
        shared: folder that the machines of SLURM jobs share, for their credentials.

    Raises:
        InputError: no such scheduler, or fewer than one worker.
        MissingDependencyError: Dask, or the library for credentials, is not installed.

    Warns:
        UnprotectedClusterWarning: the scheduler of `address` is on another machine and does not use TLS.
    """
    distributed, config = needed("dask.distributed", "campaign"), needed("dask", "campaign").config
    logging.getLogger("distributed").setLevel(logging.CRITICAL)  # rows report failures
    settings = {
        "distributed.scheduler.allowed-failures": _DEATHS,
        "distributed.comm.timeouts.connect": _PATIENCE,
        "distributed.worker.daemon": False,
        **_QUIET,
    }
    with config.set(settings):
        if address is not None:
            _require_protected(address)
            try:
                client = distributed.Client(address, timeout=_PATIENCE)
            except (OSError, ValueError) as error:
                reason = str(error) or type(error).__name__
                raise InputError(
                    f"there is no Dask scheduler at '{address}' ({reason}); start one with: dask scheduler"
                ) from None
            with client:
                yield client
            return
        if slurm is not None:
            with slurm_cluster(slurm, shared or Path()) as cluster, distributed.Client(cluster) as client:
                cluster.scale(jobs=slurm.jobs)
                yield client
        else:
            number = count("campaign", "workers", workers or os.cpu_count() or 1, least=1)
            with distributed.LocalCluster(
                n_workers=number, threads_per_worker=1, host="127.0.0.1", dashboard_address=_LOOPBACK,
                silence_logs=logging.CRITICAL,
            ) as local, distributed.Client(local) as client:  # fmt: skip
                yield client


def submitted(
    client: Any, work: Callable[[Named, Path], Any], asked: Iterable[Named], out: Path
) -> Iterator[tuple[Any, Named]]:
    """Submit tasks and yield each finished one with its request, in the order of completion.

    Args:
        client: client of a cluster.
        work: function of a task and the folder, called on a worker.
        asked: tasks, each with a unique name.
        out: folder that all workers share.
    """
    jobs = {client.submit(work, one, out, key=f"bondem-{one.name}", pure=False): one for one in asked}
    for job in needed("dask.distributed", "campaign").as_completed(list(jobs)):
        yield job, jobs.pop(job)
        job.release()


@contextmanager
def slurm_cluster(slurm: Slurm, shared: Path) -> Iterator[Any]:
    """Yield a dask-jobqueue cluster without jobs yet; its `.job_script()` returns the script of a job.

    Args:
        slurm: options of the jobs.
        shared: folder for the credentials, which all jobs can read.

    Raises:
        MissingDependencyError: dask-jobqueue or cryptography is not installed.
    """
    jobqueue = needed("dask_jobqueue.slurm", "campaign")
    with _credentials(shared) as security, jobqueue.SLURMCluster(
        queue=slurm.queue, account=slurm.account, cores=slurm.cores, processes=slurm.cores, memory=slurm.memory,
        walltime=slurm.walltime, job_extra_directives=list(slurm.directives), security=security,
        scheduler_options={"dashboard": False, "dashboard_address": _LOOPBACK},
        worker_extra_args=["--no-dashboard", "--dashboard-address", _LOOPBACK],
    ) as cluster:  # fmt: skip
        yield cluster


@contextmanager
def _credentials(shared: Path) -> Iterator[Any]:
    """Yield new TLS credentials, in files that only the user can read and that are deleted after the block."""
    distributed = needed("dask.distributed", "campaign")
    needed("cryptography.x509", "campaign")
    made = distributed.Security.temporary().get_tls_config_for_role("worker")
    with TemporaryDirectory(prefix=".credentials-", dir=shared) as folder:
        files = {name: Path(folder).resolve() / f"{name}.pem" for name in made if made[name]}
        for name, file in files.items():
            file.touch(mode=0o600)
            file.write_text(made[name])
        ends = {f"tls_{role}_{name}": str(files[name]) for role in _ROLES for name in ("cert", "key")}
        yield distributed.Security(require_encryption=True, tls_ca_file=str(files["ca_file"]), **ends)


def _require_protected(address: str) -> None:
    """Issue an UnprotectedClusterWarning for an address of another machine without TLS, where anyone may run code."""
    scheme, _, rest = address.rpartition("://")
    host = rest.rpartition(":")[0].strip("[]")
    if scheme in ("", "tcp") and host not in ("localhost", "::1") and not host.startswith("127."):
        warnings.warn(
            f"the scheduler at '{address}' does not use TLS: anyone who reaches it can run code as its user; start it"
            " with certificates and give tls://, or keep it in a network that you trust",
            UnprotectedClusterWarning, stacklevel=3,
        )  # fmt: skip
