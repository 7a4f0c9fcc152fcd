"""Files that are wrong: each is refused with the right line and field, none with a traceback."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import linkwork as lw
import pytest
from linkwork.cli import run

#: A good model; each case below changes one line of it.
YAML = """\
linkwork: 1
name: good
gravity: [0, 0, -9.81]
simulation: {t_end: 0.1, step: 1e-3}
functions:
  drive: {harmonic: {amplitude: 0.1, frequency: 3, offset: 1}}
bodies:
  - name: crank
    mass: 1.0
    inertia: [0.01, 0.02, 0.02]
    position: [0.5, 0, 0]
    orientation: [1, 0, 0, 0]
    velocity: [0, 0, 0]
  - name: rod
    mass: 2.0
    inertia: [[0.02, 0, 0], [0, 0.3, 0], [0, 0, 0.3]]
    position: [2, 0, 0]
joints:
  - kind: revolute
    name: pin
    a: ground
    b: crank
    at: [0, 0, 0]
    axis: [0, 1, 0]
  - kind: distance
    name: link
    a: crank
    b: rod
    at: [[1, 0, 0], [2, 0, 0]]
    length: drive
  - kind: spherical
    name: ball
    a: ground
    b: rod
    attachment: {origin: [[3, 0, 0], [1, 0, 0]], frame: [E, E]}
forces:
  - kind: spring_damper
    name: spring
    a: ground
    b: rod
    at: [[3, 0, 1], [3, 0, 0]]
    stiffness: 100
  - kind: applied
    name: push
    body: rod
    force: [1, drive, 0]
