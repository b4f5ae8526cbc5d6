"""Tables of a design file: access to values, evaluation of formulae, and errors about unknown keys."""

import ast
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from difflib import get_close_matches
from functools import lru_cache
from types import UnionType
from typing import Any, TypeAlias

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import FloatArray
from elastica_cad._units import MM_PER_INCH
from elastica_cad.errors import FieldName, InputError, Refusal, ended, near_names, note, quoted, sentences
from elastica_cad.formats.source_file import LARGEST_NUMBER

Value: TypeAlias = "float | FloatArray"

LARGEST_RESULT = 1e300
"""Largest result of a formula. The sum of a few such results is still finite."""

CONSTANTS = {"pi": float(np.pi), "e": float(np.e), "degrees": float(np.pi / 180), "inch": MM_PER_INCH}
"""Constants in formulae: 30*degrees is an angle in radians, and 1.5*inch a length in mm."""

FUNCTIONS: dict[str, tuple[Callable[..., Value], int]] = {
    "abs": (np.abs, 1), "sqrt": (np.sqrt, 1), "exp": (np.exp, 1), "log": (np.log, 1),
    "sin": (np.sin, 1), "cos": (np.cos, 1), "tan": (np.tan, 1),
    "asin": (np.arcsin, 1), "acos": (np.arccos, 1), "atan": (np.arctan, 1), "atan2": (np.arctan2, 2),
    "sinh": (np.sinh, 1), "cosh": (np.cosh, 1), "tanh": (np.tanh, 1), "hypot": (np.hypot, 2),
    "floor": (np.floor, 1), "sign": (np.sign, 1), "min": (np.minimum, 2), "max": (np.maximum, 2),
    "where": (np.where, 3),
}  # fmt: skip
"""Functions in formulae, and their numbers of arguments. where(condition, a, b) is a if the condition is
true, else b.
"""

_OPERATORS: dict[type[ast.operator], Callable[[Value, Value], Value]] = {
    ast.Add: np.add, ast.Sub: np.subtract, ast.Mult: np.multiply, ast.Div: np.divide, ast.Pow: np.power,
    ast.Mod: np.mod,
}  # fmt: skip

_COMPARISONS: dict[type[ast.cmpop], Callable[[Value, Value], Value]] = {
    ast.Lt: np.less, ast.LtE: np.less_equal, ast.Gt: np.greater, ast.GtE: np.greater_equal,
}  # fmt: skip


