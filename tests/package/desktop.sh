#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What desktops read is valid.   desktop.sh RESOURCES METAINFO
set -euo pipefail
for tool in desktop-file-validate appstreamcli; do
  command -v $tool >/dev/null || { echo "skipped: $tool is missing"; exit 77; }
done
said=$(desktop-file-validate "$1/desktop/surefoot.desktop" 2>&1) || true
[ -z "$said" ] || { echo "$said"; exit 1; }
appstreamcli validate --pedantic --no-net "$2"
for kind in $(sed -n 's/^MimeType=//p' "$1/desktop/surefoot.desktop" | tr ';' ' '); do
  grep -q "type=\"$kind\"" "$1/desktop/surefoot-mime.xml" || { echo "$kind is not described"; exit 1; }
  grep -q "<mediatype>$kind<" "$2" || { echo "$kind is not in the metainfo"; exit 1; }
done
