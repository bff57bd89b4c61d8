"""A session is on disk while it is played: what a kill leaves can be gone on with."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox import ApplyImpulse, Delete, SetGravity, rerun
from sandbox.replay.moment import Future, Moment
from sandbox.window.journal import MOST_ENDED, SUFFIX, Journal, ended_sessions
from sandbox.window.leftover import Leftover, leftovers, read_session
from sandbox.window.session import Session
from tests.examples import examples
from tests.window.test_session import SCENE


def written(folder: Path, session: Session, journal: Journal) -> Leftover | None:
    """What would be found if this program were gone now."""
    journal.sync(session)
    for path in folder.glob(f"*{SUFFIX}"):
        path.rename(path.with_name("99999999-gone" + SUFFIX))  # no process has that number
    found = leftovers(folder)
    for path in folder.glob(f"*{SUFFIX}"):
        path.rename(journal.path)
    return found[0] if found else None


def test_what_was_done_is_found_again_also_after_a_goodbye(tmp_path: Path) -> None:
    session, journal = Session(SCENE), Journal(tmp_path)
    assert written(tmp_path, session, journal) is None
    session.step_once()
    session.do("Push", ApplyImpulse("crate", (1.0, 2.0)))
    for _ in range(130):
        session.step_once()
        journal.sync(session)
    found = written(tmp_path, session, journal)
    assert found is not None
    assert found.scene == SCENE
    assert found.commands == ((1, ApplyImpulse("crate", (1.0, 2.0))),)
    assert 131 - 60 < found.steps <= 131
    found = written(tmp_path, session, journal)  # time stands still
    assert found is not None
    assert found.steps == 131
    again = Session(found.scene, found.commands, found.steps)
    again.skip(131)
    assert again.world.digest() == session.world.digest()
    journal.close()
    (ended,) = tmp_path.iterdir()
    assert ended_sessions(tmp_path, SCENE) == [ended]
    kept = read_session(ended)
    assert kept is not None
    assert kept.commands == found.commands
    assert leftovers(tmp_path) == []


def test_of_sessions_that_ended_the_latest_are_kept(tmp_path: Path) -> None:
    for _ in range(MOST_ENDED + 2):
        session, journal = Session(SCENE), Journal(tmp_path)
        session.do("Push", ApplyImpulse("crate", (1.0, 2.0)))
        journal.sync(session)
        journal.close()
    assert len(list(tmp_path.iterdir())) == len(ended_sessions(tmp_path, SCENE)) == MOST_ENDED


def test_a_journal_of_a_running_program_is_left_alone(tmp_path: Path) -> None:
    session, journal = Session(SCENE), Journal(tmp_path)
    session.do("Push", ApplyImpulse("crate", (1.0, 2.0)))
    journal.sync(session)
    assert leftovers(tmp_path) == []
    assert journal.path.is_file()


@pytest.mark.parametrize("cut", [1, 7, 30])
def test_a_last_line_that_was_cut_off_is_left_out(tmp_path: Path, cut: int) -> None:
    session, journal = Session(SCENE), Journal(tmp_path)
    session.do("Push", ApplyImpulse("crate", (1.0, 2.0)))
    session.do("Gravity", SetGravity((0.0, 1.0)))
    journal.sync(session)
    data = journal.path.read_bytes()
    data = data[: data.index(b"\n", data.index(b"SetGravity")) + 1]
    (tmp_path / ("99999999-gone" + SUFFIX)).write_bytes(data[:-cut])
    journal.close()
    (found,) = leftovers(tmp_path)
    assert [type(command).__name__ for _, command in found.commands] == ["ApplyImpulse"]


def test_where_nothing_can_be_written_the_session_goes_on(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    session, journal = Session(SCENE), Journal(tmp_path / "file" / "folder")
    session.do("Push", ApplyImpulse("crate", (1.0, 2.0)))
    journal.sync(session)
    journal.close()


@pytest.mark.parametrize("text", ["", "{}\n", "[]\n", '{"scene": 3}\n', "\x00\xff\n", '{"source":"a","from_file":1}\n'])
def test_a_damaged_journal_is_no_offer(tmp_path: Path, text: str) -> None:
    (tmp_path / ("99999999-x" + SUFFIX)).write_text(text)
    assert leftovers(tmp_path) == []


def futures(session: Session) -> list[Any]:
    """All that is known beside the run, without what was noted on the way."""
    past = session.timeline.past

    def plain(one: Moment | Future) -> tuple[Any, ...]:
        if isinstance(one, Future):
            return one.label, one.script(), one.length
        return one.label, plain(one.future), one.step, one.applied, list(map(plain, one.branches))

    return [*(list(map(plain, stack)) for stack in (past.undo, past.redo, past.branches)), list(past.deeds)]


ACTS = st.lists(
    st.tuples(
        st.sampled_from(["step", "push", "delete", "seek", "undo", "redo", "restart", "switch", "sync"]),
        st.integers(0, 40),
    ),
    max_size=25,
)


@examples(300)
@given(acts=ACTS)
def test_whatever_is_done_a_session_is_gone_on_with_as_if_it_had_never_ended(
    acts: list[tuple[str, int]], tmp_path_factory: Any
) -> None:
    folder = tmp_path_factory.mktemp("journal")
    session, journal = Session(SCENE), Journal(folder)
    for what, number in acts:
        match what:
            case "step":
                for _ in range(number):
                    session.step_once()
            case "push":
                session.do("Push", ApplyImpulse("crate", (float(number), 0.0)))
            case "delete" if "other" in session.world.names:
                session.do("Delete", Delete("other"))
            case "seek":
                session.seek(number)
            case "undo":
                session.undo()
            case "redo":
                session.redo()
            case "restart":
                session.restart()
            case "switch" if session.timeline.branches:
                session.switch(number % len(session.timeline.branches))
            case "sync":
                journal.sync(session)
    found = written(folder, session, journal)
    journal.close()
    assert (found.commands if found else ()) == tuple(session.timeline.commands)
    if found is None:
        return
    again = Session(found.scene, found.commands, found.steps)
    again.skip(session.timeline.length)
    again.recall(found.script, found.past, found.at)
    assert futures(again) == futures(session)
    for each in (session, again):
        each.seek(each.timeline.length)
    for go in (Session.undo, Session.redo):
        while go(session) is not None:
            assert go(again) is not None
            assert again.world.digest() == session.world.digest()
            assert again.timeline.length == session.timeline.length
    if again.timeline.branches:
        again.switch(0)
        again.seek(again.timeline.length)
    assert not again.timeline.length or rerun(again.timeline.recording()).passed


@pytest.mark.slow
def test_a_killed_window_offers_its_session_at_the_next_start(display: Any, tmp_path: Path) -> None:
    SCENE.save(tmp_path / "two.scene.json")
    (tmp_path / "play.txt").write_text("wait 5\ndrag @0.2,0.6 to @3,3\nshot done.png\nwait 100000\n")
    (tmp_path / "restore.txt").write_text("wait 2\nclick offer.restore\nwait 3\nkey S\nwait 2\n")
    command = [sys.executable, "-m", "sandbox", "run", "two.scene.json", "--size", "800x500", "--script"]
    environment = {**os.environ, "SANDBOX_STATE_DIR": str(tmp_path / "state")}
    window = subprocess.Popen([*command, "play.txt"], cwd=tmp_path, env=environment)
    while not (tmp_path / "done.png").exists():
        assert window.poll() is None
        time.sleep(0.1)
    window.kill()
    window.wait()
    assert len(list((tmp_path / "state").glob(f"*{SUFFIX}"))) == 1
    done = subprocess.run([*command, "restore.txt"], cwd=tmp_path, env=environment, capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "")
    assert not list((tmp_path / "state").glob(f"*{SUFFIX}"))
    from sandbox import Recording

    kinds = [type(command).__name__ for _, command in Recording.load(tmp_path / "two.replay.json").commands]
    assert kinds[0] == "StartDrag"
