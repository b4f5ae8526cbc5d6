"""Files that users store: python -m tests.house.stored_files writes those of this version.

Users open design files, reports and links of the page years later. `test_stored_files.py` opens those of every
earlier version.
"""

import base64
import json
import re
import shutil
import tomllib
import zlib
from pathlib import Path

from tests.command_line import run
from tests.house.name_lists import present_version
from tests.studio.conftest import link

ROOT = Path(__file__).resolve().parents[2]
STORED = ROOT / "tests" / "data" / "stored"
DESIGNS = ("arch", "lamp", "pavilion", "revolution")
"""Designs of `elastica new` without a mesh."""


def unlinked(fragment: str) -> dict[str, object]:
    """Return the design in the fragment of an address."""
    packed = base64.urlsafe_b64decode(fragment + "=" * (-len(fragment) % 4))
    return dict(json.loads(zlib.decompress(packed, wbits=-15)))


def write(folder: Path) -> None:
    """Write the files of this version."""
    folder.mkdir(parents=True, exist_ok=True)
    for name in DESIGNS:
        run("new", name, "-o", folder, "--force")
    for name in ("clip.toml", "clip.svg"):
        shutil.copy(ROOT / "examples" / "two_states" / name, folder)
    (folder / "felt.toml").write_text(
        "schema = 1\n\n[sheets.wool-felt-3]\nthickness_mm = 3.0\nyoungs_modulus_MPa = 12.0\n"
        "density_kg_m3 = 300.0\nmax_strain = 0.05\n",
        encoding="utf-8",
    )
    (folder / "elastica.schema.json").unlink()
    made = folder / "made"
    run(
        "strip", "arch.dxf", "--sheet", "birch-plywood-0.8", "--max-width", 40, "--label", "ARCH",
        "--no-step", "--no-pictures", "-o", "made", cwd=folder,
    )  # fmt: skip
    run("compare", "made/arch.json", cwd=folder)
    readings = (made / "arch-measured.toml").read_text(encoding="utf-8")
    filled = re.sub(r"^# (\w+ = [\d.]+)", r"\1", readings, flags=re.MULTILINE)
    (folder / "arch-measured.toml").write_text(filled, encoding="utf-8")
    shutil.copy(made / "arch.json", folder)
    shutil.rmtree(made)
    design = tomllib.loads((folder / "pavilion.toml").read_text(encoding="utf-8"))
    (folder / "link.txt").write_text(link(design) + "\n", encoding="utf-8")


if __name__ == "__main__":
    write(STORED / present_version())
