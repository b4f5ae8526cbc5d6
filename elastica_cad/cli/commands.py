"""The command group `elastica`, and the error messages, JSON records and option checks of all commands."""

from collections.abc import Iterator, Mapping
from contextlib import contextmanager, nullcontext
from functools import cache, partial
from importlib import import_module
from itertools import islice
from typing import Any

import click
import numpy as np

from elastica_cad._text import MADE_BY, command_of_drawings
from elastica_cad.cli.options import UNITS, Chosen, Length, option_name, typed_options
from elastica_cad.cli.suggestions import SUGGEST, TYPED, refuse_extra_words
from elastica_cad.cli.voice import echo, exit_code, progress_shown, remake_on_change, say_error, voice, warn
from elastica_cad.declared import Record
from elastica_cad.defaults import BAD_INPUT, OUTPUT_CLOSED
from elastica_cad.errors import (
    SPELLING,
    Either,
    ElasticaError,
    InputError,
    NotMetError,
    ended,
    installed_version,
    near_names,
)
from elastica_cad.formats.source_file import LARGEST_NUMBER, LARGEST_SIZE
from elastica_cad.mechanics.theorem1 import NotRealizable
from elastica_cad.plot.drawing_process import DrawingProcess

COMMANDS = {
    "new": "new_command:new",
    "check": "check_command:check",
    "strip": "strip_command:strip",
    "pair": "pair_command:pair",
    "model": "model_command:model",
    "batten": "batten_command:batten",
    "bow": "bow_command:bow_command",
    "bend": "bend_command:bend_command",
    "reshape": "reshape_command:reshape",
    "sections": "sections_command:sections",
    "coupon": "coupon_command:coupon",
    "compare": "compare_command:compare",
    "sheets": "sheets_command:sheets",
    "studio": "studio_command:studio",
    "help": "help_command:help_command",
}
"""Module and function of each command. The module is imported on first use."""

IN_FIXED_UNITS = {
    "settings": 'lengths are in mm, as in design files, and not in --units; 5 inches are "5*inch"',
    "natural_curvature": "the value is in 1/mm, not in --units; 1/inch is 0.03937",
}
"""Notes on options in fixed units, to which `--units` does not apply, by the names of their parameters."""

FILES = {
    "curve": "name a file with the curve, such as arch.dxf, or - for standard input",
    "first": "name the file with the first rest shape, or a design file with a table [pair]",
    "design": "name a design file; `elastica new pavilion` writes an example",
    "mesh": "name the file of a mesh (OBJ, STL, PLY) or of a STEP body",
}
"""Instructions for missing input files, by the name of the argument."""

FIRST_WORDS: dict[type[ElasticaError], str] = {
    NotRealizable: "Not realizable: ",
    NotMetError: "Not within these limits: ",
}
"""First words of the error message for some classes of errors."""


def _print_version(ctx: click.Context, _: click.Parameter, is_wanted: bool) -> None:
    if not is_wanted:
        return
    echo(f"elastica, version {installed_version('elastica-cad') or 'from a checkout'}")
    ctx.exit()


class _OnDemand(Mapping[str, click.Command]):
    """The commands by name, each imported when it is used."""

    def __getitem__(self, name: str) -> click.Command:
        return _imported(name)

    def __len__(self) -> int:
        return len(COMMANDS)

    def __iter__(self) -> Iterator[str]:
        return iter(COMMANDS)


@cache
def _imported(name: str) -> click.Command:
    module, function = COMMANDS[name].split(":")
    command = getattr(import_module(f"elastica_cad.cli.{module}"), function)
    return _complete(command)


@contextmanager
def _quiet_pipes(context: click.Context | None = None) -> Iterator[None]:
    """Print usage errors as rows. Print nothing if the output is closed, as in `elastica sheets | head -1`."""
    try:
        yield
    except BrokenPipeError:
        raise click.exceptions.Exit(OUTPUT_CLOSED) from None
    except click.UsageError as problem:
        if isinstance(problem, getattr(click.exceptions, "NoArgsIsHelpError", ())):
            raise
        raise _UsageRow(ended(_usage_message(problem, context))) from problem


class _UsageRow(click.ClickException):
    """Error in typed words, printed as one row."""

    exit_code = BAD_INPUT

    def show(self, _: Any = None) -> None:
        say_error(self.message)


