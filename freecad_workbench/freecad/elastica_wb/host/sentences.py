# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Sentences of the core and the workbench in the user's language.

They are written in English with their numbers in them. The translation files hold each as a key with numbered gaps,
such as "The curve crosses itself (at %1 mm): ...", and a sentence is known again by its key.
"""

import re
from functools import lru_cache
from xml.etree import ElementTree

import FreeCAD as App
from freecad.elastica_wb.host.resources import RESOURCES, translate

__all__ = ["CONTEXT", "decimal_point", "translated"]

CONTEXT = "ElasticaSentences"
GAP = re.compile(r"%(\d)")
BREAKS = ("\n", r"(?<=\.) (?=[A-Z])", "(?<=;) ")  # between sentences that were put together
ONE = r"((?:(?!\. [A-Z]).)*?)"  # what fills a gap: no second sentence
TELLING = (
    12  # letters of a key that stands for a whole text; shorter ones are for parts that nothing else knows
)


def translated(sentence: str) -> str:
    """The sentence in the user's language; what is not known stays as it is."""
    return _translated(sentence, _language()) if sentence else sentence


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
def _keys(_language: str) -> list[tuple[str, re.Pattern[str], list[str], str]]:
    """Beginning, pattern, numbers of the gaps and translation of every key; the longest come first."""
    found = []
    tree = ElementTree.parse(RESOURCES / "translations" / "Elastica.ts")
    for context in tree.getroot().iter("context"):
        for message in context.iter("message") if context.findtext("name") == CONTEXT else ():
            key = message.findtext("source", "")
            words = translate(CONTEXT, key)
            if words != key:
                text, *rest = GAP.split(key)
                gaps = ["(.*?)" if re.match(" [A-Z]", part) else ONE for part in rest[1::2]]
                ends = map(re.escape, rest[1::2])
                pattern = re.escape(text) + "".join(g + end for g, end in zip(gaps, ends, strict=True))
                found.append((text, re.compile(pattern, re.DOTALL), rest[0::2], words))
    return sorted(found, key=lambda entry: -_letters(entry))


def _letters(key: tuple[str, re.Pattern[str], list[str], str]) -> int:
    return len(re.sub(r"[^a-zA-Z]", "", key[1].pattern.replace(ONE, "")))


@lru_cache(maxsize=500)
def _translated(sentence: str, language: str) -> str:
    keys = _keys(language)
    if not keys or not re.search("[a-z]", sentence):
        return sentence
    for whole in (True, False):
        for key in keys:
            start, pattern, numbers, words = key
            match = pattern.fullmatch(sentence) if sentence.startswith(start) else None
            if match is not None and (_letters(key) >= TELLING or not whole):
                gaps = {n: _translated(gap, language) for n, gap in zip(numbers, match.groups(), strict=True)}
                return GAP.sub(lambda gap, gaps=gaps: gaps.get(gap[1], gap[0]), words)
        for between in BREAKS:
            parts = re.split(between, sentence)
            if len(parts) > 1:
                return ("\n" if between == "\n" else " ").join(_translated(part, language) for part in parts)
    blank = sentence.strip()
    if blank != sentence:
        return sentence.replace(blank, _translated(blank, language))
    return translate("Elastica", sentence)
