# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by app/run and tests/run: installs what is missing, configures, builds.

# install PACKAGE…: says what it will install, and installs it. Nothing if all is there.
install_packages() {
  local missing=()
  for package in "$@"; do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      echo "These Debian packages are missing, and there is no sudo to install them with: ${missing[*]}" >&2
      exit 2
    fi
    as_root=(sudo)
  fi
  echo "Installing ${#missing[@]} Debian packages: ${missing[*]}" >&2
  { "${as_root[@]}" apt-get update -q &&
    DEBIAN_FRONTEND=noninteractive \
      "${as_root[@]}" apt-get install -y -q --no-install-recommends "${missing[@]}"; } >&2 || {
    echo "The packages could not be installed; see apt-get's words above." >&2
    exit 2
  }
}

# Reads what ninja says, "[done/all seconds] …"; says how far it is, and about how long it will take.
show_progress() {
  local line done all seconds last=0 left
  while IFS= read -r line; do
    [[ $line =~ ^\[([0-9]+)/([0-9]+)\ +([0-9]+) ]] || continue
    done=${BASH_REMATCH[1]} all=${BASH_REMATCH[2]} seconds=${BASH_REMATCH[3]}
    [ "$done" -gt 0 ] && [ "$all" -gt 20 ] || continue
    left=$((seconds * (all - done) / done))
    if [ -t 2 ]; then
      printf '\rBuilding: %d of %d, about %d:%02d min left  ' "$done" "$all" $((left / 60)) $((left % 60)) >&2
      [ "$done" -lt "$all" ] || printf '\n' >&2
    elif [ $((10 * done / all)) -gt "$last" ]; then
      last=$((10 * done / all))
      printf 'Building: %d of %d, about %d:%02d min left\n' "$done" "$all" $((left / 60)) $((left % 60)) >&2
    fi
  done
}

# build PRESET TARGET…: configures on the first start, then builds what has changed. Program and tests share one folder,
# so that nothing is compiled twice.
build() {
  local preset=$1 folder=build/release log
  shift
  log=$(mktemp)
  if [ ! -f "$folder/build.ninja" ] ||
     { [ "$preset" = ci ] && ! grep -q '^SUREFOOT_TESTS:.*=ON' "$folder/CMakeCache.txt"; }; then
    echo "Configuring ($folder) …" >&2
    cmake --preset "$preset" >"$log" 2>&1 || { cat "$log" >&2; rm -f "$log"; exit 1; }
  fi
  NINJA_STATUS='[%f/%t %e] ' cmake --build "$folder" --target "$@" 2>&1 | tee "$log" | show_progress ||
    { echo >&2; cat "$log" >&2; rm -f "$log"; exit 1; }
  rm -f "$log"
}

BUILD_PACKAGES=(g++ cmake ninja-build pkg-config libbox2d-dev libcairo2-dev libfmt-dev libcli11-dev
                nlohmann-json3-dev libboost-dev libeigen3-dev libnlopt-dev libtomlplusplus-dev libsqlitecpp-dev
                libsqlite3-dev zlib1g-dev libmd4c-dev libmd4c-html0-dev)
WINDOW_PACKAGES=(qt6-base-dev libqt6opengl6-dev qt6-charts-dev qt6-svg-dev qt6-l10n-tools qt6-translations-l10n
                 libwebp-dev fonts-roboto-unhinted fonts-dejavu-core)
