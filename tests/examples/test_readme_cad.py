"""The README's CAD snippets run as they stand there."""

import re

import pytest


@pytest.mark.parametrize("kernel", ["build123d", "cadquery"])
def test_snippet_runs(kernel, project_root, capsys):
    snippets = re.findall(r"```python\n(.*?)```", (project_root / "README.md").read_text(), re.DOTALL)
    (code,) = [text for text in snippets if f"elastica_cad.{kernel} import" in text]
    names = {}
    exec(compile(code, "README.md", "exec"), names)
    rib = names["rib"] if kernel == "build123d" else names["rib"].val()
    assert rib.check.realizable
    assert rib.strip.width.extremes[1] == pytest.approx(40)