""".replace("E,", "[[1, 0, 0], [0, 1, 0], [0, 0, 1]],").replace("E]", "[[1, 0, 0], [0, 1, 0], [0, 0, 1]]]")

#: Lines of it that are changed often.
DRIVE = "  drive: {harmonic: {amplitude: 0.1, frequency: 3, offset: 1}}"
PUSH = "    force: [1, drive, 0]"
ATTACHMENT = next(line for line in YAML.splitlines() if line.startswith("    attachment"))

#: (line to be changed, what is there then, line of the fault, its field, words of the message)
Case = tuple[str, str, int | None, str, str]

CASES: list[Case] = [
    # --- formulas of t ---
    ("    length: drive", "    length: {expression: 'sqrt(t'}", 30, "joints[1].length", "is not a formula"),
    ("    length: drive", "    length: {expression: import t}", 30, "joints[1].length", "is not a formula"),
    ("    length: drive", "    length: {expression: 2 + tea}", 30, "joints[1].length", "unknown name 'tea'"),
    ("    length: drive", "    length: {expression: 1 / t}", 30, "joints[1].length", "at t = 0: nan"),
    ("    length: drive", "    length: {expression: 3}", 30, "joints[1].length.expression", "is not text"),
    ("    length: drive", "    length: 2 + t", 30, "joints[1].length", 'written {expression: "2 + t"}'),
    # --- couplers, curves and drives ---
    *(
        ("    length: drive", f"    length: drive\n  - {{kind: {what}}}", 31, f"joints[2]{field}", words)
        for what, field, words in (
            ("drive, joint: pin", "", "give one of position, velocity, acceleration"),
            ("drive, joint: pin, position: 1, velocity: 2", "", "give one of position"),
            ("drive, joint: pin, speed: 1", ".speed", "is not known here"),
            ("drive, joint: pin, position: t", ".position", "neither a number nor in functions"),
            ("drive, joint: pin, position: {expression: t +}", ".position", "is not a formula"),
            ("drive, joint: pin, velocity: {expression: t}", "", "integral is not known"),
            ("drive, joint: pin, position: 1, coordinate: displacement", "", "it has angle"),
            ("drive, joint: pon, position: 1", ".joint", "no joint named 'pon' before"),
            ("drive, joint: link, position: 1", "", "distance 'link'"),
            ("drive, a: crank, joint: pin, position: 1", ".a", "is not known here"),
            ("coupler, coordinates: [{joint: p, factor: 1}]", ".coordinates[0].joint", "no joint named 'p'"),
            ("coupler, coordinates: [{joint: ball, factor: 1}]", ".coordinates[0].joint", "'ball' before"),
            ("coupler, coordinates: [{joint: pin, factor: 0}]", ".coordinates[0].factor", "not be zero"),
            ("coupler, coordinates: [{joint: pin, factor: x}]", ".coordinates[0].factor", "'x' is not a"),
            ("coupler, coordinates: [{joint: pin}]", ".coordinates[0].factor", "is missing"),
            ("coupler, coordinates: [pin]", ".coordinates[0]", "'pin' is not a mapping"),
            ("coupler, coordinates: []", ".coordinates", "has 0 entries"),
            ("coupler, a: crank", ".a", "is not known here"),
            ("coupler, coordinates: [], attachment: 1", ".attachment", "is not known here"),
            ("point_on_curve, a: crank, b: rod, at: [0, 0, 0], points: [[0, 0, 0]]", ".points", "has 1 ent"),
            ("point_on_curve, a: crank, b: rod, at: [0, 0, 0], points: line", ".points", "is not a list"),
            ("point_on_curve, a: crank, b: c, at: [0, 0, 0], points: [[0, 0, 0], [1, 0, 0]]", ".b", "named"),
        )
    ),
    # --- missing ---
    ("linkwork: 1", "", None, "linkwork", "is missing"),
    ("  - name: crank", "  -", None, "bodies[0].name", "is missing"),
    ("    mass: 1.0", "", None, "bodies[0].mass", "is missing"),
    ("    inertia: [0.01, 0.02, 0.02]", "", None, "bodies[0].inertia", "is missing"),
    ("  - kind: revolute", "  - x: 1", 19, "joints[0].kind", "is missing"),
    ("    a: ground", "", None, "joints[0].a", "is missing"),
    ("    b: crank", "", None, "joints[0].b", "is missing"),
    ("    at: [0, 0, 0]", "", None, "joints[0].at", "is missing"),
    ("    axis: [0, 1, 0]", "", None, "joints[0].axis", "is missing"),
    ("    at: [[3, 0, 1], [3, 0, 0]]", "", None, "forces[0].at", "is missing"),
    ("    body: rod", "", None, "forces[1].body", "is missing"),
    # --- too much, misspelled ---
    ("name: good", "nmae: good", 2, "nmae", "the nearest is 'name'"),
    ("gravity: [0, 0, -9.81]", "gravitation: [0, 0, 1]", 3, "gravitation", "the nearest is 'gravity'"),
    ("    mass: 1.0", "    mass: 1.0\n    wieght: 3", 10, "bodies[0].wieght", "is not known here"),
    ("    velocity: [0, 0, 0]", "    velocitty: [0, 0, 0]",
     13, "bodies[0].velocitty", "the nearest is 'velocity'"),
    ("    axis: [0, 1, 0]", "    axis: [0, 1, 0]\n    axes: [0, 1, 0]",
     25, "joints[0].axes", "the nearest is 'axis'"),
    ("    axis: [0, 1, 0]", "    axis: [0, 1, 0]\n    length: 1",
     25, "joints[0].length", "is not known here"),
    ("    stiffness: 100", "    stifness: 100", 42, "forces[0].stifness", "the nearest is 'stiffness'"),
    ("    name: ball", "    name: ball\n    at: [0, 0, 0]", 33, "joints[2].at", "is not known here"),
    ("simulation: {t_end: 0.1, step: 1e-3}", "simulation: {tend: 1}",
     4, "simulation.tend", "the nearest is 't_end'"),
    (DRIVE, "  drive: {harmonic: {amplitude: 1, frequency: 3, phas: 1}}",
     6, "functions.drive.harmonic.phas", "the nearest is 'phase'"),
    # --- kinds ---
    ("  - kind: revolute", "  - kind: revolut", 19, "joints[0].kind", "the nearest is 'revolute'"),
    ("  - kind: revolute", "  - kind: 7", 19, "joints[0].kind", "is no kind of joint"),
    ("  - kind: revolute", "  - kind: [revolute]", 19, "joints[0].kind", "is no kind of joint"),
    ("  - kind: revolute", "  - kind: spring_damper",
     19, "joints[0].kind", "'spring_damper' is no kind of joint"),
    ("  - kind: spring_damper", "  - kind: revolute", 37, "forces[0].kind", "'revolute' is no kind of force"),
    ("  - kind: spherical", "  - kind: sphericle", 31, "joints[2].kind", "the nearest is 'spherical'"),
    (DRIVE, "  drive: {sinus: {amplitude: 0.1}}",
     6, "functions.drive", "is no function of time"),
    (DRIVE, "  drive: sin(t)", 6, "functions.drive", "is no function"),
    (DRIVE, "  drive: {}", 6, "functions.drive", "is no function"),
    # --- wrong type ---
    ("linkwork: 1", "linkwork: one", 1, "linkwork", "is not 1"),
    ("linkwork: 1", "linkwork: 2", 1, "linkwork", "is not 1"),
    ("linkwork: 1", "linkwork: true", 1, "linkwork", "true is not 1"),
    ("linkwork: 1", "linkwork: 1.0", 1, "linkwork", "1.0 is not 1"),
    ("name: good", "name: 7", 2, "name", "7 is not text"),
    ("name: good", "name: [good]", 2, "name", "is not text"),
    ("name: good", "units: mm", 2, "units", "is not 'SI'"),
    ("gravity: [0, 0, -9.81]", "gravity: -9.81", 3, "gravity", "-9.81 is not a list"),
    ("gravity: [0, 0, -9.81]", "gravity: {z: -9.81}", 3, "gravity", "a mapping is not a list"),
    ("gravity: [0, 0, -9.81]", "gravity: [0, 0, down]", 3, "gravity[2]", "'down' is not a number"),
    *(("    mass: 1.0", f"    mass: {tiny}", 9, "bodies[0].mass", f"{tiny} is nearer to zero than any other")
      for tiny in ("1e-400", "+.1E-323", "-2e-324", "0.02e-400")),
    ("gravity: [0, 0, -9.81]", "gravity: [0, 0, 1e-400]", 3, "gravity[2]", "1e-400 is nearer to zero"),
    ("    mass: 1.0", "    mass: heavy", 9, "bodies[0].mass", "'heavy' is not a number"),
    ("    mass: 1.0", '    mass: "1.0"', 9, "bodies[0].mass", "'1.0' is not a number"),
    ("    mass: 1.0", "    mass: true", 9, "bodies[0].mass", "true is not a number"),
    ("    mass: 1.0", "    mass:", 9, "bodies[0].mass", "nothing is not a number"),
    ("    mass: 1.0", "    mass: [1.0]", 9, "bodies[0].mass", "a list is not a number"),
    ("    mass: 1.0", "    mass: 1 kg", 9, "bodies[0].mass", "'1 kg' is not a number"),
    ("    mass: 1.0", "    mass: 1_000", 9, "bodies[0].mass", "'1_000' is not a number"),
    ("    mass: 1.0", "    mass: 1,5", 9, "bodies[0].mass",
     "'1,5' is not a number; decimals follow a point: 1.5"),
    ("    stiffness: 100", "    stiffness: 100,5", 42, "forces[0].stiffness",
     "decimals follow a point: 100.5"),
    ("    stiffness: 100", "    stiffness: {sine: {amplitude: 1.0}}", 42, "forces[0].stiffness",
     "'sine' is no function of time; choose from 'constant', "),
    ("    mass: 1.0", "    mass: 1:30", 9, "bodies[0].mass", "'1:30' is not a number"),
    ("  - name: rod", "  - name: 5", 14, "bodies[1].name", "5 is not text"),
    ("  - name: rod", "  - name: null", 14, "bodies[1].name", "nothing is not text"),
    ("    a: ground", "    a: 0", 21, "joints[0].a", "0 is not text"),
    ("    at: [0, 0, 0]", "    at: origin", 23, "joints[0].at", "'origin' is not a list"),
    ("    axis: [0, 1, 0]", "    axis: y", 24, "joints[0].axis", "'y' is not a list"),
    ("    axis: [0, 1, 0]", "    axis: [0, one, 0]", 24, "joints[0].axis[1]", "'one' is not a number"),
    ("    axis: [0, 1, 0]", "    axis: [0, 1, 0]\n    frames: world",
     25, "joints[0].frames", "is not 'space' or 'body'"),
    ("    stiffness: 100", "    stiffness: [100]", 42, "forces[0].stiffness", "is not a number"),
    ("    stiffness: 100", "    stiffness: true", 42, "forces[0].stiffness", "true is not a number"),
    ("simulation: {t_end: 0.1, step: 1e-3}", "simulation: 3", 4, "simulation", "is not a mapping"),
    ("simulation: {t_end: 0.1, step: 1e-3}", "simulation: {t_end: two}", 4, "simulation.t_end",
     "t_end 'two' s must be a finite number, zero or positive"),
    ("simulation: {t_end: 0.1, step: 1e-3}", "simulation: {t_end: 1, times: [0.1]}", 4, "simulation.times",
     "is an argument of simulate that no file has"),
    ("simulation: {t_end: 0.1, step: 1e-3}", "simulation: {t_end: 1, tines: [0.1]}", 4, "simulation.tines",
     "is no argument of simulate"),
    ("simulation: {t_end: 0.1, step: 1e-3}", "simulation: {t_end: 1, formulation: foo}", 4,
     "simulation.formulation", "formulation 'foo' does not exist"),
    ("simulation: {t_end: 0.1, step: 1e-3}", "simulation: {t_end: [1]}", 4, "simulation.t_end", ""),
    ("functions:", "functions: 3\nfunctionz:", 5, "functions", "is not a mapping"),
    ("bodies:", "bodies: many\nbodiez:", 7, "bodies", "'many' is not a list"),
    ("bodies:", "bodies: {a: 1}\nbodiez:", 7, "bodies", "a mapping is not a list"),
    ("bodies:", "bodies: [rod]\nbodiez:", 7, "bodies[0]", "'rod' is not a mapping"),
    ("joints:", "joints: [pin]\njointz:", 18, "joints[0]", "'pin' is not a mapping"),
    ("    force: [1, drive, 0]", "    force: 5", 46, "forces[1].force", "5 is not a list"),
    # --- lengths ---
    ("gravity: [0, 0, -9.81]", "gravity: [0, -9.81]", 3, "gravity", "has 2 entries, not 3"),
    ("gravity: [0, 0, -9.81]", "gravity: [0, 0, 0, 1]", 3, "gravity", "has 4 entries, not 3"),
    ("gravity: [0, 0, -9.81]", "gravity: []", 3, "gravity", "has 0 entries"),
    ("    orientation: [1, 0, 0, 0]", "    orientation: [1, 0, 0]",
     12, "bodies[0].orientation", "has 3 entries"),
    ("    inertia: [0.01, 0.02, 0.02]", "    inertia: [0.01, 0.02]",
     10, "bodies[0].inertia", "has 2 entries"),
    ("    inertia: [0.01, 0.02, 0.02]", "    inertia: [[1, 0, 0], [0, 1, 0]]",
     10, "bodies[0].inertia", "has 2 entries"),
    ("    inertia: [0.01, 0.02, 0.02]", "    inertia: [[1, 0, 0], [0, 1], [0, 0, 1]]",
     10, "bodies[0].inertia[1]", "has 2 entries"),
    ("    inertia: [0.01, 0.02, 0.02]", "    inertia: [[1, 0, 0], 1, [0, 0, 1]]",
     10, "bodies[0].inertia[1]", "is not a list"),
    ("    at: [[1, 0, 0], [2, 0, 0]]", "    at: [[1, 0, 0]]", 29, "joints[1].at", "has 1 entries"),
    ("    at: [[1, 0, 0], [2, 0, 0]]", "    at: [[1, 0, 0], [2, 0, 0], [3, 0, 0]]",
     29, "joints[1].at", "has 3 entries"),
    ("    force: [1, drive, 0]", "    force: [1, drive]", 46, "forces[1].force", "has 2 entries"),
    ("  - name: rod", "  - name: ''", 14, "bodies[1].name", "'' is not a name"),
    # --- not finite, out of range ---
    ("    mass: 1.0", "    mass: .nan", 9, "bodies[0].mass", "nan is not a finite number"),
    ("    mass: 1.0", "    mass: 1e400", 9, "bodies[0].mass", "inf is not a finite number"),
    ("    mass: 1.0", "    mass: -.inf", 9, "bodies[0].mass", "-inf is not a finite number"),
    ("    mass: 1.0", "    mass: " + "9" * 400, 9, "bodies[0].mass", "is not a"),
    ("    mass: 1.0", "    mass: " + "9" * 5000, 9, "bodies[0].mass", "is not a"),
    ("    mass: 1.0", "    mass: -1", 9, "bodies[0].mass", "-1 is not 0 or more"),
    ("    mass: 1.0", "    mass: -1e-300", 9, "bodies[0].mass", "is not 0 or more"),
    ("gravity: [0, 0, -9.81]", "gravity: [0, 0, .inf]", 3, "gravity[2]", "is not a finite number"),
    ("    position: [0.5, 0, 0]", "    position: [0.5, .NaN, 0]",
     11, "bodies[0].position[1]", "is not a finite number"),
    ("    velocity: [0, 0, 0]", "    velocity: [1e999, 0, 0]",
     13, "bodies[0].velocity[0]", "is not a finite number"),
    ("    stiffness: 100", "    stiffness: .inf", 42, "forces[0].stiffness", "is not a finite number"),
    (DRIVE, "  drive: {harmonic: {amplitude: .nan, frequency: 3}}",
     6, "functions.drive.harmonic.amplitude", "is not a finite number"),
    # --- mechanics ---
    ("    orientation: [1, 0, 0, 0]", "    orientation: [2, 0, 0, 0]",
     12, "bodies[0].orientation", "has norm 2"),
    ("    orientation: [1, 0, 0, 0]", "    orientation: [0, 0, 0, 0]",
     12, "bodies[0].orientation", "has norm 0"),
    ("    inertia: [0.01, 0.02, 0.02]", "    inertia: [0.01, 0.02, 0.2]",
     10, "bodies[0].inertia", "triangle inequality"),
    ("    inertia: [0.01, 0.02, 0.02]", "    inertia: [-0.01, 0.02, 0.02]",
     10, "bodies[0].inertia", "is negative"),
    ("    inertia: [0.01, 0.02, 0.02]", "    inertia: [[1, 0.5, 0], [0, 1, 0], [0, 0, 1]]",
     10, "bodies[0].inertia", "is not symmetric"),
    ("    axis: [0, 1, 0]", "    axis: [0, 0, 0]", 24, "joints[0].axis", "has no direction"),
    ("    axis: [0, 1, 0]", "    axis: [0, 1, 0]\n    x_axis: [0, 2, 0]",
     25, "joints[0].x_axis", "parallel to the axis"),
    ("    axis: [0, 1, 0]", "    axis: [0, 1, 0]\n    frames: body", 23, "joints[0].at", "must be a pair"),
    ("    axis: [0, 1, 0]", "    axis: [[0, 1, 0], [0, 1, 0]]", 24, "joints[0].axis", "has shape"),
    ("    b: crank", "    b: ground", 19, "joints[0]", "joins body 'ground' to itself"),
    ("    at: [[1, 0, 0], [2, 0, 0]]", "    at: [[1, 0, 0], [1, 0, 0]]", None, "joints[1]", "coincide"),
    ("    length: drive", "    length: 0", 30, "joints[1].length", "must be positive"),
    ("    length: drive", "    length: -1", 30, "joints[1].length", "must be positive"),
    (ATTACHMENT,
     ATTACHMENT.replace("[0, 1, 0]", "[0, 2, 0]", 1),
     31, "joints[2]", "orthonormal"),
    (ATTACHMENT,
     "    attachment: {origin: [[3, 0, 0], [1, 0, 0]]}", 35, "joints[2].attachment.frame", "is missing"),
    (ATTACHMENT,
     "    attachment: 5", 35, "joints[2].attachment", "5 is not a mapping"),
    (DRIVE, "  drive: {table: {t: [0, 1, 1], values: [1, 2, 3]}}",
     6, "functions.drive", "must increase, but"),
    (DRIVE, "  drive: {table: {t: [0, 1], values: [1, 2, 3]}}",
     6, "functions.drive", "as many values as times"),
    (DRIVE, "  drive: {table: {t: [0, 1]}}",
     6, "functions.drive.table.values", "is missing"),
    (DRIVE, "  drive: {polynomial: []}",
     6, "functions.drive.polynomial", "has 0 entries"),
    (DRIVE, '  drive: {expression: "open(t).read()"}',
     6, "functions.drive.expression", ""),
    (DRIVE, '  drive: {expression: "1/t"}',
     6, "functions.drive.expression", ""),
    (DRIVE, '  drive: {expression: "log(0*t)"}',
     6, "functions.drive.expression", ""),
    (DRIVE, '  drive: {expression: "9**9**9**9"}',
     6, "functions.drive.expression", ""),
    (DRIVE, '  drive: {expression: "t +"}',
     6, "functions.drive.expression", ""),
    (DRIVE, '  drive: {expression: "' + "(" * 500 + '"}',
     6, "functions.drive.expression", ""),
    (DRIVE, '  drive: {expression: "' + "x" * 20000 + '"}',
     6, "functions.drive.expression", ""),
    (DRIVE, '  drive: {expression: "sin(q)"}',
     6, "functions.drive.expression", ""),
    (DRIVE, "  drive: {expression: 5}", 6, "functions.drive.expression", "5 is not text"),
    (DRIVE, "  drive: {sum: []}", 6, "functions.drive.sum", "has 0 entries"),
    (DRIVE, "  drive: {sum: [{constant: 1}, {constant: x}]}",
     6, "functions.drive.sum[1].constant", "'x' is not a number"),
    # --- names ---
    ("    b: crank", "    b: crnak", 22, "joints[0].b", "no body named 'crnak'; the nearest is 'crank'"),
    ("    a: ground", "    a: grond", 21, "joints[0].a", "no body named 'grond'"),
    ("    body: rod", "    body: rodd", 45, "forces[1].body", "the nearest is 'rod'"),
    ("  - name: rod", "  - name: crank", 14, "bodies[1].name", "'crank' is the name of bodies[0] in line 8"),
    ("  - name: rod", "  - name: ground", 14, "bodies[1].name", "is the name of the ground"),
    ("    name: link", "    name: pin", 26, "joints[1].name", "'pin' is the name of joints[0] in line 20"),
    ("    name: push", "    name: spring",
     44, "forces[1].name", "'spring' is the name of forces[0] in line 38"),
    ("  - name: rod", '  - name: "rod\\n"', 14, "bodies[1].name", "is not printable text"),
    ("    length: drive", "    length: drvie", 30, "joints[1].length", "the nearest is 'drive'"),
    ("    force: [1, drive, 0]", "    force: [1, 2, pull]",
     46, "forces[1].force", "'pull' is neither a number nor in functions"),
    # --- shapes ---
    (PUSH, PUSH + "\nshapes: [{bodies: [rdo], shapes: [{kind: sphere, radius: 1}]}]", 47,
     "shapes[0].bodies[0]", "the nearest is 'rod'"),
    (PUSH, PUSH + "\nshapes: [{bodies: [rod], shapes: [{kind: ball, radius: 1}]}]", 47, "shapes[0].shapes[0]",
     "'ball' is no kind of shape"),
    (PUSH, PUSH + "\nshapes: [{bodies: [rod], shapes: [{kind: sphere}]}]", 47, "shapes[0].shapes[0].radius",
     "is missing"),
    (PUSH, PUSH + "\nshapes: [{bodies: [rod], shapes: [{kind: sphere, radius: -1}]}]", 47,
     "shapes[0].shapes[0]", "is not a positive number"),
    (PUSH, PUSH + "\nshapes: [{bodies: [], shapes: []}]", 47, "shapes[0].bodies", "has 0 entries"),
    # --- YAML that is no data ---
    ("  - name: rod", "  - name: &rod rod", 14, "", "anchor &rod"),
    ("    body: rod", "    body: *rod", 45, "", "alias *rod"),
    ("gravity: [0, 0, -9.81]", "gravity: &g [*g, 0, 1]", 3, "", "anchor &g"),
    ("name: good", "name: !!python/object:os.system good", 2, "", "tag"),
    ("name: good", "name: !secret good", 2, "", "tag"),
    ("name: good", "name: good\nname: better", 3, "name", "is given twice"),
    ("    mass: 1.0", "    mass: 1.0\n    mass: 2.0", 10, "bodies[0].mass", "is given twice"),
    ("    axis: [0, 1, 0]", "    axis: [0, 1, 0]\n    axis: [1, 0, 0]",
     25, "joints[0].axis", "is given twice"),
    ("name: good", "<<: {a: 1}", 2, "<<", "is not known here"),
    ("name: good", "[a, b]: 1", 2, "", "a key must be a word"),
    ("name: good", "name: good\n---\nname: better", 3, "", "one document"),
    ("name: good", "name: 'good", None, "", "is no YAML"),
    ("name: good", "\tname: good", None, "", "is no YAML"),
    ("name: good", "name: good: better", 2, "", "is no YAML"),
    ("gravity: [0, 0, -9.81]", "gravity: [0, 0, -9.81", None, "", "is no YAML"),
    ("gravity: [0, 0, -9.81]", "gravity: " + "[" * 100 + "]" * 100, 3, "", "nested more than 64 deep"),
    ("gravity: [0, 0, -9.81]", "gravity: " + "{a: " * 100 + "1" + "}" * 100,
     3, "", "nested more than 64 deep"),
    ("gravity: [0, 0, -9.81]", "gravity: " + "[" * 10000, 3, "", "nested more than 64 deep"),
    ("name: good", "name: \x01", 2, "", "is no YAML"),
    ("name: good", "? name\n? name", 3, "name", "is given twice"),
]  # fmt: skip

#: Whole files: (extension, content, line, field, words of the message)
FILES: list[tuple[str, bytes, int, str, str]] = [
    ("yaml", b"", 1, "", "the file is empty"),
    ("json", b"", 1, "", "the file is empty"),
    ("yaml", b"  \n\n", 1, "", "the file is empty"),
    ("yaml", b"# nothing\n", 1, "", "a model file is a mapping"),
    ("yaml", b"just text\n", 1, "", "a model file is a mapping"),
    ("yaml", b"- 1\n- 2\n", 1, "", "a model file is a mapping"),
    ("yaml", b"%YAML 1.1\n---\nlinkwork: 1\n", 1, "", "without directives"),
    ("yaml", "linkwork: 1\nname: a\u2028b\n".encode(), 2, "", "U+2028"),
    ("yaml", b"\x89PNG\r\n\x1a\n\x00\x00", 1, "", "is no UTF-8 text"),
    ("yaml", b"linkwork: 1\nname: \xff\n", 2, "", "is no UTF-8 text"),
    ("json", bytes(range(128, 256)), 1, "", "is no UTF-8 text"),
    ("json", b"\x00\x00", 1, "", "is no JSON"),
    ("json", b"null", 1, "", "a model file is a mapping"),
    ("json", b"[]", 1, "", "a model file is a mapping"),
    ("json", b"{", 1, "", "is no JSON"),
    ("json", b'{"linkwork": 1,\n "bodies": [}', 2, "", "is no JSON"),
    ("json", b'{"linkwork": 1,\n "bodies": []} x', 2, "", "is no JSON"),
    ("json", b"{'linkwork': 1}", 1, "", "is no JSON"),
    ("json", b'{"linkwork": 1,\n "gravity": [0, 0, NaN]}', 2, "", "NaN is no finite number"),
    ("json", b'{"linkwork": 1,\n "name": "NaN",\n "gravity": [0, 0, -Infinity]}',
     3, "", "-Infinity is no finite number"),
    ("json", b'{"linkwork": 1,\n "gravity": [0, 0, 1e-400]}', 2, "gravity[2]", "1e-400 is nearer to zero"),
    ("json", b'{"linkwork": true}', 1, "linkwork", "true is not 1"),
    ("json", b'{"linkwork": 1,\n "gravity": [0, 0, 1e400]}', 2, "gravity[2]", "is not a finite number"),
    ("json", b'{"linkwork": 1,\n "gravity": [0, 0, ' + b"9" * 5000 + b"]}", 2, "", "is no finite number"),
    ("json", b'{"linkwork": 1,\n "name": "a",\n "name": "b"}', 3, "name", "is given twice"),
    ("json", b'{"linkwork": 1,\n "bodies": [{"name": "a",\n "name": "b"}]}',
     3, "bodies[0].name", "is given twice"),
    ("json", b'{"linkwork": 1,\n "bodies":\n' + b"[" * 100_000 + b"}", 3, "", "nested more than 64 deep"),
    ("json", b'{"linkwork": 1,\n "bodies":\n' + b'{"a":' * 100_000 + b"}", 3, "", "nested more than 64 deep"),
    ("json", b'{"linkwork": 1,\n "gravity":\n' + b"[" * 500 + b"]" * 500 + b"}",
     3, "gravity[0]", "a list is not a number"),
    ("json", b'{"linkwork": 1,\n "bodies": [\n {"name": "a", "mass": 1,\n "inertia": [1, 1, "1"]}]}',
     4, "bodies[0].inertia[2]", "'1' is not a number"),
    ("json", b'<?xml version="1.0"?>\n<!DOCTYPE x>', 1, "", "is no JSON"),
    ("yaml", b'<!DOCTYPE x [<!ENTITY a "b">]>\n<robot/>', 1, "", "a model file is a mapping"),
]  # fmt: skip


def replaced(line: str, by: str) -> str:
    """The good file with its first such line changed; nothing is left of a line that is removed."""
    assert f"\n{line}\n" in f"\n{YAML}", line
    return f"\n{YAML}".replace(f"\n{line}\n", f"\n{by}\n" if by else "\n", 1).removeprefix("\n")


def faults(path: Path) -> list[lw.Fault]:
    with pytest.raises(lw.ModelFileError) as refused:
        lw.Model.load(path)
    for line, fault in zip(str(refused.value).splitlines(), refused.value.faults, strict=True):
        assert line.startswith(f"{path}:{fault.line}: ") and len(line) < 400
    return list(refused.value.faults)


def identity(case: Case) -> str:
    return re.sub(r"\W+", " ", f"{case[3]} {case[4]} {case[1]}").strip()[:70]


def test_the_good_file_is_good(tmp_path: Path) -> None:
    path = tmp_path / "model.yaml"
    path.write_text(YAML)
    assert lw.Model.load(path).row_count == 9


def test_there_are_150_cases_and_more() -> None:
    assert len(CASES) + len(FILES) >= 150 and len(set(CASES)) == len(CASES)


@pytest.mark.parametrize("case", CASES, ids=identity)
def test_a_wrong_line_is_refused_where_it_is(case: Case, tmp_path: Path) -> None:
    line, by, number, field, words = case
    path = tmp_path / "model.yaml"
    path.write_text(replaced(line, by))
    found = faults(path)
    matching = [fault for fault in found if fault.field.startswith(field) and words in fault.message]
    assert matching, found
    if number is not None:
        assert number in {fault.line for fault in matching}, found
    if field and not field.endswith(("]", "drive")):
        assert field in {fault.field for fault in matching}, found


@pytest.mark.parametrize(("suffix", "content", "line", "field", "words"), FILES)
def test_a_wrong_file_is_refused(
    suffix: str, content: bytes, line: int, field: str, words: str, tmp_path: Path
) -> None:
    path = tmp_path / f"model.{suffix}"
    path.write_bytes(content)
    (found,) = faults(path)
    assert (found.line, found.field) == (line, field)
    assert words in found.message


SETTINGS: list[tuple[dict[str, Any], str]] = [
    ({"integrator": "RK4"}, "integrator"),
    ({"on_inaccurate": "nix"}, "on_inaccurate"),
    ({"record_every": 0}, "record_every"),
    ({"record_every": 1.5}, "record_every"),
    ({"verify": "maybe"}, "verify"),
    ({"assemble": 3}, "assemble"),
    ({"atol": "a"}, "atol"),
    ({"breaks": "x"}, "breaks"),
    ({"breaks": [0.1, "x"]}, "breaks"),
    ({"rtol": 2}, "rtol"),
    ({"rtol": 1e-14}, "rtol"),
    ({"t_end": -1.0}, "t_end"),
    ({"step": 0}, "step"),
    ({"step": 0.2}, "step"),  # the run is shorter
    ({"threads": 1.5}, "threads"),
    ({"baumgarte_alpha": 5.0}, "baumgarte_alpha"),
    ({"penalty": 10.0}, "penalty"),
    ({"matrix_form": "normal"}, "matrix_form"),
    ({"matrix_form": "kkt", "linear_solver": "cholmod"}, "linear_solver"),
    ({"integrator": "rk4", "rtol": 1e-6}, "rtol"),
    ({"integrator": "hem4", "stabilization": "baumgarte"}, "integrator"),
]


@pytest.mark.parametrize(("settings", "field"), SETTINGS, ids=str)
def test_settings_that_a_run_refuses_are_faults_of_the_file_in_its_words(
    settings: dict[str, Any], field: str, tmp_path: Path
) -> None:
    settings = {"t_end": 0.1, "step": 1e-3, **settings}
    with pytest.raises(lw.OptionError) as refused:
        lw.simulate(lw.mechanisms.rod_pendulum(), progress=False, **settings)
    path = tmp_path / "model.yaml"
    path.write_text(replaced("simulation: {t_end: 0.1, step: 1e-3}", f"simulation: {json.dumps(settings)}"))
    (found,) = faults(path)
    assert (found.line, found.field, found.message) == (4, f"simulation.{field}", str(refused.value))


def test_all_wrong_settings_are_told_each_with_its_line(tmp_path: Path) -> None:
    wrong = ["integrator: RK4", "record_every: 0", "verify: maybe", "linear_solver: cholesky"]
    path = tmp_path / "model.yaml"
    lines = "\n  ".join(["simulation:", *wrong])
    path.write_text(replaced("simulation: {t_end: 0.1, step: 1e-3}", lines))
    assert [(it.line, it.field.split(".")[1]) for it in faults(path)] == [
        (5 + k, it.split(":")[0]) for k, it in enumerate(wrong)
    ]


def json_of_cases() -> Iterator[tuple[Case, str]]:
    """The cases that JSON can express, in JSON with one value a line."""
    for case in CASES:
        from linkwork.modeling.files import yaml_text

        try:
            data = yaml_text.YamlText(replaced(case[0], case[1])).data
            text = json.dumps(data, indent=1, allow_nan=False)
        except (yaml_text.Malformed, ValueError):
            continue
        yield case, text


def test_json_files_have_the_same_faults_as_yaml_files(tmp_path: Path) -> None:
    count = 0
    for case, text in json_of_cases():
        paths = tmp_path / "model.yaml", tmp_path / "model.json"
        paths[0].write_text(replaced(case[0], case[1]))
        paths[1].write_text(text)
        in_yaml, in_json = (
            {(fault.field, re.sub("line [0-9]+", "line", fault.message)) for fault in faults(path)}
            for path in paths
        )
        assert in_yaml == in_json, case
        for fault in faults(paths[1]):
            last = re.split(r"[.\[]", fault.field)[-1]
            if last and not last.endswith("]") and fault.message != "is missing":
                assert f'"{last}"' in text.splitlines()[fault.line - 1], fault
        count += 1
    assert count > 90


def test_all_faults_are_told_at_once(tmp_path: Path) -> None:
    path = tmp_path / "model.yaml"
    text = YAML
    for line, by in (("mass: 1.0", "mass: -1"), ("kind: distance", "kind: distants"),
                     ("axis: [0, 1, 0]", "axis: [0, 1]"), ("stiffness: 100", "stiff: 100")):  # fmt: skip
        text = text.replace(line, by)
    path.write_text(text)
    assert [(fault.line, fault.field) for fault in faults(path)] == [
        (9, "bodies[0].mass"), (24, "joints[0].axis"), (25, "joints[1].kind"), (42, "forces[0].stiff"),
    ]  # fmt: skip
    path.write_text(
        YAML.replace("axis: [0, 1, 0]", "axis: [0, 0, 0]").replace("[0.01, 0.02, 0.02]", "[1, 1, 9]")
    )
    assert [fault.line for fault in faults(path)] == [10, 24]


def test_names_and_mechanics_are_told_together(tmp_path: Path) -> None:
    """What needs a joint that is wrong is no fault of its own."""
    (tmp_path / "wrong.yaml").write_text("""\
