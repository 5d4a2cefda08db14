#!/bin/bash
# SPDX-License-Identifier: MIT
# Does a test fail if 4/3 becomes 3/4? Every decimal constant and every binary + and - of the laws is changed, one at a time
# (a / b -> b / a, 1.0 -> 2.0, any other x -> 1.5 x, + <-> -), and the tests of that law must fail.
# Zeros stay (they are the empty side of a select), and the lines named below, with the reason.
# Usage: tests/contact/mutants.sh [FILE...]   Prints law, mutation and the test that killed it; exit 1 if one survives.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export root work

declare -A tests_of=(
    [hertz.hpp]=hertz [jkr.hpp]=jkr [friction_cap.hpp]=friction_cap [damping_tsuji1992.hpp]=damping_tsuji1992
    [damping.hpp]=damping_viscoelastic [capillary_bridge.hpp]=capillary_bridge [ageing.hpp]=ageing
    [mindlin.hpp]="mindlin damping_viscoelastic" [yield.hpp]=mindlin [vec3.hpp]=vec3 [coulomb.hpp]=coulomb [rolling_epsd.hpp]=rolling_epsd
    [rolling_sds.hpp]=rolling_sds [rolling_edem_standard.hpp]=rolling_constant_torque
    [twisting_marshall2009.hpp]="twisting_marshall2009 damping_viscoelastic"
    [rolling_rvd.hpp]=rolling_constant_torque [effective.hpp]=effective [scale_free.hpp]=scale_free
    [drag_schiller1935.hpp]=drag [parameters.cpp]="effective damping_tsuji1992")
# The start of an iteration that converges from anywhere near.
harmless='double y = 0\.74'

# line, column, length and replacement of each mutation of a file, tab-separated
mutations() {
    awk -v harmless="$harmless" '
        function number(t) { return t == "1.0" ? "2.0" : sprintf("%#.17g", 1.5 * t) }
        { code = $0; sub(/\/\/.*/, "", code); if (code ~ harmless || code ~ /^#/) next
          gsub(/"[^"]*"/, "\"\"", code); if (index(code, "\"")) next
          at = 0; rest = code
          while (match(rest, /[0-9]+\.[0-9]+( \/ [0-9]+\.[0-9]+)?| [-+] /)) {
              token = substr(rest, RSTART, RLENGTH)
              if (token == " - ") new = " + "
              else if (token == " + ") new = " - "
              else if (split(token, part, " / ") == 2) new = part[2] " / " part[1]
              else new = number(token)
              if (token + 0 != 0 || token ~ /[-+]/)
                  printf "%d\t%d\t%d\t%s\n", NR, at + RSTART, RLENGTH, new
              at += RSTART + RLENGTH - 1; rest = substr(rest, RSTART + RLENGTH)
          } }' "$root/contact/$1"
}

compile() {  # object, source, include folders
    local object=$1 source=$2
    shift 2
    g++ -std=c++20 -O0 -w -fno-math-errno "$@" -I"$root" -c "$source" -o "$object"
}

# One mutation: its folder holds contact/FILE and nothing else, and comes first on the include path.
kill_one() {
    local file=$1 tests=$2 line=$3 column=$4 length=$5 new=$6
    local id="$file.$line.$column" old law=$work/parameters.o objects="" killer
    mkdir -p "$work/$id/contact"
    awk -v n="$line" -v c="$column" -v l="$length" -v r="$new" \
        'NR == n { $0 = substr($0, 1, c - 1) r substr($0, c + l) } { print }' "$root/contact/$file" > "$work/$id/contact/$file"
    old=$(awk -v n="$line" 'NR == n { sub(/^ +/, ""); print substr($0, 1, 70) }' "$work/$id/contact/$file")
    if [[ $file == *.cpp ]]; then
        law=$work/$id/law.o
        compile "$law" "$work/$id/contact/$file"
        for t in $tests; do objects+=" $work/$t.o"; done
    else
        for t in $tests; do
            compile "$work/$id/$t.o" "$root/tests/contact/${t}_test.cpp" -include "$work/catch.hpp" -I"$work/$id" ||
                { printf '%s\t%s\t%s\n' "$file:$line" "$old" "the compiler"; return; }
            objects+=" $work/$id/$t.o"
        done
    fi
    # shellcheck disable=SC2086
    g++ $objects "$law" "$work/errors.o" -lCatch2WithMain -lfmt -o "$work/$id/test"
    if killer=$(timeout 60 "$work/$id/test" --abort --reporter compact 2>&1); then
        killer=SURVIVED
    else
        killer=$(timeout 60 "$work/$id/test" --abort --reporter console 2>&1 | awk '/^-+$/ { getline; print; exit }')
    fi
    printf '%s\t%s\t%s\n' "$file:$line" "$old" "$killer"
    rm -rf "${work:?}/$id"
}
export -f compile kill_one

echo '#include <catch2/catch.hpp>' > "$work/catch.hpp"
g++ -std=c++20 -O0 -w -fno-math-errno -x c++-header "$work/catch.hpp" -o "$work/catch.hpp.gch"
compile "$work/parameters.o" "$root/contact/parameters.cpp"
compile "$work/errors.o" "$root/scaling/errors.cpp"
for t in effective damping_tsuji1992; do
    compile "$work/$t.o" "$root/tests/contact/${t}_test.cpp" -include "$work/catch.hpp"
done

[[ $# -gt 0 ]] || set -- $(printf '%s\n' "${!tests_of[@]}" | sort)
for file in "$@"; do
    while IFS=$'\t' read -r line column length new; do
        printf '%s\0%s\0%s\0%s\0%s\0%s\0' "$file" "${tests_of[$file]}" "$line" "$column" "$length" "$new"
    done < <(mutations "$file")
done | xargs -0 -n 6 -P "$(nproc)" bash -c 'kill_one "$@"' _ | tee "$work/table" | column -t -s $'\t'
survivors=$(grep -c SURVIVED "$work/table" || true)
echo "$(wc -l < "$work/table") mutants, $survivors survived"
[[ $survivors -eq 0 ]]
