"""Starts the real FreeCAD: a home with the workbench in its Mod folder, with or without a screen."""

import json
import os
import shutil
import subprocess
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
SCRIPTS = Path(__file__).resolve().parent / "scripts"
STYLE_SHEETS = (Path("/usr/share/freecad/Gui/Stylesheets"), Path("/usr/share/freecad/Gui"))
SCREEN = "-screen 0 1400x900x24 -dpi 96 +extension GLX"

CONFIG = """<?xml version="1.0" encoding="UTF-8" standalone="no" ?>
<FCParameters><FCParamGroup Name="Root"><FCParamGroup Name="BaseApp"><FCParamGroup Name="Preferences">
<FCParamGroup Name="General"><FCText Name="AutoloadModule">PartWorkbench</FCText>{language}</FCParamGroup>
{theme}</FCParamGroup></FCParamGroup></FCParamGroup></FCParameters>
"""

DARK = """<FCParamGroup Name="MainWindow"><FCText Name="StyleSheet">{sheet}</FCText>
<FCText Name="Theme">FreeCAD Dark</FCText></FCParamGroup>
<FCParamGroup Name="View"><FCUInt Name="BackgroundColor2" Value="555819519"/>
<FCUInt Name="BackgroundColor3" Value="555819519"/>
<FCUInt Name="BackgroundColor4" Value="555819519"/></FCParamGroup>"""


def make_home(folder: Path, *, addon: Path | None = ROOT) -> dict[str, str]:
    """A home folder whose FreeCAD finds this checkout or another folder as addon, and the environment for it."""
    for version in ("", "v1-0/", "v1-1/"):
        mods = folder / f".local/share/FreeCAD/{version}Mod"
        mods.mkdir(parents=True, exist_ok=True)
        if addon is not None:
            (mods / "elastica_cad").symlink_to(addon)
    inherited = {
        k: v for k, v in os.environ.items() if not k.startswith(("FREECAD_USER", "PYTHON", "VIRTUAL_ENV"))
    }
    return inherited | {"HOME": str(folder), "PYTHONDONTWRITEBYTECODE": "1", "LC_ALL": "C.UTF-8"}


def program(name: str) -> str:
    """`freecad` or `freecadcmd` as this system calls it."""
    found = shutil.which(name) or shutil.which({"freecad": "FreeCAD", "freecadcmd": "FreeCADCmd"}[name])
    assert found is not None, f"{name} is not installed"
    return found


def run_console(script: str, folder: Path, *, addon: Path | None = ROOT, **variables: str) -> dict[str, Any]:
    """Run a script in freecadcmd; its answers. FreeCAD ends with 0 whatever happens, so the answers decide."""
    return _run(
        [program("freecadcmd"), str(SCRIPTS / script)],
        folder,
        600,
        make_home(folder, addon=addon) | variables,
    )


def run_window(
    script: str,
    folder: Path,
    timeout: float = 1500,
    language: str = "",
    theme: str = "",
    addon: Path | None = ROOT,
    **variables: str,
) -> dict[str, Any]:
    """Run a script in FreeCAD on a screen of its own; its answers. The limit is for what hangs."""
    config = folder / "user.cfg"
    # numbers as that language writes them, whatever the system's
    locale = '<FCInt Name="UseLocaleFormatting" Value="1"/>'
    words = f'<FCText Name="Language">{language}</FCText>{locale}' if language else ""
    dark = DARK.format(sheet=_dark_sheet()) if theme == "dark" else ""
    config.write_text(CONFIG.format(language=words, theme=dark))
    managed = (
        'openbox --sm-disable & exec "$0" "$@"'  # windows get the keys, and stand where a person has them
    )
    freecad = [program("freecad"), "-u", str(config), str(SCRIPTS / script)]
    start = ["xvfb-run", "-a", "-s", SCREEN, "sh", "-c", managed, *freecad]
    return _run(start, folder, timeout, make_home(folder, addon=addon) | variables)


def _run(command: list[str], folder: Path, timeout: float, environment: dict[str, str]) -> dict[str, Any]:
    done = subprocess.run(
        command,
        check=False,
        env=environment | {"ELASTICA_TEST_OUT": str(folder)},
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        timeout=timeout,
        cwd=folder,
    )
    text = f"{done.stdout[-40000:]}\n{done.stderr[-40000:]}"
    answers = folder / "answers.json"
    assert answers.exists(), f"FreeCAD gave no answer (exit code {done.returncode}):\n{text}"
    found = json.loads(answers.read_text())
    assert "error" not in found, f"{found['error']}\n{text}"
    return dict(found)


def _dark_sheet() -> str:
    """The dark style sheet that this FreeCAD brings."""
    folder = next(f for f in STYLE_SHEETS if f.is_dir())
    names = [path.name for path in folder.rglob("*.qss")]
    return next(name for name in ("FreeCAD.qss", "Dark-blue.qss", "FreeCAD Dark.qss") if name in names)
