"""Options for rails, pins, ties and loads between the ends of a strip."""

import re
from collections.abc import Callable, Iterable, Iterator
from itertools import islice
from typing import Any

import click

from elastica_cad.cli.options import Chosen, Length, join_options, option_name, option_of
from elastica_cad.declared import REQUIRED, Field, declared
from elastica_cad.mechanics.elements import Pin, PointForce, Rail, Tie
from elastica_cad.mechanics.loads import PointMass

# class and help of each element, by the name of its option
RECORDS: dict[str, tuple[type, str]] = {
    "rail": (Rail, "Rail across the strip, which slides over it."),
    "pin": (
        Pin,
        "Pin that holds a place of the strip and lets it turn: a ring around the strip, or a hinge screwed to it.",
    ),
    "tie": (Tie, "Taut cord between two places."),
    "point_force": (PointForce, "Force in newtons, along x and y."),
    "point_mass": (PointMass, "Mass that hangs at a place, in g or with its unit: 8kg."),
}

ELEMENTS, LOADS = ("rail", "pin", "tie"), ("point_force", "point_mass")

CUTS = ("hole", "notch")
"""Fields of pins and ties for cuts in the strip. Each field has one option for all pins and ties."""


class Place(Length):
    """Parameter type of a position on a strip: a length along its curve, or a point X,Y near the strip."""

    name = "place"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Return the length along the curve, mm, or the point (x, y), mm."""
        if isinstance(value, str) and value.strip().endswith("%"):
            self.fail(
                f"{value!r} is a percentage. Give the distance from the start of the curve, in mm.",
                param,
                ctx,
            )
        if not isinstance(value, str) or value.count(",") != 1:
            return super().convert(value, param, ctx)
        return tuple(super(Place, self).convert(part, param, ctx) for part in value.split(","))


class Mass(click.ParamType):  # type: ignore[type-arg]  # no generic class before click 8.2
    """Parameter type of a mass in g: "250", "250g", "8kg"."""

    name = "mass"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> float:
        """Return the mass, g."""
        match = re.fullmatch(r"\s*([-+.\deE]+?)\s*(k?g)?\s*", str(value))
        try:
            return float(match[1] if match else "") * (1000.0 if match and match[2] == "kg" else 1.0)
        except ValueError:
            self.fail(
                f"{value!r} is not a mass. Give grams, or a mass with its unit such as 8kg.",
                param,
                ctx,
            )


def _fields(name: str) -> list[Field]:
    # the option of an element takes its required fields, in their order
    return [field for field in declared(RECORDS[name][0]) if field.default is REQUIRED]


def _types(field: Field) -> Iterator[tuple[Any, str]]:
    """Yield the type and the name of each value of a field: two values for X and Y."""
    if field.option.unit == "mm":
        yield Place(), field.name.upper()
    elif field.option.unit == "g":
        yield Mass(), field.name.upper()
    elif field.kind.name == "list":
        yield from ((float, axis) for axis in "XY")
    else:
        yield float, field.name.upper()


def element_options(names: Iterable[str] = tuple(RECORDS)) -> Callable[[Any], Any]:
    """Return a decorator that adds repeatable options for rails, pins, ties and loads."""

    def option(name: str) -> Callable[[Any], Any]:
        types, words = zip(*(pair for field in _fields(name) for pair in _types(field)), strict=True)
        return click.option(
            option_name(name), name, type=types if len(types) > 1 else types[0], multiple=True,
            metavar=" ".join(words),
            help=f"{RECORDS[name][1]} A place is in mm along the curve, or X,Y near it. Repeatable.",
        )  # fmt: skip

    return join_options(*map(option, names))


def cut_options() -> Callable[[Any], Any]:
    """Return a decorator that adds the options for holes and notches of pins and ties."""
    cuts = (field for field in declared(Pin) if field.name in CUTS)
    return join_options(*(option_of(field, more=" For each --pin and --tie.") for field in cuts))


def element_table(chosen: Chosen) -> dict[str, Any]:
    """Return the keys `between` and `loads` of a design file for the given options."""
    cuts = {name: chosen[name] for name in CUTS if chosen.get(name) is not None}
    table: dict[str, Any] = {}
    for key, names in (("between", ELEMENTS), ("loads", LOADS)):
        rows = [
            ({"kind": name} if key == "between" else {})
            | _values(name, values)
            | (cuts if name in ("pin", "tie") else {})
            for name in names
            for values in chosen.get(name) or ()
        ]
        table |= {key: rows} if rows else {}
    return table


def elements_of(chosen: Chosen, names: Iterable[str]) -> tuple[Any, ...]:
    """Return a record for every given option."""
    return tuple(
        RECORDS[name][0](**_values(name, values)) for name in names for values in chosen.get(name) or ()
    )


def _values(name: str, values: Any) -> dict[str, Any]:
    """Return the required fields of a record by name, from the values of its option.

    A field of the kind list takes two values, X and Y. A place given as X,Y is a tuple and becomes a list.
    """
    fields = _fields(name)
    remaining = iter([values] if len(fields) == 1 else values)
    row: dict[str, Any] = {}
    for field in fields:
        value, *others = islice(remaining, len(list(_types(field))))
        row[field.name] = [value, *others] if others else list(value) if isinstance(value, tuple) else value
    return row
