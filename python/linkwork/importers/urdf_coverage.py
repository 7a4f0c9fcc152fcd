"""What becomes of the elements and attributes of URDF. The syntax is that of linkwork.importers.coverage."""

from linkwork.importers.coverage import Coverage, Noted, Refused

__all__ = ["URDF"]

REPRESENTED = """
    @ name version
    link: name type
    link/inertial
    link/inertial/origin: xyz rpy
    link/inertial/mass: value
    link/inertial/inertia: ixx ixy ixz iyy iyz izz
    link/visual: name
    link/visual/origin: xyz rpy
    link/visual/geometry
    link/visual/geometry/box: size
    link/visual/geometry/cylinder: radius length
    link/visual/geometry/capsule: radius length
    link/visual/geometry/sphere: radius
    link/visual/geometry/mesh: filename scale
    link/visual/material: name
    link/visual/material/color: rgba
    material: name
    material/color: rgba
    joint: name type
    joint/origin: xyz rpy
    joint/parent: link
    joint/child: link
    joint/axis: xyz
    joint/dynamics: damping friction
    joint/mimic: joint multiplier offset reference
"""

NOTED = (
    Noted(
        "appearance", "textures are not represented", "link/visual/material/texture/**\nmaterial/texture/**"
    ),
    Noted("collision", "", "link/collision/**", by_name=True),
    Noted(
        "limits", "", "joint/limit: lower upper effort velocity acceleration deceleration jerk", by_name=True
    ),
    Noted("calibration", "", "joint/calibration/**", by_name=True),
    Noted("safety_controller", "", "joint/safety_controller/**", by_name=True),
    Noted("element", "is not represented", "transmission/**\nsensor/**\nlink/sensor/**"),
    Noted("element", "is not represented: what it changes in Gazebo stays as it is", "gazebo/**"),
    Noted(
        "element", "is not represented: there is no contact", "link/contact/**\nlink/collision_checking/**"
    ),
)

REFUSED = (
    Refused(
        "",
        "link/inertial/origin @ quat_xyzw\njoint/origin @ quat_xyzw\nlink/visual/origin @ quat_xyzw",
        by_name=True,
    ),
)

URDF = Coverage(
    REPRESENTED,
    NOTED,
    REFUSED,
    several="link joint link/visual material",
    texts=False,
)
