"""How the manual is built: Sphinx with MyST; docs/build.py builds it in every language, a warning is an error."""

import logging
import re
from pathlib import Path

from docutils import nodes
from sphinx.addnodes import pending_xref
from sphinx.search.zh import SearchChinese

from elastica_cad import __version__

DOCS = Path(__file__).parent

logging.getLogger("jieba").setLevel(logging.WARNING)  # Chinese search: it would report each start

project = "elastica_cad"
release = __version__
copyright = "the elastica_cad engineers, MIT licence"

extensions = ["myst_parser"]
myst_heading_anchors = 3
suppress_warnings = ["myst.xref_missing_anchor"]  # anchors of headings in files outside of the manual
exclude_patterns = ["_build", "*.py"]

LANGUAGES = {"en": "English", "de": "Deutsch", "zh_CN": "中文"}
"""English lies at the root of the site, the others in folders of theirs, with the pages that are translated."""
TRANSLATED = ("index", "tutorials/", "freecad_tools/")
locale_dirs = ["locale"]
gettext_compact = False
gettext_uuid = False
if tags.has("translated"):  # noqa: F821  # Sphinx brings it
    here = {path.name for path in DOCS.iterdir()} - {"index.md", "tutorials", "freecad_tools"}
    exclude_patterns += [*here, "reference"]
    suppress_warnings += ["toc.excluded", "toc.not_readable"]

highlight_language = "none"  # a block that names no language is no code

html_theme = "furo"
html_title = "elastica_cad"
html_copy_source = False
html_favicon = "../freecad_workbench/resources/icons/Elastica.svg"
html_static_path = ["_static"]
html_js_files = [("accessible.js", {"defer": "defer"})]


html_sidebars = {
    "**": [
        "sidebar/brand.html",
        "languages.html",
        "sidebar/search.html",
        "sidebar/scroll-start.html",
        "sidebar/navigation.html",
        "sidebar/scroll-end.html",
    ]
}
templates_path = ["_templates"]


def name_languages(app, pagename, _templatename, context, _doctree):
    """Where this page is in the other languages, or where they begin."""
    up = "../" * pagename.count("/") + ("" if app.config.language == "en" else "../")
    context["other_languages"] = [
        (code.replace("_", "-"), name, up + ("" if code == "en" else f"{code}/") + page + ".html")
        for code, name in LANGUAGES.items()
        if code != app.config.language
        for page in [pagename if code == "en" or pagename.startswith(TRANSLATED) else "index"]
    ]


LISTED = re.compile(r"^- \[[^\]]+\]\((?!\.\.)(\S+)\.md\)", re.MULTILINE)


def list_contents(_app, docname, source):
    """Make the table of contents from the lists of links on these two pages, which any viewer shows."""
    if docname in ("index", "freecad_tools/index"):
        for part in source[0].split("\n## ")[1:]:
            pages = LISTED.findall(part)
            title = part.partition("\n")[0]
            source[0] += "\n".join(
                ["", "```{toctree}", ":hidden:", f":caption: {title}", "", *pages, "```", ""]
            )


def show_contributing(_app, docname, source):
    """Show the file of the repository on its page of the manual, so that links to it stay inside of the site."""
    if docname == "contributing":
        text = (DOCS.parent / "CONTRIBUTING.md").read_text(encoding="utf-8")
        source[0] = text.replace("](docs/", "](")


def lead_to_english(app, doctree):
    """Pages that this language has not are linked in English."""
    up = "../" * (app.env.docname.count("/") + 1)
    for link in list(doctree.findall(pending_xref)):
        page = link["reftarget"]
        is_missing = page not in app.env.found_docs and not page.startswith("/")
        if app.config.language != "en" and link["refdomain"] == "doc" and is_missing:
            target = f"{up}{page}.html" + (f"#{link['reftargetid']}" if link.get("reftargetid") else "")
            link.replace_self(nodes.reference("", "", *link.children, refuri=target, internal=True))


HAN = re.compile(r"[\u3400-\u9fff]+")


class ChineseSearch(SearchChinese):
    """Search without a dictionary: a character, two neighbouring characters and a whole run of them are words."""

    language_name = "English"  # of the stemmer, which Sphinx looks for by the name of the language

    def split(self, text):
        """Return the words of a text; the page finds longer words within the runs."""
        runs = HAN.findall(text)
        pairs = [run[k : k + 2] for run in runs for k in range(len(run) - 1)]
        return [*runs, *pairs, *"".join(runs), *super().split(text)]

    def word_filter(self, word):
        """Return True for words that are searched."""
        return super().word_filter(word) or bool(HAN.match(word))


def setup(app):
    """Connect the functions above to the events of Sphinx."""
    app.add_search_language(ChineseSearch)
    app.connect("source-read", list_contents)
    app.connect("source-read", show_contributing)
    app.connect("html-page-context", name_languages)
    app.connect("doctree-read", lead_to_english)
