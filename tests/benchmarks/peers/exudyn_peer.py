"""Exudyn: Euler parameters and Lagrange multipliers, implicit; open chains in joint coordinates, explicit.

Its explicit solvers take no joints other than those inside a kinematic tree. Redundant equations make its
matrix singular, so the ones that linkwork finds are left out of the joints.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import exudyn as exu
import numpy as np
from exudyn import itemInterface as items
from mechanism import GROUND, SPAN, Floats, Mechanism, deviation, spanning_tree
from operation import STEP, Builders, Operation, OutOfReach, beyond_first, calls, typical

DENSE_BODIES = 10  #: up to here the dense solver, Exudyn's default, is the faster one
ALIGNED = 0.1  #: a dropped equation along an inertial axis must be along a joint axis as exactly as this
LONGEST_FIRST_STEP = 5.0  #: [s] beyond which no further steps are made
SECOND_ORDER = 2e-3  #: tolerance, with the method's damping
SCHEMES = exu.DynamicSolverType


@dataclass(frozen=True)
class System:
    container: exu.SystemContainer  # which keeps the system alive
    main: exu.MainSystem
    velocities: Callable[[], Floats]  # of the bodies (n, 6): inertial, and omega in body axes


Build = Callable[[Mechanism], System | None]


def free_bodies(mechanism: Mechanism) -> System:
    """Bodies with Euler parameters, joined by Lagrange multipliers."""
    container = exu.SystemContainer()
    system = container.AddSystem()
    bodies = {GROUND: system.AddObject(items.ObjectGround())}
    for body in range(mechanism.body_count):
        bodies[body] = _body(mechanism, body, system)
    for joint in range(mechanism.joint_count):
        markers = [
            system.AddMarker(
                items.MarkerBodyRigid(
                    bodyNumber=bodies[int(mechanism.bodies[joint, side])],
                    localHT=_transformation(mechanism.frame[joint, side], mechanism.origin[joint, side]),
                )
            )
            for side in (0, 1)
        ]
        system.AddObject(_joint(mechanism, joint, markers))
    system.Assemble()

    def velocities() -> Floats:
        kinds = (exu.OutputVariableType.Velocity, exu.OutputVariableType.AngularVelocityLocal)
        each = range(mechanism.body_count)
        return np.array(
            [
                np.concatenate([system.GetObjectOutputBody(bodies[b], kind, [0, 0, 0]) for kind in kinds])
                for b in each
            ]
        )

    return System(container, system, velocities)


def _body(mechanism: Mechanism, body: int, system: exu.MainSystem) -> int:
    """With its weight; the number that it gets."""
    p, omega, J = mechanism.orientation[body], mechanism.omega[body], mechanism.inertia[body]
    p_dot = 0.5 * np.append(-p[1:] @ omega, p[0] * omega + np.cross(p[1:], omega))
    node = system.AddNode(
        items.NodeRigidBodyEP(
            referenceCoordinates=[*mechanism.position[body], *p],
            initialVelocities=[*mechanism.velocity[body], *p_dot],
        )
    )
    moments = [J[0, 0], J[1, 1], J[2, 2], J[1, 2], J[0, 2], J[0, 1]]
    number: int = system.AddObject(
        items.ObjectRigidBody(mass=mechanism.mass[body], inertia=moments, nodeNumber=node)
    )
    weight = system.AddMarker(items.MarkerBodyMass(bodyNumber=number))
    system.AddLoad(items.LoadMassProportional(markerNumber=weight, loadVector=mechanism.gravity))
    return number


def _transformation(rotation: Floats, translation: Floats) -> Floats:
    return np.block([[rotation, translation[:, None]], [np.zeros(3), 1.0]])


def _joint(mechanism: Mechanism, joint: int, markers: list[int]) -> object:
    """ValueError: a redundant equation that is none of a generic joint's."""
    if mechanism.kind[joint] == "spherical":
        return items.ObjectJointSpherical(markerNumbers=markers)
    redundant = mechanism.dependent[joint]
    if not redundant.any():
        return items.ObjectJointRevoluteZ(markerNumbers=markers)
    constrained = np.array([1, 1, 1, 1 - redundant[4], 1 - redundant[3], 0])
    axes = np.abs(mechanism.pose(int(mechanism.bodies[joint, 0]))[1] @ mechanism.frame[joint, 0])
    for along in np.nonzero(redundant[:3])[0]:
        nearest = int(np.argmax(axes[along]))
        if axes[along, nearest] < 1 - ALIGNED:
            raise ValueError(
                f"{mechanism.name}: a redundant equation of joint {joint} is along no joint axis"
            )
        constrained[nearest] = 0
    return items.ObjectJointGeneric(markerNumbers=markers, constrainedAxes=constrained.tolist())


@dataclass(frozen=True)
class _Links:
    """Of an open chain, from link to link: frames of joints, and what refers to them."""

    bodies: list[int]
    parents: list[int]  # numbers of links; -1: the ground
    carrier: dict[int, Floats]  # by body: the frame of the carrying joint in the body's
    transformations: list[Floats]
    inertias: list[Floats]
    centers: list[Floats]
    rates: list[float]


