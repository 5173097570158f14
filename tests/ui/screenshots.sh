#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the pictures of the README again, from the real program under a virtual X server.
#   tests/ui/screenshots.sh [PROGRAM] [OUTPUT_FOLDER]
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/../.."
program=$(readlink -f "${1:-build/release/surefoot}") out=${2:-resources/screenshots}
mkdir -p "$out"
home=$(mktemp -d)
trap 'kill $(jobs -p) 2>/dev/null; rm -rf "$home"' EXIT

# shot NAME WIDTH HEIGHT APPEARANCE(1 light, 2 dark)
shot() {
  local name=$1 width=$2 height=$3
  rm -rf "$home"/*
  mkdir -p "$home/config/Surefoot"
  printf '[General]\nappearance=%s\n' "$4" >"$home/config/Surefoot/Surefoot.conf"
  exec 3>"$home/display"
  Xvfb -displayfd 3 -screen 0 "${width}x${height}x24" -nolisten tcp 2>/dev/null &
  local server=$!
  while [ ! -s "$home/display" ]; do sleep 0.1; done
  local environment=(env DISPLAY=":$(cat "$home/display")" QT_QPA_PLATFORM=xcb HOME="$home" XDG_CONFIG_HOME="$home/config" XDG_RUNTIME_DIR="$home")
  "${environment[@]}" "$program" window --policy epsilon-greedy --minutes 7 --turbo &
  local pid=$! window
  window=$("${environment[@]}" timeout 20 xdotool search --sync --onlyvisible --name '^Surefoot' | head -1)
  "${environment[@]}" xdotool windowmove --sync "$window" 0 0 windowsize --sync "$window" "$width" "$height" windowfocus --sync "$window"
  # A life of seven minutes under each policy, TRL last; the others stay as faint curves.
  local keys
  for keys in "Down Down" "Up"; do
    sleep 2
    "${environment[@]}" xdotool mousemove --window "$window" 800 50 click 1
    sleep 0.3
    "${environment[@]}" xdotool key $keys Return
    sleep 0.3
    "${environment[@]}" xdotool mousemove --window "$window" 104 50 click 1 mousemove --window "$window" 640 20
  done
  sleep 2
  "${environment[@]}" import -window root "$out/$name.png"
  kill $pid && wait $pid || true
  kill $server && wait $server 2>/dev/null || true
}

shot window-light 1280 800 1
shot window-dark 1280 800 2
