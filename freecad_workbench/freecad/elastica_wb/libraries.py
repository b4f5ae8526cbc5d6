"""Libraries that Debian's FreeCAD does not bring: which are missing, and how they get in."""

import importlib
import importlib.util
import os
import shutil
import subprocess
import sys
from pathlib import Path

import FreeCAD as App

from elastica_cad.errors import MissingDependencyError

__all__ = ["OPTIONAL", "folder", "install", "missing"]

OPTIONAL = {
    "ezdxf": "writes DXF files",
    "highspy": "finds the best widths faster",
}
"""Name of every optional library, and what it is for."""

# what these need besides numpy: --no-deps leaves FreeCAD's numpy alone, a second one would break scipy
COMPANIONS = {"ezdxf": ("fonttools", "pyparsing", "typing_extensions"), "highspy": ()}
LONGEST = 300  # s


def missing() -> list[str]:
    """The optional libraries that cannot be imported."""
    importlib.invalidate_caches()
    return [name for name in OPTIONAL if importlib.util.find_spec(name) is None]


def folder() -> Path:
    """Where FreeCAD's Addon Manager keeps libraries too."""
    return Path(App.getUserAppDataDir()) / "AdditionalPythonPackages"


def install(names: list[str]) -> None:
    """Install libraries with pip into FreeCAD's own folder, never a second numpy.

    Raises
    ------
    MissingDependencyError
        There is no pip, no network, or it refused; with the command to type instead.
    """
    target = folder()
    target.mkdir(parents=True, exist_ok=True)
    wanted = [package for name in names for package in (name, *COMPANIONS[name])]
    wanted = [p for p in wanted if p in names or importlib.util.find_spec(_module(p)) is None]
    arguments = ["-m", "pip", "install", "--no-deps", "--upgrade", "--target", str(target), *wanted]
    by_hand = f"in a terminal: {_python()} {' '.join(arguments)}"
    try:
        subprocess.run(
            [_python(), *arguments],
            check=True,
            capture_output=True,
            text=True,
            timeout=LONGEST,
            env={k: v for k, v in os.environ.items() if k != "PYTHONHOME"},
        )
    except FileNotFoundError as error:
        raise MissingDependencyError(f"there is no Python with pip here; {by_hand}") from error
    except subprocess.TimeoutExpired as error:
        raise MissingDependencyError(f"the download took longer than {LONGEST} s; try {by_hand}") from error
    except subprocess.CalledProcessError as error:
        last = (error.stderr or error.stdout).strip().splitlines()[-1:]
        raise MissingDependencyError(
            f"pip could not install {', '.join(names)}: {' '.join(last)}; {by_hand}"
        ) from error
    if str(target) not in sys.path:
        sys.path.append(str(target))
    importlib.invalidate_caches()


def _python() -> str:
    """The interpreter that belongs to this FreeCAD; FreeCAD itself is none."""
    version = f"python{sys.version_info.major}.{sys.version_info.minor}"
    beside = Path(sys.executable).with_name("python.exe" if sys.platform == "win32" else version)
    return str(beside) if beside.exists() else shutil.which(version) or shutil.which("python3") or "python3"


def _module(package: str) -> str:
    return {"fonttools": "fontTools"}.get(package, package)
