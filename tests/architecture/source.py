"""The package's source as syntax trees, and who imports whom."""

from __future__ import annotations

import ast
from collections.abc import Collection, Iterable, Iterator
from pathlib import Path

import sandbox

ROOT = Path(sandbox.__file__).resolve().parents[1]


def module_name(path: Path) -> str:
    """`sandbox/scene/__init__.py` -> `sandbox.scene`."""
    parts = path.relative_to(ROOT).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def files() -> dict[str, Path]:
    """The file of every module of the package by its name."""
    return {module_name(path): path for path in sorted((ROOT / "sandbox").rglob("*.py"))}


def trees() -> Iterator[tuple[str, ast.Module]]:
    """Every module of the package and its tree. One at a time: all at once, they are gone through for garbage."""
    for name, path in files().items():
        yield name, ast.parse(path.read_text(encoding="utf-8"))


def imports(modules: Iterable[tuple[str, ast.Module]], known: Collection[str]) -> dict[str, set[str]]:
    """The `known` modules that each module names: at its top, in functions, for the type checker, and to
    `import_module`.
    """
    return {name: set(_imported(tree, known)) - {name} for name, tree in modules}


def _imported(tree: ast.Module, modules: Collection[str]) -> Iterator[str]:
    for node in ast.walk(tree):
        match node:
            case ast.Import(names=names):
                yield from (alias.name for alias in names if alias.name in modules)
            case ast.ImportFrom(module=str(home), names=names):
                whole = [f"{home}.{alias.name}" for alias in names]
                yield from (name if name in modules else home for name in whole if name in modules or home in modules)
            case ast.Call(func=ast.Attribute(attr="import_module"), args=[ast.Constant(value=str(name)), *_]):
                if name in modules:
                    yield name


def cycles(graph: dict[str, set[str]]) -> list[list[str]]:
    """The strongly connected components of more than one module (Tarjan 1972), each sorted."""
    order: dict[str, int] = {}
    low: dict[str, int] = {}
    stack: list[str] = []
    found: list[list[str]] = []

    def visit(name: str) -> None:
        order[name] = low[name] = len(order)
        stack.append(name)
        for other in graph[name]:
            if other not in order:
                visit(other)
                low[name] = min(low[name], low[other])
            elif other in stack:
                low[name] = min(low[name], order[other])
        if low[name] == order[name]:
            component = stack[stack.index(name) :]
            del stack[stack.index(name) :]
            if len(component) > 1:
                found.append(sorted(component))

    for name in sorted(graph):
        if name not in order:
            visit(name)
    return sorted(found)
