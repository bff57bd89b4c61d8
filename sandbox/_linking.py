"""How kernels become machine code: all that an entry point calls is put into one module and optimised there, once.

By itself numba optimises every kernel together with all that it calls and makes machine code of it, and does so again
for the kernel that calls it: a leaf is compiled as often as the calls above it are deep, which took half of the time
of a first run. Here kernels that only kernels call are typed and lowered to LLVM's language and left at that.

Pipelines of one's own are a documented part of numba; its code libraries and dispatchers are not, so `pyproject.toml`
names the newest version that this was tried with.
https://numba.readthedocs.io/en/stable/developer/custom_pipeline.html
"""

from __future__ import annotations

import gc
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from numba import types
from numba._dynfunc import make_function
from numba.core import compiler, typed_passes, untyped_passes
from numba.core.codegen import JITCodeLibrary
from numba.core.compiler_machinery import PassManager, register_pass

_NEEDLESS = {
    untyped_passes.WithLifting,
    untyped_passes.InlineClosureLikes,
    untyped_passes.RewriteDynamicRaises,
    untyped_passes.MakeFunctionToJitFunction,
    untyped_passes.InlineInlinables,
    untyped_passes.FindLiterallyCalls,
    untyped_passes.LiteralUnroll,
    typed_passes.InlineOverloads,
    typed_passes.NopythonRewrites,
    typed_passes.DumpParforDiagnostics,
}
# Passes over what kernels have not: closures, `with`, raised values, literals asked for, expressions of whole arrays.


class _Library(JITCodeLibrary):
    """The module of a kernel, with the modules of all that it calls, near and far, still to be linked in."""

    def add_linking_library(self, library: Any) -> None:
        super().add_linking_library(library)
        if isinstance(library, _Part):
            self._linking_libraries.extend(library._linking_libraries)


class _Part(_Library):
    """A module of which each function is simplified, but neither optimised with others nor made machine code."""

    def finalize(self) -> None:
        self._finalized = True


@register_pass(mutates_CFG=True, analysis_only=False)
class _LowerWhole(typed_passes.NativeLowering):
    """Lower an entry point, optimise it with all that it calls, and make machine code of it."""

    _name = "lower_whole"

    def run_pass(self, state: Any) -> bool:
        state.library = _Library(state.targetctx.codegen(), state.func_id.func_qualname)
        state.library.enable_object_caching()
        return bool(super().run_pass(state))


@register_pass(mutates_CFG=True, analysis_only=False)
class _LowerPart(typed_passes.NativeLowering):
    """Lower a kernel that kernels call. What they know it by is a function that Python cannot call."""

    _name = "lower_part"

    def run_pass(self, state: Any) -> bool:
        state.library = _Part(state.targetctx.codegen(), state.func_id.func_qualname)
        state.flags.no_compile = True
        super().run_pass(state)
        lowered = state["cr"]
        what = lowered.fndesc
        key = make_function(what.lookup_module(), what.qualname, "a kernel", 0, lowered.env, (state.library,))
        state.targetctx.insert_user_function(key, what, [state.library])
        state["cr"] = lowered._replace(cfunc=key)
        return True


def _pipeline(state: Any, lower: Any) -> PassManager:
    """numba's passes in their order, without those that kernels do not need and with another last one."""
    usual = compiler.DefaultPassBuilder.define_nopython_pipeline(state)
    passes = PassManager("kernel")
    for each, why in usual.passes:
        if each not in _NEEDLESS:
            passes.add_pass(lower if each is typed_passes.NativeLowering else each, why)
    passes.finalize()
    return passes


@contextmanager
def _no_garbage_collection() -> Iterator[None]:
    """Compiling makes millions of objects that stay: looking through them for garbage is a seventh of its time."""
    on = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if on:
            gc.enable()


class EntryPointCompiler(compiler.CompilerBase):
    """Compiles what Python calls, and by that all the kernels below it."""

    def compile_extra(self, function: Any) -> Any:
        with _no_garbage_collection():
            return super().compile_extra(function)

    def define_pipelines(self) -> list[PassManager]:
        return [_pipeline(self.state, _LowerWhole)]


class KernelCompiler(compiler.CompilerBase):
    """Compiles what only kernels call."""

    def define_pipelines(self) -> list[PassManager]:
        return [_pipeline(self.state, _LowerPart)]


def take_literals_as_values(dispatcher: Any) -> None:
    """Have one version of a kernel for `f(x, 0)` and `f(x, n)`; by itself numba compiles one more for each literal."""
    usual = dispatcher.get_call_template

    def template(arguments: Any, named: Any) -> Any:
        return usual(tuple(map(types.unliteral, arguments)), {key: types.unliteral(named[key]) for key in named})

    dispatcher.get_call_template = template
