"""What becomes of the elements and attributes of SDF. The syntax is that of linkwork.importers.coverage."""

from linkwork.importers.coverage import Coverage, Noted, Refused

__all__ = ["SDF"]

REPRESENTED = """
    @ version
    world: name
    world > gravity
    model: name canonical_link placement_frame
    model > static
    include
    include > name uri static placement_frame
    frame: name attached_to
    pose: frame relative_to rotation_format degrees

    link: name
    link > gravity inertial
    link/inertial > mass inertia
    link/inertial/pose: rotation_format degrees
    link/inertial/inertia > ixx ixy ixz iyy iyz izz

    link/visual: name
    link/visual > transparency
    link/visual/pose: frame relative_to rotation_format degrees
    link/visual/geometry
    link/visual/geometry > box capsule cylinder ellipsoid empty mesh plane sphere
    link/visual/geometry/box > size
    link/visual/geometry/capsule > radius length
    link/visual/geometry/cylinder > radius length
    link/visual/geometry/ellipsoid > radii
    link/visual/geometry/sphere > radius
    link/visual/geometry/plane > normal size
    link/visual/geometry/mesh > uri scale
    link/visual/material
    link/visual/material > diffuse ambient

    joint: name type
    joint > parent child gearbox_ratio gearbox_reference_body thread_pitch screw_thread_pitch axis axis2
    joint/axis > use_parent_model_frame dynamics
    joint/axis/xyz: expressed_in
    joint/axis/dynamics > damping friction spring_stiffness spring_reference
    joint/axis/mimic: joint axis
    joint/axis/mimic > multiplier offset reference
    joint/axis2 > use_parent_model_frame
    joint/axis2/xyz: expressed_in
"""

NOTED = (
    Noted("visual", "", "link/visual/geometry > image/** heightmap/** polyline/**", by_name=True),
    Noted("appearance", "is not represented: shapes have one color",
          """
          link/visual > cast_shadows laser_retro visibility_flags meta/** plugin/** frame/**
          link/visual/geometry/mesh/submesh/**
          link/visual/material > double_sided emissive lighting pbr/** render_order
          link/visual/material > script/** shader/** specular
          """),
    Noted("collision", "", "link/collision/**", by_name=True),
    Noted("fluid_added_mass", "", "link/inertial/fluid_added_mass/**", by_name=True),
    Noted("physics", "", "joint/physics/**", by_name=True),
    Noted("sensor", "", "joint/sensor/**", by_name=True),
    Noted("limits", "",
          "joint/axis/limit\njoint/axis/limit > lower upper effort velocity stiffness dissipation",
          by_name=True),
    Noted("axis2", "", "joint/axis2/dynamics/**\njoint/axis2/limit/**\njoint/axis2/mimic/**", by_name=True),
    Noted("element", "is not represented: joints start where the poses put them",
          "joint/axis/initial_position\njoint/axis2/initial_position"),
    Noted("element", "is not represented: the link moves as forces make it",
          "link > kinematic must_be_base_link"),
    Noted("element", "is not represented: there is no resistance of the medium",
          "link/velocity_decay/**\nlink > enable_wind\nmodel > enable_wind\nworld > wind/** atmosphere/**"),
    Noted("element", "is not represented: there is no contact", "link > self_collide\nmodel > self_collide"),
    Noted("element", "is not represented: the state of a run is not taken", "world/state/**"),
    Noted("element", "is not represented, but for gravity before SDF 1.6: methods are those of the run",
          "world/physics/**"),
    Noted("element", "is not represented: the choice of method is that of the run",
          "model > allow_auto_disable"),
    Noted("element", "is not represented: a frame in a link or joint is not taken",
          "link/frame/**\njoint/frame/**\nlink/inertial/frame/**"),
    Noted("element", "is not represented: it matters to automatic inertias only",
          "link/inertial > density auto_inertia_params/**"),
    Noted(
        "element",
        "is not represented",
        """
        actor/**
        light/**
        plugin/**
        include/plugin/**
        model/plugin/**
        model/gripper/**
        link/sensor/**
        link/projector/**
        link/audio_sink/**
        link/audio_source/**
        link/battery/**
        link/light/**
        link/particle_emitter/**
        link/plugin/**
        world/actor/**
        world/audio/**
        world/gui/**
        world/light/**
        world/magnetic_field/**
        world/plugin/**
        world/road/**
        world/scene/**
        world/spherical_coordinates/**
        """,
    ),
)  # fmt: skip

REFUSED = (
    Refused("is not taken: write its models out", "world/population/**"),
    Refused(
        "", "include @ merge\nlink/inertial @ auto\nlink/inertial/pose @ frame relative_to", by_name=True
    ),
)

SDF = Coverage(
    REPRESENTED,
    NOTED,
    REFUSED,
    same={
        "world/model": "model",
        "model/model": "model",
        "model/link": "link",
        **{f"{around}/{tag}": tag for around in ("world", "model") for tag in ("include", "joint", "frame")},
        **{f"{around}/pose": "pose" for around in ("model", "include", "link", "joint", "frame")},
    },
    several="model link joint frame include link/visual",
)
