"""Mechanisms that run in lanes, variants of them, and what is compared bit by bit."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

import linkwork as lw
import numpy as np
from linkwork import mechanisms
from linkwork.modeling.files import record_of
from linkwork.studies.variants import Changed


#: Trees, loops, redundant equations, drivers, gears, springs; step [s].
def bead_on_a_wire() -> lw.Model:
    """Closed, and curved in space."""
    turns = np.linspace(0, 2 * np.pi, 24, endpoint=False)
    wire = np.column_stack([np.cos(turns), 0.7 * np.sin(turns), 0.2 * np.sin(2 * turns)])
    model = lw.Model(name="bead")
    bead = model.body("bead", mass=0.5, inertia=(1e-3, 2e-3, 2e-3), position=wire[3])
    model.point_on_curve("ground", bead, points=wire, at=wire[3], closed=True)
    return model


KNOWN: dict[str, tuple[Callable[[], lw.Model], float]] = {
    "chain": (mechanisms.chain, 1e-3),
    "binary_tree": (mechanisms.binary_tree, 1e-3),
    "hub": (mechanisms.hub, 1e-3),
    "heavy_top": (mechanisms.heavy_top, 1e-3),
    "gyroscope": (mechanisms.gyroscope, 1e-3),
    "rolling_disc": (mechanisms.rolling_disc, 1e-3),
    "four_bar": (lambda: mechanisms.four_bar(2), 1e-3),
    "spatial_slider_crank": (mechanisms.spatial_slider_crank, 1e-3),
    "bricard": (mechanisms.bricard, 1e-3),
    "bennett": (mechanisms.bennett, 1e-3),
    "watt_six_bar": (mechanisms.watt_six_bar, 1e-3),
    "stewart_platform": (mechanisms.stewart_platform, 1e-3),
    "double_wishbone": (mechanisms.double_wishbone, 1e-3),
    "flyball_governor": (mechanisms.flyball_governor, 1e-4),
    "delta_robot": (mechanisms.delta_robot, 1e-4),
    "bead_on_a_wire": (bead_on_a_wire, 1e-3),
    "hub_in_loops": (lambda: mechanisms.hub(12, loops=True), 1e-3),
}

FIELDS = ("t", "q", "v", "vdot", "lambda", "kinetic", "potential", "work", "violation", "history")


def variants(model: lw.Model, count: int, seed: int) -> list[lw.Model]:
    """Other masses, inertias and gravity; nothing that the joints notice."""
    rng = np.random.default_rng(seed)
    bodies = record_of(model, {})["bodies"]
    names = [f"{it['name']}.{field}" for it in bodies for field in ("mass", "inertia")]
    source = Changed.of(model, [*names, "gravity"])
    record = {name: source.value(name) for name in (*names, "gravity")}

    def scaled() -> dict[str, Any]:
        factor = {name.rpartition(".")[0]: rng.uniform(0.5, 2.0) for name in record}
        return {name: (np.asarray(value) * factor[name.rpartition(".")[0]]).tolist()
                for name, value in record.items()}  # fmt: skip

    return [source.model(scaled()) for _ in range(count)]


@cache
def known_variants(name: str, count: int, seed: int) -> list[lw.Model]:
    """Of one of KNOWN, made once for all tests."""
    return variants(KNOWN[name][0](), count, seed)


def alone(model: lw.Model, t_end: float, step: float | None = None, **options: Any) -> lw.Result:
    chosen = {"deterministic": True, "on_inaccurate": "pass", "progress": False, **options}
    return lw.simulate(model, t_end, step, **chosen)


def bits(result: lw.Result) -> dict[str, bytes]:
    return {name: result.recorded(name).tobytes() for name in FIELDS}


def with_inerters(model: lw.Model, seed: int, inertance: float) -> lw.Model:
    """About hinges and along slides, several at balls, and others that make loops."""
    rng = np.random.default_rng(seed)
    axes = {"revolute": "r", "cylindrical": "rt", "translational": "t", "universal": "r", "spherical": "rr"}
    record = record_of(model, {})
    names = ["ground", *(it["name"] for it in record["bodies"])]
    places = [(kind, it["a"], it["b"]) for it in record["joints"] for kind in axes.get(it["kind"], "")]
    for kind in rng.choice(["r", "t", "l"], 2):
        places.append((str(kind), *(str(name) for name in rng.choice(names, 2, replace=False))))
    for kind, a, b in places:
        at, amount = rng.uniform(-1, 1, 3), inertance * rng.uniform(0.1, 1)
        if kind == "l":
            model.inerter(a, b, at=(at, at + rng.standard_normal(3)), inertance=amount)
        else:
            add = model.rotational_inerter if kind == "r" else model.translational_inerter
            add(a, b, at=at, axis=rng.standard_normal(3), inertance=amount)
    return model


def with_functions(amplitude: float, stiffness: float) -> lw.Model:
    """A crank that is driven, and a rod on a spring with history; lanes differ in functions of time."""
    model = lw.Model(name="functions")
    crank = model.body("crank", mass=1.0, inertia=(0.01, 0.02, 0.02), position=(0.5, 0, 0))
    rod = model.body("rod", mass=2.0, inertia=(0.02, 0.3, 0.3), position=(1.5, 0, 0))
    model.revolute(model.ground, crank, at=(0, 0, 0), axis=(0, 1, 0), name="motor pin")
    model.revolute(crank, rod, at=(1, 0, 0), axis=(0, 1, 0), name="elbow")
    motion = lw.functions.harmonic(amplitude=amplitude, frequency=2.0, phase=np.pi / 2, offset=-amplitude)
    model.angle_driver(model.ground, crank, angle=motion, at=(0, 0, 0), axis=(0, 1, 0), name="motor")
    model.rotational_spring_damper(crank, rod, at=(1, 0, 0), axis=(0, 1, 0), stiffness=stiffness, damping=0.1,
                                   free_angle=0.2, torque=0.0, name="spring")  # fmt: skip
    return model


def crank_rocker() -> lw.Model:
    """Bars of 0.5, 2 and 1.5 m, a base of 2 m; as it turns other equations become the redundant ones."""
    model = lw.Model(gravity=(0, 0, -9.81), name="crank-rocker")
    crank, base = np.array((0, 0, 0.5)), np.array((2.0, 0, 0))
    distance = np.linalg.norm(base - crank)
    x, along = (base - crank) / distance, (2.0**2 - 1.5**2 + distance**2) / (2 * distance)
    elbow = crank + along * x + np.sqrt(2.0**2 - along**2) * np.array((-x[2], 0, x[0]))
    points = [np.zeros(3), crank, elbow, base]
    names = ["ground", "crank", "coupler", "rocker", "ground"]
    for k, mass in enumerate((1.0, 2.0, 1.5)):
        bar = points[k + 1] - points[k]
        model.body(names[k + 1], mass=mass, inertia=mechanisms.thin_rod(mass, float(np.linalg.norm(bar))),
                   position=(points[k] + points[k + 1]) / 2,
                   orientation=lw.rotation.from_axes(x=bar, y=(0, 1, 0)))  # fmt: skip
    for k, point in enumerate(points):
        model.revolute(names[k], names[k + 1], at=point, axis=(0, 1, 0), name=f"pin {k}")
    return model


def carousel(lift: float) -> lw.Model:
    """Twelve arms hinged on a free hub, their tips tied to the ground.

    One rod is along the axis of its hinge but for `lift`: nearly, it holds the hub alone.
    """
    model = lw.Model(gravity=(0, 0, -9.81), name="carousel")
    hub = model.body("hub", mass=5.0, inertia=(1, 1, 2), position=(0, 0, 1))
    up = np.array([0.0, 0.0, 1.0])
    for k, turn in enumerate(2 * np.pi * np.arange(12) / 12):
        out, along = np.array([np.cos(turn), np.sin(turn), 0]), np.array([-np.sin(turn), np.cos(turn), 0])
        arm = model.body(f"arm {k}", mass=1.0, inertia=(0.05, 0.06, 0.07), position=up + out)
        model.revolute(hub, arm, at=up + 0.5 * out, axis=along, name=f"pin {k}")
        tip, rod = up + 1.5 * out, 0.1 * k * along + 0.7 * up + 0.3 * out if k else along + lift * up
        model.distance(arm, model.ground, at=(tip, tip + rod), name=f"rod {k}")
    return model
