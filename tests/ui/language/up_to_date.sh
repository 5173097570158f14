#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# up_to_date.sh LUPDATE DECLARED_TEXTS, from the folder of the source: whether resources/languages has every text of the
# source and no other.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp resources/languages/*.ts "$folder"
"$(dirname "$0")/update.sh" "$1" "$2" "$folder"
diff -r -u resources/languages "$folder" || {
  echo "resources/languages is behind the source: ninja -C build/release languages" >&2
  exit 1
}
