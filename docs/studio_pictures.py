"""Draw the studio for README and manual: python docs/studio_pictures.py writes drawing.png, lamp.png and drag.gif.

In the film, a point of the arch is pulled until no strip can take the curve, and back. The pointer is drawn into
the frames, because a browser without a screen has none.
"""

import io
import sys
import tempfile
from pathlib import Path
from time import sleep

import numpy as np
from PIL import Image, ImageDraw

ROOT = Path(__file__).resolve().parents[1]
FOLDER = ROOT / "docs/studio"
sys.path.insert(0, str(ROOT))

from tests.studio.browser import chromium  # noqa: E402 - the checkout comes first on the path
from tests.studio.conftest import running  # noqa: E402

SIZE = (1360, 817)
SCALE = 0.6
FRAMES = 22
"""Frames from one end of the drag to the other."""

MS = 90
HOLD = 9
"""Repeats of the frames at both ends of the drag."""

ANSWER_S = 1.5
"""Time in which the page has certainly answered."""

POINT = 2
"""Number of the point that is pulled."""

PULL = np.array([60.0, -120.0])
"""Way of the point, px."""

ARROW = np.array([(0, 0), (0, 17), (4, 13), (7, 20), (10, 19), (7, 12), (12, 12)])


def frame(browser, at):
    """The page as a small picture with a pointer."""
    picture = Image.open(io.BytesIO(browser.get_screenshot_as_png())).convert("RGB")
    outline = [tuple(corner) for corner in (ARROW + at).tolist()]
    ImageDraw.Draw(picture).polygon(outline, fill="black", outline="white")
    return picture.resize((round(SIZE[0] * SCALE), round(SIZE[1] * SCALE)), Image.Resampling.LANCZOS)


def photograph(studio):
    """Write the pictures of an arch, with the force along the slider, and of a lamp."""
    studio.start("arch")
    studio.until(lambda: "Accuracy" in studio.text(".numbers") and not studio.text(".empty"))
    studio.mouse("mouseMoved", studio.center(".bend input"), buttons=0)
    studio.until(lambda: studio.all(".bend .marks path"))
    studio.browser.save_screenshot(str(FOLDER / "drawing.png"))
    studio.start("lamp")
    studio.until(lambda: "16 pieces" in studio.text(".told"))
    sleep(ANSWER_S)
    studio.browser.save_screenshot(str(FOLDER / "lamp.png"))


def film(studio):
    """Write the film of a drag."""
    frames = []
    studio.start("arch")
    studio.until(studio.shape)
    start = studio.point(POINT)
    studio.mouse("mouseMoved", start, buttons=0)
    studio.mouse("mousePressed", start, clickCount=1)
    for share in 0.5 - 0.5 * np.cos(np.pi * np.arange(FRAMES + 1) / FRAMES):
        at = start + share * PULL
        studio.mouse("mouseMoved", at)
        sleep(ANSWER_S)
        frames.append(frame(studio.browser, at))
    studio.mouse("mouseReleased", start, clickCount=1)
    pictures = [frames[0]] * HOLD + frames + [frames[-1]] * HOLD + frames[::-1]
    # the palette contains the colours of the strip that can be made and of the refused one
    both = Image.new("RGB", (frames[0].width, 2 * frames[0].height))
    both.paste(frames[0])
    both.paste(frames[-1], (0, frames[0].height))
    colours = both.quantize(256, Image.Quantize.MAXCOVERAGE, kmeans=4)
    pictures = [picture.quantize(palette=colours, dither=Image.Dither.NONE) for picture in pictures]
    pictures[0].save(
        FOLDER / "drag.gif", save_all=True, append_images=pictures[1:], duration=MS, loop=0, optimize=True
    )


def main():
    """Write all pictures."""
    with (
        tempfile.TemporaryDirectory() as folder,
        running(cwd=folder) as server,
        chromium(folder, size=SIZE) as studio,
    ):
        inside = studio.browser.execute_script("return [innerWidth, innerHeight]")
        studio.browser.set_window_size(*(2 * np.array(SIZE) - inside).tolist())
        studio.open(server.address)
        film(studio)
        photograph(studio)


if __name__ == "__main__":
    main()
