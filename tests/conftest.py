"""Settings shared by all tests. `tests` is a package, so that rooms can share `tests.flat` and the naive twins."""

from __future__ import annotations

import os
import sys

import pytest
from hypothesis import HealthCheck, settings

from sandbox._kernel_cache import cache_root

pytest_plugins = ["pytester"]

# These tests start hundreds of processes. Where the environment asks for no bytecode beside the sources, each would
# compile all of them again: it lies in the cache folder then.
if sys.dont_write_bytecode:
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
    os.environ["PYTHONPYCACHEPREFIX"] = sys.pycache_prefix = str(cache_root() / "bytecode")
    sys.dont_write_bytecode = False

# `quick` by default, `further` in CI after it, `thorough` by --hypothesis-profile=thorough: a property test looks at
# this share, in percent, of what it asks for with `tests.examples`. `quick` looks at the same examples in every run, so
# that a red run is due to a change and not to chance. So does `further` with a seed, as .ci/run gives it: at others.
# No time limits, for the first call of a kernel compiles it. Shapes are drawn at random and many do not meet, and CI
# machines are slow: neither says anything about the code.
checks = [HealthCheck.filter_too_much, HealthCheck.too_slow]
for profile, share, derandomize, database in (
    ("quick", 5, True, None), ("further", 5, False, None), ("thorough", 100, False, settings.default.database),
):  # fmt: skip
    settings.register_profile(
        profile, max_examples=share, derandomize=derandomize, database=database, deadline=None, print_blob=True,
        suppress_health_check=checks,
    )  # fmt: skip
settings.load_profile("quick")


def pytest_sessionstart(session: pytest.Session) -> None:
    """Compile before workers are started, for each would do so by itself."""
    if session.config.getoption("numprocesses", None) and not session.config.option.collectonly:
        from tests.compiled import compile_all

        terminal = session.config.pluginmanager.getplugin("terminalreporter")
        compile_all(terminal.write_line)


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """The longest first: one that begins last is waited for by workers that have nothing left to do."""
    items.sort(key=lambda item: -max((mark.kwargs.get("seconds", 0) for mark in item.iter_markers("slow")), default=0))