def _links(mechanism: Mechanism) -> _Links:
    branches, _ = spanning_tree(mechanism)
    number = {GROUND: -1} | {branch.body: k for k, branch in enumerate(branches)}
    parents = [number[branch.parent] for branch in branches]
    links = _Links([branch.body for branch in branches], parents, {GROUND: np.eye(4)}, [], [], [], [])
    for branch in branches:
        joint, side = branch.joint, branch.side
        outer, inner = (
            _transformation(mechanism.frame[joint, s], mechanism.origin[joint, s]) for s in (1 - side, side)
        )
        links.transformations.append(np.linalg.solve(links.carrier[branch.parent], outer))
        links.carrier[branch.body] = inner
        C = inner[:3, :3]
        links.inertias.append(C.T @ mechanism.inertia[branch.body] @ C)
        links.centers.append(-C.T @ inner[:3, 3])
        links.rates.append(mechanism.relative_omega(joint, side)[2])
    return links


def tree(mechanism: Mechanism) -> System | None:
    """An open chain of revolute joints in joint coordinates; None for other mechanisms."""
    if mechanism.has_loops or (mechanism.kind != "revolute").any():
        return None
    links = _links(mechanism)
    container = exu.SystemContainer()
    system = container.AddSystem()
    chain = _add_chain(mechanism, links, system)
    kinds = (exu.OutputVariableType.Velocity, exu.OutputVariableType.AngularVelocityLocal)
    sensors = {
        body: [
            system.AddSensor(
                items.SensorKinematicTree(
                    objectNumber=chain, linkNumber=k, localPosition=links.centers[k], outputVariableType=kind,
                    writeToFile=False,
                )
            )
            for kind in kinds
        ]
        for k, body in enumerate(links.bodies)
    }  # fmt: skip
    system.Assemble()

    def velocities() -> Floats:
        """From link axes to body axes."""
        found = np.array(
            [[system.GetSensorValues(it) for it in sensors[body]] for body in range(mechanism.body_count)]
        )
        for body in range(mechanism.body_count):
            found[body, 1] = links.carrier[body][:3, :3] @ found[body, 1]
        return found.reshape(-1, 6)

    return System(container, system, velocities)


def _add_chain(mechanism: Mechanism, links: _Links, system: exu.MainSystem) -> int:
    """With its coordinates; the number that it gets."""
    count = len(links.bodies)
    node = system.AddNode(
        items.NodeGenericODE2(
            referenceCoordinates=np.zeros(count),
            initialCoordinates=np.zeros(count),
            initialCoordinates_t=links.rates,
            numberOfODE2Coordinates=count,
        )
    )
    number: int = system.AddObject(
        items.ObjectKinematicTree(
            nodeNumber=node,
            gravity=mechanism.gravity,
            jointTypes=[exu.JointType.RevoluteZ] * count,
            linkParents=links.parents,
            jointHTs=links.transformations,
            linkInertiasCOM=exu.Matrix3DList(links.inertias),
            linkCOMs=exu.Vector3DList(links.centers),
            linkMasses=[mechanism.mass[body] for body in links.bodies],
        )
    )
    return number


def _solver(mechanism: Mechanism, system: System, scheme: exu.DynamicSolverType) -> Callable[[int], None]:
    """What makes so many steps from the initial state. RuntimeError: the solver failed."""
    dense = mechanism.body_count <= DENSE_BODIES
    return partial(_solve, system.main, scheme, dense)


def _solve(system: exu.MainSystem, scheme: exu.DynamicSolverType, dense: bool, steps: int) -> None:
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = steps
    settings.timeIntegration.endTime = steps * STEP
    settings.timeIntegration.verboseMode = 0
    settings.timeIntegration.stepInformation = 0
    settings.solution.file.write = False
    settings.solution.sensors.active = False
    settings.show.globalTimers = False
    settings.parallel.numberOfThreads = 1
    kinds = exu.LinearSolverType
    settings.linearSolver.solverType = kinds.EXUdense if dense else kinds.EigenSparse
    if not system.SolveDynamic(settings, solverType=scheme):
        raise RuntimeError(f"Exudyn's {scheme} failed within {steps} steps")


def first_step(build: Build, scheme: exu.DynamicSolverType, mechanism: Mechanism) -> Operation | None:
    """The solver's initialization and one step, on an assembled system."""
    system = build(mechanism)
    if system is None:
        return None
    batch = calls(partial(_solver(mechanism, system, scheme), 1))
    return Operation(partial(typical, batch), "first step", None, 0.0, "initialization and a step")


def step(
    build: Build, scheme: exu.DynamicSolverType, tolerance: float, mechanism: Mechanism
) -> Operation | None:
    """A step of many: what more steps take beyond the first few."""
    system = build(mechanism)
    if system is None:
        return None
    solve = _solver(mechanism, system, scheme)
    first = calls(partial(solve, 1))(1)
    if first > LONGEST_FIRST_STEP:
        raise OutOfReach(f"its first step took {first:.0f} s")

    solve(round(SPAN / STEP))
    found = (system.velocities() - mechanism.v) / SPAN

    return Operation(
        partial(beyond_first, lambda count: calls(partial(solve, count))(1)),
        "rk4 step",
        deviation(found, mechanism.mean_acceleration),
        tolerance,
        "beyond the first steps",
    )


OPERATIONS: Builders = {
    "generalized alpha step": partial(step, free_bodies, SCHEMES.GeneralizedAlpha, SECOND_ORDER),
    "generalized alpha first step": partial(first_step, free_bodies, SCHEMES.GeneralizedAlpha),
    "RK44 step of a tree": partial(step, tree, SCHEMES.RK44, 1e-6),
}
