"""What is measured: a mechanism of a certain size."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from linkwork.errors import OptionError, nearest
from linkwork.mechanisms import Mechanism, named

if TYPE_CHECKING:
    from linkwork.modeling.model import Model


@dataclass(frozen=True)
class Subject:
    """A mechanism by name or file and the arguments of its function: small, for other processes."""

    mechanism: str
    parameters: Mapping[str, Any]

    @classmethod
    def of(
        cls,
        mechanism: str,
        bodies: int | None = None,
        parameters: Mapping[str, Any] | None = None,
        option: str = "bodies",
    ) -> Subject:
        """A registered mechanism with its parameters, or the largest with no more than so many bodies, which
        were given by an option of that name.

        OptionError: no such mechanism or parameter; none so small; `bodies` where there is one size only.
        """
        record = named(mechanism)
        chosen = dict(parameters or {})
        known = [parameter.name for parameter in record.parameters]
        for name in chosen:
            if name not in known:
                raise OptionError(
                    f"{mechanism}: no parameter '{name}'{nearest(name, known)}", code="unknown_option"
                )
        if bodies is not None:
            if record.size is None:
                raise OptionError(
                    f"{option} {bodies}: mechanism '{mechanism}' has one size only", code="one_size"
                )
            value = record.size.value_for(bodies)
            if (smallest := record.size.bodies(value)) > bodies:
                message = f"{option} {bodies}: the smallest '{mechanism}' has {smallest}"
                raise OptionError(message, code="bodies")
            chosen = {record.size.parameter: value} | chosen
        return cls(mechanism, chosen)

    @property
    def record(self) -> Mechanism:
        return named(self.mechanism)

    @property
    def step(self) -> float:
        """Recommended, or 1 ms where a file recommends none [s]."""
        return float(self.record.settings.get("step", 1e-3))

    @property
    def bodies(self) -> int:
        """How many it has. ModelError, OptionError: parameters that make no mechanism."""
        size = self.record.size
        if size is not None and size.parameter in self.parameters:
            return size.bodies(self.parameters[size.parameter])
        return self.build().body_count

    def build(self) -> Model:
        """The model. ModelError, OptionError: parameters that make no mechanism."""
        return self.record.function(**self.parameters)
