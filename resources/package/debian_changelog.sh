#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The changelog of the package: the newest part of CHANGELOG.md in Debian's form, compressed.
#   debian_changelog.sh CHANGELOG.md OUTPUT.gz VERSION DATE MAINTAINER
set -eu
export LC_ALL=C.UTF-8
{
  printf 'surefoot (%s) unstable; urgency=medium\n\n' "$3"
  # An entry a line, headings in brackets; then each in lines of 76 characters.
  awk '/^## / {part++; next} part != 1 || !NF {next}
       /^### / {if (entry) print entry; entry = "[ " substr($0, 5) " ]"; next}
       /^- / {if (entry) print entry; entry = substr($0, 3); next}
       {sub(/^ +/, ""); entry = entry " " $0} END {print entry}' "$1" |
    while IFS= read -r entry; do printf '%s\n' "$entry" | fold -s -w 74 | sed '1s/^/  * /; 1!s/^/    /; s/ *$//'; done |
    sed 's/^  \* \[ /\n  [ /'
  printf '\n -- %s  %s\n' "$5" "$(date -u -d "$4 12:00" '+%a, %d %b %Y %H:%M:%S +0000')"
} | cat -s | gzip -9n >"$2"
