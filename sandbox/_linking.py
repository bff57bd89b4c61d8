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
from functools import cache
from typing import Any

from numba import njit, types
from numba._dynfunc import make_function
from numba.core import compiler, typed_passes, untyped_passes
from numba.core.codegen import JITCodeLibrary, JITCPUCodegen
from numba.core.compiler_lock import global_compiler_lock
from numba.core.compiler_machinery import PassManager, register_pass

from sandbox._compiling import tell, weight
from sandbox._llvm_aliasing import tell_types_apart
from sandbox._llvm_bundles import by_address
from sandbox._llvm_rows import rows_from_the_first
from sandbox._llvm_vectors import teach_operators
from sandbox._machine_code import ENTER, Returns
from sandbox._way_in import way_in

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

_NUMBA = ("_ZN5numba", "numba_", "numba.", "NRT_")
_FLAGS: dict[str, Any] = {
    "error_model": "numpy",
    "boundscheck": False,
    "_nrt": False,
    "no_cpython_wrapper": True,
    "no_cfunc_wrapper": True,
}
# Kernels allocate nothing, so numba's reference counting is off: its atomic counters around every call that takes an
# array cost more than the arithmetic (the grid ran 7 times slower with them).
_MANY = 1_000_000
"""Objects of 200 MB."""

teach_operators()


class _Library(JITCodeLibrary):
    """The module of a kernel, with the modules of all that it calls, near and far, still to be linked in."""

    def add_ir_module(self, module: Any) -> None:
        tell_types_apart(module)
        super().add_ir_module(module)

    def add_linking_library(self, library: Any) -> None:
        super().add_linking_library(library)
        if isinstance(library, _Part):
            self._linking_libraries.extend(library._linking_libraries)


class _Part(_Library):
    """A module of which each function is simplified, but neither optimised with others nor made machine code."""

    def finalize(self) -> None:
        self._finalized = True


class _Whole(_Library):
    """The module of an entry point, which becomes an object file. numba itself never loads it."""

    code: bytes

    def _optimize_final_module(self) -> None:
        """Optimise, knowing that nobody else calls any of it: what an array is passed with and not asked for (numba
        passes seven words for each) need not be passed then."""
        for function in self._final_module.functions:
            if not function.is_declaration and function.name != ENTER:
                function.linkage = "internal"
        super()._optimize_final_module()

    def _finalize_final_module(self) -> None:
        module = self._final_module
        missing = [each.name for each in (*module.functions, *module.global_variables) if each.is_declaration]
        if found := [name for name in missing if name.startswith(_NUMBA)]:
            raise NotImplementedError(f"{self.name} needs what numba alone has: {', '.join(found)}")
        self.code = self._codegen._tm.emit_object(module)
        self._finalized = True


@register_pass(mutates_CFG=True, analysis_only=False)
class _LowerPart(typed_passes.NativeLowering):
    """Lower a kernel. What other kernels know it by is a function that Python cannot call."""

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
        tell(f"kernel {weight(state.func_id.func)}")
        return True


def _pipeline(state: Any) -> PassManager:
    """numba's passes in their order, without those that kernels do not need and with another last one."""
    usual = compiler.DefaultPassBuilder.define_nopython_pipeline(state)
    passes = PassManager("kernel")
    for each, why in usual.passes:
        if each not in _NEEDLESS:
            passes.add_pass(_LowerPart if each is typed_passes.NativeLowering else each, why)
    passes.finalize()
    return passes


class _Garbage:
    """Compiling makes a million objects that stay: looking through them for garbage is a fifth of its time.

    They are not looked through right after it either, but before something else is compiled, and only if their memory
    counts by then: small entry points would take three times as long.
    """

    def __init__(self) -> None:
        self._made = 0

    @contextmanager
    def kept(self) -> Iterator[None]:
        """Do not look for garbage meanwhile."""
        on = gc.isenabled()
        gc.disable()
        if on and self._made > _MANY:
            gc.unfreeze()
            gc.collect()
            self._made = 0
        try:
            yield
        finally:
            self._made += gc.get_count()[0]
            gc.freeze()
            if on:
                gc.enable()


_garbage = _Garbage()


@contextmanager
def _remembered_calls() -> Iterator[None]:
    """Ask numba once what `+` gives for two floats, and so on: it tries every rule that it has, at every mention.

    Of 11,322 questions in the largest entry point 226 were different ones.
    """
    operators: Any = types.Function
    usual, known = operators.get_call_type, {}

    def get_call_type(function: Any, context: Any, arguments: Any, named: Any) -> Any:
        if named:
            return usual(function, context, arguments, named)
        asked = function, tuple(arguments)
        if asked not in known:
            known[asked] = usual(function, context, arguments, named)
        return known[asked]

    operators.get_call_type = get_call_type
    try:
        yield
    finally:
        operators.get_call_type = usual


@contextmanager
def _exact_records() -> Iterator[None]:
    """Compile a kernel for the rows of each table by itself. By itself numba takes rows for those of a table that has
    only their first fields, if there is code for these already, and warns of it."""
    records: Any = types.Record
    usual = records.can_convert_to
    records.can_convert_to = lambda record, context, other: None
    try:
        yield
    finally:
        records.can_convert_to = usual


class KernelCompiler(compiler.CompilerBase):
    """Compiles what is called by kernels, and by the function through which Python enters."""

    def define_pipelines(self) -> list[PassManager]:
        return [_pipeline(self.state)]


def dispatcher(function: Any, **flags: Any) -> Any:
    """`function` under numba: one version of it for `f(x, 0)` and `f(x, n)`.

    By itself numba compiles one more for each literal.
    """
    made = njit(pipeline_class=KernelCompiler, **_FLAGS, **flags)(function)
    usual = made.get_call_template

    def template(arguments: Any, named: Any) -> Any:
        return usual(tuple(map(types.unliteral, arguments)), {key: types.unliteral(named[key]) for key in named})

    made.get_call_template = template
    return made


class _Processor(JITCPUCodegen):
    """Makes machine code for another processor than this one, with no more than all of its kind have."""

    def __init__(self, name: str) -> None:
        self._processor = name
        super().__init__(name)

    def _get_host_cpu_name(self) -> str:
        return self._processor

    def _get_host_cpu_features(self) -> str:
        return ""


@cache
def _processor(name: str) -> _Processor:
    return _Processor(name)


def machine_code(entry: Any, arguments: tuple[Any, ...], processor: str = "") -> tuple[Returns, bytes]:
    """What an entry point returns, and the machine code of it and all the kernels below it, as an object file.

    `entry` is its dispatcher, `arguments` are of the types to compile it for, `processor` is LLVM's name of one; "" is
    this very one. What numba does, two thirds of the time, is done once for all processors.
    """
    returns, whole = linked(entry, arguments, processor)
    return returns, whole.code


def linked(entry: Any, arguments: tuple[Any, ...], processor: str = "") -> tuple[Returns, Any]:
    """What an entry point returns, and its library: the module of it and all the kernels below it."""
    with global_compiler_lock, _garbage.kept(), _remembered_calls(), _exact_records(), rows_from_the_first():
        kinds = tuple(by_address(entry.typeof_pyval(each)) for each in arguments)
        entry.compile(kinds)
        compiled = entry.overloads[kinds]
        maker = _processor(processor) if processor else compiled.target_context.codegen()
        whole = _Whole(maker, compiled.fndesc.qualname)
        module, returns = way_in(whole, compiled)
        whole.add_ir_module(module)
        whole.add_linking_library(compiled.library)
        whole.finalize()
        return returns, whole
