"""Films a drag in the studio for README: python docs/studio_film.py writes docs/studio/drag.gif.

A point of the arch is pulled until no strip can take the curve, and back. The pointer is drawn into the frames,
because a browser without a screen has none.
"""

import io
import sys
import tempfile
from pathlib import Path
from time import sleep

import numpy as np
from PIL import Image, ImageDraw

ROOT = Path(__file__).resolve().parents[1]
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

ANSWER_S = 0.6
"""Time in which the page has certainly answered."""

PULL = np.array([60.0, -120.0])
"""Way of the point, px."""

ARROW = np.array([(0, 0), (0, 17), (4, 13), (7, 20), (10, 19), (7, 12), (12, 12)])


def frame(browser, at):
    """The page as a small picture with a pointer."""
    picture = Image.open(io.BytesIO(browser.get_screenshot_as_png())).convert("RGB")
    outline = [tuple(corner) for corner in (ARROW + at).tolist()]
    ImageDraw.Draw(picture).polygon(outline, fill="black", outline="white")
    return picture.resize((round(SIZE[0] * SCALE), round(SIZE[1] * SCALE)), Image.Resampling.LANCZOS)


def main():
    """Write the film."""
    frames = []
    with (
        tempfile.TemporaryDirectory() as folder,
        running(cwd=folder) as server,
        chromium(folder, size=SIZE) as studio,
    ):
        inside = studio.browser.execute_script("return [innerWidth, innerHeight]")
        studio.browser.set_window_size(*(2 * np.array(SIZE) - inside).tolist())
        studio.open(server.address)
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
    film = [frames[0]] * HOLD + frames + [frames[-1]] * HOLD + frames[::-1]
    both = Image.new("RGB", (film[0].width, 2 * film[0].height))
    both.paste(frames[0])
    both.paste(frames[-1], (0, film[0].height))
    colours = both.quantize(
        256, Image.Quantize.MAXCOVERAGE, kmeans=4
    )  # of the strip that can be made and of the refused one
    film = [picture.quantize(palette=colours, dither=Image.Dither.NONE) for picture in film]
    film[0].save(
        ROOT / "docs/studio/drag.gif",
        save_all=True,
        append_images=film[1:],
        duration=MS,
        loop=0,
        optimize=True,
    )


POINT = 2
"""Number of the point that is pulled."""

if __name__ == "__main__":
    main()
