"""A leg of Theo Jansen's beach animals."""

from __future__ import annotations

import numpy as np

from linkwork import Model
from linkwork.arrays import Floats
from linkwork.equations.assembly import assemble
from linkwork.functions import polynomial
from linkwork.mechanisms.mechanism import Mechanism
from linkwork.mechanisms.planar import meet, polar, tube_link

#: Jansen's "holy numbers", by his letters; here in cm.
LENGTHS = {
    "a": 38.0, "b": 41.5, "c": 39.3, "d": 40.1, "e": 55.8, "f": 39.4, "g": 36.7, "h": 65.7, "i": 49.0,
    "j": 50.0, "k": 61.9, "l": 7.8, "m": 15.0,
}  # fmt: skip

DENSITY, RADIUS = 0.12, 0.0095  # of PVC tube of 19 mm, 1.5 mm thick [kg/m], [m]


def leg_points(crank_angle: float) -> dict[str, Floats]:
    """Joints and foot (3,) [m] at an angle of the crank from x [rad]; the axle is the origin."""
    n = {letter: length / 100 for letter, length in LENGTHS.items()}
    axle, fixed = np.zeros(3), np.array([-n["a"], -n["l"], 0.0])
    pin = polar(n["m"], crank_angle)
    top = meet(fixed, pin, n["b"], n["j"], 1)
    back = meet(fixed, top, n["d"], n["e"], 1)
    low = meet(fixed, pin, n["c"], n["k"], -1)
    ankle = meet(back, low, n["f"], n["g"], -1)
    foot = meet(ankle, low, n["h"], n["i"], -1)
    return {"axle": axle, "fixed": fixed, "pin": pin, "top": top, "back": back, "low": low, "ankle": ankle,
            "foot": foot}  # fmt: skip


def strandbeest_leg(speed: float = -6.0) -> Model:
    """Leg of a Strandbeest: eight links that turn a crank into steps with a level foot (Jansen's numbers).

    A driver turns the crank; the foot, the last corner of the lower triangle, draws a flat line while it
    would be on the ground and lifts on its way back. Lengths as Theo Jansen gives them, here in cm: 38, 41.5,
    39.3, 40.1, 55.8, 39.4, 36.7, 65.7, 49, 50, 61.9, 7.8, 15. Links of PVC tube, 19 mm and 0.12 kg/m, are our
    choice; the foot hangs free. Ten revolutes with parallel axes and the driver: 51 equations of rank 42 on
    42 coordinates. Gravity along -y.

    speed  of the crank [rad/s]; negative ones walk along +x

        model = lw.mechanisms.strandbeest_leg()
    """
    model = Model(gravity=(0, -9.81, 0), name="strandbeest_leg")
    p = leg_points(0.0)
    links = {
        "crank": ("axle", "pin"),
        "upper rod": ("pin", "top"),
        "lower rod": ("pin", "low"),
        "upper triangle": ("fixed", "top", "back"),
        "upright": ("fixed", "low"),
        "back rod": ("back", "ankle"),
        "lower triangle": ("low", "ankle", "foot"),
    }
    for name, corners in links.items():
        tube_link(model, name, [p[corner] for corner in corners], DENSITY, RADIUS)
    for name, first, second, point in (
        ("axle", "ground", "crank", "axle"),
        ("pin of upper rod", "crank", "upper rod", "pin"),
        ("pin of lower rod", "crank", "lower rod", "pin"),
        ("hip", "ground", "upper triangle", "fixed"),
        ("hip of upright", "ground", "upright", "fixed"),
        ("top", "upper rod", "upper triangle", "top"),
        ("back", "upper triangle", "back rod", "back"),
        ("knee", "upright", "lower triangle", "low"),
        ("knee of lower rod", "lower rod", "lower triangle", "low"),
        ("ankle", "back rod", "lower triangle", "ankle"),
    ):
        model.revolute(first, second, at=p[point], axis=(0, 0, 1), name=name)
    model.angle_driver(
        "ground", "crank", at=p["axle"], axis=(0, 0, 1), angle=polynomial(0.0, speed), name="motor"
    )
    return assemble(model).model


STRANDBEEST_LEG = Mechanism(strandbeest_leg, t_end=2.0, step=1e-3)
