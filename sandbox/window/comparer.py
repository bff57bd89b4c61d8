"""A recording held against what the window computes: in a thread, with the expected run as a ghost beside it."""

from __future__ import annotations

from sandbox.errors import SandboxError
from sandbox.render.camera import Camera
from sandbox.render.frame import Frame, capture
from sandbox.render.marks import Marks
from sandbox.render.theme import Color
from sandbox.replay.comparison import Comparison, compare_two, compare_with_recording
from sandbox.replay.recording.recording import Recording
from sandbox.window.ghost import Ghost, GhostMoment, frame_at_poses, ghost_marks
from sandbox.window.job import Cancelled, Job, Progress
from sandbox.window.session import Session
from sandbox.window.time_marks import TimeMark


class Comparer:
    """Holds `recording` against its own fingerprints, or against `other`. `comparison` is None until that is done.

    If `patient`, pictures wait for the ghost, so that they are the same every time.
    """

    def __init__(self, recording: Recording, other: Recording | None = None, patient: bool = False) -> None:
        self.patient = patient
        self.recording = recording
        self.other = other
        self.comparison: Comparison | None = None
        self.trouble = ""
        """Why there is none; empty if there is."""
        self.ghost: Ghost | None = None
        self.ghost_shown = True
        self.job = Job(self._compare)
        self._taken = False
        self._own: tuple[int, int, int | None] = (0, -1, None)

    @property
    def against(self) -> Recording:
        """The recording that says what is expected."""
        return self.other or self.recording

    def poll(self) -> bool:
        """True once, when the comparison is there, or the reason why there is none."""
        if self._taken or not self.job.done:
            return False
        self._taken = True
        try:
            self.comparison = self.job.result()
        except Cancelled:
            return False
        except (SandboxError, OSError) as error:
            self.trouble = str(error)
            return True
        if self.comparison.expected is not None:
            self.ghost = Ghost(self.comparison.expected)
        return True

    def close(self) -> None:
        """Compare no more."""
        self.job.cancel()
        if self.ghost is not None:
            self.ghost.close()

    def title(self) -> str:
        """What came of it, in a line."""
        found = self.comparison
        if found is None:
            return f"not compared: {self.trouble}" if self.trouble else "comparing"
        name = "as recorded" if self.other is None else f"as in {found.origin}"
        if found.divergence is None:
            steps = min(self.recording.steps, self.against.steps)
            return f"{name}, to the bit, in all {steps:,} steps"
        parted = found.divergence
        return f"not {name} from step {parted.step:,} on ({parted.time:.2f} s)"

    def time_marks(self) -> list[TimeMark]:
        """The first step that differs, for the scrubber."""
        parted = self.comparison.divergence if self.comparison is not None else None
        if parted is None:
            return []
        body = self.comparison.body if self.comparison is not None else None
        who = f": {body}" if body else ""
        return [TimeMark(parted.step, f"the first step that differs: {parted.group}{who}")]

    def own_acts_from(self, session: Session) -> int | None:
        """The step from which on the session does not do what the recording did; None if it does all of it."""
        mine, script = session.timeline.commands, self.recording.commands
        if self._own[:2] != (id(mine), len(mine)):
            pairs = zip(mine, script, strict=False)
            same = next((k for k, (a, b) in enumerate(pairs) if a is not b and a != b), min(len(mine), len(script)))
            coming = (*mine[same : same + 1], *script[same : same + 1])
            self._own = id(mine), len(mine), min((step for step, _ in coming), default=None)
        return self._own[2]

    def moment(self, session: Session) -> GhostMoment | None:
        """What is expected where the session stands, if that run can be had and has come there."""
        if self.ghost is None:
            return None
        here = session.timeline.step_count
        self.ghost.want(here)
        return self.ghost.wait(here) if self.patient else self.ghost.at(here)

    def marks(self, session: Session, frame: Frame, camera: Camera, color: Color) -> Marks:
        """The ghost over what is shown; where the expected run cannot be had, its recorded end over the last step."""
        ghost = self._ghost_frame(session) if self.ghost_shown else None
        return Marks() if ghost is None else ghost_marks(ghost, frame, camera, color)

    def _ghost_frame(self, session: Session) -> Frame | None:
        here = session.timeline.step_count
        if self.ghost is not None:
            self.moment(session)
            return self.ghost.frame(here, session.clock.alpha)
        found = self.comparison
        ended = found is not None and found.divergence is not None and here == self.against.steps
        if not ended or self.own_acts_from(session) is not None:
            return None
        state = session.world.state
        return frame_at_poses(capture(state, session.current.mesh), state.bodies, dict(self.against.final))

    def _compare(self, progress: Progress) -> Comparison:
        progress.total = min(self.recording.steps, self.against.steps)
        if self.other is not None:
            return compare_two(self.recording, self.other, progress.at)
        return compare_with_recording(self.recording, progress.at)
