"""Script behind `make addon`: write the folder that users of FreeCAD copy to `Mod`.

The other front ends, compiled loops and sources of translations are left out. The folder can be
published only if its maintainer and repository are given.
"""

import argparse
import re
import shutil
from collections.abc import Iterable
from datetime import date
from pathlib import Path
from xml.etree import ElementTree

ROOT = Path(__file__).resolve().parents[1]
SPACE = "https://wiki.freecad.org/Package_Metadata"
LEFT_OUT = shutil.ignore_patterns("__pycache__", "*.py[cod]", "*.so", "*.pyd", "*.[ch]", "*.ts")
OTHER_FRONT_ENDS = ("build123d", "cadquery", "cli", "web")
WORKBENCH = "freecad/elastica_wb"
PAGES = {
    "repository": "",
    "readme": "/blob/main/README.md",
    "documentation": "/tree/main/docs",
    "bugtracker": "/issues",
}


def _maintainer(text: str) -> tuple[str, str]:
    match = re.fullmatch(r"\s*([^<>]*[^<>\s])\s*<([^<>@\s]+@[^<>@\s]+)>\s*", text)
    if not match:
        raise argparse.ArgumentTypeError(
            f'"{text}" has no e-mail address. Write MAINTAINER="Name <name@example.org>".'
        )
    return match[1], match[2]


def _repository(text: str) -> str:
    if not re.fullmatch(r"https://[\w.-]+/[\w./-]+", text):
        raise argparse.ArgumentTypeError(
            f'"{text}" is no web address. Write REPOSITORY=https://HOST/OWNER/NAME.'
        )
    return text.rstrip("/").removesuffix(".git")


def _metadata(maintainer: tuple[str, str] | None, repository: str | None) -> ElementTree.ElementTree:
    ElementTree.register_namespace("", SPACE)
    tree = ElementTree.parse(ROOT / "package.xml")
    package = tree.getroot()
    for element in package.iter():
        if element.text and element.text.strip():
            element.text = re.sub(r"^(freecad_workbench/)?resources", f"{WORKBENCH}/resources", element.text)
            element.text = element.text.replace("freecad_workbench/", "")
    source = (ROOT / "elastica_cad" / "__init__.py").read_text(encoding="utf-8")
    version = source.partition('__version__ = "')[2].partition('"')[0]
    for name, text in (("version", version), ("date", date.today().isoformat())):
        package.find(f"{{{SPACE}}}{name}").text = text
    if maintainer:
        element = package.find(f"{{{SPACE}}}maintainer")
        element.text, element.attrib["email"] = maintainer
    if repository:
        after = list(package).index(package.find(f"{{{SPACE}}}license")) + 1
        for kind, place in reversed(PAGES.items()):
            url = ElementTree.Element(
                f"{{{SPACE}}}url", {"type": kind} | ({"branch": "main"} if kind == "repository" else {})
            )
            url.text = repository + place
            package.insert(after, url)
    ElementTree.indent(tree)
    return tree


def _readme(repository: str | None) -> str:
    """Return the README with absolute links. Without a repository, links and pictures are removed."""
    text = (ROOT / "freecad_workbench" / "README.md").read_text(encoding="utf-8")
    if repository:
        text = re.sub(r"!\[([^]]*)\]\(\.\./", rf"![\1]({repository}/raw/main/", text)
        return re.sub(r"\]\(\.\./", f"]({repository}/blob/main/", text)
    text = re.sub(r"!\[[^]]*\]\([^)]*\)\n*", "", text)
    return re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", text)


def write_addon(folder: Path, maintainer: tuple[str, str] | None, repository: str | None) -> None:
    """Write the folder, and replace an existing folder."""
    shutil.rmtree(folder, ignore_errors=True)
    inside = folder / WORKBENCH
    shutil.copytree(ROOT / "freecad_workbench" / WORKBENCH, inside, ignore=LEFT_OUT)
    shutil.copytree(ROOT / "freecad_workbench" / "resources", inside / "resources", ignore=LEFT_OUT)
    shutil.copytree(ROOT / "elastica_cad", inside / "core" / "elastica_cad", ignore=_without_other_front_ends)
    shutil.copy(ROOT / "LICENSE", folder)
    (folder / "README.md").write_text(_readme(repository), encoding="utf-8")
    _metadata(maintainer, repository).write(folder / "package.xml", encoding="UTF-8", xml_declaration=True)


def _without_other_front_ends(folder: str, names: list[str]) -> Iterable[str]:
    return {*LEFT_OUT(folder, names), *(OTHER_FRONT_ENDS if Path(folder) == ROOT / "elastica_cad" else ())}


def main() -> None:
    """Read the options and write the folder."""
    parser = argparse.ArgumentParser(description="Write the addon for FreeCAD.")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--maintainer", type=_maintainer)
    parser.add_argument("--repository", type=_repository)
    options = parser.parse_args()
    write_addon(options.folder, options.maintainer, options.repository)
    print(f"Written to {options.folder}: copy it into FreeCAD's folder Mod.")
    for name in ("maintainer", "repository"):
        if getattr(options, name) is None:
            print(f"Before it can be published, {name.upper()} is missing; see docs/publishing.md.")


if __name__ == "__main__":
    main()
