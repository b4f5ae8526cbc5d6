#!/usr/bin/env bash
# README's commands on a Debian 12 that has Python, make and git alone, made by debootstrap in a temporary folder.
#
#     tests/campaign/fresh.sh [PACKAGE ...]
#
# Needs root, 8 GB and a network. PACKAGEs are installed before: with "gcc libc6-dev python3-dev" there is a compiler
# from the start. The settings of apt and pip on this machine are copied, nothing else. First a user without rights
# types `make test` and must get one sentence. The last line is the result; the folder of a run that fails is kept.
set -euo pipefail
cd "$(dirname "$0")/../.."
[ "$(id -u)" = 0 ] || { echo "debootstrap needs root: sudo make campaign-fresh"; exit 1; }
command -v debootstrap >/dev/null || apt-get install -y -qq --no-install-recommends debootstrap >/dev/null

folder=$(mktemp -d) && root=$folder/root
mounted=()
leave() {
	local passed=$?
	for place in ${mounted[@]+"${mounted[@]}"}; do umount "$root$place" || umount --lazy "$root$place"; done
	if [ "$passed" = 0 ]; then rm -rf --one-file-system "$folder"; else echo "failed; what was made is in $folder"; fi
}
trap leave EXIT
place() { mkdir -p "$root$1" && mount --bind "$1" "$root$1" && mounted=("$1" "${mounted[@]}"); }
copy() { for path in "$@"; do [ ! -e "$path" ] || { mkdir -p "$root$(dirname "$path")" && cp -aL --remove-destination "$path" "$root$(dirname "$path")/"; }; done; }

mirror=$(cat /etc/apt/sources.list /etc/apt/sources.list.d/*.{list,sources} 2>/dev/null | grep -E '^(URIs:|deb )' | grep -oE -m 1 '(https?|file):[^ ]+' || true)
packages="python3,python3-venv,python3-pip,make,git,ca-certificates$(printf ',%s' "$@" | grep -v '^,$' || true)"
debootstrap --variant=minbase --include="$packages" bookworm "$root" ${mirror:+"$mirror"} >"$folder/debootstrap.log" 2>&1 || { tail -5 "$folder/debootstrap.log"; exit 1; }

[ -z "$mirror" ] || rm -f "$root/etc/apt/sources.list"
copy /etc/resolv.conf /etc/hosts /etc/apt/sources.list /etc/apt/sources.list.d /etc/apt/apt.conf.d /etc/ssl/certs /usr/share/keyrings
copy /etc/pip.conf /etc/xdg/pip "$HOME/.config/pip" "$HOME/.pip"
for local in $({ python3 -m pip config list; echo "${PIP_FIND_LINKS:-}"; } 2>/dev/null | grep -oE "/[^' ,]+" | sort -u); do
	[ ! -d "${local%/simple}" ] || place "${local%/simple}" # folders of packages
done
for system in /proc /sys /dev; do place $system; done
git clone -q . "$root/project"
chroot "$root" useradd --create-home visitor
cp -a "$root/project" "$root/home/visitor/project" && chroot "$root" chown -R visitor: /home/visitor/project

inside() { # a user, the user's home, a folder, words
	local settings
	mapfile -t settings < <(env | grep -E '^PIP_' || true)
	env -i HOME="$2" LANG=C.UTF-8 PATH=/usr/sbin:/usr/bin:/sbin:/bin "${settings[@]}" \
		chroot --userspec="$1" "$root" sh -c 'cd "$1" && shift && exec "$@"' sh "$3" "${@:4}"
}
if inside visitor:visitor /home/visitor /home/visitor/project make test >"$folder/visitor.log" 2>&1 ||
	[ "$(grep -v '^make' "$folder/visitor.log" | cut -d: -f1)" != "First install what the tests need, as root" ]; then
	echo "a user without rights is not told what to install: see $folder/visitor.log"
	exit 1
fi
inside root:root /root /project make demo
inside root:root /root /project make test 2>&1 | tee "$folder/test.log"
echo "make demo and make test pass; $(grep -oE '[0-9]+ passed' "$folder/test.log" | awk '{ sum += $1 } END { print sum }') tests passed"
