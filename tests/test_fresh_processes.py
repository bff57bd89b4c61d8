"""Processes that work is shared among hear nothing of Ctrl-C, and end at once with the one that began them."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

PROGRAM = r"""
import os, signal, sys, time
from sandbox._fresh_processes import fresh_processes

WHERE = sys.argv[1]

def stay():
    time.sleep(900)
    os.write(1, b"was waited for\n")

if __name__ != "__main__" and WHERE == "import":  # as a process does that has just begun
    os.write(1, b"here\n")
    stay()

def begin(word):
    assert word == "given"

def work(number):
    if WHERE == "work":
        os.write(1, b"here\n")
        stay()
    if WHERE == "error":
        if number == 0:
            raise ValueError("none")
        stay()
    return 2 * number

if __name__ == "__main__":
    signal.signal(signal.SIGINT, signal.default_int_handler)  # who began the tests may ignore it
    try:
        with fresh_processes(2, begin, "given") as pool:
            futures = [pool.submit(work, number) for number in range(4)]
            print([future.result() for future in futures])
    except KeyboardInterrupt:
        sys.exit(130)
    except ValueError as error:
        print(error)
"""


@pytest.fixture
def program(tmp_path: Path) -> list[str]:
    path = tmp_path / "program.py"
    path.write_text(PROGRAM)
    return [sys.executable, str(path)]


@pytest.mark.skipif(os.name != "posix", reason="there are no groups of processes")
@pytest.mark.parametrize("where", ["import", "work"])
def test_ctrl_c_is_silent_and_waits_for_nobody(program: list[str], where: str) -> None:
    """A terminal sends it to all of them: those that were importing printed where, and one at work for an hour was
    waited for."""
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE}
    process = subprocess.Popen([*program, where], text=True, start_new_session=True, **pipes)  # type: ignore[call-overload]
    assert [process.stdout.readline() for _ in range(2)] == ["here\n"] * 2
    os.killpg(process.pid, signal.SIGINT)
    out, err = process.communicate()
    assert (process.returncode, out, err) == (130, "", "")


def test_work_comes_in_its_order(program: list[str]) -> None:
    done = subprocess.run([*program, "nowhere"], capture_output=True, text=True)
    assert (done.stdout, done.stderr) == ("[0, 2, 4, 6]\n", "")


def test_an_error_does_not_wait_for_the_others(program: list[str]) -> None:
    done = subprocess.run([*program, "error"], capture_output=True, text=True)
    assert (done.stdout, done.stderr) == ("none\n", "")
