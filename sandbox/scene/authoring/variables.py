"""Numbers by name, which may be made of each other."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence

from sandbox.scene.authoring.arithmetic import CONSTANTS, FUNCTIONS, INDICES
from sandbox.scene.authoring.document import Written
from sandbox.scene.authoring.evaluate import BROKEN, Evaluator, Numbers
from sandbox.scene.authoring.expression import is_expression, parsed
from sandbox.scene.authoring.mistake import ExpressionError
from sandbox.scene.constraints import describe
from sandbox.scene.finding import quoted
from sandbox.scene.limits import MAX_NAME, MAX_VARS
from sandbox.scene.number_mend import number_mend

_NAME = re.compile(r"[A-Za-z_][A-Za-z_0-9]*")
_SHOWN = 8
_TAKEN = {*FUNCTIONS, *CONSTANTS, *INDICES}


def numbers(written: Mapping[str, Written], outer: Numbers, evaluator: Evaluator) -> dict[str, float]:
    """The numbers behind `written`, each worked out after those that it is made of; `outer` are known besides.

    What is wrong goes to the evaluator, and is `BROKEN`.
    """
    if len(written) > MAX_VARS:
        first = next(iter(written.values()))
        evaluator.faults.append(first.fault(f"{len(written)} numbers by name; {MAX_VARS} is the limit"))
        return dict.fromkeys(written, BROKEN)
    found: dict[str, float] = {}
    for name, entry in written.items():
        if not _is_named_well(name, entry, evaluator) or not _is_number(entry, evaluator):
            found[name] = BROKEN
        elif not is_expression(entry.value):
            found[name] = float(entry.value)
    known = {**outer, **found}
    for name in written:
        _work_out(name, written, known, found, evaluator)
    return found


def _is_named_well(name: str, entry: Written, evaluator: Evaluator) -> bool:
    if name in _TAKEN:
        evaluator.faults.append(entry.fault(f"the name {quoted(name)} means something already", on_key=True))
    elif not _NAME.fullmatch(name) or len(name) > MAX_NAME:
        text = f"the name {quoted(name)} must be letters, digits and _, and begin with no digit"
        evaluator.faults.append(entry.fault(text, on_key=True))
    else:
        return True
    return False


def _is_number(entry: Written, evaluator: Evaluator) -> bool:
    value = entry.value
    if is_expression(value):
        return True
    if isinstance(value, (int, float)) and not isinstance(value, bool) and abs(value) < math.inf:
        return True
    hint = number_mend(value) if isinstance(value, str) else ""
    said = "must be a finite number" if isinstance(value, float) else f"must be a number, not {describe(value)}"
    evaluator.faults.append(entry.fault(said, hint))
    return False


def _work_out(
    name: str, written: Mapping[str, Written], known: dict[str, float], found: dict[str, float], evaluator: Evaluator
) -> None:
    """Put one number, and those that it is made of, into `found` and `known`, which has the outer ones besides.

    There is no recursion, as chains may be long.
    """
    way = [name]
    while way:
        last = way[-1]
        if last in found:
            way.pop()
            continue
        ask = [other for other in _asked(written[last]) if other in written and other not in found]
        circle = next((other for other in ask if other in way), None)
        if circle is not None:
            told = way_round(way[way.index(circle) :])
            evaluator.faults.append(written[last].fault(f"these numbers are made of each other: {told}"))
            found.update(dict.fromkeys(way, BROKEN))
            known.update(dict.fromkeys(way, BROKEN))
        elif ask:
            way.append(ask[0])
        else:
            found[last] = known[last] = evaluator.number(written[last], known)


def way_round(names: Sequence[str]) -> str:
    """Names that lead back to the first one, as messages tell them."""
    shown = [*names[:_SHOWN], "..."] if len(names) > _SHOWN else list(names)
    return " > ".join([*shown, names[0]])


def _asked(entry: Written) -> list[str]:
    try:
        return sorted(parsed(entry.value).names)
    except ExpressionError:
        return []
