"""No kernel has more than 10 parameters, no other function more than 7."""

from __future__ import annotations

import ast
from collections.abc import Iterator

import pytest

from tests.architecture.source import trees

LIMIT, KERNEL_LIMIT = 7, 10
KERNELS = {"kernel", "inlined_kernel", "entry_point"}


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
    found = {each for name, tree in trees() for each in too_long(name, tree)}
    assert sorted(found) == []


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
