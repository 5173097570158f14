#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# update.sh LUPDATE DECLARED_TEXTS: brings resources/languages up to date with the texts of ui, of app, and with those
# that the core declares. From the folder of the source.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$2" >"$folder/declared.cpp"
"$1" -silent -no-obsolete -locations none -I . ui app "$folder" \
  -ts resources/languages/surefoot_nl.ts resources/languages/surefoot_de.ts
"$1" -silent -no-obsolete -locations none -pluralonly -I . ui app -ts resources/languages/surefoot_en.ts
