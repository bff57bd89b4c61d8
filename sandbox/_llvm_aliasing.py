"""What LLVM is told of memory: numbers of different types never lie in the same place.

C compilers know that of C. Of what numba writes LLVM has to suppose that any number which is stored may be the row, the
place or the count that it read before, and reads these again.

https://llvm.org/docs/LangRef.html#tbaa-metadata
"""

from __future__ import annotations

from typing import Any

from llvmlite import ir

_OFFSET = ir.Constant(ir.IntType(64), 0)
_BYTE = 8
_NUMBERS = (ir.IntType, ir.FloatType, ir.DoubleType, ir.PointerType)


def tell_types_apart(module: Any) -> None:
    """Note of which type each number is, or several side by side, that is loaded or stored. A byte may be of any."""
    known: dict[Any, Any] = {}
    for function in module.functions:
        for block in function.blocks:
            for each in block.instructions:
                if isinstance(each, (ir.LoadInstr, ir.StoreInstr)) and "tbaa" not in each.metadata:
                    kind = each.type if isinstance(each, ir.LoadInstr) else each.operands[0].type
                    if kind not in known:
                        known[kind] = _tag(module, kind)
                    if known[kind] is not None:
                        each.set_metadata("tbaa", known[kind])


def of_any_type(module: Any, instruction: Any) -> Any:
    """The instruction, with a note that what it loads or stores may be of any type."""
    instruction.set_metadata("tbaa", _access(module, _any(module)))
    return instruction


def _tag(module: Any, kind: Any) -> Any:
    """What is noted of numbers of a type; None of other values."""
    kind = kind.element if isinstance(kind, ir.VectorType) else kind
    if not isinstance(kind, _NUMBERS):
        return None
    if isinstance(kind, ir.IntType) and kind.width <= _BYTE:
        return _access(module, _any(module))
    name = "pointer" if isinstance(kind, ir.PointerType) else str(kind)
    return _access(module, module.add_metadata([name, _any(module), _OFFSET]))


def _any(module: Any) -> Any:
    return module.add_metadata(["any type", module.add_metadata(["memory"]), _OFFSET])


def _access(module: Any, kind: Any) -> Any:
    return module.add_metadata([kind, kind, _OFFSET])
