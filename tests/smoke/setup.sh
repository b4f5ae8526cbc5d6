#!/usr/bin/env bash
# Installs the programs that open our files in the tests, where they are missing and allowed; says how where not.
set -euo pipefail
PACKAGES=(inkscape librecad openscad poppler-utils xvfb xauth xdotool calculix-ccx chromium chromium-driver)
PACKAGES+=(libglu1-mesa libxcursor1 libxft2 libxinerama1) # what gmsh asks for

missing=0
for program in inkscape librecad openscad pdftocairo xvfb-run xdotool ccx chromedriver; do
	command -v "$program" >/dev/null || missing=1
done
[ "$missing" = 0 ] && exit 0

as_root=()
if [ "$(id -u)" != 0 ]; then
	sudo -n true 2>/dev/null || { echo "Install first: sudo apt-get install --no-install-recommends ${PACKAGES[*]}"; exit 1; }
	as_root=(sudo -n)
fi
export DEBIAN_FRONTEND=noninteractive
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" apt-get install -y -qq --no-install-recommends "${PACKAGES[@]}" >/dev/null
