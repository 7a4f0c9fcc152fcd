"""Comparisons: one model by every method, errors measured against a reference solution.

comparison = lw.compare("spatial_slider_crank", 2.0, steps=[1e-2, 5e-3, 2.5e-3])
print(comparison)
comparison.to_html("comparison.html")
"""

from __future__ import annotations

from linkwork.comparison.choices import DEFAULT_CHOICES, Choice
from linkwork.comparison.comparing import compare
from linkwork.comparison.runs import Outcome
from linkwork.comparison.table import Comparison

__all__ = ["DEFAULT_CHOICES", "Choice", "Comparison", "Outcome", "compare"]
