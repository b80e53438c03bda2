"""Workers of a campaign: processes of this machine, SLURM jobs, or any Dask cluster."""

import logging
import os
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Protocol, TypeVar

from bondem._checks import count
from bondem._extras import needed
from bondem.campaign.sweep import Slurm
from bondem.errors import InputError

# A task is given up when so many workers have died over it.
_DEATHS = 5
# Nobody but this machine reaches a local cluster: its scheduler, its workers and its page.
_HERE = "127.0.0.1"
# How long to wait for a scheduler [s].
_PATIENCE = "10s"
# What Dask does beside the work, up to a hundred times a second: 9 % of two cores that both work, 1 % with these.
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
    *, workers: int | None = None, address: str | None = None, slurm: Slurm | None = None
) -> Iterator[Any]:
    """Connect to a cluster and yield its client; a cluster started here is closed at the end of the block.

    Args:
        workers: number of processes of this machine with one thread each; None for one per core.
        address: scheduler address of an existing cluster, such as "tcp://host:8786".
        slurm: SLURM jobs to request.

    Raises:
        InputError: no such scheduler, or fewer than one worker.
        MissingDependencyError: Dask is not installed.
    """
    distributed, config = needed("dask.distributed", "campaign"), needed("dask", "campaign").config
    logging.getLogger("distributed").setLevel(logging.CRITICAL)  # what fails is told by rows
    settings = {
        "distributed.scheduler.allowed-failures": _DEATHS,
        "distributed.comm.timeouts.connect": _PATIENCE,
        "distributed.worker.daemon": False,
        **_QUIET,
    }
    with config.set(settings):
        if address is not None:
            try:
                client = distributed.Client(address, timeout=_PATIENCE)
            except (OSError, ValueError) as error:
                reason = str(error) or type(error).__name__
                raise InputError(
                    f"address = '{address}': no Dask scheduler there ({reason}); start one with: dask scheduler"
                ) from None
            with client:
                yield client
            return
        if slurm is not None:
            cluster: Any = slurm_cluster(slurm, security=temporary_credentials())
            cluster.scale(jobs=slurm.jobs)
        else:
            number = count("campaign", "workers", workers or os.cpu_count() or 1, least=1)
            cluster = distributed.LocalCluster(
                n_workers=number, threads_per_worker=1, host=_HERE, dashboard_address=f"{_HERE}:0",
                silence_logs=logging.CRITICAL,
            )  # fmt: skip
        with cluster, distributed.Client(cluster) as client:
            yield client


def submitted(
    client: Any, work: Callable[[Named, Path], Any], asked: Iterable[Named], out: Path
) -> Iterator[tuple[Any, Named]]:
    """Submit work and yield each finished task with its specimen, in the order of completion.

    Args:
        client: client of a cluster.
        work: function of a specimen and the folder, called on a worker.
        asked: specimens, each with a unique name.
        out: folder that all workers share.
    """
    jobs = {client.submit(work, one, out, key=f"bondem-{one.name}", pure=False): one for one in asked}
    for job in needed("dask.distributed", "campaign").as_completed(list(jobs)):
        yield job, jobs.pop(job)
        job.release()


def temporary_credentials() -> Any:
    """Create new TLS keys for one campaign; a scheduler executes code of every client that has them.

    Raises:
        MissingDependencyError: Dask or cryptography is not installed.
    """
    needed("cryptography", "campaign")
    return needed("dask.distributed", "campaign").Security.temporary()


def slurm_cluster(slurm: Slurm, *, security: Any = None) -> Any:
    """Create the dask-jobqueue cluster, before any job is requested; `.job_script()` is the script of a job.

    Args:
        slurm: options of the jobs.
        security: keys for TLS between scheduler and workers; they lie in the home folder, readable by its owner only,
            as long as the cluster exists. None for no TLS.

    Raises:
        MissingDependencyError: dask-jobqueue is not installed.
    """
    keys = {} if security is None else {
        "security": security, "protocol": "tls://", "shared_temp_directory": str(Path.home()),
    }  # fmt: skip
    return needed("dask_jobqueue.slurm", "campaign").SLURMCluster(
        queue=slurm.queue, account=slurm.account, cores=slurm.cores, processes=slurm.cores, memory=slurm.memory,
        walltime=slurm.walltime, job_extra_directives=list(slurm.directives), scheduler_options={"dashboard": False},
        **keys,
    )  # fmt: skip
