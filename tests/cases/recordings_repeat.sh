#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The cases of data/recordings are what their convert.py makes of the originals, byte for byte.
set -eu
root=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -r "$root/data/recordings/." "$work"
for script in "$work"/*/convert.py; do
    folder=$(dirname "$script")
    find "$folder" -name case.json -delete
    find "$folder" -name '*.csv' -not -path '*/original/*' -delete
    (cd "$folder" && python3 convert.py)
done
diff -r "$root/data/recordings" "$work"
