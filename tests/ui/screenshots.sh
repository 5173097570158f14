#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the pictures of the README and the handbook again, from the real program under a virtual X server.
#   tests/ui/screenshots.sh [PROGRAM] [OUTPUT_FOLDER]
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/../.."
program=$(readlink -f "${1:-build/release/surefoot}") out=${2:-resources/screenshots}
mkdir -p "$out"
home=$(mktemp -d)
trap 'kill $(jobs -p) 2>/dev/null || true; rm -rf "$home"' EXIT

# shot NAME WIDTH HEIGHT APPEARANCE(1 light, 2 dark)
shot() {
  local name=$1 width=$2 height=$3
  rm -rf "$home"/* "$home"/.local
  mkdir -p "$home/config/Surefoot"
  printf '[General]\nappearance=%s\n' "$4" >"$home/config/Surefoot/Surefoot.conf"
  exec 3>"$home/display"
  Xvfb -displayfd 3 -screen 0 "${width}x${height}x24" -nolisten tcp 2>/dev/null &
  local server=$!
  while [ ! -s "$home/display" ]; do sleep 0.1; done
  local environment=(env DISPLAY=":$(cat "$home/display")" QT_QPA_PLATFORM=xcb HOME="$home"
                     XDG_CONFIG_HOME="$home/config" XDG_RUNTIME_DIR="$home")
  "${environment[@]}" "$program" window --policy epsilon-greedy --minutes 7 --turbo &
  local pid=$! window
  window=$("${environment[@]}" timeout 20 xdotool search --sync --onlyvisible --name '^Surefoot' | head -1)
  "${environment[@]}" xdotool windowmove --sync "$window" 0 0 \
    windowsize --sync "$window" "$width" "$height" windowfocus --sync "$window"
  # A life of seven minutes under each policy, TRL last; the others stay as faint curves.
  local keys
  for keys in "Down Down" "Up"; do
    sleep 2
    "${environment[@]}" xdotool mousemove --window "$window" 886 50 click 1
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

# begin [ARGUMENT …]: the window in a home of its own; sets environment, window, pid and server.
begin() {
  rm -rf "$home"/* "$home"/.local
  mkdir -p "$home/config/Surefoot"
  printf '[General]\nappearance=1\n' >"$home/config/Surefoot/Surefoot.conf"
  exec 3>"$home/display"
  Xvfb -displayfd 3 -screen 0 1280x800x24 -nolisten tcp 2>/dev/null &
  server=$!
  while [ ! -s "$home/display" ]; do sleep 0.1; done
  environment=(env DISPLAY=":$(cat "$home/display")" QT_QPA_PLATFORM=xcb HOME="$home"
               XDG_CONFIG_HOME="$home/config" XDG_DATA_HOME="$home/data" XDG_RUNTIME_DIR="$home")
  "${environment[@]}" "$program" window "$@" &
  pid=$!
  window=$("${environment[@]}" timeout 20 xdotool search --sync --onlyvisible --name '^Surefoot' | head -1)
  "${environment[@]}" xdotool windowmove --sync "$window" 0 0 \
    windowsize --sync "$window" 1280 800 windowfocus --sync "$window"
}

end() {
  kill $pid && wait $pid || true
  kill $server && wait $server 2>/dev/null || true
}

# animation NAME: four seconds of a pendulum that has learned for a moment, half the size.
animation() {
  begin --policy trl
  "${environment[@]}" xdotool key t
  sleep 0.6
  "${environment[@]}" xdotool key t
  mkdir "$home/frames"
  local i
  for i in $(seq -w 32); do
    "${environment[@]}" import -window root "$home/frames/$i.png"
    sleep 0.05
  done
  convert -delay 12 -loop 0 "$home/frames/*.png" -resize 50% -layers optimize "$out/$1.gif"
  end
}

# experiment NAME: the Experiment page with the shipped plan, run to its end.
experiment() {
  begin
  "${environment[@]}" xdotool key space ctrl+2
  sleep 1
  "${environment[@]}" xdotool mousemove 24 48 click 1 mousemove 640 20
  sleep 75
  "${environment[@]}" import -window root "$out/$1.png"
  end
}

# walker NAME: LEO learning to walk, some hundred times as fast as it would.
walker() {
  begin --environment leo --policy trl --turbo --seed 5
  sleep 22
  "${environment[@]}" import -window root "$out/$1.png"
  end
}

# lesson NAME: a prediction of lesson 5, and what came out.
lesson() {
  begin --lesson exploring-costs-falls
  sleep 2
  "${environment[@]}" xdotool key alt+Right
  sleep 2
  "${environment[@]}" xdotool type 40
  "${environment[@]}" xdotool key Return
  sleep 6
  "${environment[@]}" import -window root "$out/$1.png"
  end
}

# lessons NAME: the list.
lessons() {
  begin
  "${environment[@]}" xdotool key ctrl+3
  sleep 2
  "${environment[@]}" xdotool key Down Down Down Down Down
  sleep 1
  "${environment[@]}" import -window root "$out/$1.png"
  end
}

# robot NAME: the Robot page with the hopper, the pointer on its trunk.
robot() {
  begin --environment hopper
  "${environment[@]}" xdotool key space ctrl+o
  sleep 1
  mkdir "$home/robots" && cp resources/robots/hopper.toml "$home/robots"
  "${environment[@]}" xdotool type "$home/robots/hopper.toml"
  "${environment[@]}" xdotool key Return
  sleep 2
  "${environment[@]}" xdotool mousemove 640 270
  sleep 1
  "${environment[@]}" import -window root "$out/$1.png"
  end
}

# Only those that are named, as in ONLY="lesson lessons" screenshots.sh …
wanted() {
  case " ${ONLY:-$1} " in *" $1 "*) "$@" ;; esac
}

wanted lessons lessons
wanted lesson lesson
wanted robot robot
wanted experiment experiment
[ -z "${ONLY:-}" ] || exit 0
shot window-light 1280 800 1
shot window-dark 1280 800 2
animation window
walker walker
