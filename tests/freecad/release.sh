#!/usr/bin/env bash
# Runs the FreeCAD suite on another Debian release (trixie: FreeCAD 1.0, sid: 1.1) in a folder made by debootstrap.
# Needs root and about 3.5 GB under ELASTICA_ROOTS; a finished folder is used again.
set -euo pipefail
release=$1
here=$(cd "$(dirname "$0")/../.." && pwd)
root=${ELASTICA_ROOTS:-$HOME/.cache/elastica-cad}/$release
mirror=${ELASTICA_MIRROR:-}
packages="make freecad qt6-svg-plugins xvfb xauth xdotool openbox imagemagick python3-scipy python3-numpy python3-ezdxf python3-pytest"

[ "$(id -u)" = 0 ] || { echo "debootstrap needs root: sudo tests/freecad/release.sh $release"; exit 1; }
command -v debootstrap >/dev/null || apt-get install -y -qq --no-install-recommends debootstrap >/dev/null

leave() { for place in project dev proc; do mountpoint -q "$root/$place" && umount --lazy "$root/$place"; done; true; }
trap leave EXIT
if [ ! -e "$root/made" ]; then
	rm -rf --one-file-system "$root"
	mkdir -p "$root"
	debootstrap --variant=minbase "$release" "$root" ${mirror:+"$mirror"} >"$root.log" 2>&1 || { tail -5 "$root.log"; exit 1; }
	touch "$root/made"
fi
mkdir -p "$root/project"
mountpoint -q "$root/proc" || mount -t proc proc "$root/proc"
mountpoint -q "$root/dev" || mount --bind /dev "$root/dev"
mountpoint -q "$root/project" || { mount --bind "$here" "$root/project" && mount -o remount,bind,ro "$root/project"; }
if [ "$(cat "$root/ready" 2>/dev/null)" != "$packages" ]; then
	for file in /etc/resolv.conf /etc/hosts; do cp -L "$file" "$root$file" || true; done
	for folder in /etc/apt/apt.conf.d /etc/ssl/certs /usr/local/share/ca-certificates; do
		[ -d "$folder" ] && mkdir -p "$root$folder" && cp -aLn "$folder/." "$root$folder/" || true
	done
	chroot "$root" apt-get -o Acquire::Check-Valid-Until=false update -qq
	chroot "$root" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $packages >>"$root.log" 2>&1 ||
		{ tail -5 "$root.log"; exit 1; }
	echo "$packages" >"$root/ready"
fi
chroot "$root" freecadcmd --version 2>/dev/null || true
chroot "$root" env -u DISPLAY PYTHONDONTWRITEBYTECODE=1 HOME=/root sh -c \
	'cd /project && python3 -m pytest -p no:cacheprovider -q --import-mode=importlib -o addopts="" -o filterwarnings="" tests/freecad "$@"' sh "${@:2}"
