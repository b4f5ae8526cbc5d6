"""How the manual is built: Sphinx with MyST; docs/build.py builds it in every language, a warning is an error."""

import sys
import tomllib
from pathlib import Path

DOCS = Path(__file__).parent
sys.path.insert(0, str(DOCS))

import generated_pages  # noqa: E402  # lies beside this file
from docutils import nodes  # noqa: E402
from sphinx.addnodes import pending_xref  # noqa: E402

project = "elastica_cad"
release = tomllib.loads((DOCS.parent / "pyproject.toml").read_text(encoding="utf-8"))["project"]["version"]
copyright = "the elastica_cad engineers, MIT licence"

extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon"]
myst_enable_extensions = ["colon_fence", "attrs_inline"]
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

napoleon_google_docstring = False
napoleon_use_ivar = True
autodoc_member_order = "bysource"
autodoc_typehints = "none"  # the docstrings give shapes and units
default_role = "code"

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


def lead_to_english(app, doctree):
    """Pages that this language has not are linked in English."""
    up = "../" * (app.env.docname.count("/") + 1)
    for link in list(doctree.findall(pending_xref)):
        page = link["reftarget"]
        if link["refdomain"] == "doc" and page not in app.env.found_docs:
            target = f"{up}{page}.html" + (f"#{link['reftargetid']}" if link.get("reftargetid") else "")
            link.replace_self(nodes.reference("", "", *link.children, refuri=target, internal=True))


def setup(app):
    """Write the pages that the code tells before any page is read."""
    app.connect("builder-inited", lambda _: generated_pages.write(DOCS / "reference"))
    app.connect("html-page-context", name_languages)
    app.connect("doctree-read", lead_to_english)
