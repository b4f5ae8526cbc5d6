"""The start page of a kit: one HTML file beside the others, with pictures, numbers and links to them all."""

from collections.abc import Mapping, Sequence
from pathlib import PurePosixPath
from urllib.parse import quote

from elastica_cad._printable import html_text

STYLE = (
    "body{font:15px/1.5 sans-serif;max-width:62rem;margin:2rem auto;padding:0 1rem;color:#1f2430}"
    "img{max-width:100%;border:1px solid #ddd}figure{margin:1rem 0}"
    "td,th{padding:.15rem .8rem .15rem 0;text-align:left}"
)


def compose_start_page(
    name: str, lines: Sequence[str], notes: Sequence[str], files: Mapping[str, str]
) -> str:
    """The page's text.

    Parameters
    ----------
    name : str
        Of the model.
    lines : sequence of str
        What was made, in a few sentences.
    notes : sequence of str
        What a maker should know before cutting.
    files : mapping
        What each file is, by its name with / between folders; pictures are shown.

    Examples
    --------
    >>> page = compose_start_page("arch", ["1 strip"], [], {"sheets/arch 1.dxf": "nested sheet"})
    >>> '<a href="sheets/arch%201.dxf">' in page
    True
    """
    pictures = [file for file in files if file.endswith(".png")]
    shown = "".join(
        f'<figure><a href="{quote(file)}"><img src="{quote(file)}" alt="{html_text(files[file])}"></a>'
        f"<figcaption>{html_text(files[file])}: {html_text(PurePosixPath(file).name)}</figcaption></figure>"
        for file in pictures
    )
    rows = "".join(
        f'<tr><td><a href="{quote(file)}">{html_text(file)}</a></td><td>{html_text(what)}</td></tr>'
        for file, what in files.items()
        if file not in pictures
    )
    told = "".join(f"<p>{html_text(line)}</p>" for line in lines)
    warned = "".join(f"<li>{html_text(note)}</li>" for note in notes)
    return (
        f'<!doctype html><html lang="en"><head><meta charset="utf-8"><title>{html_text(name)}</title>'
        f"<style>{STYLE}</style></head><body><h1>{html_text(name)}</h1>{told}"
        f"{f'<h2>Before you cut</h2><ul>{warned}</ul>' if warned else ''}{shown}"
        f"<h2>Files</h2><table><tr><th>file</th><th>what it is</th></tr>{rows}</table></body></html>\n"
    )