linkwork: 1
name: "tab\\there"
bodies:
  - {name: bar, mass: 1, inertia: [1, 1, 1]}
  - {name: bar, mass: 1, inertia: [1, 1, 1]}
  - {name: two, mass: 1, inertia: [1, 1, 9]}
joints:
  - {kind: revolute, name: pin, a: ground, b: baar, at: [0, 0, 0], axis: [0, 1, 0]}
  - {kind: revolute, name: knee, a: ground, b: bar, at: [0, 0, 0], axis: [0, 0, 0]}
  - {kind: coupler, name: belt, coordinates: [{joint: pin, factor: 1.0}, {joint: knee, factor: 1.0}]}
  - {kind: drive, name: motor, joint: knee, position: 1.0}
forces:
  - {kind: drag, a: ground, b: bar, at: [0, 0, 0], coefficient: -1}
  - {kind: drag, a: ground, b: two, at: [0, 0, 0], coefficient: unknown}
history: [1.0]
""")
    with pytest.raises(lw.ModelFileError) as caught:
        lw.Model.load(tmp_path / "wrong.yaml")
    assert [fault.line for fault in caught.value.faults] == [2, 5, 6, 8, 9, 13, 14]


def test_of_very_many_faults_the_first_are_told(tmp_path: Path) -> None:
    path = tmp_path / "model.json"
    body: dict[str, Any] = {"name": "b", "mass": -1, "inertia": [1, 1, 1]}
    path.write_text(json.dumps({"linkwork": 1, "bodies": [body] * 10_000}))
    assert len(faults(path)) == 21


def test_files_beyond_the_limit_are_refused_unread(tmp_path: Path) -> None:
    path = tmp_path / "model.yaml"
    with path.open("wb") as file:
        file.truncate(2**24 + 1)
    assert "a .yaml file may have 16 MiB; write it as .json" in faults(path)[0].message


def test_cases_never_show_a_traceback(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for case in CASES[::7]:
        path = tmp_path / "model.yaml"
        path.write_text(replaced(case[0], case[1]))
        assert run(["check", str(path)], debug=False) == 1, case
        said = capsys.readouterr().err.splitlines()
        assert said and all(line.startswith(f"error: {path}:") for line in said), said


@pytest.mark.parametrize("path", ["no/such/model.yaml", "model.txt", "model.yamel", "."])
def test_what_is_no_model_file_is_refused(path: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    with pytest.raises(lw.FileError):
        lw.Model.load(path)
    (tmp_path / "folder.yaml").mkdir()
    with pytest.raises(lw.FileError, match="directory"):
        lw.Model.load("folder.yaml")
