"""Draws the pictures of the FreeCAD tools: python docs/freecad_pictures.py.

Needs FreeCAD, Xvfb, openbox and ImageMagick (tests/setup.sh), and a Chinese font (fonts-wqy-microhei).
"""

import sys
from pathlib import Path
from tempfile import TemporaryDirectory

from PIL import Image

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from tests.freecad.launching import run_window  # noqa: E402  # lies in the checkout

PICTURES = ROOT / "docs" / "freecad_tools" / "pictures"
WIDTH_PX, COLOURS = 1100, 128
LANGUAGES = {"": "", ".de": "German", ".zh_CN": "Chinese Simplified"}
"""What FreeCAD calls the languages of the manual, by what Sphinx looks for at the end of a picture's name."""


def main() -> None:
    """Each tool at work in every language, small enough for a page."""
    PICTURES.mkdir(exist_ok=True)
    for ending, language in LANGUAGES.items():
        with TemporaryDirectory() as folder:
            run_window("manual_pictures.py", Path(folder), timeout=900, language=language)
            for path in sorted(Path(folder).glob("*.png")):
                picture = Image.open(path).convert("RGB")
                height = round(picture.height * WIDTH_PX / picture.width)
                small = picture.resize((WIDTH_PX, height), Image.Resampling.LANCZOS)
                shown = PICTURES / f"{path.stem}{ending}.png"
                small.quantize(COLOURS).save(shown, optimize=True)
                print(shown)


if __name__ == "__main__":
    main()
