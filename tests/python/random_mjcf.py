"""Random MJCF files: elements and attributes of many kinds that reach MuJoCo's model, and must reach ours."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

#: The joints of a body: those that one joint here can stand for, and others that follow each other.
JOINTS = ("free", "ball", "hinge", "slide", "weld", "planar", "cylindrical", "universal", "several")


class RandomFile:
    def __init__(self, seed: int) -> None:
        self._rng = np.random.default_rng(seed)
        self._degrees = self._maybe(0.5)
        self._actuators: list[str] = []
        self._count = 0

    def text(self) -> str:
        bodies = "".join(self._body(0) for _ in range(self._rng.integers(1, 4)))
        sequence = "".join(self._one("xX" if self._maybe(0.5) else "x", "y", "z")[0] for _ in range(3))
        sequence = self._one("xyz", "XYZ", "zyx", "ZYX", "xYz", sequence)
        compiler = f'angle="{"degree" if self._degrees else "radian"}" eulerseq="{sequence}"'
        for attribute, value in (("settotalmass", "7"), ("boundmass", "0.3"), ("boundinertia", "0.01"),
                                 ("inertiafromgeom", "true"), ("balanceinertia", "true")):  # fmt: skip
            if self._maybe(0.15):
                compiler += f' {attribute}="{value}"'
        flags = "".join(
            f' {flag}="disable"'
            for flag in (
                "gravity",
                "spring",
                "damper",
                "constraint",
                "equality",
                "limit",
                "contact",
                "eulerdamp",
            )
            if self._maybe(0.15)
        )
        return (
            f'<mujoco model="random"><compiler {compiler}/><option gravity="{self._numbers(3, 10)}">'
            f"<flag{flags}/></option>{self._defaults()}<worldbody>{bodies}</worldbody>"
            f"<actuator>{''.join(self._actuators)}</actuator></mujoco>\n"
        )

    # --- choices ---

    def _maybe(self, chance: float) -> bool:
        return bool(self._rng.random() < chance)

    def _one(self, *choices: str) -> str:
        return choices[self._rng.integers(len(choices))]

    def _numbers(self, count: int, scale: float = 1.0) -> str:
        return " ".join(f"{x:.6f}" for x in self._rng.uniform(-scale, scale, count))

    def _positive(self, count: int = 1, scale: float = 1.0) -> str:
        return " ".join(f"{x:.6f}" for x in self._rng.uniform(0.1 * scale, scale, count))

    def _angle(self) -> str:
        return f"{self._rng.uniform(-1, 1) * (57.3 if self._degrees else 1):.6f}"

    def _some(self, attributes: Sequence[tuple[str, str]], chance: float = 0.4) -> str:
        return "".join(f' {name}="{value}"' for name, value in attributes if self._maybe(chance))

    def _orientation(self) -> str:
        angles = " ".join(self._angle() for _ in range(3))
        return self._one(
            "", f'quat="{self._numbers(4)}"', f'axisangle="{self._numbers(3)} {self._angle()}"',
            f'euler="{angles}"', f'zaxis="{self._numbers(3)}"', f'xyaxes="{self._numbers(6)}"',
        )  # fmt: skip

    # --- elements ---

    def _defaults(self) -> str:
        joint = self._some(self._dynamics(), 0.2)
        stiff = f'<joint stiffness="{self._positive()}" damping="{self._positive()}"/>'
        geom = f'<geom density="{self._positive(1, 900)}"/>'
        return f'<default><joint{joint}/><default class="stiff">{stiff}{geom}</default></default>'

    def _dynamics(self) -> list[tuple[str, str]]:
        return [
            ("damping", self._positive()),
            ("armature", self._positive(1, 0.1)),
            ("stiffness", self._positive()),
        ]

    def _body(self, depth: int) -> str:
        self._count += 1
        name = f"b{self._count}"
        joints = self._joints(name, depth)
        attributes = self._some([("gravcomp", self._positive()), ("childclass", "stiff")], 0.25)
        inner = joints + self._inertia()
        children = int(self._rng.integers(0, 3)) if depth < 3 else 0
        inner += "".join(self._body(depth + 1) for _ in range(children))
        body = (
            f'<body name="{name}" pos="{self._numbers(3)}" {self._orientation()}{attributes}>{inner}</body>'
        )
        if self._maybe(0.2) and depth:
            return f'<frame pos="{self._numbers(3)}" {self._orientation()}>{body}</frame>'
        return body

    def _inertia(self) -> str:
        """Given, or of shapes."""
        place = f'pos="{self._numbers(3, 0.3)}" {self._orientation()}'
        moments = 0.03 + 0.02 * self._rng.random(3)
        shape = f'<geom type="{self._one("box", "ellipsoid")}" size="{self._positive(3, 0.3)}" {place} {{}}/>'
        given = self._one(
            f'<inertial {place} mass="{self._positive()}" diaginertia="{" ".join(map(str, moments))}"/>',
            f'<inertial pos="{self._numbers(3, 0.3)}" mass="{self._positive()}" fullinertia="0.05 0.04 0.03 '
            f'{self._numbers(3, 0.005)}"/>',
            "",
        )  # fmt: skip
        shell = f'mass="{self._positive()}" shellinertia="true"' if "box" in shape else ""
        mass = self._one(f'mass="{self._positive()}"', f'density="{self._positive(1, 500)}"', shell)
        return given + shape.format(mass)

    def _joints(self, name: str, depth: int) -> str:
        kind = self._one(*JOINTS) if not depth else self._one(*JOINTS[1:])
        point = f'pos="{self._numbers(3, 0.3)}"'
        if kind == "weld":
            return ""
        if kind in ("free", "ball"):
            dynamics = self._some(self._dynamics()) if kind == "free" else self._some(self._dynamics()[::2])
            place = (
                f'{point} armature="0"' if kind == "ball" else ""
            )  # that of a ball is noted, not represented
            return f'<joint name="{name}" type="{kind}"{dynamics} {place}/>'
        if kind in ("hinge", "slide"):
            return self._scalar(
                name, kind, f'{point} axis="{self._numbers(3)}"', self._some(self._dynamics())
            )
        if kind == "several":
            return self._several(name)
        x, y, z = np.linalg.qr(self._rng.normal(size=(3, 3)))[0].T
        axes = {
            "planar": ((x, "slide"), (y, "slide"), (z, "hinge")),
            "cylindrical": ((x, "slide"), (x, "hinge")),
            "universal": ((x, "hinge"), (y, "hinge")),
        }[kind]
        joints = [
            self._scalar(f"{name}_{k}", type_, f'{point} axis="{" ".join(map(repr, axis.tolist()))}"',
                         ' damping="0" armature="0" stiffness="0"')
            for k, (axis, type_) in enumerate(axes)
        ]  # fmt: skip
        return "".join(joints)

    def _several(self, name: str) -> str:
        """Each about an axis and a point of its own."""
        out = ""
        for k in range(int(self._rng.integers(2, 4))):
            place = f'pos="{self._numbers(3, 0.3)}" axis="{self._numbers(3)}"'
            dynamics = self._some(self._dynamics())
            out += self._scalar(f"{name}_{k}", self._one("hinge", "slide"), place, dynamics)
        if self._maybe(0.2):
            out += f'<joint name="{name}_ball" type="ball" pos="{self._numbers(3, 0.3)}" armature="0"/>'
        return out

    def _scalar(self, name: str, type_: str, place: str, dynamics: str) -> str:
        angle = self._angle() if type_ == "hinge" else self._numbers(1)
        rest = self._angle() if type_ == "hinge" else self._numbers(1)
        single = 'armature="0"' not in dynamics
        if single and self._maybe(0.2):
            dynamics += f' springdamper="{self._positive()} {self._positive()}"'
        if single and self._maybe(0.4):
            own = self._some([("armature", self._positive(1, 0.1)), ("damping", self._positive())])
            at = self._one("joint", "jointinparent")
            self._actuators.append(f'<motor {at}="{name}" gear="{self._numbers(1, 5)}"{own}/>')
        return (f'<joint name="{name}" type="{type_}" {place}{dynamics}'
                f'{self._some([("ref", angle), ("springref", rest)])}/>')  # fmt: skip
