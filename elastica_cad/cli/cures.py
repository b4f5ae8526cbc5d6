"""What a refusal ends with: the command that would work, tried before it is said, and what it costs."""

import shlex
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

import click

from elastica_cad.errors import ElasticaError
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.fabrication.strip_spec import StripSpec
from elastica_cad.forming.limits import Keep, Limits
from elastica_cad.forming.nearest.nearest_record import NearestRod

TYPED = "elastica.typed"
"""Key of the words that the user typed, in click's `meta`."""

NEAREST = "--nearest"


def _typed_command(*added: str) -> str:
    """The running command as it was typed with options behind it, which outweigh those of the same name before."""
    words: Sequence[str] = click.get_current_context().meta.get(TYPED, ())
    return shlex.join(["elastica", *(word for word in words if word != NEAREST), *added])


def cure_for(spec: StripSpec) -> str:
    """A sentence with a command that makes a strip of this request after all; empty where none was found.

    The ways are tried in order, and the first that succeeds is told: the nearest curve within sheet and widths,
    then with a free end, then a wider strip.
    """
    for added, fields in _ways(spec):
        try:
            changed = spec.changed(**fields)
            found = changed.rod_spec.solve()
            made = changed.make(found)
        except ElasticaError:
            continue
        if isinstance(found, NearestRod):
            return f"This works: `{_typed_command(*added)}` {_costs(found, made)}."
    return ""


def _ways(spec: StripSpec) -> Iterator[tuple[tuple[str, ...], dict[str, Any]]]:
    """Words to add and the fields that they change, the smallest change first."""
    if spec.natural_curvature or spec.loads or spec.samples is not None:
        return  # such strips follow their curve exactly
    limits, keep = spec.limits or Limits(), spec.keep or Keep()
    if not spec.may_change:
        yield (NEAREST,), {"limits": limits, "keep": keep}
    if keep.both_ends == (True, True):
        freed = replace(keep, ends=(True, False))
        yield (NEAREST, "--keep-ends", "start"), {"limits": limits, "keep": freed}
    if spec.max_width is not None:
        wider = round(2 * spec.max_width, 3)
        yield ("--max-width", f"{wider:g}", NEAREST), {"limits": limits, "keep": keep, "max_width": wider}


def _costs(near: NearestRod, made: Strip) -> str:
    strain = 100 * made.max_strain / made.strain_limit
    return (
        f"bends to within {near.deviation:.2g} mm of the drawn curve, ratio {made.rod.ratio:.2g}, "
        f"{strain:.0f} % of the strain that {made.sheet.name} bears"
    )
