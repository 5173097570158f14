#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# update.sh LUPDATE DECLARED_TEXTS LANGUAGES: brings the files in a folder up to date with the texts of ui, of app, and
# with those that the core declares. From the folder of the source.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$2" >"$folder/declared.cpp"
"$1" -silent -no-obsolete -locations none -I . ui app "$folder" -ts "$3/surefoot_nl.ts" "$3/surefoot_de.ts"
"$1" -silent -no-obsolete -locations none -pluralonly -I . ui app -ts "$3/surefoot_en.ts"
