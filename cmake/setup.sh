# SPDX-License-Identifier: MIT
# Sourced by ./check. Installs the Debian packages that are missing, and nothing else.

build_packages="g++ cmake ninja-build pkg-config libboost-dev libeigen3-dev libgsl-dev libfmt-dev libcli11-dev
    nlohmann-json3-dev libudunits2-dev libcsv-dev librandom123-dev libkainjow-mustache-dev libstb-dev libxlsxwriter-dev"
python_packages="python3-dev pybind11-dev python3-numpy python3-pandas python3-matplotlib"
test_packages="catch2 python3-vtk9 python3-pandas python3-openpyxl libreoffice-calc-nogui lammps dpkg-dev"

missing_packages() {
    for package in "$@"; do
        dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null | grep -q '^installed$' || printf '%s ' "$package"
    done
}

install_missing() {
    if ! command -v dpkg-query >/dev/null; then
        echo "This is not a Debian system. Needed, by Debian's names:" $* >&2
        return 0
    fi
    missing=$(missing_packages "$@")
    [ -n "$missing" ] || return 0
    as_root=""
    if [ "$(id -u)" != 0 ]; then
        if ! command -v sudo >/dev/null; then
            printf 'These packages are missing and only root can install them:\n    apt-get install %s\n' "$missing" >&2
            exit 1
        fi
        as_root=sudo
    fi
    echo "Installing: $missing" >&2
    $as_root apt-get update -q >/dev/null
    DEBIAN_FRONTEND=noninteractive $as_root apt-get install -y -q --no-install-recommends $missing >/dev/null
}
