#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The layering test itself must be able to fail: a small tree with one fault of each kind.
set -u
here=$(cd "$(dirname "$0")" && pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
mkdir "$tree/scaling" "$tree/contact" "$tree/cases"
echo '#include "scaling/errors.hpp"' > "$tree/contact/a.hpp"
bash "$here/layering.sh" "$tree" || { echo "a tree without fault was refused"; exit 1; }
for line in '#include "dem_min/step.hpp"' '#include "cases/case.hpp"' '#include <nlohmann/json.hpp>' '#include <gsl/gsl_math.h>'; do
    echo "$line" > "$tree/contact/b.hpp"
    bash "$here/layering.sh" "$tree" >/dev/null && { echo "not seen: contact with $line"; exit 1; }
done
mkdir "$tree/prove"
rm "$tree/contact/b.hpp"
echo '#include "contact/a.hpp"' > "$tree/prove/a.hpp"
bash "$here/layering.sh" "$tree" >/dev/null && { echo "not seen: prove that includes contact"; exit 1; }
rm "$tree/prove/a.hpp"
mkdir "$tree/app" "$tree/python"
echo '#include "app/version.hpp"' > "$tree/python/a.cpp"
bash "$here/layering.sh" "$tree" || { echo "python with app/version.hpp was refused"; exit 1; }
echo '#include "app/common.hpp"' > "$tree/python/a.cpp"
bash "$here/layering.sh" "$tree" >/dev/null && { echo "not seen: python with the part of app that prints"; exit 1; }
exit 0
