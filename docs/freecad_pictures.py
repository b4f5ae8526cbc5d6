"""Draws the pictures of the FreeCAD tools: python docs/freecad_pictures.py; needs FreeCAD, Xvfb and ImageMagick."""

import sys
from pathlib import Path
from tempfile import TemporaryDirectory

from PIL import Image

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from tests.freecad.launching import run_window  # noqa: E402  # lies in the checkout

PICTURES = ROOT / "docs" / "freecad_tools" / "pictures"
WIDTH_PX, COLOURS = 1100, 96


def main() -> None:
    """Each tool at work, small enough for a page."""
    PICTURES.mkdir(exist_ok=True)
    with TemporaryDirectory() as folder:
        run_window("manual_pictures.py", Path(folder), timeout=900)
        for path in sorted(Path(folder).glob("*.png")):
            picture = Image.open(path).convert("RGB")
            height = round(picture.height * WIDTH_PX / picture.width)
            small = picture.resize((WIDTH_PX, height), Image.Resampling.LANCZOS)
            small.quantize(COLOURS).save(PICTURES / path.name, optimize=True)
            print(PICTURES / path.name)


if __name__ == "__main__":
    main()
