"""Names for what a compiled MuJoCo model has: those of the file, and others where it gives none."""

from __future__ import annotations

from typing import TYPE_CHECKING

from linkwork.importers.names import free

if TYPE_CHECKING:
    import mujoco

__all__ = ["Names"]

#: What becomes bodies and what becomes joints, which need names of their own.
ROLES = {"body": "body", "joint": "joint", "equality": "joint"}


class Names:
    """By kind and number, which unnamed objects are called by. No two bodies or joints have the same."""

    def __init__(self, model: mujoco.MjModel) -> None:
        self._model = model
        self._taken: dict[str, set[str]] = {role: set() for role in ROLES.values()}
        self._names: dict[tuple[str, int], str] = {}
        objects = [(kind, k) for kind in ROLES for k in range(self._count(kind))]
        named = [it for it in objects if self._given(*it)]
        for kind, k in [*named, *objects]:  # what the file calls by a name keeps it
            if (kind, k) not in self._names:
                self._names[kind, k] = self.free(kind, self._given(kind, k) or f"{kind} {k}")

    def __call__(self, kind: str, index: int) -> str:
        return self._names.get((kind, index)) or self._given(kind, index) or f"{kind} {index}"

    def free(self, kind: str, wanted: str) -> str:
        """For one more body or joint: the name that is wanted, or with a number behind it."""
        taken = self._taken[ROLES[kind]]
        name = free(wanted, taken.__contains__)
        taken.add(name)
        return name

    def _count(self, kind: str) -> int:
        count: int = getattr(self._model, {"body": "nbody", "joint": "njnt", "equality": "neq"}[kind])
        return count

    def _given(self, kind: str, index: int) -> str:
        import mujoco

        object_type = getattr(mujoco.mjtObj, f"mjOBJ_{kind.upper()}")
        return mujoco.mj_id2name(self._model, object_type, index) or ""
