"""Poses beyond which the motion that drivers prescribe does not go on."""

from __future__ import annotations

from dataclasses import dataclass

from linkwork.constraints.crossing import SUSPICIOUS
from linkwork.constraints.equations import LISTED

__all__ = ["Impasse", "named"]


@dataclass(frozen=True)
class Impasse:
    """The pose beyond which no motion was found."""

    time: float  # [s]
    joints: list[str]  # whose equations depend on each other there, the strongest first
    sigma: float  # the smallest singular value
    driven: bool  # whether a driver asks for a velocity that they do not allow: u D = 0, and u Phi_t is not

    @property
    def dead(self) -> bool:
        return self.sigma < SUSPICIOUS

    def __str__(self) -> str:
        pose = "a dead point" if self.dead else "a pose"
        return (
            f"{pose} where the equations of {named(self.joints)} depend on each other (smallest singular "
            f"value {self.sigma:.2g})"
        )


def named(names: list[str]) -> str:
    return ", ".join(f"'{name}'" for name in names[:LISTED]) + (", ..." if len(names) > LISTED else "")
