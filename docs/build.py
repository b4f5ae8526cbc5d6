"""Builds the manual: python docs/build.py FOLDER [--english]; a warning is an error."""

import subprocess
import sys
from pathlib import Path

DOCS = Path(__file__).resolve().parent
TRANSLATIONS = ("de", "zh_CN")
SPHINX = (sys.executable, "-m", "sphinx", "-W", "--keep-going", "-q", "-b", "html")


def main(site: Path, translations: tuple[str, ...] = TRANSLATIONS) -> None:
    """English at the root, the others in folders of theirs."""
    subprocess.run([*SPHINX, DOCS, site], check=True)
    for language in translations:
        chosen = ("-t", "translated", "-D", f"language={language}")
        subprocess.run([*SPHINX, *chosen, DOCS, site / language], check=True)
    print(f"{site / 'index.html'}")


if __name__ == "__main__":
    main(Path(sys.argv[1]), () if "--english" in sys.argv[2:] else TRANSLATIONS)
