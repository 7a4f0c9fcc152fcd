"""The large models: mechanisms, with the sizes in which they are measured."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from linkwork.arguments import whole
from linkwork.benchmark.subject import Subject
from linkwork.errors import OptionError, nearest

__all__ = ["LARGE_MODELS", "SIZES", "LargeModel", "large_subjects"]

#: small: some hundred bodies, so that all models together take minutes; full: as they are published.
SIZES = ("small", "full")

Parameters = Mapping[str, Any]


@dataclass(frozen=True)
class LargeModel:
    """A mechanism that is measured by its error against time."""

    name: str
    mechanism: str
    small: Parameters
    full: Sequence[Parameters]
    t_end: float  #: [s]
    step: float  #: the longest that is tried [s]
    always: Parameters | None = None  #: parameters in any size

    def subjects(self, size: str, links: int | None) -> list[Subject]:
        """In one of the SIZES, or the largest with no more bodies than that. OptionError: none so small."""
        always = dict(self.always or {})
        if links is not None and Subject.of(self.mechanism).record.size is not None:
            return [Subject.of(self.mechanism, links, always, "links")]
        chosen = [self.small] if size == "small" else self.full
        return [Subject.of(self.mechanism, None, {**it, **always}) for it in chosen]


#: Names and sizes of the published models; what is not published of them is ours, see each mechanism.
LARGE_MODELS: dict[str, LargeModel] = {
    model.name: model
    for model in (
        LargeModel("net", "hub_net", {"n": 10}, [{"n": 100}], 0.2, 2e-2),
        LargeModel(
            "chain", "chain", {"bodies": 300}, [{"bodies": n} for n in (10_000, 100_000, 1_076_748)],
            0.4, 4e-2, {"joint": "spherical"},
        ),
        LargeModel("lattice", "lattice", {"n": 3}, [{"n": 10}, {"n": 20}], 0.2, 4e-2),
        LargeModel("hexagonal net", "hexagonal_net", {"rings": 5}, [{"rings": 14}], 0.4, 2e-2),
        LargeModel("net capture", "capture_net", {"n": 9}, [{"n": 100}], 0.1, 1e-3),
        LargeModel(
            "scissors", "scissors", {"arms": 6, "units": 10}, [{"arms": 100, "units": 50}], 0.5, 0.1
        ),
        LargeModel("tracked vehicle", "tracked_vehicle", {"shoes": 60}, [{"shoes": 90}], 0.1, 2e-4),
        LargeModel("rope", "rope", {"links": 300}, [{"links": 100_000}], 0.2, 4e-3),
        LargeModel("ladder", "four_bar", {"n": 100}, [{"n": 100_000}], 0.4, 4e-2),
    )
}  # fmt: skip


def large_subjects(
    names: Sequence[str] = (), size: str = "small", links: int | None = None
) -> list[tuple[LargeModel, Subject]]:
    """All models, or those of these names. OptionError: a name or size that does not exist, or no model of so
    few links.
    """
    if links is not None:
        whole(links, 1, "links")
    if size not in SIZES:
        raise OptionError(f"size '{size}' is not available{nearest(size, SIZES)}", code="unknown_option")
    for name in names:
        if name not in LARGE_MODELS:
            raise OptionError(
                f"no large model '{name}'{nearest(name, list(LARGE_MODELS))}", code="unknown_model"
            )
    chosen = [LARGE_MODELS[name] for name in names or LARGE_MODELS]
    return [(model, subject) for model in chosen for subject in model.subjects(size, links)]
