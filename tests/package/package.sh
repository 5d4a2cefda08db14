#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs the build into an empty place and builds a consumer there with find_package and with pkg-config; makes the Debian
# packages, unpacks them and runs the program from them.
set -euo pipefail
source=$1 build=$2
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
cmake --install "$build" --prefix "$place/usr" >/dev/null
"$place/usr/bin/similitude" --version
[ -z "$(find "$place/usr/include" -name '*.hpp' -exec grep -l '#include "tests/' {} +)" ]

cmake -S "$source/tests/package/consumer" -B "$place/consumer" -DCMAKE_PREFIX_PATH="$place/usr" >/dev/null
cmake --build "$place/consumer" >/dev/null
case=$source/tests/diagnose/data/pull-off-adhesion
"$place/consumer/consumer" "$case" | tee "$place/out"
grep -qx '0.000107442 N' "$place/out" # 3/2 pi w R* by hand: 1.5 * 3.14159265 * 0.38 * 60e-6

export PKG_CONFIG_PATH=$(dirname "$(find "$place/usr" -name similitude.pc)")
g++ $(pkg-config --cflags similitude) "$source/tests/package/consumer/main.cpp" \
    $(pkg-config --libs similitude) -o "$place/by-pkg-config"
"$place/by-pkg-config" "$case" | cmp - "$place/out"

mandoc=$(command -v man || true)
[ -z "$mandoc" ] || ! man --warnings -l "$place/usr/share/man/man1/similitude.1" 2>&1 >/dev/null | grep .
# Completion, as a shell asks for it.
complete_words() {
    PATH=$place/usr/bin:$PATH bash -c '. "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _similitude; echo "${COMPREPLY[@]}"' \
        complete "$place/usr/share/bash-completion/completions/similitude" "$@"
}
[ "$(complete_words similitude di)" = diagnose ]
[ "$(complete_words similitude convert ro)" = rolling ]
complete_words similitude diagnose x --pre | grep -qx -- --predict

if command -v dpkg-shlibdeps >/dev/null; then
    (cd "$place" && cpack --config "$build/CPackConfig.cmake" -B "$place/packages" >/dev/null)
    for deb in "$place"/packages/*.deb; do dpkg-deb -x "$deb" "$place/root"; done
    "$place/root/usr/bin/similitude" scale "$place/root/usr/share/similitude/examples/zirconia" --quiet
    dpkg-deb -f "$place"/packages/similitude_*.deb Depends | grep -q libudunits2
else
    echo "dpkg-dev is not installed: no Debian packages were made"
fi
