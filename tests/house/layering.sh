#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Who may include whom: a room sees those to its left, never its right, and rooms in one place never each other.
# Also: JSON is seen by cases, reports, app and python alone; contact and dem_min see neither JSON nor GSL nor Eigen; python sees of
# app what neither prints nor exits.
set -eu
root=${1:-.}
places="scaling contact,cases dem_min rigs engines,statistics calibrate,diagnose,prove,verify,bench,photo reports app python"
faults=0
fault() { echo "$1"; faults=1; }
allowed=""
for place in $places; do
    for room in ${place//,/ }; do
        [ -d "$root/$room" ] || continue
        for include in $(grep -rhoE '^#include "[a-z_]+/' "$root/$room" | cut -d'"' -f2 | tr -d / | sort -u); do
            # The blind proof must not know what it tests.
            case "$room:$include" in
                prove:prove | prove:scaling | prove:cases | prove:statistics) ;;
                prove:*) fault "prove includes $include: it shares no code with forward models and judge" ;;
            esac
            case " $allowed $room " in
                *" $include "*) ;;
                *) fault "$room includes $include, which is not to its left: $(grep -rlE "^#include \"$include/" "$root/$room" | tr '\n' ' ')" ;;
            esac
        done
        case $room in
            cases | reports | app | python) ;;
            *) ! grep -rnE '^#include <nlohmann' "$root/$room" || fault "$room includes JSON" ;;
        esac
        case $room in
            contact | dem_min) ! grep -rnE '^#include <(gsl|Eigen)' "$root/$room" || fault "$room includes GSL or Eigen" ;;
        esac
    done
    allowed="$allowed ${place//,/ }"
done
[ ! -d "$root/python" ] || for include in $(grep -rhoE '^#include "app/[a-z_]+' "$root/python" | cut -d/ -f2 | sort -u); do
    case $include in
        calibration_runs | forward_curves | machine_speed | pile_cost | scale_input | version) ;;
        *) fault "python includes app/$include: only the command line prints or exits" ;;
    esac
done
exit $faults
