"""Models in files: YAML 1.2 (.yaml, .yml) and JSON (.json) by one published schema; `linkwork schema` prints
it.

    model = lw.Model.load("crank.yaml")
    model.save("crank.json")

SI units, angles in rad. Positions and velocities are inertial, `omega` and the inertia refer to body axes
through the center of mass, orientations are Euler parameters, scalar first. A file is checked as a whole
before a model is made of it; ModelFileError has all its faults, each with line and field.
"""

from __future__ import annotations

from linkwork.modeling.files.reading import ModelFile, from_changed_record, from_record, read
from linkwork.modeling.files.schema import json_schema
from linkwork.modeling.files.syntax import SUFFIXES
from linkwork.modeling.files.writing import record_of, whole_record, write

__all__ = [
    "SUFFIXES",
    "ModelFile",
    "from_changed_record",
    "from_record",
    "json_schema",
    "read",
    "record_of",
    "whole_record",
    "write",
]
