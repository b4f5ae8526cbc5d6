"""Brings the catalogues in docs/locale up to date: python docs/catalogues.py, then fill in what is left empty.

Sphinx gathers the sentences of the translated pages; what the workbench says in its own catalogue is taken
from there.
"""

import subprocess
import sys
from copy import deepcopy
from io import BytesIO
from pathlib import Path
from tempfile import TemporaryDirectory
from xml.etree import ElementTree

from babel.messages.catalog import Catalog
from babel.messages.pofile import read_po, write_po

DOCS = Path(__file__).resolve().parent
WORDS = DOCS.parent / "freecad_workbench" / "resources" / "translations"
LANGUAGES = {"de": "de", "zh_CN": "zh-CN"}
"""Languages as Sphinx and as Qt call them."""


def main() -> None:
    """Every catalogue anew; nothing that is translated is lost."""
    wanted = templates()
    for language in LANGUAGES:
        known = workbench_words(language)
        for name, template in wanted.items():
            path = catalogue_path(language, name)
            catalogue = read(path) if path.exists() else Catalog(language, project="elastica_cad")
            catalogue.update(deepcopy(template), no_fuzzy_matching=True)
            catalogue.obsolete.clear()
            for message in catalogue:
                if message.id and not message.string:
                    message.string = known.get(message.id, "")
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(text_of(catalogue, language))
        empty = sum(not m.string for name in wanted for m in read(catalogue_path(language, name)) if m.id)
        print(f"{language}: {empty} sentences are left")


def templates() -> dict[str, Catalog]:
    """The sentences of every translated page, by its name."""
    with TemporaryDirectory() as folder:
        gather = (sys.executable, "-m", "sphinx", "-q", "-b", "gettext", "-t", "translated", DOCS, folder)
        subprocess.run(gather, check=True)
        found = {path.relative_to(folder).with_suffix(""): read(path) for path in Path(folder).rglob("*.pot")}
        return {name.as_posix(): found[name] for name in sorted(found)}


def catalogue_path(language: str, name: str) -> Path:
    """Where the sentences of a page lie."""
    return DOCS / "locale" / language / "LC_MESSAGES" / f"{name}.po"


def read(path: Path) -> Catalog:
    """A catalogue or a template."""
    with path.open("rb") as file:
        return read_po(file)


def text_of(catalogue: Catalog, language: str) -> bytes:
    """Without dates and line numbers, so that a change shows what changed."""
    stream = BytesIO()
    write_po(stream, catalogue, width=100, omit_header=True, no_location=True)
    lines = f"Language: {language}", "Content-Type: text/plain; charset=utf-8"
    head = 'msgid ""\nmsgstr ""\n' + "".join(f'"{line}\\n"\n' for line in lines) + "\n"
    return head.encode() + stream.getvalue().rstrip(b"\n") + b"\n"


def workbench_words(language: str) -> dict[str, str]:
    """Titles and tips of the tools as FreeCAD shows them; tips are sentences here."""
    root = ElementTree.parse(WORDS / f"Elastica_{LANGUAGES[language]}.ts").getroot()
    stop = "。" if language == "zh_CN" else "."
    found = {}
    for context in root.iter("context"):
        if (context.findtext("name") or "").startswith("Elastica_"):
            for message in context.iter("message"):
                source, said = message.findtext("source") or "", message.findtext("translation") or ""
                found |= {source: said, f"{source}.": f"{said}{stop}"}
    return found


if __name__ == "__main__":
    main()
