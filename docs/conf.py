"""How the manual is built: Sphinx with MyST; `make docs` treats every warning as an error."""

import sys
import tomllib
from pathlib import Path

DOCS = Path(__file__).parent
sys.path.insert(0, str(DOCS))

import generated_pages  # noqa: E402  # lies beside this file

project = "elastica_cad"
release = tomllib.loads((DOCS.parent / "pyproject.toml").read_text(encoding="utf-8"))["project"]["version"]
copyright = "the elastica_cad engineers, MIT licence"

extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon"]
myst_enable_extensions = ["colon_fence", "attrs_inline"]
myst_heading_anchors = 3
suppress_warnings = ["myst.xref_missing_anchor"]  # anchors of headings in files outside of the manual
exclude_patterns = ["_build", "*.py"]

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


def setup(app):
    """Write the pages that the code tells before any page is read."""
    app.connect("builder-inited", lambda _: generated_pages.write(DOCS / "reference"))
