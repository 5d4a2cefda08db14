#!/bin/sh
# SPDX-License-Identifier: MIT
# Scale-free sources: no power with a fractional exponent, no library cube root, no comparison with a literal length or a
# machine epsilon. Each of them breaks the bits of a scaled run, or decides about grains by their size in metres.
# dem_min/timestep.cpp is left out: it proposes a step to a user once; a scaled run takes the reference's, rescaled.
# Usage: lint.sh FOLDER...   Prints the offending lines; exit 1 if there are any, 2 if there was nothing to read.
set -eu
files=$(find "$@" \( -name '*.hpp' -o -name '*.cpp' \) ! -path '*dem_min/timestep.cpp' | sort)
[ -n "$files" ] || { echo "lint: no sources in $*" >&2; exit 2; }
found=0
refuse() {  # reason, extended regular expression
    # Comments may speak of what the code must not do.
    hits=$(for f in $files; do sed 's|//.*||' "$f" | grep -nE "$2" | sed "s|^|$f:|"; done || true)
    [ -z "$hits" ] && return
    found=1
    printf '%s\n%s\n' "$1:" "$hits" >&2
}
refuse 'power with a fractional exponent' '\bpow *\(.*(\.[0-9]*[1-9]|/)'
refuse 'library cube root (contact/scale_free.hpp has one that keeps bits)' '\bcbrt[fl]? *\('
refuse 'comparison with a literal tolerance' '[<>]=? *[0-9.]+e-[0-9]+|[0-9.]e-[0-9]+ *[<>]'
refuse 'machine epsilon' '\b(DBL|FLT)_EPSILON\b|epsilon *\( *\)'
exit $found
