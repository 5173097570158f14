#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The manual pages, compressed, in folders of their sections.   manual.sh SUREFOOT FOLDER DATE
set -eu
rm -rf "$2"
mkdir -p "$2"
"$1" manual "$2" "$3"
for page in "$2"/*.[1-8]; do
  section=$2/man${page##*.}
  mkdir -p "$section"
  gzip -9n "$page"
  mv "$page.gz" "$section"
done
touch "$2"
