#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A window opens the file that it is started with, and with --reuse-window a later start hands its file to that window.
#   open_window.sh PROGRAM RESOURCES
set -uo pipefail
program=$1 resources=$2
home=$(mktemp -d)
trap 'kill $(jobs -p) 2>/dev/null; wait 2>/dev/null; rm -rf "$home"' EXIT
fail() { echo "FAILED: $*"; exit 1; }
export HOME=$home XDG_CONFIG_HOME=$home/config XDG_DATA_HOME=$home/data XDG_RUNTIME_DIR=$home QT_QPA_PLATFORM=offscreen
recent() { cat "$home"/config/Surefoot/*.conf 2>/dev/null; }
# The window keeps its settings when something is remembered.
await() {
  for _ in $(seq 150); do recent | grep -q "$1" && return; sleep 0.1; done
  fail "$1 was not opened: $(recent)"
}

chmod 700 "$home"
"$program" "$resources/robots/hopper.toml" 2>"$home/errors" &
await hopper.toml
for _ in $(seq 50); do [ -S "$home/surefoot-window" ] && break; sleep 0.1; done
[ -S "$home/surefoot-window" ] || fail "no window listens"
timeout 20 "$program" window --reuse-window "$resources/lessons/06-the-cliff.toml" || fail "the second start: $?"
await 06-the-cliff.toml
timeout 20 "$program" window --reuse-window || fail "to the front: $?"
kill -TERM %1
wait %1
code=$?
[ $code = 130 ] || fail "the first window ended with $code: $(cat "$home/errors")"
[ -s "$home/errors" ] && fail "something was printed: $(cat "$home/errors")"
[ -e "$home/surefoot-window" ] && fail "the socket is left behind"
echo passed
