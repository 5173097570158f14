#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A tour through the window under a virtual X server, as a person would take it: τ, the threshold, the pole held by the
# mouse, turbo, the Q-function saved and loaded, an experiment run and its charts exported; a picture at every stop.
#   tour.sh PROGRAM OUTPUT_FOLDER
set -uo pipefail
program=$1 out=$2
mkdir -p "$out"
for tool in Xvfb xdotool import; do
  command -v "$tool" >/dev/null || { echo "skipped: $tool is missing"; exit 77; }
done

home=$(mktemp -d)
trap 'kill $(jobs -p) 2>/dev/null || true; rm -rf "$home"' EXIT
fail() { import -window root "$out/tour-failed.png"; echo "FAILED: $*"; exit 1; }

exec 3>"$home/display"
Xvfb -displayfd 3 -screen 0 1280x800x24 -nolisten tcp 2>/dev/null &
for _ in $(seq 50); do [ -s "$home/display" ] && break; sleep 0.1; done
export DISPLAY=:$(cat "$home/display") QT_QPA_PLATFORM=xcb HOME=$home
export XDG_CONFIG_HOME=$home/config XDG_DATA_HOME=$home/data XDG_RUNTIME_DIR=$home
echo leak:libdbus-1 >"$home/leaks"
export LSAN_OPTIONS=suppressions=$home/leaks:print_suppressions=0

cat >"$home/plan.toml" <<'PLAN'
title = "Two walks along a cliff"
lives = 8
reference = "ε-greedy"
[base]
environment = "cliff"
features = "table"
episodes = 300
[[condition]]
name = "ε-greedy"
[[condition]]
name = "Softmax"
policy = "softmax"
PLAN

"$program" window --policy trl --seed 4 >"$home/output" 2>"$home/errors" &
pid=$!
window=$(timeout 20 xdotool search --sync --onlyvisible --name '^Surefoot' | head -1)
[ -n "$window" ] || fail "no window appeared: $(cat "$home/errors")"
xdotool windowmove --sync "$window" 0 0 windowsize --sync "$window" 1280 800 windowfocus --sync "$window"

stop() { sleep 0.4; import -window root "$out/tour-$1.png"; }
waitFor() { for _ in $(seq 100); do eval "$1" && return; sleep 0.1; done; fail "$2"; }
# A file dialog has the focus in its field for the name.
answer() {
  sleep 0.7
  xdotool key ctrl+a
  xdotool type --delay 5 "$1"
  sleep 0.2
  xdotool key Return
  sleep 0.7
  xdotool windowfocus --sync "$window"
}

stop 1-start
xdotool mousemove 149 216 mousedown 1 mousemove 156 216 mouseup 1      # τ
xdotool mousemove 400 640 mousedown 1 mousemove 420 640 mouseup 1      # the threshold
stop 2-threshold
xdotool mousemove 552 190 mousedown 1 mousemove 600 190; stop 3-held; xdotool mouseup 1
xdotool key t; sleep 2; stop 4-turbo
xdotool key alt+f; sleep 0.4; xdotool key f; answer "$home/learned.safetensors"
waitFor '[ -s "$home/learned.safetensors" ]' "the Q-function was not saved"
xdotool key r; stop 5-restarted
xdotool key ctrl+o; answer "$home/learned.safetensors"; stop 6-loaded
xdotool key ctrl+o; answer "$home/plan.toml"
xdotool key alt+x; sleep 0.4; xdotool key r
waitFor 'ls "$home"/data/*/*/results-*.sqlite >/dev/null 2>&1' "the experiment did not begin"
sleep 4; stop 7-experiment
mkdir "$home/charts"
xdotool key alt+x; sleep 0.4; xdotool key h; answer "$home/charts"
waitFor '[ -s "$home/charts/falls.png" ] && [ -s "$home/charts/falls.csv" ]' "the charts were not exported"
xdotool key ctrl+q; stop 8-quit
xdotool key alt+d  # what was learned is not saved
waitFor '! kill -0 $pid 2>/dev/null' "Ctrl+Q does not end the program"
wait $pid; code=$?
[ $code = 0 ] || fail "exit code $code: $(cat "$home/errors")"
[ -s "$home/errors" ] && fail "something was printed: $(cat "$home/errors")"
grep -q "Softmax" "$home/charts/falls.csv" || fail "the chart's table does not name the conditions"
ls "$home"/data/*/*/last-session-*.surefoot >/dev/null 2>&1 || fail "the session is not kept for the next start"
ls "$home"/data/*/*/autosave-* 2>/dev/null && fail "an autosave is left behind"
echo "passed"
