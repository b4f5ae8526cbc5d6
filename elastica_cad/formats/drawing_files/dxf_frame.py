"""What stands around the entities of a DXF file: made by ezdxf once for all drawings with the same layers."""

import io
import logging
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache, lru_cache
from importlib import import_module
from threading import Lock
from typing import TYPE_CHECKING, Any

from elastica_cad._types import FloatArray
from elastica_cad.errors import MissingDependencyError, how_to_install
from elastica_cad.fabrication.drawings.drawing import SHEET
from elastica_cad.formats.drawing_files.layers import LayerStyle

if TYPE_CHECKING:
    from ezdxf.document import Drawing as Document

DXF_VERSIONS = ("R12", "R2000", "R2004", "R2007", "R2010", "R2013", "R2018")

_TRUE_COLOR = DXF_VERSIONS[2:]
_OPTIONS = Lock()
_KEPT = 32  # files of a kit have a handful of sets of layers
_ENTITIES = "  0\nSECTION\n  2\nENTITIES\n"
_LATE = 0xFADE00000000  # numbers from here on are given while the file is written: they follow the entities'

# no drawing has them: they stand in the frame where each has its own
_LEFT, _LOW, _RIGHT, _HIGH, _X, _Y, _TALL = (float(f"{digit}.625e77") for digit in range(1, 8))


@dataclass(frozen=True, eq=False)
class DxfFrame:
    """A DXF file without entities.

    Attributes
    ----------
    document : ezdxf.document.Drawing
        Of which it was written.
    head, tail : str
        Before and behind the entities.
    owner : str
        Number of what owns the entities.
    first : int
        The first number that is free for them.
    group : str
        Number of an empty group that shows how all are written; empty in R12, which has none.
    late : int
        How many numbers follow those of the entities.
    """

    document: "Document"
    head: str
    tail: str
    owner: str
    first: int
    group: str
    late: int

    def around(
        self,
        entities: Sequence[str],
        groups: Sequence[tuple[str, Sequence[str]]],
        bounds: FloatArray,
        *,
        free: int,
    ) -> bytes:
        """The file with entities and groups, of a drawing with these bounds (2, 2), mm.

        Parameters
        ----------
        entities : sequence of str
        groups : sequence of (number, numbers of members)
        bounds : (2, 2) array
        free : int
            The first number that is not taken.
        """
        tail = self._with_groups(groups) if self.group else self.tail
        own = {f"{_LATE + k:X}": f"{free + k:X}" for k in range(self.late + 1)} | _numbers(bounds)
        return self.document.encode("".join([_filled(self.head, own), *entities, _filled(tail, own)]))

    def _with_groups(self, groups: Sequence[tuple[str, Sequence[str]]]) -> str:
        """The tail with groups for the empty one."""
        before, _, after = self.tail.partition(_name_of_group(1, self.group))
        names = [_name_of_group(k, number) for k, (number, _) in enumerate(groups, 1)]
        begin = after.index(f"  0\nGROUP\n  5\n{self.group}\n")
        end = after.index("\n  0\n", begin) + 1
        empty = after[begin:end].partition(self.group)
        filled = [
            "".join((empty[0], number, empty[2], *[f"340\n{member}\n" for member in members]))
            for number, members in groups
        ]
        return "".join((before, *names, after[:begin], *filled, after[end:]))


def dxf_frame(version: str, layers: tuple[tuple[str, LayerStyle], ...]) -> DxfFrame:
    """The frame of drawings with these layers and their styles.

    Raises
    ------
    MissingDependencyError
        ezdxf is not installed.
    """
    _ezdxf()
    return _written_frame(version, layers)


@lru_cache(maxsize=_KEPT)
def _written_frame(version: str, layers: tuple[tuple[str, LayerStyle], ...]) -> DxfFrame:
    with _plain_ezdxf() as ezdxf:
        document: Document = ezdxf.new(version, setup=False, units=ezdxf.units.MM)
        for layer, style in layers:
            index = _nearest_index(style.rgb)
            row = document.layers.add(style.name, color=index)
            if version in _TRUE_COLOR and ezdxf.colors.aci2rgb(index) != style.rgb:
                row.rgb = style.rgb
            if layer == SHEET and version != "R12":
                row.dxf.plot = 0  # seen, not worked
        low, high = (_LEFT, _LOW, 0.0), (_RIGHT, _HIGH, 0.0)
        document.modelspace().reset_extents(low, high)
        document.header["$EXTMIN"], document.header["$EXTMAX"] = low, high
        document.set_modelspace_vport(_TALL, (_X, _Y))
        first = int(str(document.entitydb.handles), 16)
        group = "" if version == "R12" else str(document.groups.new("LOOP_1").dxf.handle)
        document.entitydb.handles.reset(f"{_LATE:X}")
        _sort_classes(document)
        stream = io.StringIO()
        if version == "R12":
            stream.write("999\nall lengths in mm\n")
        document.write(stream)
    head, entities, tail = stream.getvalue().partition(_ENTITIES)
    owner, late = document.modelspace().layout_key, int(str(document.entitydb.handles), 16) - _LATE
    return DxfFrame(document, head + entities, tail, owner, first, group, late)


def _filled(text: str, own: Mapping[str, str]) -> str:
    """The text with what is a drawing's own for what stands there."""
    for stands, theirs in own.items():
        text = text.replace(f"{stands}\n", f"{theirs}\n")
    return text


def _numbers(bounds: FloatArray) -> dict[str, str]:
    """What a drawing with these bounds has for the numbers of the frame."""
    low, high = bounds
    width, height = (high - low).tolist()
    places = (*low.tolist(), *high.tolist(), *((low + high) / 2).tolist(), 1.1 * max(height, width / 2))
    ours = (_LEFT, _LOW, _RIGHT, _HIGH, _X, _Y, _TALL)
    return {str(stands): str(own) for stands, own in zip(ours, places, strict=True)}


def _name_of_group(count: int, number: str) -> str:
    return f"  3\nLOOP_{count}\n350\n{number}\n"


def _sort_classes(document: "Document") -> None:
    """ezdxf keeps the classes that a version needs in a set: their order would change with every process."""
    document.classes.add_required_classes(document.dxfversion)
    document.classes.classes = dict(sorted(document.classes.classes.items()))


@cache
def _nearest_index(rgb: tuple[int, int, int]) -> int:
    """The AutoCAD colour index nearest to a colour; black is 7, which is drawn in the ink of the screen."""
    from ezdxf.colors import aci2rgb

    if rgb == (0, 0, 0):
        return 7
    return min(range(1, 256), key=lambda i: sum((a - b) ** 2 for a, b in zip(aci2rgb(i), rgb, strict=True)))


def _ezdxf() -> Any:
    try:
        return import_module("ezdxf")
    except ImportError:
        raise MissingDependencyError(f"writing DXF needs ezdxf: {how_to_install('ezdxf')}") from None


@contextmanager
def _plain_ezdxf() -> Iterator[Any]:
    """ezdxf without time stamps and random identifiers, by which files would differ, and without chatter."""
    ezdxf = _ezdxf()
    logger = logging.getLogger("ezdxf")
    with _OPTIONS:
        before, level = ezdxf.options.write_fixed_meta_data_for_testing, logger.level
        ezdxf.options.write_fixed_meta_data_for_testing = True
        logger.setLevel(logging.ERROR)
        try:
            yield ezdxf
        finally:
            ezdxf.options.write_fixed_meta_data_for_testing = before
            logger.setLevel(level)
