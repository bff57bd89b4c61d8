"""No kernel has more than 10 parameters, no other function more than 7."""

from __future__ import annotations

import ast
from collections.abc import Iterator

import pytest

from tests.architecture.source import trees

LIMIT, KERNEL_LIMIT = 7, 10
KERNELS = {"kernel", "inlined_kernel", "entry_point"}
KNOWN = {
    "sandbox.engine.events.sensors.sense",
    "sandbox.engine.fields.apply.apply_fields",
    "sandbox.engine.queries.proximity._answer",
    "sandbox.engine.queries.proximity._nearest_in_box",
    "sandbox.engine.queries.proximity.nearest_shape",
    "sandbox.engine.queries.proximity.overlaps",
    "sandbox.engine.queries.sweep.all_hits",
    "sandbox.engine.queries.sweep.first_hits",
    "sandbox.geometry.clip_steps._clip",
    "sandbox.geometry.manifold._add_point",
    "sandbox.geometry.manifold._clip",
    "sandbox.geometry.manifold.collide_cores",
    "sandbox.geometry.manifold.face_manifold",
    "sandbox.geometry.pair.manifold_on_axis",
    "sandbox.geometry.ray._corner_normal",
    "sandbox.geometry.ray._enters_corner",
    "sandbox.geometry.sweep._first_touch",
    "sandbox.geometry.time_of_touch.time_of_touch",
}
"""Functions that have more; one that has not any more must go from this list."""


def parameters(function: ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda) -> list[str]:
    """The names of all parameters but self and cls."""
    given = function.args
    plain = [*given.posonlyargs, *given.args, *given.kwonlyargs, *filter(None, (given.vararg, given.kwarg))]
    names = [each.arg for each in plain]
    return names[1:] if names[:1] in (["self"], ["cls"]) else names


def too_long(name: str, tree: ast.Module) -> Iterator[str]:
    """`MODULE.FUNCTION` for every function with too many parameters."""
    for node in ast.walk(tree):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda)):
            decorators = {each.id for each in getattr(node, "decorator_list", ()) if isinstance(each, ast.Name)}
            limit = KERNEL_LIMIT if decorators & KERNELS else LIMIT
            if len(parameters(node)) > limit:
                yield f"{name}.{getattr(node, 'name', '<lambda>')}"


def test_no_function_has_too_many_parameters() -> None:
    found = {each for name, tree in trees().items() for each in too_long(name, tree)}
    assert sorted(found - KNOWN) == []
    assert sorted(KNOWN - found) == []


@pytest.mark.parametrize(
    ("source", "found"),
    [
        ("def f(a, b, c, d, e, f, g): ...", []),
        ("def f(a, b, c, d, e, f, g, h): ...", ["m.f"]),
        ("def f(a, b, c, /, d, e, *f, g, **h): ...", ["m.f"]),
        ("class C:\n    def f(self, a, b, c, d, e, f, g): ...", []),
        ("class C:\n    async def f(self, a, b, c, d, e, f, g, h): ...", ["m.f"]),
        ("f = lambda a, b, c, d, e, f, g, h: 0", ["m.<lambda>"]),
        ("@kernel\ndef f(a, b, c, d, e, f, g, h, i, j): ...", []),
        ("@inlined_kernel\ndef f(a, b, c, d, e, f, g, h, i, j, k): ...", ["m.f"]),
    ],
)
def test_all_kinds_of_parameters_count(source: str, found: list[str]) -> None:
    assert list(too_long("m", ast.parse(source))) == found
