#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the packages in a fresh minimal Debian 12 and uses them: learning, a lesson, the window, manual, completion,
# kinds of files, Python, C; then removes them and looks for what is left. As root, with mmdebstrap.
#   trial.sh BUILD_FOLDER SOURCES [CHROOT]     CHROOT: an existing one, which is changed; else a new one, removed after
set -uo pipefail
build=$1 sources=$2 chroot=${3:-}
packages=("$build"/surefoot_*.deb "$build"/libsurefoot[0-9]*.deb "$build"/libsurefoot-dev_*.deb
          "$build"/python3-surefoot_*.deb)
for package in "${packages[@]}"; do
  [ -f "$package" ] || { echo "skipped: there is no $package (cmake --build $build --target package)"; exit 77; }
done
[ "${#packages[@]}" = 4 ] || { echo "skipped: there are packages of several versions in $build"; exit 77; }
[ "$(id -u)" = 0 ] && command -v mmdebstrap >/dev/null || { echo "skipped: it takes root and mmdebstrap"; exit 77; }

fail() { echo "FAILED: $*"; exit 1; }
if command -v lintian >/dev/null; then
  said=$(lintian --fail-on error,warning "${packages[@]}" 2>&1) || fail "lintian: $said"
fi
if [ -z "$chroot" ]; then
  chroot=$(mktemp -d)
  trap 'umount "$chroot/proc" "$chroot/dev/shm" 2>/dev/null; rm -rf --one-file-system "$chroot"' EXIT
  mmdebstrap --variant=minbase bookworm "$chroot" >/dev/null 2>&1 || fail "mmdebstrap"
else
  trap 'umount "$chroot/proc" "$chroot/dev/shm" 2>/dev/null' EXIT
fi
chmod 755 "$chroot"
mkdir -p "$chroot/dev/shm"
mount -t proc proc "$chroot/proc" && mount -t tmpfs tmpfs "$chroot/dev/shm" || fail "mount"
cp /etc/resolv.conf "$chroot/etc/" 2>/dev/null
inside() {
  chroot "$chroot" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/tmp/home LANG=C.UTF-8 \
    DEBIAN_FRONTEND=noninteractive "$@"
}
everything() { inside find / -xdev -iname '*surefoot*' -not -path '/proc/*' -not -path '/var/cache/*' | sort; }

mkdir -p "$chroot/tmp/home"
cp "${packages[@]}" "$chroot/tmp/"
install_packages() { inside sh -c 'apt-get install -y -q --no-install-recommends "$@" >/dev/null 2>&1' sh "$@"; }
inside apt-get update -q >/dev/null || fail "apt-get update"
install_packages "/tmp/$(basename "${packages[0]}")" || fail "apt-get install of the program alone"
inside surefoot --version || fail "--version"
inside surefoot train --minutes 1 --save /tmp/home/q.safetensors --journal /tmp/home/j.jsonl || fail "train"
inside surefoot replay /tmp/home/j.jsonl --verify >/dev/null || fail "replay"
inside surefoot lessons check /usr/share/surefoot/lessons/06-the-cliff.toml || fail "a lesson"
inside surefoot experiment quick --dry-run >/dev/null || fail "a plan that comes with it"
inside surefoot check hopper >/dev/null || fail "a robot that comes with it"

# What only the trial needs.
install_packages xvfb man-db bash-completion shared-mime-info libglib2.0-bin mandoc gcc libc6-dev pkg-config cmake \
  make || fail "tools of the trial"
for page in surefoot surefoot-train surefoot-parameters; do
  inside sh -c "zcat /usr/share/man/man*/$page.*.gz | mandoc -Tutf8 | head -3" | grep -qi "$page" || fail "man $page"
done
inside man surefoot-train | grep -q -- --minutes || fail "man surefoot-train"
inside bash -c '. /usr/share/bash-completion/completions/surefoot
  COMP_WORDS=(surefoot train --policy soft) COMP_CWORD=3; _surefoot; [ "${COMPREPLY[*]}" = softmax ]' ||
  fail "completion"

