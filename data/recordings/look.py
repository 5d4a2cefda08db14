#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints the figures of docs/recordings.md from the originals, by closed forms and least squares alone.
python3 data/recordings/look.py [balls | kharaz | afm]"""
import cmath
import csv
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
G, AIR, OUNCE, FRAME = 9.79, 1.2, 28.349523125e-3, 1.0 / 15.0
BALLS = {"Whiffle Ball 1": (1.0, 0.228, 0), "Tennis Ball": (2.0, 0.2075, 1), "Golf Ball": (1.62, 0.138, 1),
         "Blue Basketball": (18.0, 0.75, 1), "Bowling Ball": (208.0, 0.685, 1)}  # oz, m round, buoyant or not


def rms(x):
    return math.sqrt(sum(v * v for v in x) / len(x))


def lag1(x):
    return sum(a * b for a, b in zip(x, x[1:])) / sum(v * v for v in x)


def white_part(x):
    """Noise by third differences: blind to any smooth motion. Standard deviation, lag-1 (white: -0.75)."""
    d = [x[i + 3] - 3 * x[i + 2] + 3 * x[i + 1] - x[i] for i in range(len(x) - 3)]
    return rms(d) / math.sqrt(20.0), lag1(d)


def solve(a, b):
    n = len(b)
    m = [row[:] + [y] for row, y in zip(a, b)]
    for i in range(n):
        p = max(range(i, n), key=lambda r: abs(m[r][i]))
        m[i], m[p] = m[p], m[i]
        for r in range(n):
            if r != i:
                f = m[r][i] / m[i][i]
                m[r] = [x - f * y for x, y in zip(m[r], m[i])]
    return [m[i][n] / m[i][i] for i in range(n)]


def fitted(residual, start, free):
    """Levenberg-Marquardt. Parameters, standard error of the last free one (white noise), residuals."""
    p, damping = list(start), 1e-3
    r = residual(p)
    for _ in range(300):
        slopes = []
        for i in free:
            q = p[:]
            q[i] += 1e-6
            slopes.append([(y - x) / 1e-6 for x, y in zip(r, residual(q))])
        normal = [[sum(x * y for x, y in zip(a, b)) for b in slopes] for a in slopes]
        damped = [[v * (1 + damping * (i == j)) for j, v in enumerate(row)] for i, row in enumerate(normal)]
        step = solve(damped, [-sum(x * y for x, y in zip(a, r)) for a in slopes])
        q = p[:]
        for i, s in zip(free, step):
            q[i] += s
        tried = residual(q)
        gain = rms(r) - rms(tried)
        if gain > 0:
            p, r, damping = q, tried, max(damping / 5, 1e-12)
            if gain < 1e-12:
                break
        elif damping > 1e8:
            break
        else:
            damping *= 5
    unit = [0.0] * (len(free) - 1) + [1.0]
    return p, math.sqrt(solve(normal, unit)[-1] * sum(v * v for v in r) / (len(r) - len(free))), r


def fall(ball, t, height, release, cd, scale):
    ounces, girth, buoyant = BALLS[ball]
    mass, radius = ounces * OUNCE, girth / 2 / math.pi
    g = G * (1 - buoyant * AIR * 4 / 3 * math.pi * radius**3 / mass)
    k = 0.5 * AIR * cd * math.pi * radius**2 / mass
    t = max(0.0, t - release)
    if abs(k) < 1e-9:
        return height - scale * 0.5 * g * t * t
    if k > 0:
        return height - scale * math.log(math.cosh(math.sqrt(g * k) * t)) / k
    return height - scale * math.log(math.cos(math.sqrt(-g * k) * t)) / k


def drops():
    read = {}
    with open(HERE + "/falling_balls/original/ball_drops.csv", newline="") as file:
        for row in csv.DictReader(file):
            read.setdefault((row["ball"], int(row["drop"])), []).append((float(row["t_s"]), float(row["height_m"])))
    return read


def fit_ball(ball, rows, free, cd=0.0):
    def residual(p):
        return [z - fall(ball, t, *p) for t, z in rows]
    return fitted(residual, [rows[0][1], 0.05, cd, 1.0], free)


def pixel(z):
    """The step between 25.5 and 32.5 mm that all heights are multiples of, one apart from the other: coherence (1: exactly), step in m."""
    steps = [0.0255 + 4e-6 * i for i in range(1750)]
    return max((abs(sum(cmath.exp(2j * math.pi * (h - z[0]) / q) for h in z)) / len(z), q) for q in steps)


def pieces(z):
    """Runs of at least 8 rows on one pixel grid: first row, last row, step in m."""
    found, i = [], 0
    while i < len(z) - 7:
        coherence, q = pixel(z[i:i + 8])
        if coherence < 0.995:
            i += 1
            continue
        end = i + 8
        while end < len(z):
            coherence, step = pixel(z[i:end + 1])
            if coherence < 0.99:
                break
            q, end = step, end + 1
        found.append((i, end - 1, q))
        i = end
    return found


def predicted(ball, rows, cd):
    return [z - fall(ball, t, rows[0][1], FRAME, cd, 1.0) for t, z in rows]


def balls():
    read = drops()
    print("drop: pieces on one pixel grid: from, to (s), pixel (mm); from, to (m)")
    for (ball, n), rows in read.items():
        runs = [f"{rows[a][0]:.2f} {rows[b][0]:.2f} {q * 1e3:.2f} {rows[a][1]:.1f} {rows[b][1]:.1f}"
                for a, b, q in pieces([h for _, h in rows])]
        steps = [f"{b[0] - a[0]:.3f} at {b[0]:.2f}" for a, b in zip(rows, rows[1:]) if abs(b[0] - a[0] - FRAME) > 0.005]
        print(f"{ball} {n}: {'; '.join(runs)}" + (f"; odd time step: {', '.join(steps)}" if steps else ""))
    print("drop: noise of first and last 15 rows (m); with drag Cd, release (s), rms (m), lag-1; rms without;\n"
          "      with a scale in place of drag: it, its rms, release; with both: Cd, scale, release, rms")
    for (ball, n), rows in read.items():
        z = [h for _, h in rows]
        base = fit_ball(ball, rows, [0, 1])
        drag = fit_ball(ball, rows, [0, 1, 2], 0.3)
        scale = fit_ball(ball, rows, [0, 1, 3])
        both = fit_ball(ball, rows, [0, 1, 2, 3], 0.3)
        print(f"{ball} {n}: {white_part(z[:15])[0]:.3f} {white_part(z[-15:])[0]:.3f}; {drag[0][2]:.3f} +- {drag[1]:.3f}, {drag[0][1]:.3f}, "
              f"{rms(drag[2]):.3f}, {lag1(drag[2]):.2f}; {rms(base[2]):.3f}; {scale[0][3]:.3f} {rms(scale[2]):.3f} {scale[0][1]:.2f}; "
              f"{both[0][2]:.2f} {both[0][3]:.2f} {both[0][1]:.2f} {rms(both[2]):.3f}")
    print("rows above 34.4 m alone, with drag: Cd, rms (m), lag-1")
    for (ball, n), rows in read.items():
        drag = fit_ball(ball, [row for row in rows if row[1] > 34.4], [0, 1, 2], 0.3)
        print(f"{ball} {n}: {drag[0][2]:.2f} +- {drag[1]:.2f}, {rms(drag[2]):.3f}, {lag1(drag[2]):.2f}")
    print("drop 2 foretold from drop 1, nothing refitted: rms without and with drag (m), ratio")
    for ball in BALLS:
        cd = fit_ball(ball, read[(ball, 1)], [0, 1, 2], 0.3)[0][2]
        without, with_drag = (rms(predicted(ball, read[(ball, 2)], c)) for c in (0.0, cd))
        print(f"{ball}: {without:.2f} {with_drag:.2f} {without / with_drag:.1f}")
    print("one Cd for several drops; rms of the others without and with it (m), ratio")
    light = ("Whiffle Ball 1", "Tennis Ball")
    groups = {"light": ([(b, 1) for b in light], [(b, 2) for b in light])}
    for out in BALLS:
        groups["all but " + out] = ([k for k in read if k[0] != out], [k for k in read if k[0] == out])
    for name, (used, kept) in groups.items():
        def misfit(cd):
            return sum(v * v for k in used for v in fit_ball_fixed(k[0], read[k], cd))
        cd = min((0.01 * i for i in range(81)), key=misfit)
        without, with_drag = (rms([v for k in kept for v in predicted(k[0], read[k], c)]) for c in (0.0, cd))
        print(f"{name}: Cd {cd:.2f}; {without:.2f} {with_drag:.2f} {without / with_drag:.1f}")


def fit_ball_fixed(ball, rows, cd):
    return fit_ball(ball, rows, [0, 1], cd)[2]


def kharaz():
    read = {}
    with open(HERE + "/oblique_impact_kharaz2001/original/oblique_impact.csv", newline="") as file:
        for row in csv.DictReader(file):
            read.setdefault(row["quantity"], []).append((math.radians(float(row["impact_angle_deg"])), float(row["value"])))
    radius, speed, mu, e = 2.5e-3, 3.9, 0.092, 0.98

    def coulomb(angle):  # rigid: rolls after 5/7, or slides all through
        return max(5.0 / 7.0, 1.0 - mu * (1 + e) / math.tan(angle))

    def spin(angle, e_t):  # conservation of angular momentum about the contact point
        return 2.5 * speed * math.sin(angle) * (1 - e_t) / radius

    print(f"rigid Coulomb, mu {mu}, e {e}: slides all through above {math.degrees(math.atan(3.5 * mu * (1 + e))):.1f} deg")
    e_t = read["tangential_restitution"]

    def between(angle):
        for (a, x), (b, y) in zip(e_t, e_t[1:]):
            if a <= angle <= b:
                return x + (y - x) * (angle - a) / (b - a)
        return None

    print("angle (deg): recorded tangential restitution less rigid Coulomb's")
    print("  " + ", ".join(f"{math.degrees(a):.1f}: {x - coulomb(a):+.3f}" for a, x in e_t))
    print("the same for the spin (rad/s); and less what the recorded restitution says, by angular momentum")
    for a, w in read["rebound_spin_rad_s"]:
        other = f"{w - spin(a, between(a)):+.0f}" if between(a) else "-"
        print(f"  {math.degrees(a):.1f}: {w - spin(a, coulomb(a)):+.0f}; {other}")
    print("the same for the rebound angle (deg); and the normal restitution that both together ask for")
    for a, b in read["rebound_angle_deg"]:
        simulated = math.degrees(math.atan(coulomb(a) * math.tan(a) / e))
        other = f"{between(a) * math.tan(a) / math.tan(math.radians(b)):.3f}" if between(a) else "-"
        print(f"  {math.degrees(a):.1f}: {b - simulated:+.2f}; {other}")


def afm():
    with open(HERE + "/afm_force_curves/original/fmt-afm-workshop-fd_single_2020-02-14_13.41.25.csv", newline="") as file:
        rows = list(csv.reader(file))
    first = next(i for i, row in enumerate(rows) if row and row[0].startswith("Extend")) + 1
    table = [[float(x) for x in row] for row in rows[first:] if row]
    z, there, z_back, back = (list(column) for column in zip(*table))
    top, far = max(z), there[:400]
    base = sum(far) / len(far)
    print(f"rows {len(z)} each way, drive {z[0]:.1f} to {top:.1f} nm in steps of {z[1] - z[0]:.2f} nm")
    print(f"base line {base:.1f} nN, ripple {min(far) - base:+.1f} to {max(far) - base:+.1f} nN; way back ends {back[-1] - there[0]:+.1f} nN off")
    print("white part (nN): base line %.2f, in contact %.2f" % (white_part(far)[0], white_part(there[700:])[0]))
    touch = max(i for i, f in enumerate(there) if f <= max(far))
    print(f"approach leaves the ripple at displacement {top - z[touch]:.0f} nm; largest force {max(there) - base:.0f} nN over the base line")
    print(f"largest fall of force over 3 rows on approach {min(b - a for a, b in zip(there, there[3:])):.1f} nN: no jump into contact")
    print(f"the way back begins {there[-1] - back[0]:.0f} nN lower at the same z; slope of its first 10, 30 rows "
          + ", ".join(f"{(back[0] - back[n]) / (z_back[0] - z_back[n]):.1f} nN/nm" for n in (10, 30)))
    low = back.index(min(back))
    cross = next(i for i, f in enumerate(back) if f < base)
    home = next(i for i in range(low, len(back)) if back[i] > base - 20.0)
    print(f"crosses the base line at {top - z_back[cross]:.0f} nm, lowest {min(back) - base:.0f} nN at {top - z_back[low]:.0f} nm, "
          f"home (20 nN) at {top - z_back[home]:.0f} nm; largest rise over 3 rows there "
          f"{max(b - a for a, b in zip(back[low:], back[low + 3:])):.0f} nN: no snap off")
    lost = sum(a - b for a, b in zip(there, reversed(back))) * (z[1] - z[0]) * 1e-18
    print(f"work lost in the loop {lost * 1e12:.2f} pJ; put in above the base line "
          f"{sum(max(0.0, f - base) for f in there) * (z[1] - z[0]) * 1e-6:.2f} pJ")


for name in sys.argv[1:] or ["balls", "kharaz", "afm"]:
    {"balls": balls, "kharaz": kharaz, "afm": afm}[name]()
