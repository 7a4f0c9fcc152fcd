"""The chain of linkwork by MuJoCo, whose `rollout` steps many of them on several threads."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from functools import partial
from typing import Any

import numpy as np

from linkwork.arrays import Floats
from linkwork.errors import LinkworkError
from linkwork.modeling.model import Model

__all__ = ["rollouts"]

Measure = Callable[[], float]

#: Chains that are stepped at a time for each thread, and how often.
BATCH, STEPS = 32, 50

#: Accelerations are the same within this, relative to the largest.
AGREES = 1e-8


@contextmanager
def rollouts(model: Model, turning: Floats, threads: Sequence[int]) -> Iterator[dict[int, Measure]]:
    """Measures by threads: wall time of one step of one chain, one evaluation by Euler's method [s].

    model    linkwork's chain of rods of 1 m along x, joined by hinges about y
    turning  the angular acceleration of each link about y by linkwork [rad/s2], at rest

    No measures without threads or MuJoCo. LinkworkError: it has other accelerations.
    """
    try:
        import mujoco
        from mujoco import rollout
    except ImportError:
        threads = ()
    if not threads:
        yield {}
        return
    own = mujoco.MjModel.from_xml_string(_mjcf(model))
    data = [mujoco.MjData(own) for _ in range(max(threads))]
    mujoco.mj_forward(own, data[0])
    apart = float(np.abs(np.cumsum(data[0].qacc) - turning).max()) / float(np.abs(turning).max())
    if not apart < AGREES:
        raise LinkworkError(f"chain: MuJoCo gives other accelerations, {apart:.1e} off", code="peer")
    kind: Any = mujoco.mjtState.mjSTATE_FULLPHYSICS
    start = np.zeros(mujoco.mj_stateSize(own, kind))
    mujoco.mj_getState(own, data[0], start, kind)

    def measure(pool: Any, count: int) -> float:
        many = np.tile(start, (BATCH * count, 1))
        started = time.perf_counter()
        pool.rollout(own, data[:count], many, nstep=STEPS)
        return (time.perf_counter() - started) / (len(many) * STEPS)

    with ExitStack() as pools:
        found: dict[int, Measure] = {}
        for count in threads:
            pool = pools.enter_context(rollout.Rollout(nthread=count if count > 1 else 0))
            found[count] = partial(measure, pool, count)
        yield found


def _mjcf(model: Model) -> str:
    """Nested bodies, each with its frame at its hinge; nothing touches."""
    core = model.compiled()
    mass, inertia = np.asarray(core.mass), np.asarray(core.inertia).reshape(-1, 3, 3)
    text = ""
    for k in reversed(range(model.body_count)):
        moments = " ".join(f"{inertia[k, c, c]:.17g}" for c in range(3))
        text = (
            f'<body pos="{1.0 if k else 0.0} 0 0"><joint type="hinge" axis="0 1 0"/>'
            f'<inertial pos="0.5 0 0" mass="{mass[k]:.17g}" diaginertia="{moments}"/>{text}</body>'
        )
    return (
        '<mujoco><option timestep="1e-6" integrator="Euler" gravity="0 0 -9.81">'
        '<flag contact="disable" constraint="disable" eulerdamp="disable"/></option>'
        f"<worldbody>{text}</worldbody></mujoco>"
    )
