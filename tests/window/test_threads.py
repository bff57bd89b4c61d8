"""Threads beside the window end with it."""

from __future__ import annotations

import threading
import time
from pathlib import Path
from typing import Any

import pytest

from sandbox.replay.golden.run import Run
from sandbox.window import thumbnails
from sandbox.window.ghost import Ghost
from sandbox.window.job import Cancelled, Job, Progress
from sandbox.window.threads import end_threads, ended_threads, start_thread
from tests.window.test_session import SCENE


def counting(progress: Progress) -> None:
    while True:
        progress.at(0)
        time.sleep(0.001)


def test_jobs_ghosts_and_pictures_of_scenes_are_asked_to_stop(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    drawing = threading.Event()

    def draw(path: Path) -> bytes | None:
        drawing.set()
        time.sleep(0.05)
        return None

    monkeypatch.setattr(thumbnails, "_pixels", draw)
    with ended_threads():
        job, ghost, pictures = Job(counting), Ghost(Run(SCENE, 100_000)), thumbnails.Thumbnails(None)
        for k in range(100):
            pictures.texture(tmp_path / str(k))
        drawing.wait()
    threads: list[Any] = [job._thread, ghost._thread, pictures._thread]
    assert not any(thread.is_alive() for thread in threads)
    with pytest.raises(Cancelled):
        job.result()


def test_what_cannot_be_stopped_is_not_waited_for_for_ever() -> None:
    done = threading.Event()
    thread = start_thread(lambda: [done.wait(), None][1])
    end_threads(0.05)
    assert thread.is_alive()
    done.set()
    thread.join()