kind() { inside gio info -a standard::content-type "$1" | sed -n 's/.*content-type: //p'; }
printf '[package]\nname = "other"\n' >"$chroot/tmp/home/Cargo.toml"
[ "$(kind /tmp/home/q.safetensors)" = application/x-surefoot-q-function ] || fail "kind of a Q-function"
[ "$(kind /tmp/home/j.jsonl)" = application/x-surefoot-journal ] || fail "kind of a journal"
[ "$(kind /usr/share/surefoot/robots/hopper.toml)" = application/x-surefoot-robot ] || fail "kind of a robot"
[ "$(kind /usr/share/surefoot/lessons/06-the-cliff.toml)" = application/x-surefoot-lesson ] || fail "kind of a lesson"
[ "$(kind /usr/share/surefoot/plans/quick.toml)" = application/x-surefoot-plan ] || fail "kind of a plan"
[ "$(kind /tmp/home/Cargo.toml)" = application/toml ] || fail "another program's file is taken for ours"

# The window under a virtual X server: it opens files, and ends cleanly with what it learned.
for file in "" /tmp/home/q.safetensors /usr/share/surefoot/lessons/06-the-cliff.toml; do
  inside sh -c "Xvfb :77 -screen 0 1280x800x24 -nolisten tcp >/dev/null 2>&1 & x=\$!; sleep 2
    DISPLAY=:77 timeout -s INT 8 surefoot window $file --json >/tmp/home/window.json 2>/tmp/home/errors
    kill \$x; wait \$x"
  [ -s "$chroot/tmp/home/errors" ] && fail "the window said: $(cat "$chroot/tmp/home/errors")"
  grep -q '"hash"' "$chroot/tmp/home/window.json" || fail "the window with '$file' did not tell of its life"
done

# From Python and from C: what the handbook shows.
example() {
  sed -n "/^\`\`\`$1\$/,/^\`\`\`\$/p" "$sources/resources/handbook/$2" | sed '/^```/d' >"$chroot/tmp/home/$3"
}
install_packages "${packages[@]/#*\//\/tmp\/}" || fail "apt-get install of all packages"
example python 69-from-python.md example.py
[ "$(wc -l <"$chroot/tmp/home/example.py")" -ge 10 ] || fail "the handbook's example in Python is missing"
inside sh -c 'cd /tmp/home && python3 example.py' || fail "the handbook's example in Python"
inside python3 -c 'import surefoot; print(surefoot.make("hopper").about["state"][0]["title"])' || fail "a robot by name"
ls "$chroot"/usr/lib/python3/dist-packages/surefoot/__pycache__/*.pyc >/dev/null || fail "Python files are not compiled"
example c 69-from-c.md life.c
inside sh -c 'cd /tmp/home && cc -std=c11 -Wall -Wextra -Werror life.c $(pkg-config --cflags --libs surefoot) \
  -o life' || fail "a program in C by pkg-config"
hash=$(inside surefoot train --agent sarsa-2q --seed 4 --minutes 9 --json |
  sed -n 's/.*"hash": *"\([0-9a-f]*\)".*/\1/p')
[ -n "$hash" ] && [ "$(inside /tmp/home/life)" = "$hash" ] || fail "the life from C is not that of the program"
printf '%s\n' 'cmake_minimum_required(VERSION 3.25)' 'project(life C)' 'find_package(surefoot REQUIRED)' \
  'add_executable(life life.c)' 'target_link_libraries(life surefoot::surefoot)' >"$chroot/tmp/home/CMakeLists.txt"
inside sh -c 'cd /tmp/home && cmake -B build . >/dev/null && cmake --build build >/dev/null' || fail "C by CMake"
[ "$(inside /tmp/home/build/life)" = "$hash" ] || fail "the life from C by CMake"

rm -rf "$chroot/tmp/home" "$chroot"/tmp/*.deb
inside apt-get purge -y -q surefoot "libsurefoot*" python3-surefoot >/dev/null || fail "apt-get purge"
[ -z "$(everything)" ] || fail "left behind: $(everything)"
echo "passed: $(printf '%s ' "${packages[@]##*/}")"
