"""What becomes of the elements and attributes of MJCF. The syntax is that of linkwork.importers.coverage."""

from linkwork.importers.coverage import Coverage, Noted, Refused

__all__ = ["MJCF"]

REPRESENTED = """
    @ model

    compiler: alignfree angle assetdir autolimits balanceinertia boundinertia boundmass conflict coordinate
    compiler @ discardvisual eulerseq fitaabb fusestatic inertiafromgeom inertiagrouprange meshdir passthrough
    compiler @ savecanonical savecompiled saveinertial settotalmass strippath texturedir usethread
    extension/**

    option: gravity
    option/flag: constraint contact damper equality frictionloss gravity limit spring

    default: class
    default/tendon/**
    default/equality: active

    asset
    asset/mesh: builtin class content_type face file inertia maxhullvert name normal params
    asset/mesh @ refpos refquat scale smoothnormal texcoord vertex
    asset/mesh @ material
    asset/mesh/plugin/**
    asset/texture/**
    asset/material: class name rgba texture
    asset/model: content_type file name

    body: name pos quat axisangle euler xyaxes zaxis childclass fuse gravcomp simple
    body/replicate: count offset euler sep
    body/attach: body frame model prefix
    body/inertial: pos quat axisangle euler xyaxes zaxis mass diaginertia fullinertia
    body/joint: name class type pos axis ref springref stiffness springdamper damping armature frictionloss
    body/joint @ actuatorgravcomp
    body/freejoint: name align
    body/geom: name class type pos quat axisangle euler xyaxes zaxis fromto size hfield mesh fitscale
    body/geom @ mass density shellinertia group material rgba
    body/geom/plugin/**
    body/site: name class pos quat axisangle euler xyaxes zaxis fromto mesh

    deformable
    equality
    equality/connect: name class active body1 body2 anchor site1 site2
    equality/weld: name class active body1 body2 anchor site1 site2 relpose torquescale
    equality/joint: name class active joint1 joint2 polycoef

    actuator
    actuator/general: name class joint jointinparent gear armature damping
"""

NOTED = (
    Noted(
        "simulator",
        "settings of MuJoCo's own simulation are not taken",
        """
        compiler/lengthrange/**
        option @ ccd_iterations ccd_tolerance cone impratio integrator iterations jacobian ls_iterations
        option @ ls_tolerance noslip_iterations noslip_tolerance sdf_initpoints sdf_iterations solver timestep
        option @ tolerance
        option/flag @ autoreset diagexact energy eulerdamp filterparent fwdinv invdiscrete ipc island midphase
        option/flag @ multiccd nativeccd refsafe sensor speculative warmstart clampctrl
        size/**
        statistic/**
        """,
    ),
    Noted(
        "appearance",
        "that is not represented: shapes have one color",
        """
        visual/**
        asset/hfield/**
        asset/material @ emission metallic reflectance roughness shininess specular texrepeat texuniform
        asset/material/layer/**
        asset/skin/**
        body/camera/**
        body/light/**
        body/freejoint @ group
        body/joint @ group
        body/geom @ castshadow
        body/site @ group material rgba size type
        deformable/skin/**
        """,
    ),
    Noted("sensor", "sensors are not represented", "sensor/**\noption @ magnetic"),
    Noted("keyframe", "states in the file are not taken: give `coordinates` and `velocities`", "keyframe/**"),
    Noted(
        "custom",
        "users' data are not represented",
        "custom/**\nbody @ user\nbody/joint @ user\nbody/geom @ user\nbody/site @ user",
    ),
    Noted("mocap", "a body that is moved from outside stands where it is in the file", "body @ mocap"),
    Noted("plasticity", "springs that yield stay elastic here", "body/joint @ springyield"),
    Noted(
        "limits",
        "",
        "body/joint @ limited range margin solimplimit solreflimit",
        by_name=True,
    ),
    Noted("friction", "", "body/joint @ solimpfriction solreffriction", by_name=True),
    Noted("sleep", "", "body @ sleep\noption @ sleep_tolerance\noption/flag @ sleep", by_name=True),
    Noted("medium", "", "option @ density viscosity wind\nbody/geom @ fluidcoef fluidshape", by_name=True),
    Noted(
        "contact",
        "",
        """
        option @ o_friction o_margin o_solimp o_solref
        option/flag @ override
        body/geom @ adhesion conaffinity condim contype friction gap margin priority solimp solmix solref
        body/geom @ surfacevel
        contact/**
        """,
        by_name=True,
    ),
    Noted(
        "equality",
        "",
        """
        default/equality @ solimp solref
        equality/connect @ solimp solref
        equality/weld @ solimp solref
        equality/joint @ solimp solref
        equality/tendon/**
        equality/flex/**
        equality/flexstrain/**
        """,
        by_name=True,
    ),
    Noted(
        "actuator",
        "",
        """
        option @ actuatorgroupdisable
        option/flag @ actuation
        body/joint @ actuatorfrclimited actuatorfrcrange
        actuator/general @ actdim actearly actlimited actrange area bias biasprm biastype
        actuator/general @ body cogging controller cranklength cranksite ctrllimited ctrlrange dampratio delay
        actuator/general @ diameter dynprm dyntype ffrange force forcelimited forcerange
        actuator/general @ fpmax fvmax gain gainprm gaintype group imax
        actuator/general @ inductance inheritrange input instance interp ki kp kv lengthrange lmax lmin lugre
        actuator/general @ motorconst nominal nsample plugin posrange range refsite resistance
        actuator/general @ saturation scale site slewmax slidersite tausmooth
        actuator/general @ tendon thermal timeconst user velrange vmax
        actuator/general/config/**
        """,
        by_name=True,
    ),
)

REFUSED = (
    Refused("forces of plugins are not taken: remove it, or model it here", "body/plugin/**"),
    Refused("", "tendon/**\nbody/flexcomp/**\ndeformable/flex/**", by_name=True),
)

ACTUATORS = """motor position velocity intvelocity orientation pid damper cylinder muscle adhesion dcmotor
               plugin""".split()

MJCF = Coverage(
    REPRESENTED,
    NOTED,
    REFUSED,
    same={
        "worldbody": "body",
        "body/body": "body",
        "body/frame": "body",
        "default/default": "default",
        **{f"actuator/{kind}": "actuator/general" for kind in ACTUATORS},
        **{f"default/{kind}": "actuator/general" for kind in ["general", *ACTUATORS]},
        **{f"default/{kind}": f"asset/{kind}" for kind in ("mesh", "texture", "material")},
        **{f"default/{kind}": f"body/{kind}" for kind in ("joint", "geom", "site", "camera", "light")},
        "default/pair": "contact/pair",
    },
    inside={"body/replicate": "body"},
    texts=False,
)
