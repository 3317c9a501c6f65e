"""Where scans are worked on: in this process, or by Dask on this machine and others."""

from __future__ import annotations

import contextlib
import tempfile
import time
from typing import Any, Callable, Dict, Iterator, List, NamedTuple, Optional, Sequence

from .. import _symscene
from ._manifest import Scan
from ._task import Settings, run_scan, write_record

Tell = Callable[[str], object]

_TELL_EVERY = 2.0  # s
_WINDOW = 1000  # scans that the scheduler knows of at a time; more where there are more workers


class Cluster(NamedTuple):
    """Which workers of Dask there are. At most one of these is given."""

    workers: int = 1  # processes on this machine; 1: this process, without Dask
    hosts: Sequence[str] = ()  # machines that ssh reaches; the first also runs the scheduler
    workers_per_host: int = 1
    scheduler: str = ""  # address of a scheduler that runs: "tcp://10.0.0.1:8786"


def shard(scans: Sequence[Scan], index: int, count: int) -> List[Scan]:
    """The scans of the shard `index` of `count`, from 1: every count-th one."""
    if count < 1 or not 1 <= index <= count:
        _symscene.refuse("shard", "i/n with 1 <= i <= n", f"{index}/{count}")
    return list(scans[index - 1 :: count])


class _Progress:
    """Counts of scans as text."""

    def __init__(self, total: int, tell: Optional[Tell]) -> None:
        self.total, self._tell = total, tell
        self.counts: Dict[str, int] = {"done": 0, "skipped": 0, "failed": 0}
        self._start = self._told = time.monotonic()

    def add(self, status: str) -> None:
        self.counts[status] += 1
        now = time.monotonic()
        if now - self._told >= _TELL_EVERY or sum(self.counts.values()) == self.total:
            self._told = now
            self.tell(now - self._start)

    def tell(self, seconds: float) -> None:
        if self._tell is None:
            return
        ended = sum(self.counts.values())
        rate = ended / max(seconds, 1e-9)
        text = f"{ended} of {self.total} scans"
        for status in ("skipped", "failed"):
            if self.counts[status]:
                text += f", {self.counts[status]} {status}"
        self._tell(f"{text}, {rate:.1f} per second, {(self.total - ended) / rate:.0f} s left")


def _give_up(scan: Scan, settings: Settings, error: BaseException) -> str:
    message = f"{type(error).__name__}: {error}".splitlines()[0]
    write_record(scan, settings, "failed", message=message, objects=[])
    return "failed"


def _run_here(scans: Sequence[Scan], settings: Settings, retries: int, progress: _Progress) -> None:
    for scan in scans:
        for attempt in range(retries + 1):
            try:
                progress.add(run_scan(scan, settings))
                break
            except Exception as error:  # noqa: BLE001: what a scan raises must not end the others
                if attempt == retries:
                    progress.add(_give_up(scan, settings, error))


def _distributed() -> Any:
    try:
        import distributed
    except ImportError:
        _symscene.refuse("workers", "Dask's package distributed (python3-distributed)", "none")
    return distributed


@contextlib.contextmanager
def _client(cluster: Cluster, retries: int) -> Iterator[Any]:
    """A client of Dask. Workers that die are restarted; a scan is given up after retries + 1 of them."""
    distributed = _distributed()
    import dask

    with contextlib.ExitStack() as stack:
        stack.enter_context(
            dask.config.set({"distributed.scheduler.allowed-failures": retries})
        )
        if cluster.scheduler:
            yield stack.enter_context(distributed.Client(cluster.scheduler))
            return
        folder = stack.enter_context(tempfile.TemporaryDirectory())
        if cluster.hosts:
            made = distributed.SSHCluster(
                [cluster.hosts[0], *cluster.hosts],
                worker_options={"nthreads": 1, "n_workers": cluster.workers_per_host},
            )
        else:
            made = distributed.LocalCluster(
                n_workers=cluster.workers,
                threads_per_worker=1,
                processes=True,
                memory_limit=0,  # none: a scan is not divided
                dashboard_address=None,
                local_directory=folder,
            )
        yield stack.enter_context(distributed.Client(stack.enter_context(made)))


def _run_by_dask(
    scans: Sequence[Scan], settings: Settings, cluster: Cluster, retries: int, progress: _Progress
) -> None:
    with _client(cluster, retries) as client:
        window = max(_WINDOW, 10 * len(client.scheduler_info()["workers"]))
        rest = iter(scans)
        scan_of: Dict[Any, Scan] = {}

        def submit(scan: Scan) -> Any:
            future = client.submit(run_scan, scan, settings, pure=False, retries=retries)
            scan_of[future.key] = scan
            return future

        ended = _distributed().as_completed([submit(scan) for _, scan in zip(range(window), rest)])
        for future in ended:
            scan = scan_of.pop(future.key)
            try:
                progress.add(future.result())
            except Exception as error:  # noqa: BLE001: as above, and workers that died
                progress.add(_give_up(scan, settings, error))
            for following in rest:
                ended.add(submit(following))
                break


def run(
    scans: Sequence[Scan],
    settings: Settings,
    cluster: Cluster = Cluster(),
    *,
    retries: int = 2,
    tell: Optional[Tell] = None,
) -> Dict[str, int]:
    """Segment scans; return how many are "done", "skipped" (done before) and "failed".

    cluster: which workers. All must see the same folders and have this package.
    retries: how often a scan is tried again whose worker died or that raised what is not InputError.
    tell: is called with a line of progress at most every 2 s.

    Raises InputError if Dask is needed and not installed.
    """
    progress = _Progress(len(scans), tell)
    if cluster.workers > 1 or cluster.hosts or cluster.scheduler:
        _run_by_dask(scans, settings, cluster, retries, progress)
    else:
        _run_here(scans, settings, retries, progress)
    return progress.counts
