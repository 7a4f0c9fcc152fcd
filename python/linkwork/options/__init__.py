"""The choices of a run. What a choice cannot do is refused with the reason, never ignored.

What there is to choose is said once, in the compiled module's table (formulation/options.def).
"""

from linkwork.options.table import (
    LEVELS,
    RENAMED,
    RUN_SETTINGS,
    TABLE,
    Policy,
    check_name,
    check_number,
    check_option,
    compile_options,
    names,
    renamed,
)
from linkwork.options.types import Level, Options

__all__ = [
    "LEVELS",
    "Level",
    "Options",
    "Policy",
    "RENAMED",
    "RUN_SETTINGS",
    "TABLE",
    "check_name",
    "check_number",
    "check_option",
    "compile_options",
    "names",
    "renamed",
]
