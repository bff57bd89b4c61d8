"""Settings shared by all tests. `tests` is a package, so that rooms can share `tests.flat` and the naive twins."""

from __future__ import annotations

import os

from hypothesis import settings

# Tests call single kernels; has to be said before the first of them is imported.
os.environ["SANDBOX_CALLABLE_KERNELS"] = "1"

# The first call of a kernel compiles it, which no deadline could allow for.
settings.register_profile("sandbox", deadline=None, print_blob=True)
settings.load_profile("sandbox")
