"""Kit of a flexure, a part with two rest shapes: cutting files, bodies, picture and report."""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._text import distinct, file_word
from elastica_cad.defaults import LASER_KERF
from elastica_cad.design.kit_spec import DEFAULT_CUTTING, Cutting
from elastica_cad.errors import FieldName, Length, Refusal, note
from elastica_cad.files import save, step_trouble
from elastica_cad.form_finding.limits import FAR_SHARE
from elastica_cad.formats.write_files import File, text_file, write_json
from elastica_cad.kit.kit import Kit, can_draw, cutting_files, save_solid
from elastica_cad.pairs.flexure import STATES, Flexure
from elastica_cad.pairs.flexure_spec import FlexureSpec


@dataclass(frozen=True, eq=False)
class MadePair:
    """A flexure and its request.

    Attributes
    ----------
    spec : FlexureSpec
    part : Flexure
    name : str
        Stem of the names of the files.
    cutting : Cutting
        Options of the cutting files.
    """

    spec: FlexureSpec
    part: Flexure
    name: str
    cutting: Cutting = DEFAULT_CUTTING

    @cached_property
    def kit(self) -> Kit:
        """Report and files, without files that require a missing package."""
        name, part = self.name, self.part
        files = [
            file
            for stem, drawing in ((name, part.drawing()), (f"{name}-holder", part.holder()))
            for file in cutting_files(drawing, stem, self.cutting, part.sheet)
        ]
        if not step_trouble():
            stems = distinct([name, *(f"{name}-{file_word(str(label))}" for label in part.state_labels)])
            files += [
                File(f"{stem}.step", partial(save, part, state=state, name=name))
                for stem, state in zip(stems, (None, *STATES), strict=True)
            ]
            holder = part.holder_solid
            files += [
                File(f"{name}.stl", partial(save_solid, part.solid)),
                File(f"{name}-holder.stl", partial(save_solid, holder, bed=holder.frame)),
            ]
        if can_draw():
            from elastica_cad.plot.canvas import draw_file
            from elastica_cad.plot.pair_pictures import pair_sheet

            files.append(File(f"{name}.png", partial(draw_file, partial(pair_sheet, part, self.spec.faired))))
        files.append(text_file(f"{name}-force.csv", part.force_csv()))
        matched = self.spec.matched
        report = {
            "name": name,
            **({} if matched is None else {"moved_mm": list(matched.moved)}),
            **part.as_dict(),
            "reports": [str(warning) for warning in self.warnings],
            "files": [*(file.name for file in files), f"{name}.json"],
        }
        return Kit((*files, File(f"{name}.json", lambda path: write_json(path, report))), report)

    @cached_property
    def warnings(self) -> tuple[Refusal, ...]:
        """Warnings about the flexure, its curves and its cutting files."""
        return (*self._moved_far(), *self._cut_away(), *self.part.warnings)

    def _moved_far(self) -> Iterator[Refusal]:
        moved = (0.0, 0.0) if self.spec.matched is None else self.spec.matched.moved
        sizes = [np.hypot(*np.ptp(drawn.bounds, axis=0)) for drawn in self.spec.faired]
        share, far = max((far / size, far) for far, size in zip(moved, sizes, strict=True))
        if share > FAR_SHARE:
            yield note(
                "A curve was moved by up to {far}, {percent:.2g} % of its size, to make both curves equally "
                "long. The picture shows the drawn curves dashed. Draw curves of more similar length, or "
                "change {field}.",
                severity="warning", field=FieldName("match"), far=Length(far), percent=100 * share,
            )  # fmt: skip

    def _cut_away(self) -> Iterator[Refusal]:
        """Yield the warning that the cut, if it is not compensated, makes the part thinner and weaker."""
        sheet, thin = self.part.sheet, self.part.scale
        if self.part.printed or self.cutting.options(sheet)["kerf"]:
            return
        # the force is proportional to the cube of the thickness
        kerf = sheet.kerf or LASER_KERF
        remaining = max(thin - kerf, 0.0)
        yield note(
            "The files do not compensate the width of the cut. A laser cut of {kerf} makes the thinnest place "
            "{left:.2g} wide instead of {thin:.2g} and leaves {percent:.0f} % of the force. Set {field}, unless "
            "the laser program compensates the cut.",
            severity="warning", field=FieldName("cut.kerf"), kerf=Length(kerf), left=Length(remaining),
            thin=Length(thin), percent=100 * (remaining / thin) ** 3,
        )  # fmt: skip
