"""What kernels may not say: calls and operators whose bits differ between machines, builds or runs."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

import sandbox
from sandbox import _jit
from sandbox.engine.contact_solver.soft_constraint import soft_coefficients
from sandbox.geometry.trig import arctan2, cos_sin

PACKAGE = Path(sandbox.__file__).parent
SOURCES = sorted([*(PACKAGE / "geometry").glob("*.py"), *(PACKAGE / "engine").rglob("*.py")])
MARKS = {"kernel", "inlined_kernel", "entry_point"}
FORBIDDEN_CALLS = {
    "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh", "exp", "exp2", "expm1", "log",
    "log2", "log10", "log1p", "pow", "hypot", "cbrt", "fsum", "prod", "sum", "dot", "vdot", "inner", "matmul",
    "mean", "norm", "linalg", "einsum", "min", "max", "minimum", "maximum", "fmin", "fmax", "amin", "amax", "argmin",
    "argmax", "argsort", "sort", "sorted", "round", "around", "fma", "prange", "set", "frozenset", "dict", "hash",
    "id", "random", "time", "vars", "clip", "power", "cumsum",
}  # fmt: skip
FORBIDDEN_NODES = (
    ast.Set, ast.SetComp, ast.Dict, ast.DictComp, ast.GeneratorExp, ast.ListComp, ast.Try, ast.Lambda, ast.Yield,
    ast.MatMult,
)  # fmt: skip


def marks(function: ast.FunctionDef) -> set[str]:
    """Names of a function's decorators."""
    names = [d.func if isinstance(d, ast.Call) else d for d in function.decorator_list]
    return {d.attr if isinstance(d, ast.Attribute) else getattr(d, "id", "") for d in names}


def kernels(source: str) -> list[ast.FunctionDef]:
    """The kernels of a module."""
    return [n for n in ast.walk(ast.parse(source)) if isinstance(n, ast.FunctionDef) and marks(n) & MARKS]


def faults(function: ast.FunctionDef) -> list[str]:
    """What a kernel says that it may not."""
    found = []
    for node in ast.walk(function):
        if isinstance(node, ast.Call):
            name = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
            if name in FORBIDDEN_CALLS:
                found.append(f"line {node.lineno}: calls {name}")
        if isinstance(node, (ast.BinOp, ast.AugAssign)) and isinstance(node.op, (ast.Pow, ast.MatMult)):
            found.append(f"line {node.lineno}: {type(node.op).__name__}")
        if isinstance(node, FORBIDDEN_NODES):
            found.append(f"line {node.lineno}: {type(node).__name__}")
        if isinstance(node, ast.Subscript) and isinstance(getattr(node.slice, "op", None), ast.USub):
            found.append(f"line {node.lineno}: a row from the end")
    return found


@pytest.mark.parametrize("path", SOURCES, ids=[str(p.relative_to(PACKAGE)) for p in SOURCES])
def test_kernels_keep_to_arithmetic_that_is_the_same_everywhere(path):
    for function in kernels(path.read_text(encoding="utf-8")):
        assert faults(function) == [], function.name


@pytest.mark.parametrize("path", [*SOURCES, PACKAGE / "_jit.py"], ids=lambda p: str(p.relative_to(PACKAGE)))
def test_no_flag_relaxes_arithmetic(path):
    tree = ast.parse(path.read_text(encoding="utf-8"))
    words = {node.arg for node in ast.walk(tree) if isinstance(node, ast.keyword)}
    assert not words & {"fastmath", "parallel"}
    names = {getattr(node, "id", getattr(node, "attr", "")) for node in ast.walk(tree)}
    assert not names & {"prange", "vectorize", "guvectorize", "jitclass", "stencil"}


def test_there_are_kernels_to_look_at():
    count = sum(len(kernels(path.read_text(encoding="utf-8"))) for path in SOURCES)
    assert count > 30


@pytest.mark.parametrize(
    "line",
    [
        "math.sin(x)",
        "np.sum(x)",
        "x ** 2",
        "min(x, y)",
        "math.hypot(x, y)",
        "{x, y}",
        "[k for k in x]",
        "x.dot(y)",
        "round(x)",
        "x[-1]",
        "x[-y]",
    ],
)
def test_the_lint_finds_what_it_is_for(line):
    (function,) = kernels(f"@kernel\ndef f(x, y):\n    return {line}\n")
    assert faults(function)


@pytest.mark.parametrize(
    "line", ["math.sqrt(x)", "math.floor(x)", "abs(x)", "x if x < y else y", "math.frexp(x)[1]", "x[y - 1]"]
)
def test_the_lint_lets_exact_arithmetic_pass(line):
    (function,) = kernels(f"@entry_point\ndef f(x, y):\n    return {line}\n")
    assert not faults(function)


@pytest.mark.skipif(not _jit.jit_enabled(), reason="there is no machine code without the compiler")
@pytest.mark.parametrize(
    ("function", "arguments"), [(cos_sin, (0.3,)), (arctan2, (0.3, 0.7)), (soft_coefficients, (1.0, 1.0, 1.0))]
)
def test_the_machine_code_has_no_fused_multiply_add(function, arguments):
    """One rounding instead of two would part the machines that have it from those that have not."""
    from sandbox import _linking

    text = _linking.linked(function.dispatcher, arguments)[1].get_asm_str()
    assert "mul" in text
    assert "fmadd" not in text
    assert "fnmadd" not in text
    assert "fmsub" not in text
