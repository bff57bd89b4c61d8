"""A session as it is played: a live run with undo of all that was done, and with the futures that were left."""

from __future__ import annotations

from collections.abc import Sequence

from sandbox.engine.commands.base import Command
from sandbox.errors import ArgumentError
from sandbox.replay.deeds import Deeds
from sandbox.replay.live_run import BUDGET, LiveRun
from sandbox.replay.moment import Future, Moment, Past, common_prefix, parting
from sandbox.replay.recording.command_words import TimedCommand
from sandbox.replay.recording.tape import Tape
from sandbox.scene import Scene

UNDO_LEVELS, MOST_BRANCHES = 500, 30


class Timeline(LiveRun):
    """Acts are groups of commands that are undone as one: `begin_act` says where one begins.

    A future whose place another one takes becomes one of the `branches`, to which `switch` leads.
    """

    __slots__ = ("_branches", "_deeds", "_redo", "_undo")

    def __init__(
        self, scene: Scene, script: Sequence[TimedCommand] = (), length: int = 0, workers: int = 1, budget: int = BUDGET
    ) -> None:
        super().__init__(scene, script, length, workers, budget)
        self._undo: list[Moment] = []
        self._redo: list[Moment] = []
        self._branches: tuple[Future, ...] = ()
        self._deeds = Deeds()

    @property
    def undo_label(self) -> str | None:
        """What `undo` would take back; None if there is nothing."""
        return self._undo[-1].label if self._undo else None

    @property
    def redo_label(self) -> str | None:
        """What `redo` would bring back; None if there is nothing."""
        return self._redo[-1].label if self._redo else None

    @property
    def branches(self) -> Sequence[Future]:
        """The other futures, the latest one last. Undo brings back those of its time."""
        return self._branches

    @property
    def past(self) -> Past:
        """What it knows besides its run: for `recall`."""
        return Past(self._undo, self._redo, self._branches, self._deeds.last)

    def recall(self, past: Past) -> None:
        """Know what another timeline knew; of its commands those are the same run's that are the same objects."""
        self._undo, self._redo = list(past.undo), list(past.redo)
        self._branches, self._deeds = tuple(past.branches), Deeds(past.deeds)

    def parts_from(self, branch: Future) -> int | None:
        """The step after which another future goes its own way; None if it only is longer or shorter."""
        return parting(self.commands, branch.script())[1]

    def begin_act(self, label: str) -> None:
        """What is applied from now on is undone as one; `label` says what it is, such as "Delete crate"."""
        self._undo.append(self._moment(label))
        self._deeds.begin(label)
        del self._undo[:-UNDO_LEVELS]

    def end_act(self) -> None:
        """Forget the last act if nothing came of it."""
        if self._undo and self._undo[-1] == self._moment(self._undo[-1].label):
            self._undo.pop()

    def begin_again(self, commands: Sequence[TimedCommand] = ()) -> None:
        """Go to the start and know nothing but `commands` of what comes; an act of its own, to be undone."""
        self.begin_act("Restart")
        self._redo.clear()
        script = list(commands)
        lost = len(self.commands) > common_prefix(self.commands, script)
        branches = self._with_mine() if lost else self._branches
        self._resume(Moment("Restart", Future("", script, len(script), Tape(), 0), 0, 0, branches))

    def switch(self, number: int) -> None:
        """Know that one of the `branches` instead of this future, which becomes one of them; an act of its own.

        Goes to the step after which they part, or to its last one if that comes before. Raises `ArgumentError` if there
        is no such branch.
        """
        if not 0 <= number < len(self._branches):
            raise ArgumentError(f"branch {number} is not one of the {len(self._branches)} that there are")
        wanted = self._branches[number]
        self.begin_act("Other future")
        self._redo.clear()
        common, step = parting(self.commands, wanted.script())
        step = min(self.step_count if step is None else step, wanted.length)
        branches = tuple(branch for branch in self._with_mine() if branch is not wanted)
        applied = common if step < wanted.length else wanted.known
        self._resume(Moment(wanted.label, wanted, step, applied, branches))

    def undo(self) -> str | None:
        """Go to where the last act began, as if it had never been; gives its label, None if there is none."""
        return self._swap(self._undo, self._redo)

    def redo(self) -> str | None:
        """Go to where the last `undo` came from; gives the label of the act, None if there is none."""
        return self._swap(self._redo, self._undo)

    def _apply(self, command: Command, ending: frozenset[str]) -> None:
        left = not self.at_end and self.length > self.step_count
        branches = self._with_mine() if left else self._branches
        super()._apply(command, ending)
        self._branches = branches
        self._redo.clear()
        self._deeds.note(self._stepper.commands[self._stepper.applied - 1])

    def _moment(self, label: str) -> Moment:
        return Moment(label, self._future(label), self.step_count, self._stepper.applied, self._branches)

    def _with_mine(self) -> tuple[Future, ...]:
        """The branches, and this future as one of them."""
        return (*self._branches, self._future(self._deeds.label(self.commands)))[-MOST_BRANCHES:]

    def _swap(self, from_stack: list[Moment], to_stack: list[Moment]) -> str | None:
        if not from_stack:
            return None
        moment = from_stack.pop()
        to_stack.append(self._moment(moment.label))
        self._resume(moment)
        return moment.label

    def _resume(self, moment: Moment) -> None:
        """Be at a moment again, and know what was known then."""
        self._branches = moment.branches
        self._know(moment.future, moment.step, moment.applied)
