#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the package in a fresh minimal Debian 12 and uses it: learning, a lesson, the window, manual, completion,
# kinds of files; then removes it and looks for what is left. As root, with mmdebstrap.
#   trial.sh BUILD_FOLDER [CHROOT]     CHROOT: an existing one, which is changed; else a new one, which is removed
set -uo pipefail
build=$1 chroot=${2:-}
package=$(ls "$build"/surefoot_*.deb 2>/dev/null | head -1)
[ -n "$package" ] || { echo "skipped: there is no package in $build (cmake --build $build --target package)"; exit 77; }
[ "$(id -u)" = 0 ] && command -v mmdebstrap >/dev/null || { echo "skipped: it takes root and mmdebstrap"; exit 77; }

fail() { echo "FAILED: $*"; exit 1; }
if command -v lintian >/dev/null; then
  said=$(lintian --fail-on error,warning "$package" 2>&1) || fail "lintian: $said"
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
cp "$package" "$chroot/tmp/package.deb"
inside apt-get update -q >/dev/null || fail "apt-get update"
inside apt-get install -y -q --no-install-recommends /tmp/package.deb >/dev/null || fail "apt-get install"
inside surefoot --version || fail "--version"
inside surefoot train --minutes 1 --save /tmp/home/q.safetensors --journal /tmp/home/j.jsonl || fail "train"
inside surefoot replay /tmp/home/j.jsonl --verify >/dev/null || fail "replay"
inside surefoot lessons check /usr/share/surefoot/lessons/06-the-cliff.toml || fail "a lesson"
inside surefoot experiment quick --dry-run >/dev/null || fail "a plan that comes with it"
inside surefoot check hopper >/dev/null || fail "a robot that comes with it"

# What only the trial needs.
inside apt-get install -y -q --no-install-recommends xvfb man-db bash-completion shared-mime-info \
  libglib2.0-bin mandoc >/dev/null 2>&1 || fail "tools of the trial"
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

rm -rf "$chroot/tmp/home"
inside apt-get purge -y -q surefoot >/dev/null || fail "apt-get purge"
[ -z "$(everything)" ] || fail "left behind: $(everything)"
echo "passed: $(basename "$package")"
