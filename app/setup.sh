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

# build PRESET TARGET…: configures on the first start, then builds what has changed.
build() {
  local preset=$1 log
  shift
  log=$(mktemp)
  if [ ! -f "build/$preset/build.ninja" ]; then
    echo "Configuring (build/$preset) …" >&2
    cmake --preset "$preset" >"$log" 2>&1 || { cat "$log" >&2; rm -f "$log"; exit 1; }
    echo "Building, which takes a few minutes the first time …" >&2
  fi
  cmake --build "build/$preset" --target "$@" >"$log" 2>&1 || { cat "$log" >&2; rm -f "$log"; exit 1; }
  rm -f "$log"
}

BUILD_PACKAGES=(g++ cmake ninja-build libbox2d-dev libfmt-dev libcli11-dev nlohmann-json3-dev libboost-dev
                libeigen3-dev libtomlplusplus-dev libsqlitecpp-dev libsqlite3-dev)
WINDOW_PACKAGES=(qt6-base-dev libqt6opengl6-dev qt6-charts-dev qt6-svg-dev fonts-roboto-unhinted fonts-dejavu-core)
