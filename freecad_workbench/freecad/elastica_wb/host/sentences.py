# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Sentences of the core and the workbench in the user's language.

They are written in English with their numbers in them. The translation files hold each as a key with numbered gaps,
such as "The curve crosses itself (at %1 mm): ...", and a sentence is known again by its key.
"""

import re
from dataclasses import dataclass
from functools import lru_cache
from xml.etree import ElementTree

import FreeCAD as App
from freecad.elastica_wb.host.resources import RESOURCES, translate

from elastica_cad._printable import printable

__all__ = ["CONTEXT", "capital", "decimal_point", "report", "report_error", "report_warning", "translated"]

CONTEXT = "ElasticaSentences"
GAP = re.compile(r"%(\d)")
BREAKS = (r"(?<=\.) (?=[A-Z])", "(?<=;) ")  # between sentences that were put together
ONE = r"((?:(?!\. [A-Z]).)*?)"  # what fills a gap: no second sentence
TELLING = 12  # letters of a key that stands for a whole text; shorter ones are for parts of one
TYPED = (  # what the core's sentences tell those who type to write, and where that is set in FreeCAD
    (
        re.compile(r"\bsmooth = ([\d.]+),? (?:(?:or|oder|或) )?--smooth [\d.]+,?", re.IGNORECASE),
        r"Smooth = \1",
    ),
    (re.compile(r"\bSmooth = ([\d.]*\d)(?![\d.]| ?mm)"), r"Smooth = \1 mm"),  # else 0.1 is read in inches
    (re.compile(r"\bignore_limits \(--ignore-limits\)"), "Anyway"),
    (re.compile(r" \(--force, or force=True\)"), ""),
    (re.compile(r" \(--unit\)"), ""),
    (re.compile(r"\bshop=Shop\(least_width=\.\.\.\)"), "LeastWidth"),
    (re.compile(r"`blank` in the report has its curvature"), "the property Blank has its curvature"),
    (re.compile(r"\bmax_width\b"), "MaxWidth"),
    (re.compile(r"\bmin_width\b"), "MinWidth"),
    (re.compile(r"\bhole_ratio\b"), "HoleRatio"),
    (
        re.compile(r"\bgive gravity=True or a direction in that plane"),
        "set Gravity, with GravityDirection in that plane",
    ),
    (
        re.compile(r"\bleave out limits, keep and natural_curvature, or gravity"),
        "set Follow to Exactly and NaturalCurvature to 0, or leave gravity out",
    ),
    (re.compile(r"\bleave limits and keep out\b"), "set Follow to Exactly"),
)


@dataclass(frozen=True)
class Key:
    """What is known of a sentence: the texts between its gaps, the numbers of these, its translation."""

    texts: tuple[str, ...]
    gaps: tuple[str, ...]
    words: str
    pattern: re.Pattern[str]
    letters: int

    @classmethod
    def of(cls, key: str, words: str) -> "Key":
        """From the text of a translation file."""
        parts = GAP.split(key)
        texts = tuple(parts[0::2])
        fill = ["(.*?)" if re.match(" [A-Z]", text) else ONE for text in texts[1:]]
        pattern = "".join(
            [re.escape(texts[0]), *(f + re.escape(t) for f, t in zip(fill, texts[1:], strict=True))]
        )
        letters = len(re.sub("[^a-zA-Z]", "", "".join(texts)))
        return cls(texts, tuple(parts[1::2]), words, re.compile(pattern, re.DOTALL), letters)

    def filled(self, sentence: str) -> dict[str, str] | None:
        """What stands in the gaps; None for another sentence. Most are told apart without the pattern."""
        if not (sentence.startswith(self.texts[0]) and sentence.endswith(self.texts[-1])):
            return None
        if not all(text in sentence for text in self.texts):
            return None
        match = self.pattern.fullmatch(sentence)
        return None if match is None else dict(zip(self.gaps, match.groups(), strict=True))


def translated(sentence: str) -> str:
    """The sentence in the user's language, with the names of properties; what is not known stays as it is."""
    found = _translated(sentence, _language()) if sentence else sentence
    for typed, named in TYPED:
        found = typed.sub(named, found)
    return found


def capital(sentence: str) -> str:
    """It begins with a capital letter, but for a name of the user's that a colon follows."""
    first = sentence.partition(" ")[0]
    return sentence if first.endswith(":") else sentence[:1].upper() + sentence[1:]


def decimal_point() -> str:
    """What stands between whole and decimal digits, as in FreeCAD's own boxes."""
    if not App.GuiUp:
        return "."
    from freecad.elastica_wb.host.qt import QtCore

    return str(QtCore.QLocale().decimalPoint())


def _language() -> str:
    """What tells a language from another; it can be changed while FreeCAD runs."""
    return translate("Elastica", "can") + translate("Elastica", "cannot")


@lru_cache(maxsize=2)
def _keys(_language: str) -> list[Key]:
    """All that are translated; the longest come first."""
    tree = ElementTree.parse(RESOURCES / "translations" / "Elastica.ts")
    contexts = [one for one in tree.getroot().iter("context") if one.findtext("name") == CONTEXT]
    texts = [message.findtext("source", "") for one in contexts for message in one.iter("message")]
    pairs = [(text, translate(CONTEXT, text)) for text in texts]
    return sorted((Key.of(*pair) for pair in pairs if pair[0] != pair[1]), key=lambda key: -key.letters)


@lru_cache(maxsize=500)
def _translated(sentence: str, language: str) -> str:
    keys = _keys(language)
    if not keys or not re.search("[a-z]", sentence):
        return sentence
    if "\n" in sentence:  # no key spans lines
        return "\n".join(_translated(line, language) for line in sentence.split("\n"))
    if sentence.endswith(";"):  # one of a list
        return _translated(sentence[:-1], language) + ";"
    for whole in (True, False):
        for key in keys:
            found = key.filled(sentence) if key.letters >= TELLING or not whole else None
            if found is not None:
                told = {gap: _translated(text, language) for gap, text in found.items()}
                return GAP.sub(lambda gap, told=told: told.get(gap[1], gap[0]), key.words)
        for between in BREAKS:
            parts = re.split(between, sentence)
            if len(parts) > 1:
                return " ".join(_translated(part, language) for part in parts)
    label, colon, rest = sentence.partition(": ")  # a part's name and what is wrong with it
    if colon and " " not in label:
        return f"{label}: {_translated(rest, language)}"
    blank = sentence.strip()
    if blank != sentence:
        return sentence.replace(blank, _translated(blank, language))
    if sentence.endswith("."):  # a key that stands at the end
        return _translated(sentence[:-1], language) + "."
    return translate("Elastica", sentence)


def report(sentence: str, who: str = "") -> None:
    """Something that was done, in the report view and on the terminal that FreeCAD was started from."""
    App.Console.PrintMessage(_line(sentence, who))


def report_warning(sentence: str, who: str = "") -> None:
    """Something to know; `who` is the label of the object that it is about."""
    App.Console.PrintWarning(_line(sentence, who))


def report_error(sentence: str, who: str = "") -> None:
    """Something that went wrong."""
    App.Console.PrintError(_line(sentence, who))


def _line(sentence: str, who: str) -> str:
    return printable(f"Elastica, {who}: {sentence}\n" if who else f"Elastica: {sentence}\n")
