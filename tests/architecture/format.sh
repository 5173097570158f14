#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Every C++ file is as .clang-format says.   format.sh SOURCE_FOLDER
set -euo pipefail
command -v clang-format >/dev/null || { echo "skipped: clang-format is missing"; exit 77; }
cd "$1"
find app core physics ui tests \( -name '*.h' -o -name '*.cpp' \) -print0 | xargs -0 clang-format --dry-run -Werror