@dataclass(frozen=True)
class Formula:
    """A parsed and checked formula.

    Parameters
    ----------
    text : str
        Numbers, names, + - * / % **, comparisons, and calls of `FUNCTIONS`.
    where : str
        Name of the formula in messages, such as its position in a design file.

    Examples
    --------
    >>> Formula("hypot(3, 4) * x")(x=2.0)
    10.0
    """

    text: str
    where: str = "formula"

    def __post_init__(self) -> None:
        _require_arithmetic(self._parsed[0], self)

    @property
    def names(self) -> frozenset[str]:
        """Names in the formula that need a value."""
        tree, names = self._parsed
        calls = {node.func for node in ast.walk(tree) if isinstance(node, ast.Call)}
        return frozenset({node.id for node in names if node not in calls} - set(CONSTANTS))

    @property
    def _shown(self) -> str:
        return self.text[:200]

    @cached_property
    def _parsed(self) -> tuple[ast.expr, tuple[ast.Name, ...]]:
        if len(self.text) > 2000:
            raise InputError(
                "{place}: a formula of {count} characters is too long. Name parts of the formula in a table "
                "'let'.",
                place=self.where,
                count=len(self.text),
            )
        try:
            return _parsed(self.text)
        except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
            # releases of Python raise different errors; only an error with a place is about missing characters
            place = getattr(error, "offset", None)
            if place is None:
                raise InputError(
                    "{place}: {typed!r} cannot be read as a formula. Correct it.",
                    place=self.where,
                    typed=self._shown,
                ) from error
            raise InputError(
                "{place}: the formula {typed!r} cannot be read at {at}. Correct it there.",
                place=self.where,
                typed=self._shown,
                at=f"character {place}" if place else "its end",
            ) from error

    def __call__(self, values: Mapping[str, Value] | None = None, **more: Value) -> Value:
        """Return the value of the formula for values of its names, in a mapping or as keywords.

        Arrays are computed elementwise.
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
                (
                    "{place}: the value of {typed!r} is not finite. Look for a division by 0 or the root of a "
                    "negative number."
                ),
                place=self.where,
                typed=self._shown,
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
            "{place}: unknown {thing} {name!r} at character {letter} of {formula!r}; {hint}",
            place=self.where, thing=kind, name=node.id[:LONGEST_KEY], letter=node.col_offset + 1,
            formula=self._shown, hint=hint,
        )  # fmt: skip


@lru_cache(maxsize=256)
def _parsed(text: str) -> tuple[ast.expr, tuple[ast.Name, ...]]:
    """Return the syntax tree and all names in a formula; cached, because many strips have the same formulae."""
    tree = ast.parse(text.strip(), mode="eval").body
    return tree, tuple(node for node in ast.walk(tree) if isinstance(node, ast.Name))


def _require_arithmetic(node: ast.expr, formula: Formula, depth: int = 0) -> None:
    """Refuse all parts of a formula except numbers, names, known operators and known functions."""
    if depth > 60:  # below the limit of Python's parser
        raise _refusal(
            node, formula, "the formula is nested too deeply; name parts of the formula in a table 'let'"
        )
    match node:
        case ast.Constant(value=bool() | complex() | str() | bytes() | None):
            raise _refusal(node, formula, f"{repr(node.value)[:LONGEST_KEY]} is not a number; write a number")
        case ast.Constant(value=int() | float() as number):
            if abs(number) > LARGEST_RESULT:
                raise _refusal(
                    node,
                    formula,
                    f"the number is larger than the limit of {LARGEST_RESULT:g}; write a smaller number",
                )
        case ast.Name():
            if node.id in FUNCTIONS:
                raise _refusal(node, formula, f"{node.id} is a function; write its arguments in brackets")
        case ast.UnaryOp(op=ast.USub() | ast.UAdd()):
            pass
        case ast.BinOp():
            if type(node.op) not in _OPERATORS:
                hint = "write ** for powers" if isinstance(node.op, ast.BitXor) else "use + - * / % **"
                raise _refusal(node, formula, f"this operator is not known; {hint}")
        case ast.Compare(ops=[op]) if type(op) in _COMPARISONS:
            pass
        case ast.Call(func=ast.Name() as called, keywords=[]):
            if called.id not in FUNCTIONS:
                raise InputError(formula._unknown("function", called, FUNCTIONS))
            count = FUNCTIONS[called.id][1]
            if len(node.args) != count:
                raise _refusal(
                    node,
                    formula,
                    f"{called.id} takes {count} argument{'s' if count > 1 else ''}, "
                    f"not {len(node.args)}; correct the call",
                )
        case _:
            raise _refusal(
                node,
                formula,
                "only numbers, names, + - * / % **, < > and known functions are allowed; leave out this part",
            )
    for part in node.args if isinstance(node, ast.Call) else ast.iter_child_nodes(node):
        if isinstance(part, ast.expr):
            _require_arithmetic(part, formula, depth + 1)


def _refusal(node: ast.expr, formula: Formula, fault: str) -> InputError:
    return InputError(
        "{place}: {typed!r}, character {col_offset}: {fault}",
        place=formula.where,
        typed=formula._shown,
        col_offset=node.col_offset + 1,
        fault=fault,
    )


def _value(node: ast.expr, known: Mapping[str, Value]) -> Value:
    """Return the value of a formula that `_require_arithmetic` accepted."""
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
            raise AssertionError("unexpected node in a formula that was checked before")


MOST_COUNTED = 10_000
"""Largest count in a file: of strips, sections or repeats."""

LONGEST_KEY = 60
"""Number of characters of an unknown key, name or text that a message shows."""

FORMER_KEYS = {"law": "section"}
"""Present names of keys of strips, by the former names that files, reports and `--set` still accept."""

OTHER_WORDS = {
    **FORMER_KEYS,
    "file": "curve", "path": "curve", "material": "sheet", "width": "max_width", "scale": "length",
    "curve": "strips.curve", "label": "strips.label", "style": "style.kind",
    "pages": "extras.pages", "paper": "extras.pages", "kerf": "cut.kerf", "outer_width": "style.width",
    "tab": "ends.length", "start": "supports", "end": "supports", "rail": "between", "pin": "between",
    "tie": "between", "point_mass": "loads", "point_force": "loads", "down": "gravity",
    "ratio": "limits.ratio", "margin": "limits.margin", "stable": "limits.margin", "nearest": "limits",
    "keep_strain": "limits.strain", "keep_ends": "keep.ends", "keep_tangents": "keep.tangents",
    "keep_length": "keep.length",
}  # fmt: skip
"""Correct key for words that users may write instead, such as the options of `elastica strip`."""


def _compute_number(value: object, where: str, scope: Mapping[str, Value]) -> float:
    """Return the number of a value, which may be a formula. `scope` has the values of names."""
    if isinstance(value, str):
        value = Formula(value, where)(scope)
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise InputError(
            "{place} is {given}. Write a number or a formula in quotes.",
            place=where,
            given=quoted(value),
        )
    if not -LARGEST_NUMBER <= value <= LARGEST_NUMBER:
        shown_value = f"{value:.3g}" if isinstance(value, float) else "a whole number of many digits"
        raise InputError(
            "{place} is {told}. Use a finite number of at most {largest_number:g}.",
            place=where,
            told=shown_value,
            largest_number=LARGEST_NUMBER,
        )
    return float(value)


def with_present_keys(table: Any) -> Any:
    """Return a table of a design, or a list of tables, in which the keys of strips have their present names.

    A former name beside the present name stays, and is refused as unknown.

    Examples
    --------
    >>> with_present_keys({"law": 1, "strips": [{"law": 2, "section": 3}]})
    {'section': 1, 'strips': [{'law': 2, 'section': 3}]}
    """
    if isinstance(table, list):
        return [with_present_keys(row) for row in table]
    if not isinstance(table, Mapping):
        return table
    present = {key: FORMER_KEYS.get(key, key) for key in table}
    return {
        key if present[key] in table else present[key]: (
            with_present_keys(value) if key in ("strips", "revolution") else value
        )
        for key, value in table.items()
    }


def merged(table: Mapping[str, Any], others: Mapping[str, Any]) -> dict[str, Any]:
    """Return a table with values replaced by those of another table, recursively."""
    result = dict(table)
    for key, value in others.items():
        inner = result.get(key)
        result[key] = merged(inner, value) if isinstance(inner, dict) and isinstance(value, dict) else value
    return result


class Slips:
    """Errors of a file, collected to be reported together."""

    def __init__(self) -> None:
        # sentences by the same sentence without its position
        self._texts: dict[str, str] = {}

    def add(self, sentence: str, where: str = "") -> None:
        """Add an error. The same error at another position is not added."""
        self._texts.setdefault(sentence.removeprefix(where), sentence)

    @contextmanager
    def gathering(self) -> Iterator[None]:
        """Collect the errors that a `with` block raises, so that reading continues after the block."""
        try:
            yield
        except InputError as problem:
            self.add(str(problem))

    @property
    def text(self) -> str:
        """Sentences for all errors, or "" if there are no errors."""
        *others, last = list(self._texts.values()) or [""]
        return sentences([*map(ended, others), last], " Also: ")

    def refuse(self) -> None:
        """Raise InputError with all errors, if there are any."""
        if self.text:
            raise InputError(self.text)


class Table:
    """A table of a design file and the names that its formulae may use.

    Parameters
    ----------
    data : mapping
        Values as parsed, by key.
    where : str
        Name of the file and of the table, for messages.
    scope : mapping
        Values of the names that formulae may use.
    defaults : Table, optional
        Table with the values of keys that are missing in `data`.
    """

    def __init__(
        self, data: object, where: str, scope: Mapping[str, Value], defaults: "Table | None" = None
    ) -> None:
        if not isinstance(data, Mapping):
            raise InputError(
                "{place} is {data}. Write a table of keys and values.", place=where, data=quoted(data)
            )
        self.data: Mapping[str, Any] = data
        self.where = where
        self.scope = scope
        self.defaults = defaults

    def only(self, *keys: str) -> "Table":
        """Return this table. Raise InputError if it has a key other than `keys`."""
        slips = Slips()
        for key in self.data:
            if key not in keys:
                # a meant key of another table has a dotted path
                meant = OTHER_WORDS.get(key.lower(), "")
                near = [meant] if meant in keys or "." in meant else near_names(key.lower(), keys)
                hint = (
                    note("did you mean {near}?", near=near[0])
                    if near
                    else note("known keys are {keys}", keys=", ".join(sorted(keys)))
                )
                slips.add(note(
                    "{place}: unknown key {key!r}; {hint}",
                    place=self.where, key=key[:LONGEST_KEY], hint=hint,
                ))  # fmt: skip
        slips.refuse()
        return self

    def place(self, key: str) -> str:
        """Return the name of a key in messages, with its file and table."""
        return note("{table}: {key}", table=self.where, key=key) if self.where else FieldName(key)

    @contextmanager
    def naming(self, key: str | None = None) -> Iterator[None]:
        """In a `with` block, add the name of this table, or of `key`, to errors that state no position."""
        try:
            yield
        except InputError as error:
            where = self.where if key is None else self.place(key)
            why = error.refusal
            # an error of an inner key already begins with the name of this table
            if where and not why.startswith(self.where or where):
                why = Refusal(
                    why.kind, "{place}: {why}", {"place": where, "why": why}, why.where, why.changes
                )
            raise InputError(why, kind=why.kind) from error

    def raw(self, key: str, default: Any = None) -> Any:
        """Return the parsed value of a key in this table or, if missing, in `defaults`."""
        if key in self.data:
            return self.data[key]
        return default if self.defaults is None else self.defaults.raw(key, default)

    def has(self, key: str) -> bool:
        """Return True if a key is in this table or in `defaults`."""
        return self.raw(key) is not None

    def number(self, key: str, default: float | None = None) -> float:
        """Return the value of a key as a number. A formula is computed."""
        value = self.raw(key, default)
        if value is None:
            raise InputError("{key} is missing. Add a number or a formula in quotes.", key=self.place(key))
        return _compute_number(value, self.place(key), self.scope)

    def maybe(self, key: str) -> float | None:
        """Return the value of a key as a number, or None if the key is missing."""
        return self.number(key) if self.has(key) else None

    def count(self, key: str) -> int:
        """Return the value of a key as a whole number from 1 to `MOST_COUNTED`; 1 if the key is missing."""
        value = self.number(key, 1)
        if value != int(value) or value < 1:
            raise InputError(
                "{key} is {given:.15g}. Use a whole number, 1 or more.", key=self.place(key), given=value
            )
        if value > MOST_COUNTED:
            raise InputError(
                "{key} is {given:g}, above the limit of {most}. Use a smaller number.",
                key=self.place(key),
                given=value,
                most=MOST_COUNTED,
            )
        return int(value)

    def vector(self, key: str, size: int) -> tuple[float, ...]:
        """Return the value of a key as `size` numbers, each written as a number or a formula."""
        value = self.raw(key)
        if not isinstance(value, list | tuple) or len(value) != size:
            raise InputError(
                "{key} is {given}. Write {size} numbers in brackets.",
                key=self.place(key),
                given=quoted(value),
                size=size,
            )
        return tuple(
            _compute_number(item, f"{self.place(key)}[{i}]", self.scope)
            for i, item in enumerate(value, start=1)
        )

    def _of_kind(self, kind: type | UnionType, key: str, message: str, default: Any = None) -> Any:
        # `message` is the template of the error, with {key} and {given}
        value = self.raw(key, default)
        if not isinstance(value, kind):
            raise InputError(message, key=self.place(key), given=quoted(value))
        return value

    def row(self, key: str) -> tuple[float, ...]:
        """Return the value of a key as numbers."""
        values = self._of_kind(list | tuple, key, "{key} is {given}. Write numbers in brackets.")
        return self.vector(key, len(values))

    def text(self, key: str, default: str | None = None, choices: Sequence[str] = ()) -> str:
        """Return the value of a key as a string. If `choices` are given, they must contain the string."""
        value: str = self._of_kind(str, key, "{key} is {given}. Write a text in quotes.", default)
        if choices and value not in choices:
            raise InputError(
                "{key} is {given}. Use one of {choices}.",
                key=self.place(key),
                given=quoted(value),
                choices=", ".join(choices),
            )
        return value

    def flag(self, key: str) -> bool:
        """Return the value of a key, which must be true or false."""
        return bool(self._of_kind(bool, key, "{key} is {given}. Write true or false."))

    def table(self, key: str) -> "Table":
        """Return the table that is the value of a key, or an empty table if the key is missing."""
        return Table(self.raw(key, {}), self.place(key), self.scope)

    def tables(self, key: str) -> "list[Table]":
        """Return the tables in the list that is the value of a key."""
        rows = self._of_kind(list, key, "{key} is {given}. Write a list of tables.", [])
        where = self.place(key)
        return [
            Table(row, note("{table}[{row}]", table=where, row=number), self.scope)
            for number, row in enumerate(rows, start=1)
        ]

    def within(self, let: object) -> dict[str, Value]:
        """Return the scope with the further names in `let`. The formula of a name may use earlier names."""
        scope = dict(self.scope)
        for name, value in Table(let, self.place("let"), scope).data.items():
            if not name.isidentifier():
                raise InputError(
                    "{place}: {name!r} is not a valid name. Use letters, digits and _.",
                    place=self.place("let"),
                    name=name,
                )
            scope[name] = _compute_number(value, f"{self.place('let')}.{name}", scope)
        return scope
