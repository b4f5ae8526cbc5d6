"""`elastica help`: explain all keys of a strip and of a design file."""

from typing import Any

import click

from elastica_cad.cli.settings import GROUPS, CommandKeys
from elastica_cad.cli.strip_options import typed_name
from elastica_cad.cli.voice import answer, say
from elastica_cad.declared import REQUIRED, Kind, Record
from elastica_cad.design.model_tables import DesignKeys, makers_using
from elastica_cad.design.records import (
    current_path,
    help_with_unit,
    paths_of,
    require_path_of,
    title,
    written,
)
from elastica_cad.errors import Either, InputError, Listed, near_names, quoted


def _keys_beginning_with(_: click.Context, __: click.Parameter, typed: str) -> list[Any]:
    return [path for path in {**paths_of(DesignKeys), **paths_of(CommandKeys)} if path.startswith(typed)]


FORMS: tuple[tuple[Record, str], ...] = (
    (CommandKeys, ""),
    (DesignKeys, ""),
    (DesignKeys, "strips."),
    (DesignKeys, "pair."),
)
"""Records of keys that `--set` accepts, and the table of a design file that contains each key."""


@click.command("help")
@click.argument("key", required=False, shell_complete=_keys_beginning_with)
def help_command(key: str | None) -> None:
    """Explain a key or an option, or list all keys.

    KEY is a key of a strip or a design file, such as limits.ratio, or an option. Without it, all keys are listed.

    Set a key by its option, if `elastica strip --help` has one, by `--set KEY=VALUE`, or in a design file.
    """
    key = None if key is None else current_path(key)
    text = _list_of_keys() if key is None else _explanation(key, typed_name(key))
    answer({"key": key, "text": text})
    say(text)


def _in_words(kind: Kind) -> str:
    """Describe the valid values of a key.

    Examples
    --------
    >>> _in_words(paths_of(CommandKeys)["limits.strain"].kind)
    'true or false, or a number'
    """
    kind = written(kind)
    if kind.name == "either":
        return ", or ".join(dict.fromkeys(_in_words(alternative) for alternative in kind.of))
    if kind.name == "choice":
        return " or ".join(str(choice) for choice in kind.choices)
    if kind.record is not None:
        return f"table {title(kind.record)}"
    if kind.name == "list":
        inner, size = _in_words(kind.of[0]), "" if kind.size is None else f"{kind.size} "
        plural = {"a number": "numbers", "true or false": "times true or false"}.get(inner, f"times {inner}")
        return f"[{size}{plural}]" if inner in ("a number", "true or false") else f"list of {inner}"
    plain = {"number": "a number", "count": "a whole number", "flag": "true or false", "text": "a text"}
    return plain.get(kind.name, "names and their values")


def _explanation(path: str, option: str) -> str:
    """Return the explanation of a key with its values, bounds, default and keys below it.

    `option` is how a command sets the key.
    """
    record, key = next(
        ((record, f"{table}{path}") for record, table in FORMS if f"{table}{path}" in paths_of(record)),
        (DesignKeys, path),
    )
    if key not in paths_of(record):
        from elastica_cad.cli.strip_command import strip

        strip_options = [option for option in strip.params if isinstance(option, click.Option)]
        options = {name.lstrip("-"): option for option in strip_options for name in option.opts}
        word = path.lstrip("-")
        if word in options:
            typed = " ".join(filter(None, [f"--{word}", options[word].metavar]))
            return f"{path}\n  {options[word].help}\n  elastica strip: {typed}"
        near = [
            key for key in paths_of(record) if key.endswith(f".{word}") and not key.startswith("strips.")
        ] or [name for name in near_names(word, [*paths_of(record), *options]) if name in options]
        if near:
            raise InputError(
                "The key {path} does not exist: did you mean {near}?", path=quoted(path), near=Either(near)
            )
    field = require_path_of(key, record)
    declaration = field.option
    lines = [help_with_unit(field.help, declaration.unit), f"Value: {_in_words(field.kind)}."]
    if declaration.bounds:
        lines.append(f"Bounds: {declaration.bounds}.")
    if isinstance(field.default, bool | int | float | str) and field.default != "":
        text = f"Default: {field.default}."
        lines.append(text.lower() if isinstance(field.default, bool) else text)
    elif field.default is REQUIRED:
        lines.append("Required.")
    split = (inner_key.rpartition(".") for inner_key in paths_of(record))
    inner = [name for table, _, name in split if table == key]
    if inner:
        lines.append(f"Keys below it: {', '.join(inner)}.")
    if makers := makers_using(path.partition(".")[0]):
        lines.append(f"At the top of a design file, it applies to {Listed(makers)}.")
    typed = f"{option}=VALUE" if option.startswith("--set") else option
    setting = f"elastica strip: {typed}" if record is CommandKeys else "elastica model: a design file"
    return "\n".join([path, *(f"  {line}" for line in [*lines, setting])])


def _list_of_keys() -> str:
    """Return all keys by group, down to the second level."""
    keys = paths_of(CommandKeys)
    heads = {f"{group}:": group for group in GROUPS} | {"whole models, in design files:": ""}
    lines = []
    for head, group in heads.items():
        lines += ["", head]
        for path, field in (keys if group else paths_of(DesignKeys)).items():
            first = path.partition(".")[0]
            listed = keys[first].option.group == group if group else first not in {*keys, "strips"}
            if listed and path.count(".") <= 1:  # deeper keys are explained one by one
                lines.append(f"  {path:<24} {help_with_unit(field.help, field.option.unit)}")
    return "\n".join(lines[1:])
