"""The choices of a run. What a choice cannot do is refused with the reason, never ignored.

What there is to choose is said once, in the compiled module's table (formulation/options.def).
"""

from linkwork.options.settings import *
from linkwork.options.table import *
