"""Objects that refuse attributes which they do not have, so that a misspelt name is a mistake and not a silence."""

from __future__ import annotations

import difflib
from functools import cache
from types import MemberDescriptorType
from typing import TYPE_CHECKING, Any

from sandbox.errors import ReadOnlyAttributeError, UnknownAttributeError


class FixedAttributes:
    """A class with `__slots__` and properties, and nothing else that could be set.

    Setting a property that has a setter is allowed. A public slot is set once, when the object is made. Anything else
    raises `UnknownAttributeError` with the nearest name, or `ReadOnlyAttributeError`. A subclass without `__slots__`
    may have attributes of its own.
    """

    __slots__ = ()

    if not TYPE_CHECKING:  # a type checker knows the attributes by itself

        def __setattr__(self, name: str, value: Any) -> None:
            slots, setters = _settable(type(self))
            if name in setters or (name in slots and (name[0] == "_" or not hasattr(self, name))):
                object.__setattr__(self, name, value)
            elif name in slots or hasattr(type(self), name) or not hasattr(self, "__dict__"):
                raise refusal(type(self).__name__, name, hasattr(type(self), name), setters)
            else:
                object.__setattr__(self, name, value)


def refusal(kind: str, name: str, known: bool, settable: frozenset[str] = frozenset()) -> UnknownAttributeError:
    """The error for setting `name` of a `kind`: it is `known` but only reads, or there is no such name."""
    if known:
        can = f"; what can be set is {', '.join(sorted(settable))}" if settable else ""
        return ReadOnlyAttributeError(f"{name} of {kind} is read-only{can}")
    near = difflib.get_close_matches(name, sorted(settable), 1)
    return UnknownAttributeError(f"{kind} has no attribute {name!r}" + (f"; did you mean {near[0]!r}?" if near else ""))


def attributes_besides(base: type[Any], state: Any) -> Any:
    """What `object.__getstate__` says of an object, without the slots of `base`: what a subclass has of its own."""
    values, slots = state if isinstance(state, tuple) else (state, None)
    own = {name: value for name, value in (slots or {}).items() if name not in base.__slots__}
    return (values, own) if values or own else None


@cache
def _settable(kind: type[Any]) -> tuple[frozenset[str], frozenset[str]]:
    """The slots of a class, and its properties that have setters."""
    found = {name: value for base in reversed(kind.__mro__) for name, value in vars(base).items()}
    slots = {name for name, value in found.items() if isinstance(value, MemberDescriptorType)}
    setters = {name for name, value in found.items() if isinstance(value, property) and value.fset is not None}
    return frozenset(slots), frozenset(setters)