class _Sentences(click.Group):
    """Command group that prints errors as sentences with suggestions."""

    def make_context(self, *args: Any, **options: Any) -> click.Context:
        with _quiet_pipes():
            return super().make_context(*args, **options)

    def format_help_text(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        from elastica_cad.files import listed_formats

        self.help = (self.help or "").replace("FORMATS", listed_formats())
        super().format_help_text(ctx, formatter)

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        ctx.meta[TYPED] = tuple(args)
        return super().parse_args(ctx, _common_options_first(args))

    def resolve_command(self, ctx: click.Context, args: list[str]) -> Any:
        if args[0] not in COMMANDS and not args[0].startswith("-"):
            near = near_names(args[0], COMMANDS)
            advice = f"Did you mean {near[0]!r}?" if near else "`elastica --help` lists all commands."
            ctx.fail(f"There is no command {args[0]!r}. {advice}")
        return super().resolve_command(ctx, args)

    def invoke(self, ctx: click.Context) -> Any:
        """Run a command with its spelling of options in messages, and print errors as sentences."""
        before = MADE_BY.set(command_of_drawings(ctx.meta[TYPED]))
        ctx.call_on_close(lambda: MADE_BY.reset(before))
        spelled = SPELLING.set(_spelled)
        ctx.call_on_close(lambda: SPELLING.reset(spelled))
        with _quiet_pipes(ctx):
            try:
                return super().invoke(ctx)
            except ElasticaError as problem:
                ctx.exit(_refuse(problem))


# a design file has both supports in one list
SUPPORTS_IN_DESIGN = {
    "supports.start": "the first value of supports", "supports.end": "the second value of supports",
}  # fmt: skip


def _spelled(path: str) -> str:
    """Return the option that sets a field. Without such an option, name a key of `elastica strip`."""
    if path == "rod.curve":
        return "the file NAME.json of `elastica strip`"
    context, typed = click.get_current_context(), option_name(path.rpartition(".")[2])
    # `elastica bend` has --hold-start, other commands have --start
    held = f"--hold{typed[1:]}" if path.startswith("supports.") else typed
    for option in (held, typed):
        if any(option in parameter.opts for parameter in context.command.params):
            return option
    if context.info_name == "strip":
        from elastica_cad.cli.strip_options import typed_name

        return typed_name(path) or path
    if context.info_name == "model":  # fields are keys of the design file
        return SUPPORTS_IN_DESIGN.get(path, path)
    records = _records_of(context)
    if records:
        from elastica_cad.design.records import paths_of

        return f"--set {path}" if any(path in paths_of(record) for record in records) else path
    return f"{path} of `elastica strip`"


ANYWHERE = {"-q": 0, "--quiet": 0, "--watch": 0, "--units": 1}
"""Options of `elastica` that may also follow the name of a command, and their numbers of values."""


def _common_options_first(args: list[str]) -> list[str]:
    """Return the words with the options of `elastica` before the command, so that they can be typed anywhere."""
    first: list[str] = []
    remaining: list[str] = []
    words = iter(args)
    for word in words:
        if word == "--":
            return [*first, *remaining, word, *words]
        name, equals_sign, _ = word.partition("=")
        (first if name in ANYWHERE else remaining).append(word)
        if name in ANYWHERE and not equals_sign:
            first += islice(words, ANYWHERE[name])
    return [*first, *remaining]


def _records_of(context: click.Context) -> list[Record]:
    """Return the records of the keys that `--set` of the command takes."""
    return [
        record
        for param in context.command.params
        if (record := getattr(param.type, "record", None)) is not None
    ]


def _instead_of(problem: click.NoSuchOption) -> str:
    """Return the sentence on an unknown option, with the option or the key of a file that was probably meant."""
    typed, context = problem.option_name, problem.ctx
    assert context is not None
    command, word = context.command_path, typed.lstrip("-")
    name = word.replace("-", "_")
    options = [option for param in context.command.params for option in param.opts]
    words = [option.lstrip("-") for option in options]
    if near := near_names(word, words, cutoff=0.8):
        return f"`{command}` has no option {typed}. Did you mean --{near[0]}?"
    # options with the same use in different commands
    if name == "name" and "--label" in options:
        return f"{typed} is called --label"
    from elastica_cad.cli.settings import CommandKeys
    from elastica_cad.design.model_tables import DesignKeys
    from elastica_cad.design.records import is_settable, meant_paths, paths_of
    from elastica_cad.design.tables import OTHER_WORDS

    # keys of a design file with this name
    of_designs = [path for path in paths_of(DesignKeys) if path.rpartition(".")[2] == name]
    for record in _records_of(context):
        keys = paths_of(record)
        if paths := meant_paths(name, keys):
            key = f"pair.{paths[0]}" if context.info_name == "pair" else paths[0]
            instead = Either(
                own
                if (own := option_name(path.rpartition(".")[2])) in options
                else f"--set {path}=VALUE"
                if is_settable(path, keys)
                else f"{path} in the design file"
                for path in paths
            )
            explained = f"`elastica help {key}` explains it"
            if name in OTHER_WORDS or paths[0].rpartition(".")[2] == name:
                return f"use {instead} instead of {typed}: {explained}"
            if not of_designs:
                return f"`{command}` has no option {typed}. Did you mean {instead}? {explained}."
    near = near_names(word, words)
    # option of `elastica strip` with this name or meaning, or ""
    strip_has = typed if any(typed in param.opts for param in _imported("strip").params) else ""
    if not strip_has and (new := OTHER_WORDS.get(name)) in paths_of(CommandKeys):
        strip_has = f"--set {new}"
    if of_designs and not strip_has:
        keys_of_designs = f"{Either(of_designs[:5])}. `elastica help {of_designs[0]}` explains it."
        return f"`{command}` has no option {typed}, which is a key of design files: {keys_of_designs}"
    has = f"; `elastica strip` has {strip_has}" if strip_has else ""
    advice = f"Did you mean --{near[0]}?" if near else f"`{command} --help` lists all options."
    return f"`{command}` has no option {typed}{has}. {advice}"


def _usage_message(problem: click.UsageError, context: click.Context | None) -> str:
    """Return the message of an error in typed words, with what is needed instead."""
    match problem:
        case click.NoSuchOption():
            return _instead_of(problem)
        case click.MissingParameter() if needed := _instruction_for_missing(problem.param):
            return f"{problem.format_message().rstrip('.')}: {needed}"
        case click.BadOptionUsage() if context is not None and context.invoked_subcommand:
            for option in _imported(context.invoked_subcommand).params:
                if isinstance(option, click.Option) and problem.option_name in option.opts and option.metavar:
                    values = f"{option.nargs} values, " if option.nargs > 1 else ""
                    return f"{problem.option_name} needs {values}{option.metavar}. {option.help}"
    return problem.format_message()


def _instruction_for_missing(param: click.Parameter | None) -> str:
    if isinstance(param, click.Option) and param.metavar and param.help:
        return f"give {param.opts[0]} {param.metavar}. {param.help.rstrip('.')}"
    return FILES.get(param.name or "", "") if isinstance(param, click.Argument) else ""


@click.group(
    cls=_Sentences,
    commands=_OnDemand(),
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
)
@click.option("--version", is_flag=True, is_eager=True, expose_value=False, callback=_print_version,
              help="Show the version and exit.")  # fmt: skip
@click.option("-q", "--quiet", is_flag=True, help="Print errors only.")
@click.option("--units", type=click.Choice(list(UNITS)), default="mm", show_default=True,
              help="Unit of lengths in options; a length may have its own unit: 1.5in.")  # fmt: skip
@click.option("--watch", is_flag=True, help="Run again when an input file is saved; stop with Ctrl-C.")
def elastica(quiet: bool, units: str, watch: bool) -> None:
    """Design flat strips that bend into a drawn curve.

    \b
    A first session:
      elastica check arch.dxf                       check whether a strip can take the curve
      elastica sheets                               list the known materials
      elastica strip arch.dxf --sheet birch-plywood-0.8 --max-width 40 -o out
      elastica new pavilion                         a commented design file to start from
      elastica model pavilion.toml -o out           many strips: slots, base, parts on sheets, cut list
      elastica batten --length 2400 --camber 10 --at 40 --sheet pom-1 --stock 25 8
                                                    a sail batten planed from a bar 25 mm wide and 8 mm thick,
                                                    deepest at 40 % of its chord, by 10 % of the chord
      elastica bow arch.dxf --rod 8                 a rod bent by a cord
      elastica sections pot.obj --radial 16         curves where 16 half planes cut a mesh or a STEP body

    Curves come from files: FORMATS. Lengths are in mm, or in their own unit: 1.5in, 4cm. Every command has --json
    and -v. The options below may stand before or after the command. `elastica help` lists all settings of a strip
    (keys of a design file and of --set), and `elastica help KEY` explains a key.

    Exit codes: 0 done, with warnings or without; 1 the input is valid, but no strip can be made (no strip can take
    the curve, this is undecided, a limit of the request or of the workshop is not met, such as --margin, --ratio or
    a least width, no solution was found, or the sheet is likely to break); 2 bad input; 130 stopped by Ctrl-C; 141
    the program that reads the output, such as `head`, ended early. Of several curves, the largest code counts.

    A sheet is likely to break above its breaking strain: 1.5 times the allowed strain for wood and plywood, more
    for other listed sheets, unknown for card, metals and polypropylene. If the strain is above the allowed strain
    only, `elastica strip` warns and exits with 0, or with 1 if --set files.strict=true is given.
    """


def _complete(command: click.Command) -> click.Command:
    """Add `--json` and `-v` to a command, and apply the options of `elastica`."""
    run, parameter_names = command.callback, {param.name for param in command.params}
    assert run is not None
    # `refuse_extra_words` reports extra words, with advice
    command.allow_extra_args = True
    command.params += [
        _output_flag("--json", "as_json", help="Print the answer as one JSON record (docs/json.md)."),
        _output_flag("-v", "--verbose", help="Print every step with its seconds, and all notes."),
    ]  # fmt: skip
    # the page of `elastica studio` runs until it is stopped
    reads = command.name != "studio" and any(
        isinstance(parameter, click.Argument) and isinstance(parameter.type, click.Path)
        for parameter in command.params
    )

    def run_with_root_options(**chosen: Any) -> None:
        """Run the command with the options of `elastica`: once, or with --watch after each change of its files."""
        root_options = click.get_current_context().find_root().params
        watched = bool(root_options.get("watch"))
        voice().quiet = bool(root_options.get("quiet"))
        refuse_extra_words(click.get_current_context().args)
        if watched and not reads:
            raise InputError("--watch applies only to commands that read files and end. Leave out --watch.")
        typed = {} if root_options.get("units", "mm") == "mm" else typed_options()
        notes = [f"Note: {typed[name]}: {text}" for name, text in IN_FIXED_UNITS.items() if name in typed]
        _check_numbers(chosen)
        if not watched:
            _run_once(run, chosen, notes)
            return

        def make() -> None:
            try:
                _run_once(run, chosen, notes)
            except click.exceptions.Exit:
                # the run has concluded with an exit code; continue to watch the files
                pass
            except ElasticaError as problem:
                _refuse(problem)
                return
            if "force" in parameter_names:
                # without `force`, the next run would refuse to overwrite the files
                chosen["force"] = True

        remake_on_change(make, partial(echo, err=True))

    command.callback = run_with_root_options
    return command


def _check_numbers(chosen: Chosen) -> None:
    """Refuse numbers that are not finite or far too large."""
    context = click.get_current_context()
    for option in context.command.params:
        kinds = option.type.types if isinstance(option.type, click.Tuple) else [option.type]
        is_length = any(isinstance(kind, Length) for kind in kinds)
        most, what = (LARGEST_SIZE, "a length") if is_length else (LARGEST_NUMBER, "a number")
        for number in _numbers(chosen.get(str(option.name))):
            if not np.isfinite(number):
                raise InputError("{opts} is not finite. Use finite numbers.", opts=option.opts[0])
            # `sections` itself rejects numbers too large for a surface
            if abs(number) > most and context.info_name != "sections":
                unit = " mm" if is_length else ""
                raise InputError(
                    "{opts} is {number:.3g}{unit}, above the limit. Use {what} of at most {most:g}{unit}.",
                    opts=option.opts[0],
                    number=number,
                    unit=unit,
                    what=what,
                    most=most,
                )


def _numbers(value: Any) -> Iterator[float]:
    """Yield all numbers in a value. Integers too large for a float become 1e300."""
    if isinstance(value, tuple | list):
        for item in value:
            yield from _numbers(item)
    elif isinstance(value, float | int) and not isinstance(value, bool):
        yield float(value) if isinstance(value, float) or abs(value) < 10**300 else 1e300


def _output_flag(*names: str, help: str) -> click.Option:

    def set_voice(_: click.Context, param: click.Parameter, value: bool) -> None:
        if value:
            setattr(voice(), str(param.name), True)

    return click.Option(
        list(names), is_flag=True, is_eager=True, expose_value=False, callback=set_voice, help=help
    )


def _run_once(run: Any, chosen: Chosen, in_mm: list[str]) -> None:
    """Run a command, and print its answer, also if it ends with an exit code."""
    voice().begin()
    for sentence in in_mm:
        warn(sentence)
    working = progress_shown if voice().command != "studio" else nullcontext
    try:
        with working():
            run(**chosen)
    except MemoryError:
        raise ElasticaError(
            "There is not enough memory. Request less at a time, such as fewer strips or samples."
        ) from None
    except click.exceptions.Exit:
        voice().conclude()
        raise
    voice().conclude()


def _refuse(problem: ElasticaError) -> int:
    """Print an error with suggestions, and return its exit code.

    An undecided check is not introduced as an error.
    """
    if (process := click.get_current_context().find_object(DrawingProcess)) is not None:
        process.end()
    begins, code = FIRST_WORDS.get(type(problem), ""), exit_code(problem)
    # if the check is undecided, the curve may be realizable
    undecided = bool(problem.details)
    text, option = f"{'' if undecided else begins}{problem}", problem.refusal.where.get("option", "")
    unnamed = [name for name in option.split(", ") if name and name not in text]
    text += f" ({', '.join(unnamed)})" if unnamed else ""
    search = click.get_current_context().meta.get(SUGGEST, lambda _: [])
    voice().refuse(ended(text), problem, code, partial(search, problem))
    return code
