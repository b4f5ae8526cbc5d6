#!/usr/bin/env bash
# Installs what the tests need besides Python's packages, where it is missing and allowed; says how where it is not.
# Run it before an environment is built: the compiled loops are built there only if a compiler is installed.
set -euo pipefail
python=${PYTHON:-python3}

# A package of Debian, and what shows that it is here: a program, a library, or what `is_here` knows.
NEEDED="
gcc               compiler
libc6-dev         compiler
python3-dev       compiler
python3-venv      environments
git               git
freecad           freecadcmd
xvfb              xvfb-run
xauth             xauth
xdotool           xdotool
openbox           openbox
imagemagick       import
inkscape          inkscape
librecad          librecad
openscad          openscad
poppler-utils     pdftocairo
calculix-ccx      ccx
chromium          chromium
chromium-driver   chromedriver
libglu1-mesa      libGLU.so.1
libxcursor1       libXcursor.so.1
libxft2           libXft.so.2
libxinerama1      libXinerama.so.1
" # gmsh asks for the libraries

is_here() {
	case $1 in
	compiler)
		local headers
		headers=$("$python" -c 'import sysconfig; print(sysconfig.get_path("include"))') &&
			echo '#include <Python.h>' | cc -fsyntax-only -I"$headers" -x c -
		;;
	environments) "$python" -c 'import ensurepip' ;;
	*.so.*) PATH=$PATH:/sbin ldconfig -p | grep -F "$1 " ;;
	*) command -v "$1" ;;
	esac >/dev/null 2>&1
}

missing() {
	while read -r package shown; do
		[ -z "$package" ] || is_here "$shown" || echo "$package"
	done <<<"$NEEDED"
}

mapfile -t packages < <(missing)
[ ${#packages[@]} = 0 ] && exit 0
as_root=()
[ "$(id -u)" = 0 ] || as_root=(sudo -n)
if command -v apt-get >/dev/null && "${as_root[@]}" true 2>/dev/null; then
	apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq)
	"${apt[@]}" update && "${apt[@]}" install -y --no-install-recommends "${packages[@]}" >/dev/null || true
	mapfile -t packages < <(missing)
	[ ${#packages[@]} = 0 ] && exit 0
fi
echo "First install what the tests need, as root: apt-get install --no-install-recommends ${packages[*]}"
exit 1
