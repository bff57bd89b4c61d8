"""Named tuples of tables as kernels pass them on: by address.

By itself numba passes every table of a tuple as seven words of its own and packs and unpacks all of them at every call,
which was half of what it told LLVM. Here a kernel has the address of a bundle of words (`_argument_words.py`) and reads
of it what it asks for. What a kernel itself makes is a tuple of numba's.

numba's low-level extensions: https://numba.readthedocs.io/en/stable/extending/low-level.html
"""

from __future__ import annotations

import hashlib
from typing import Any

from numba.core import types as _types
from numba.core.registry import cpu_target
from numba.core.typing.templates import AttributeTemplate
from numba.extending import infer_getattr, lower_getattr_generic, models, register_model

from sandbox._llvm_words import WORD, Words, word_count

types: Any = _types


class BundleType(types.Type):  # type: ignore[misc]
    """A named tuple that lies in memory and does not change while machine code runs."""

    def __init__(self, kind: Any) -> None:
        self.attributes: dict[str, Any] = {}
        self.first_words: dict[str, int] = {}
        self.word_count = 0
        for name, each in zip(kind.fields, kind.types, strict=True):
            self.attributes[name] = by_address(each)
            self.first_words[name] = self.word_count
            self.word_count += word_count(each)
        code = hashlib.blake2b(str(kind).encode(), digest_size=8).hexdigest()
        super().__init__(f"{kind.instance_class.__name__}_{code}")


def by_address(kind: Any) -> Any:
    """The type by which a kernel is given an argument."""
    return BundleType(kind) if isinstance(kind, types.BaseNamedTuple) else kind


@register_model(BundleType)
class _BundleModel(models.PrimitiveModel):
    def __init__(self, manager: Any, kind: Any) -> None:
        super().__init__(manager, kind, WORD.as_pointer())


@infer_getattr
class _BundleAttribute(AttributeTemplate):
    key = BundleType

    def generic_resolve(self, value: Any, attr: str) -> Any:  # type: ignore[override]  # numba's own says nothing
        return value.attributes.get(attr)


@lower_getattr_generic(BundleType)  # type: ignore[untyped-decorator]
def _attribute(context: Any, builder: Any, bundle: Any, address: Any, name: str) -> Any:
    words = Words(context, builder, address, constant=True)
    words.skip(bundle.first_words[name])
    kind = bundle.attributes[name]
    return words.place() if isinstance(kind, BundleType) else words.read(kind)


cpu_target.typing_context.refresh()
