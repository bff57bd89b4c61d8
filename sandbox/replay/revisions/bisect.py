"""Which commit made a run go another way: halving the commits between a good and a bad one."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from sandbox.errors import SandboxError
from sandbox.replay.golden.divergence import Divergence
from sandbox.replay.golden.run import Run
from sandbox.replay.revisions.compare import first_parting, lay_side_by_side
from sandbox.replay.revisions.trace import RevisionError, Trace, trace
from sandbox.replay.revisions.worktree import Commit, Repository, Worktree


@dataclass(frozen=True)
class Skipped:
    """A commit that cannot run this, and why."""

    commit: Commit
    reason: str


@dataclass(frozen=True)
class Found:
    """The commits of which one is the first that goes another way, oldest first: one, unless some cannot run.

    Empty if the bad commit goes the same way as the good one. `divergence` compares the last of them with `good`.
    `good_parts` is the step after which the good commit leaves the recording: 0 if it does not, None if not known.
    """

    suspects: tuple[Commit, ...]
    tried: int
    skipped: tuple[Skipped, ...]
    divergence: Divergence | None = None
    good_parts: int | None = None


@dataclass
class _Search:
    """The search under way: everything that goes the way of `good` is good."""

    tree: Worktree
    run: Run
    no_jit: bool
    good: Trace
    skipped: dict[str, Skipped] = field(default_factory=dict)
    tried: int = 0
    bad: Trace | None = None

    def is_good(self, commit: Commit) -> bool | None:
        """Whether the commit goes the way of the good one; None if it cannot run."""
        try:
            got = trace(self.tree.checkout(commit), self.run, no_jit=self.no_jit)
        except RevisionError as error:
            self.skipped[commit.hash] = Skipped(commit, str(error))
            return None
        self.tried += 1
        if first_parting(self.good, got) is None:
            return True
        self.bad = got  # the one tried last is the earliest
        return False


def bisect(
    repository: Repository,
    run: Run,
    good: Commit,
    bad: Commit,
    no_jit: bool = False,
    on_left: Callable[[int], None] | None = None,
    digests: Sequence[str] = (),
) -> Found:
    """Find the commit after `good` and up to `bad` from which on `run` goes another way than at `good`.

    `digests` are the fingerprints of the recording, if it is one. `on_left` hears how many commits are left to choose
    from. Raises `SandboxError` if `good` does not come before `bad`, `RevisionError` if one of them cannot run it.
    """
    _candidates(repository, [good.hash], bad.hash)  # before anything is run
    with Worktree(repository) as tree:
        first = _at_good(tree, good, run, no_jit)
        parts = first.parts_from(digests) if digests else None
        search = _Search(tree, run, no_jit, first)
        at_bad = search.is_good(bad)
        if at_bad is None:
            raise RevisionError(f"the bad commit {bad} cannot run it: {search.skipped[bad.hash].reason}")
        if at_bad:
            return Found((), search.tried, (), good_parts=parts)
        suspects = _halve(search, repository, good, bad, on_left)
        divergence = _explain(search, good, suspects[-1])
    return Found(suspects, search.tried, tuple(search.skipped.values()), divergence, parts)


def _at_good(tree: Worktree, good: Commit, run: Run, no_jit: bool) -> Trace:
    try:
        return trace(tree.checkout(good), run, no_jit=no_jit)
    except RevisionError as error:
        raise RevisionError(f"the good commit {good} cannot run it: {error}") from None


def _halve(
    search: _Search, repository: Repository, good: Commit, bad: Commit, on_left: Callable[[int], None] | None
) -> tuple[Commit, ...]:
    goods, last = [good.hash], bad.hash
    while True:
        left = _candidates(repository, goods, last)
        open_ones = [name for name in left if name != last and name not in search.skipped]
        if on_left is not None:
            on_left(len(open_ones))
        if not open_ones:
            return tuple(repository.commit(name) for name in left)
        middle = open_ones[(len(open_ones) - 1) // 2]
        verdict = search.is_good(repository.commit(middle))
        if verdict:
            goods.append(middle)
        elif verdict is False:
            last = middle


def _candidates(repository: Repository, goods: list[str], bad: str) -> list[str]:
    """The commits that come after a good one and lead to the bad one, oldest first, the bad one last."""
    excluded = [f"^{name}" for name in goods]
    names = repository.git("rev-list", "--ancestry-path", "--topo-order", "--reverse", bad, *excluded).split()
    if bad in goods:
        raise SandboxError(f"the good and the bad revision are the same one, {bad[:12]}")
    if not names:
        raise SandboxError(f"the good revision {goods[0][:12]} is no ancestor of the bad one {bad[:12]}")
    return names


def _explain(search: _Search, good: Commit, culprit: Commit) -> Divergence | None:
    """How the culprit parts from the good commit."""

    def at(commit: Commit) -> Callable[..., Trace]:
        return lambda dump=(): trace(search.tree.checkout(commit), search.run, dump, search.no_jit)

    assert search.bad is not None
    return lay_side_by_side(
        search.good, search.bad, search.run.steps, search.run.scene.settings.step_rate, (at(good), at(culprit))
    )
