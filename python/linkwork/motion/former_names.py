"""What runs of earlier versions say of themselves, by the names of today."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from linkwork.options import renamed

__all__ = ["renamed_manifest", "renamed_statistics"]

#: Of what is known of a crossing of a singular pose.
CROSSING = {"taken_over": "fallback_evaluations"}


def renamed_manifest(manifest: Mapping[str, Any]) -> dict[str, Any]:
    parts = (part for part in ("options", "options_given") if part in manifest)
    return {**manifest, **{part: renamed(manifest[part]) for part in parts}}


def renamed_statistics(found: Mapping[str, Any]) -> dict[str, Any]:
    if "passages" not in found:
        return dict(found)
    crossings = [{CROSSING.get(name, name): x for name, x in one.items()} for one in found["passages"]]
    rest = {name: x for name, x in found.items() if name != "passages"}
    return {**rest, "singularity_crossings": crossings}
