"""Formulae of design files: arithmetic on numbers and arrays, and nothing else."""

import ast
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from functools import cached_property, lru_cache
from typing import TypeAlias

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._units import MM_PER_INCH
from elastica_cad.errors import InputError
from elastica_cad.refusals import note

Value: TypeAlias = "float | FloatArray"

MOST_LETTERS = 2000
"""Letters of a formula; longer ones belong into `let`, in parts."""

LARGEST_NUMBER = 1e300
"""A little below the largest float, so that sums of a few stay finite."""

MOST_NESTED = 60
"""Brackets, signs and operators inside each other: Python's own parser gives up not much later."""

CONSTANTS = {"pi": float(np.pi), "e": float(np.e), "degrees": float(np.pi / 180), "inch": MM_PER_INCH}
"""`degrees` turns 30*degrees into radians, `inch` 1.5*inch into mm."""

FUNCTIONS: dict[str, tuple[Callable[..., Value], int]] = {
    "abs": (np.abs, 1), "sqrt": (np.sqrt, 1), "exp": (np.exp, 1), "log": (np.log, 1),
    "sin": (np.sin, 1), "cos": (np.cos, 1), "tan": (np.tan, 1),
    "asin": (np.arcsin, 1), "acos": (np.arccos, 1), "atan": (np.arctan, 1), "atan2": (np.arctan2, 2),
    "sinh": (np.sinh, 1), "cosh": (np.cosh, 1), "tanh": (np.tanh, 1), "hypot": (np.hypot, 2),
    "floor": (np.floor, 1), "sign": (np.sign, 1), "min": (np.minimum, 2), "max": (np.maximum, 2),
    "where": (np.where, 3),
}  # fmt: skip
"""Functions and how many arguments they take; where(condition, a, b) chooses."""

_OPERATORS: dict[type[ast.operator], Callable[[Value, Value], Value]] = {
    ast.Add: np.add, ast.Sub: np.subtract, ast.Mult: np.multiply, ast.Div: np.divide, ast.Pow: np.power,
    ast.Mod: np.mod,
}  # fmt: skip

_COMPARISONS: dict[type[ast.cmpop], Callable[[Value, Value], Value]] = {
    ast.Lt: np.less, ast.LtE: np.less_equal, ast.Gt: np.greater, ast.GtE: np.greater_equal,
}  # fmt: skip


@dataclass(frozen=True)
class Formula:
    """A formula, read and checked but not yet computed.

    Parameters
    ----------
    text : str
        Numbers, names, + - * / % **, comparisons, and calls of `FUNCTIONS`.
    where : str
        What messages call it, such as the place in a design file.

    Raises
    ------
    InputError
        Anything else than arithmetic: what it is and at which letter.

    Examples
    --------
    >>> Formula("hypot(3, 4) * x")(x=2.0)
    10.0
    """

    text: str
    where: str = "formula"

    def __post_init__(self) -> None:
        _check(self._tree, self)

    @property
    def names(self) -> frozenset[str]:
        """Names that must be given."""
        calls = {node.func for node in ast.walk(self._tree) if isinstance(node, ast.Call)}
        found = {n.id for n in self._parsed[1] if n not in calls}
        return frozenset(found - set(CONSTANTS))

    @property
    def _tree(self) -> ast.expr:
        return self._parsed[0]

    @cached_property
    def _parsed(self) -> "_Parsed":
        if len(self.text) > MOST_LETTERS:
            raise InputError(
                "{place}: a formula of {count} letters is too long; use let to name parts",
                place=self.where,
                count=len(self.text),
            )
        try:
            return _parsed(self.text)
        except SyntaxError as error:
            at = f"letter {error.offset}" if error.offset else "its end"
            raise InputError(
                "{place}: {typed!r} is no formula: it breaks off at {at}",
                place=self.where,
                typed=self.text,
                at=at,
            ) from error
        except (ValueError, RecursionError, MemoryError) as error:
            raise InputError(
                "{place}: {typed!r} is no formula that can be read", place=self.where, typed=self.text[:60]
            ) from error

    def __call__(self, values: Mapping[str, Value] | None = None, **more: Value) -> Value:
        """The value for names given as a mapping or as keywords; arrays are computed element by element.

        Raises
        ------
        InputError
            A name that has no value, or a result that is not finite.
        """
        known: dict[str, Value] = {**CONSTANTS, **(values or {}), **more}
        tree, names = self._parsed
        for node in names:
            if node.id not in known and node.id not in FUNCTIONS:
                raise InputError(self._unknown("name", node, known))
        with np.errstate(all="ignore"):
            result = np.asarray(_value(tree, known), dtype=float)
        if not np.all(np.isfinite(result)):
            raise InputError(
                "{place}: {typed!r} gives no finite number: a division by 0 or a root below 0?",
                place=self.where,
                typed=self.text,
            )
        return float(result) if result.ndim == 0 else result

    def _unknown(self, kind: str, node: ast.Name, known: Mapping[str, object]) -> str:
        near = get_close_matches(node.id, known, n=1)
        hint = (
            note("did you mean {near}?", near=near[0])
            if near
            else note("known are {names}", names=", ".join(sorted(known)))
        )
        return note(
            "{place}: unknown {thing} {name!r} at letter {letter} of {formula!r}; {hint}",
            place=self.where, thing=kind, name=node.id, letter=node.col_offset + 1, formula=self.text,
            hint=hint,
        )  # fmt: skip


