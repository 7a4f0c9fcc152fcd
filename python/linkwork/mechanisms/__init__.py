"""Example mechanisms: each is a function in a file of its own that builds a model, registered by one name.

lw.simulate(lw.mechanisms.chain(100), t_end=1.0, step=1e-3)
"""

from __future__ import annotations

from linkwork.errors import OptionError, nearest
from linkwork.mechanisms.andrews import ANDREWS, andrews
from linkwork.mechanisms.bennett import BENNETT, bennett
from linkwork.mechanisms.binary_tree import BINARY_TREE, binary_tree
from linkwork.mechanisms.bricard import BRICARD, bricard
from linkwork.mechanisms.capture_net import CAPTURE_NET, capture_net
from linkwork.mechanisms.chain import CHAIN, chain
from linkwork.mechanisms.delta_robot import DELTA_ROBOT, delta_robot
from linkwork.mechanisms.double_wishbone import DOUBLE_WISHBONE, double_wishbone
from linkwork.mechanisms.flyball_governor import FLYBALL_GOVERNOR, flyball_governor
from linkwork.mechanisms.four_bar import FOUR_BAR, four_bar
from linkwork.mechanisms.from_file import is_file, is_model_file, mechanism_of_file
from linkwork.mechanisms.gyroscope import GYROSCOPE, gyroscope
from linkwork.mechanisms.heavy_top import HEAVY_TOP, heavy_top
from linkwork.mechanisms.hexagonal_net import HEXAGONAL_NET, hexagonal_net
from linkwork.mechanisms.hub import HUB, hub
from linkwork.mechanisms.hub_net import HUB_NET, hub_net
from linkwork.mechanisms.lattice import LATTICE, lattice
from linkwork.mechanisms.mechanism import Mechanism, Parameter, Size
from linkwork.mechanisms.net import NET, net
from linkwork.mechanisms.pendulum import PENDULUM, pendulum
from linkwork.mechanisms.planetary_gear import PLANETARY_GEAR, planetary_gear
from linkwork.mechanisms.rod_pendulum import ROD_PENDULUM, rod_pendulum
from linkwork.mechanisms.rods import square_rod, thin_rod
from linkwork.mechanisms.rolling_disc import ROLLING_DISC, rolling_disc
from linkwork.mechanisms.rope import ROPE, rope
from linkwork.mechanisms.scissors import SCISSORS, scissors
from linkwork.mechanisms.six_bars import STEPHENSON_SIX_BAR, WATT_SIX_BAR, stephenson_six_bar, watt_six_bar
from linkwork.mechanisms.spatial_slider_crank import SPATIAL_SLIDER_CRANK, spatial_slider_crank
from linkwork.mechanisms.stewart_platform import STEWART_PLATFORM, stewart_platform
from linkwork.mechanisms.strandbeest_leg import STRANDBEEST_LEG, strandbeest_leg
from linkwork.mechanisms.torque_free_top import TORQUE_FREE_TOP, torque_free_top
from linkwork.mechanisms.tracked_chain import TRACKED_CHAIN, tracked_chain
from linkwork.mechanisms.tracked_vehicle import TRACKED_VEHICLE, tracked_vehicle

__all__ = [
    "MECHANISMS", "Mechanism", "Parameter", "Size", "andrews", "bennett", "binary_tree", "bricard",
    "capture_net", "chain", "delta_robot", "double_wishbone", "flyball_governor", "four_bar",
    "gyroscope", "heavy_top", "hexagonal_net", "hub", "hub_net", "is_file", "is_model_file", "lattice",
    "named", "net", "pendulum", "planetary_gear", "rod_pendulum", "rolling_disc", "rope", "scissors",
    "spatial_slider_crank", "square_rod", "stephenson_six_bar", "stewart_platform", "strandbeest_leg",
    "thin_rod", "torque_free_top", "tracked_chain", "tracked_vehicle", "watt_six_bar",
]  # fmt: skip

MECHANISMS: dict[str, Mechanism] = {
    mechanism.name: mechanism
    for mechanism in (
        PENDULUM, ROD_PENDULUM, CHAIN, BINARY_TREE, HUB, HEAVY_TOP, TORQUE_FREE_TOP, FOUR_BAR, ANDREWS,
        BRICARD, FLYBALL_GOVERNOR, SPATIAL_SLIDER_CRANK, NET, WATT_SIX_BAR, STEPHENSON_SIX_BAR,
        STRANDBEEST_LEG, BENNETT, GYROSCOPE, PLANETARY_GEAR, ROLLING_DISC, STEWART_PLATFORM, DELTA_ROBOT,
        DOUBLE_WISHBONE, TRACKED_CHAIN, HUB_NET, HEXAGONAL_NET, CAPTURE_NET, LATTICE, ROPE, SCISSORS,
        TRACKED_VEHICLE,
    )
}  # fmt: skip


def named(name: str) -> Mechanism:
    """The mechanism of this name, or in the file of this name.

        model = lw.mechanisms.named("chain").function(10)

    OptionError: no such mechanism. FileError.
    """
    if name in MECHANISMS:
        return MECHANISMS[name]
    if is_file(name):
        return mechanism_of_file(name)
    raise OptionError(f"no mechanism '{name}'{nearest(name, MECHANISMS)}", code="unknown_mechanism")
