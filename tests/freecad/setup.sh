#!/usr/bin/env bash
# Installs Debian's FreeCAD and a screen without a monitor, where that is missing and allowed; says how where it is not.
set -euo pipefail
PACKAGES=(freecad xvfb xauth xdotool openbox imagemagick)

missing=0
for program in freecadcmd xvfb-run xdotool openbox import; do
	command -v "$program" >/dev/null || missing=1
done
[ "$missing" = 0 ] && exit 0

say_how() {
	echo "FreeCAD is missing: $1"
	echo "Install it with: sudo apt-get install --no-install-recommends ${PACKAGES[*]}"
	# the workbench is tested on every machine that decides about a change
	[ -n "${CI:-}" ] && exit 1
	exit 0
}

command -v apt-get >/dev/null || say_how "this is no Debian system"
as_root=()
if [ "$(id -u)" != 0 ]; then
	sudo -n true 2>/dev/null || say_how "installing it needs root"
	as_root=(sudo -n)
fi
export DEBIAN_FRONTEND=noninteractive
"${as_root[@]}" apt-get update -qq || say_how "apt cannot reach its packages"
"${as_root[@]}" apt-get install -y -qq --no-install-recommends "${PACKAGES[@]}" >/dev/null || say_how "apt refused"
