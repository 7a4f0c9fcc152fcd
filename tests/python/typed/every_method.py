"""A user's script that calls every method of Model, for type checkers and to be run."""

from pathlib import Path

import linkwork as lw
import numpy as np
from linkwork.functions import cycloidal, harmonic

model = lw.Model(gravity=(0, 0, -9.81), name="every method")
tip = np.array([0.5, 0.0, 0.1])
length = np.linalg.norm(tip)  # a scalar of NumPy, as lengths often are
a = model.body("a", mass=2 * length, inertia=lw.mechanisms.thin_rod(2 * length, length))
b = model.body("b", mass=1, inertia=(1, 1, 1), position=(length, 0, 0.1), shape=lw.Sphere(length))
c = model.body("c", mass=1.0, inertia=np.eye(3), position=(0, 0, 1), omega=[0, 0, 1])
row = model.bodies("row", mass=1.0, inertia=(1, 1, 1), position=np.eye(3))
ground: lw.Body = model.ground
found: lw.Body = model.find("b")
places = model.indices(row)
model.shape([a, "b"], lw.Box((1, 1, 1), color="red"), lw.Rod((0, 0, 0), tip))
a.shape(lw.Cylinder(0.1, length, axis=tip))

x, y, z = (1, 0, 0), (0, 1, 0), (0, 0, 1)
pin: lw.Joint = model.revolute(model.ground, a, at=(0, 0, 0), axis=y, name="pin")
slider = model.translational("ground", b, at=tip, axis=np.array(x), name="slider")
model.cylindrical(a, c, at=tip, axis=z)
model.spherical(a, b, at=tip)
model.universal(a, b, at=tip, axes=(x, y))
model.fixed(b, c, at=(tip, (0, 0, 0)), frames="body")
model.planar(ground, c, at=tip, axis=z, x_axis=x)
model.screw(a, b, at=tip, axis=z, pitch=0.01)
model.gear(a, b, at=((0, 0, 0), (3, 0, 0)), axis=z, teeth_a=20, teeth_b=40)
model.rack_pinion(a, b, at=(length, 0, 0), axes=(x, y), radius=0.1)
model.rolling_disc(ground, b, at=((0, 0, 0), tip), axes=(z, y), radius=0.1)
model.knife_edge(ground, c, at=tip, axis=y)
model.constant_velocity(a, b, at=tip, axes=(x, (1, 0.1, 0)))
model.distance(a, b, at=((0, 0, 0), tip), length=length)
model.orientation(a, b)
model.parallel_axes(a, b, axis=z)
model.perpendicular_axes(a, b, axes=(x, y))
model.point_on_line(a, b, at=tip, axis=x)
model.point_on_plane(a, b, at=tip, axis=z)
model.point_on_curve(ground, c, points=[(0, 0, 1), (0.3, 0, 1), (1, 1, 1), (0, 1, 1)], at=(0, 0, 1))
model.revolute_revolute(a, b, at=((0, 0, 0), tip), axis=y)
model.revolute_spherical(a, b, at=((0, 0, 0), tip), axis=y)
model.revolute_translational(a, b, at=tip, axes=(z, x))
model.universal_spherical(a, b, at=((0, 0, 0), tip))
model.coupler([("pin", 1.0), (slider, "displacement", -2.0)], offset=0.1)
pairs = model.joints("spherical", row[:-1], row[1:], at=np.zeros((2, 3)))

model.angle_driver(ground, a, at=(0, 0, 0), axis=y, angle=harmonic(0.1, 2.0))
model.displacement_driver(ground, b, at=tip, axis=x, displacement=0.1)
driver: lw.Joint = model.drive(pin, position=cycloidal(1.0, 0.5))

spring: lw.Force = model.spring_damper(a, b, at=((0, 0, 0), tip), stiffness=1e3, damping=np.float64(2.0))
model.nonlinear_spring_damper(a, b, at=((0, 0, 0), tip), spring=lambda d: 1e3 * d + 1e5 * d**3)
model.rotational_spring_damper(a, b, axis=y, stiffness=10.0)
model.translational_spring_damper(ground, b, at=tip, axis=x, stiffness=10.0, free_displacement=-1.0)
model.nonlinear_rotational_spring_damper(a, b, at=tip, axis=y, spring=lambda angle: 5 * angle)
model.rotational_friction(a, b, at=tip, axis=y, coulomb=0.1)
model.translational_friction(ground, b, at=tip, axis=x, viscous=0.2)
model.rotational_stop(ground, a, at=(0, 0, 0), axis=y, lower=-1, upper=1, stiffness=1e4)
model.translational_stop(ground, b, at=tip, axis=x, lower=-length, upper=length, stiffness=1e4)
model.bushing(a, b, at=tip, stiffness=(1e3, 1e3, 1e3))
model.inerter(a, b, at=(x, tip), inertance=0.2)
model.rotational_inerter(a, b, at=tip, axis=x, inertance=0.1)
model.translational_inerter(a, b, at=tip, axis=x, inertance=0.1)
model.bending_spring(a, b, axis=x, stiffness=3.0)
model.linear_damping(a, b, at=tip, damping=0.5)
model.drag(ground, b, at=tip, coefficient=0.1)
model.motor(a, b, at=tip, axis=y, curve=lambda speed: 10 - speed)
model.sphere_plane_contact(ground, b, at=((0, 0, 0), tip), normal=z, radius=0.1, stiffness=1e5)
model.sphere_sphere_contact(a, b, at=((0, 0, 0), tip), radius_a=0.1, radius_b=length, stiffness=1e5)
model.force(a, force=(0, 0, lambda t: np.sin(t)), at=tip, frame="body")
model.joint_force("pin", lambda t, angle, rate: -0.1 * rate)
model.user_force(lambda t, q, v: np.zeros(6), c)
rows = model.forces("drag", "ground", row, at=np.eye(3), coefficient=0.2)

count: int = (
    model.body_count + model.joint_count + model.force_count + model.row_count + model.user_force_count
)
text: str = model.describe() + model.hash() + model.name
settings = (model.curves, model.drivers, model.shapes, model.signals, model.user_forces)
table = model.table("joints")
first: str = table[0]["name"]
compiled = model.compiled()

small = lw.mechanisms.four_bar(1)
values: dict[str, object] = small.values("beam 0")
heavier: lw.Model = small.replaced(small.find("beam 0"), mass=2.0).without("beam 0", attached=True)
lighter: lw.Model = small.with_gravity(model.gravity / 6)
moved = small.with_initial_state(small.compiled().q0, np.zeros(6 * small.body_count))
moved.save("four_bar.yaml", simulation={"t_end": 1.0})
again: lw.Model = lw.Model.load(Path("four_bar.yaml"))
page = again.view("four_bar.html")
figure = again.plot("four_bar.png")
figure.suptitle("initial pose")