_Parsed: TypeAlias = tuple[ast.expr, tuple[ast.Name, ...]]


@lru_cache(maxsize=256)
def _parsed(text: str) -> _Parsed:
    """A formula's tree, and all names in it; strips of a family share their formulae."""
    tree = ast.parse(text.strip(), mode="eval").body
    return tree, tuple(node for node in ast.walk(tree) if isinstance(node, ast.Name))


def _check(node: ast.expr, formula: Formula, depth: int = 0) -> None:
    """Refuse whatever is not arithmetic."""
    if depth > MOST_NESTED:
        raise _refusal(node, formula, "this is nested too deeply; use let to name parts")
    match node:
        case ast.Constant(value=bool() | complex() | str() | bytes() | None):
            raise _refusal(node, formula, f"{node.value!r} is no number")
        case ast.Constant(value=int() | float() as number):
            if abs(number) > LARGEST_NUMBER:
                raise _refusal(node, formula, f"numbers reach to {LARGEST_NUMBER:g}")
        case ast.Name():
            if node.id in FUNCTIONS:
                raise _refusal(node, formula, f"{node.id} is a function and needs its arguments in brackets")
        case ast.UnaryOp(op=ast.USub() | ast.UAdd()):
            _check(node.operand, formula, depth + 1)
        case ast.BinOp():
            if type(node.op) not in _OPERATORS:
                hint = "write ** for powers" if isinstance(node.op, ast.BitXor) else "use + - * / % **"
                raise _refusal(node, formula, f"this operator is not known; {hint}")
            _check(node.left, formula, depth + 1)
            _check(node.right, formula, depth + 1)
        case ast.Compare(ops=[op], comparators=[other]) if type(op) in _COMPARISONS:
            _check(node.left, formula, depth + 1)
            _check(other, formula, depth + 1)
        case ast.Call(func=ast.Name() as called, keywords=[]):
            if called.id not in FUNCTIONS:
                raise InputError(formula._unknown("function", called, FUNCTIONS))
            count = FUNCTIONS[called.id][1]
            if len(node.args) != count:
                raise _refusal(node, formula, f"{called.id} takes {count} argument{'s' if count > 1 else ''}")
            for argument in node.args:
                _check(argument, formula, depth + 1)
        case _:
            raise _refusal(
                node, formula, "only numbers, names, + - * / % **, < > and known functions are allowed"
            )


def _refusal(node: ast.expr, formula: Formula, fault: str) -> InputError:
    return InputError(
        "{place}: {typed!r}, letter {col_offset}: {fault}",
        place=formula.where,
        typed=formula.text[:80],
        col_offset=node.col_offset + 1,
        fault=fault,
    )


def _value(node: ast.expr, known: Mapping[str, Value]) -> Value:
    """The value of a checked tree."""
    match node:
        case ast.Constant(value=int() | float() as number):
            return float(number)
        case ast.Name():
            return known[node.id]
        case ast.UnaryOp(op=op, operand=operand):
            value = _value(operand, known)
            return -value if isinstance(op, ast.USub) else value
        case ast.BinOp():
            return _OPERATORS[type(node.op)](_value(node.left, known), _value(node.right, known))
        case ast.Compare(ops=[op], comparators=[other]):
            return _COMPARISONS[type(op)](_value(node.left, known), _value(other, known))
        case ast.Call(func=ast.Name() as called):
            return FUNCTIONS[called.id][0](*(_value(argument, known) for argument in node.args))
        case _:
            raise AssertionError("a checked formula holds nothing else")
