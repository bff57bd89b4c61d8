"""What the machine code on disk is named by has every kernel in it."""

from __future__ import annotations

import ast

from sandbox._kernel_cache import WITHOUT_KERNELS
from tests.architecture.source import files, imports, trees
from tests.architecture.test_parameters import KERNELS


def test_folders_without_kernels_have_none_and_no_kernel_reads_from_them() -> None:
    left_out = tuple(f"sandbox.{folder.replace('/', '.')}" for folder in WITHOUT_KERNELS)
    assert all(any(name.startswith(folder) for name in files()) for folder in left_out)
    with_kernels = [(name, tree) for name, tree in trees() if _has_kernels(tree)]
    assert len(with_kernels) > 100
    assert [name for name, _ in with_kernels if name.startswith(left_out)] == []
    graph = imports(with_kernels, files())
    assert [(name, other) for name in graph for other in graph[name] if other.startswith(left_out)] == []


def _has_kernels(tree: ast.Module) -> bool:
    return any(isinstance(node, ast.Name) and node.id in KERNELS for node in ast.walk(tree))
