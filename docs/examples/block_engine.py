#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""An engine for handhold: a body that translates on one plane, moving or not, with Coulomb friction. Plays with

    handhold suite --level L1 --engine "mine=python3 docs/examples/block_engine.py {problem} {out}"
"""
import json, math, os, sys

problem, out = json.load(open(sys.argv[1])), sys.argv[2]
h, steps, (body,), supports = problem["step"], problem["steps"], problem["bodies"], problem["supports"]

def not_asked(why):
    print(json.dumps({"not_asked": why}))
    sys.exit(4)

if len(supports) != 1 or problem["springs"] or body["mobility"] != "translation":
    not_asked("it knows one block on one support, without springs")
support = supports[0]
if support["surface"]["type"] != "plane" or "normal_force" in support:
    not_asked("it knows planes that do not press")
if support["mu_static"] != support["mu_dynamic"]:
    not_asked("it has one coefficient of friction")
n, mu, zeros = support["surface"]["normal"], support["mu_dynamic"], [[0, 0, 0]] * (steps + 1)
plane, force = support.get("motion", {}).get("v", zeros), body.get("force", zeros)
p, v, rows = body["p"], body["v"], []
for k in range(steps + 1):
    if k % problem["frame_every"] == 0:
        rows.append([k * h, *p, *body["q"], *v, 0, 0, 0])
    if k == steps:
        break
    u = [v[i] + h * (problem["gravity"][i] + force[k][i] / body["mass"]) - plane[k + 1][i] for i in range(3)]
    away = sum(u[i] * n[i] for i in range(3))  # speed against the plane, along its normal; it pushes if that is < 0
    slide = [u[i] - away * n[i] for i in range(3)]
    keep = max(0, 1 - mu * max(0, -away) / (math.hypot(*slide) or 1))
    v = [plane[k + 1][i] + max(0, away) * n[i] + keep * slide[i] for i in range(3)]
    p = [p[i] + h * v[i] for i in range(3)]
with open(os.path.join(out, "frames.csv"), "w") as file:
    names = "t_s x_m y_m z_m qw qx qy qz vx_m_per_s vy_m_per_s vz_m_per_s wx_rad_per_s wy_rad_per_s wz_rad_per_s"
    print(f"# engine: block\n# scene: {problem['name']}\n# body: {body['name']}\n{names.replace(' ', ',')}", file=file)
    print("\n".join(",".join(map(repr, row)) for row in rows), file=file)
