#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Starts the program under a virtual X server and uses it: run, turbo, threshold, restart, quit; compares what it writes
# with what the headless command writes.   end_to_end.sh PROGRAM OUTPUT_FOLDER
set -uo pipefail
program=$1 out=$2
for tool in Xvfb xdotool import compare; do
  command -v "$tool" >/dev/null || { echo "skipped: $tool is missing"; exit 77; }
done

home=$(mktemp -d)
trap 'kill $(jobs -p) 2>/dev/null || true; rm -rf "$home"' EXIT
fail() { echo "FAILED: $*"; exit 1; }

exec 3>"$home/display"
Xvfb -displayfd 3 -screen 0 1280x800x24 -nolisten tcp 2>/dev/null &
for _ in $(seq 50); do [ -s "$home/display" ] && break; sleep 0.1; done
export DISPLAY=:$(cat "$home/display") QT_QPA_PLATFORM=xcb HOME=$home XDG_CONFIG_HOME=$home/config XDG_RUNTIME_DIR=$home

echo leak:libdbus-1 >"$home/leaks"  # a library's own, seen when this runs with the address sanitizer
export LSAN_OPTIONS=suppressions=$home/leaks:print_suppressions=0

arguments=(--policy trl --set policy.threshold=50 --seed 4 --episodes 1500)
"$program" window "${arguments[@]}" --json --log "$home/window.csv" >"$home/window.json" 2>"$home/errors" &
pid=$!
window=$(timeout 20 xdotool search --sync --onlyvisible --name '^Surefoot' | head -1)
[ -n "$window" ] || fail "no window appeared: $(cat "$home/errors")"
xdotool windowmove --sync "$window" 0 0 windowfocus --sync "$window"

shot() { sleep 0.6; import -window root "$out/$1.png"; }
differ() { [ "$(compare -metric AE "$out/$1.png" "$out/$2.png" null: 2>&1)" != 0 ]; }
shot learning; shot learning-later
differ learning learning-later || fail "the pendulum does not move"
xdotool key space; sleep 1; shot paused; shot paused-later
differ paused paused-later && fail "a paused window moves"
xdotool key period; shot stepped
differ paused stepped || fail "a step changes nothing"
xdotool key t key space; shot turbo
for _ in $(seq 300); do
  [ "$(xdotool getwindowname "$window")" = "Surefoot: the life is complete" ] && break
  sleep 0.1
done
[ "$(xdotool getwindowname "$window")" = "Surefoot: the life is complete" ] || fail "the life does not end"
xdotool key ctrl+q
for _ in $(seq 50); do kill -0 $pid 2>/dev/null || break; sleep 0.1; done
kill -0 $pid 2>/dev/null && fail "Ctrl+Q does not end the program"
wait $pid; code=$?
[ $code = 0 ] || fail "exit code $code: $(cat "$home/errors")"
[ -s "$home/errors" ] && fail "something was printed: $(cat "$home/errors")"

env -u DISPLAY "$program" train "${arguments[@]}" --json --log "$home/train.csv" >"$home/train.json" || fail "train"
hash() { grep -o '"hash": "[0-9a-f]*"' "$1"; }
[ "$(hash "$home/window.json")" = "$(hash "$home/train.json")" ] ||
  fail "the window's hash differs: $(hash "$home/window.json") $(hash "$home/train.json")"
cmp "$home/window.csv" "$home/train.csv" || fail "the logs differ"
echo "passed: $(hash "$home/train.json")"
