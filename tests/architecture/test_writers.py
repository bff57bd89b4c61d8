"""All files are written by the one module that writes them whole or not at all."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from tests.architecture.source import files, trees

WRITER = "sandbox._atomic_write"
SCRATCH = {
    "sandbox.replay.revisions.trace": "a job in a temporary folder, for another process",
    "sandbox.replay.revisions.tracer": "the answer to it",
    "sandbox.sweeps.journal": "grows by a line for each finished run; a last one that was cut off is left out",
    "sandbox.window.journal": "grows by a line at a time; a reader leaves out a last one that was cut off",
}


def writes(tree: ast.Module) -> Iterator[int]:
    """The lines at which files are written: `x.write_text()`, `open(x, "w")`, `savefig(path)` and the like."""
    for node in ast.walk(tree):
        match node:
            case ast.Call(func=ast.Attribute(attr="write_text" | "write_bytes" | "savetxt" | "tofile")):
                yield node.lineno
            case ast.Call(func=ast.Name(id="open") | ast.Attribute(attr="open"), args=args):
                modes = [arg.value for arg in args if isinstance(arg, ast.Constant) and isinstance(arg.value, str)]
                if any(set(mode) <= set("rwxab+t") and set(mode) & set("wxa+") for mode in modes):
                    yield node.lineno
            case ast.Call(func=ast.Attribute(attr="savefig"), args=[ast.Name(id="path"), *_]):
                yield node.lineno


def test_only_one_module_writes_files() -> None:
    found = {name: lines for name, tree in trees() if (lines := list(writes(tree)))}
    assert found.keys() == SCRATCH.keys()
    assert WRITER in files()
