"""Runs on the workers of a Dask cluster that is there already (the `sweep` extra).

https://distributed.dask.org/en/stable/client.html
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import islice
from typing import Any

from sandbox._version import __version__
from sandbox.engine.arithmetic_version import ARITHMETIC
from sandbox.errors import MissingDependencyError, SandboxError
from sandbox.sweeps.runners import Job
from sandbox.sweeps.study import Outcome, Study, make_run

_PATIENCE = "10s"
"""How long a scheduler may take to answer."""
_AHEAD = 8
"""Runs that are at the cluster for each of its threads."""


def run_on_cluster(study: Study, jobs: Iterable[Job], address: str) -> Iterator[Outcome]:
    """By the workers of the scheduler at `address`, such as "tcp://10.0.0.1:8786".

    Raises `MissingDependencyError` where Dask is not installed, and `SandboxError` where nobody answers, or where
    workers lack this package, or have another version of it, which might give other bits.
    """
    distributed = _require()
    try:
        distributed.comm.resolve_address(address)  # a client of no address at all takes 20 s to end, and complains
        client = distributed.Client(address, timeout=_PATIENCE, set_as_default=False)
    except (OSError, ValueError, TimeoutError) as error:
        raise SandboxError(f"--scheduler {address}: no Dask scheduler answers there ({_words(error)})") from None
    with client, client.as_current():
        _check_workers(client, address)
        shared = client.scatter(study, broadcast=True)
        yield from _outcomes(client, distributed.as_completed, shared, iter(jobs))


def versions() -> tuple[str, int]:
    """What a worker must have in common with this process. Runs on the worker."""
    return __version__, ARITHMETIC


def _require() -> Any:
    try:
        import distributed
    except ImportError as error:
        text = "--scheduler talks to a cluster by Dask, which is not installed: python -m pip install distributed"
        raise MissingDependencyError(text) from error
    return distributed


def _check_workers(client: Any, address: str) -> None:
    if not client.scheduler_info(n_workers=-1)["workers"]:
        raise SandboxError(f"--scheduler {address}: the cluster has no workers; start some with dask worker {address}")
    try:
        found = client.run(versions)
    except Exception as error:  # whatever a worker's Python says when it cannot import this package
        text = f"its workers cannot import this package ({_words(error)}); install it where they run"
        raise SandboxError(f"--scheduler {address}: {text}") from None
    for worker, theirs in found.items():
        if tuple(theirs) != versions():
            text = f"the worker {worker} has sandbox {theirs[0]}, arithmetic {theirs[1]}"
            mine = f"this is {__version__}, arithmetic {ARITHMETIC}"
            raise SandboxError(f"--scheduler {address}: {text}; {mine}. Runs there might give other bits")


def _outcomes(client: Any, as_completed: Any, shared: Any, jobs: Iterator[Job]) -> Iterator[Outcome]:
    room = _AHEAD * max(1, sum(client.nthreads().values()))

    def submitted(count: int) -> list[Any]:
        # Not pure: Dask would look for equal arguments, and runs have none.
        return [client.submit(make_run, shared, *job, pure=False) for job in islice(jobs, count)]

    done = as_completed(submitted(room))
    try:
        for future in done:
            yield future.result()
            for more in submitted(1):
                done.add(more)
    except (OSError, RuntimeError) as error:
        raise SandboxError(f"the cluster was lost: {_words(error)}") from None


def _words(error: BaseException) -> str:
    return " ".join(str(error).split()) or type(error).__name__
