"""No file of the package imports, over whatever detour, one that imports it."""

from __future__ import annotations

import ast

import pytest

from tests.architecture.source import cycles, files, imports, trees


def graph_of(sources: dict[str, str]) -> dict[str, set[str]]:
    return imports([(name, ast.parse(text)) for name, text in sources.items()], sources)


def test_no_import_cycles() -> None:
    assert cycles(imports(trees(), files())) == []


@pytest.mark.parametrize(
    ("a", "b"),
    [
        ("import p.b", "import p.a"),
        ("from p import b", "from p.a import f"),
        ("from p.b import g", "def g():\n    from p.a import f"),
        ("import p.b", "if TYPE_CHECKING:\n    from p.a import f"),
        ("import p.b", "importlib.import_module('p.a')"),
    ],
)
def test_every_kind_of_import_closes_a_cycle(a: str, b: str) -> None:
    sources = {"p": "", "p.a": a, "p.b": b, "p.c": "import p.a"}
    assert cycles(graph_of(sources)) == [["p.a", "p.b"]]


def test_imports_one_way_are_no_cycle() -> None:
    sources = {"p": "import p.a", "p.a": "from p.b import f, g", "p.b": "import os"}
    graph = graph_of(sources)
    assert graph == {"p": {"p.a"}, "p.a": {"p.b"}, "p.b": set()}
    assert cycles(graph) == []
