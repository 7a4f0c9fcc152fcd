"""Forces of the user's own: functions of Python, laws along a joint's coordinate, compiled functions."""

from __future__ import annotations

import ctypes
import secrets
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from linkwork import arguments, functions
from linkwork.arrays import Floats
from linkwork.errors import ModelError
from linkwork.fingerprints import called_from_ctypes, law
from linkwork.functions import TimeFunction, as_time_function
from linkwork.functions.calls import Calls
from linkwork.functions.compiled_law import CompiledLaw
from linkwork.modeling.coordinates import coordinate_of
from linkwork.modeling.handles import BodiesLike, Body, BodyLike, Joint

if TYPE_CHECKING:
    from linkwork.modeling.builder import ModelBuilder

__all__ = ["UserForce", "UserForceMethods"]


@dataclass(frozen=True)
class UserForce:
    """A force of the user's own, as it was added."""

    law: Any  #: whose code counts
    place: str  #: bodies, or joint and coordinate, by number
    record: Mapping[str, Any]  #: kind (the method of Model that adds it) and arguments; bodies, joint by name
    calls: Calls | None = None  #: of its law; None: nobody can look at what it remembers
    data: Any = None  #: what a compiled law is given, whose content counts

    def fingerprint(self) -> str:
        """Equal for equal laws at equal places, whatever their names."""
        return " ".join([law(self.law), self.place, *([] if self.data is None else [law(self.data)])])

    @property
    def reaching(self) -> Any:
        """What reaches all that its law reads."""
        return self.law if self.calls is None else self.calls.function

    @property
    def name(self) -> str:
        return str(self.record["name"])

    @property
    def counts_bodies(self) -> bool:
        """Its law gets all bodies of the model, by number."""
        return "joint" not in self.record and self.record.get("bodies") is None

    def check_leaves(self) -> None:
        """ModelError: it is known by an address, which is that of this process."""
        if self.record["kind"] == "compiled_force":
            raise ModelError(
                f"'{self.name}' is a compiled force, whose address is that of this process: build the model "
                "in the other one, by a function build(**parameters)",
                code="not_data",
            )

    @staticmethod
    def add(model: ModelBuilder, record: Mapping[str, Any]) -> None:
        """As it was added to another model. ModelError: what its method refuses."""
        getattr(model, record["kind"])(**{what: x for what, x in record.items() if what != "kind"})


class UserForceMethods:
    """The methods of Model that add forces which the user computes."""

    def user_force(
        self,
        function: Callable[..., ArrayLike],
        bodies: BodyLike | BodiesLike | None = None,
        *,
        vectorized: bool = False,
        breaks: ArrayLike = (),
        name: str | None = None,
    ) -> None:
        """Let a Python function apply forces: one call an evaluation, for all its bodies at once.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.user_force(lambda t, q, v: [0, 0, -0.3 * abs(v[2]) * v[2], 0, 0, 0], body)   # drag

        bodies      without them all n of the model
        function    of t [s], q (n, 7) and v (n, 6) of these bodies, which returns (n, 6): force [N],
                    inertial, and torque [N m] about the center of mass, in body axes; of one body (7,), (6,)
                    and (6,).
                    Within a step the Euler parameters may be off unit length by little
        vectorized  the function is one of k mechanisms at once, t (k,), q (k, n, 7) and v (k, n, 6), and
                    returns (k, n, 6); of one body (k, 7), (k, 6) and (k, 6). An ensemble calls it once for
                    all members that run side by side and have this same function, a run by itself with
                    k = 1. What it returns of a mechanism must not depend on the others, to the last bit:
                    operations on elements do not
        breaks      times [s] at which it is not smooth: steps that follow tolerances end there

        All its power counts as work. Python in the loop costs microseconds an evaluation and keeps other
        threads out: see `compiled_force`.

        ModelError: not a function of (t, q, v), no such body; at run time: a wrong shape.
        """
        model = cast("ModelBuilder", self)
        name = model._named(name, "user force", len(model._user_forces))
        if not callable(function):
            raise ModelError(f"user force '{name}': {function!r} is not a function", code="not_callable")
        if not isinstance(vectorized, bool):
            raise ModelError(
                f"user force '{name}': vectorized is {vectorized!r:.80}, not True or False", code="vectorized"
            )
        arguments.check_called(function, ("t", "q", "v"), f"user force '{name}'")
        calls = Calls(function)
        whole, place, chosen = calls.ask, "", []
        named: str | list[str] | None = None
        if bodies is not None:
            single, indices = isinstance(bodies, Body | str), model.indices(bodies)
            whole, place = _on_bodies(calls.ask, indices, single, name), f"bodies {list(indices)}"
            chosen = [int(single), *indices.tolist()]
            names = [model._core.body_name(body) for body in indices.tolist()]
            named = names[0] if single else names
        times = functions.check_breaks(breaks, f"user force '{name}'")
        model._core.add_user_force(name, whole, (function, chosen) if vectorized else None)
        model._core.add_breaks(times)
        record = {"kind": "user_force", "name": name, "bodies": named, "function": function,
                  "vectorized": vectorized, "breaks": times}  # fmt: skip
        model._user_forces.append(UserForce(function, place, record, calls))

    def joint_force(
        self,
        joint: Joint | str,
        function: Callable[[float, float, float], float] | TimeFunction | float,
        *,
        coordinate: str | None = None,
        breaks: ArrayLike = (),
        name: str | None = None,
    ) -> None:
        """Let a law of your own act along a free coordinate of a joint: a controller, a clutch, friction.

            body = model.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1), position=(1, 0, 0))
            model.revolute("ground", body, at=(0, 0, 0), axis=(0, 0, 1), name="pin")
            model.joint_force("pin", lambda t, angle, rate: 3.0 * (0.5 - angle) - 0.2 * rate)

        function    a Python function of t [s], the coordinate x and its rate, which returns the force [N] or
                    torque [N m] Q that does the work Q dx: it acts on b, and back on a. Or Q as a number or a
                    function of time, such as linkwork.functions.table(t, torques)
        coordinate  as `Result.coordinate` names it; not needed where the joint has only one. Angles are
                    within half a turn of zero at the initial pose and go on over full turns
        breaks      times [s] at which it is not smooth: steps that follow tolerances end there

        All its power counts as work. A Python function costs about a microsecond an evaluation, a function of
        time much less. For compiled laws see the force elements and `compiled_force`.

        ModelError: no such joint or coordinate, no law, or one of other arguments; at run time: it returned
        no number.
        """
        model = cast("ModelBuilder", self)
        index, text = model._joint_named(joint, "joint_force")
        name = model._named(name, "joint force", len(model._user_forces))
        which = coordinate_of(model._core.joint_kind(index), text, coordinate)
        law: Any = function if callable(function) else _effort(function, name)
        if not isinstance(law, TimeFunction):
            arguments.check_called(law, ("t", "x", "x_dot"), f"joint force '{name}'")
        calls = None if isinstance(law, TimeFunction) else Calls(law)
        compiled = law.compiled() if calls is None else calls.ask
        times = functions.check_breaks(breaks, f"joint force '{name}'")
        model._core.add_joint_force(name, index, which, compiled)
        model._core.add_breaks(times)
        record = {"kind": "joint_force", "name": name, "joint": text, "coordinate": which,
                  "function": law, "breaks": times}  # fmt: skip
        model._user_forces.append(UserForce(law, f"{index} {which}", record, calls))
        if isinstance(law, TimeFunction):
            model._signals.append((f"joint force '{name}'", law))

    def compiled_force(
        self, function: Any, *, data: Any = 0, breaks: ArrayLike = (), name: str | None = None
    ) -> None:
        """Let a compiled function apply forces; it runs without Python.

            from ctypes import CFUNCTYPE, POINTER, c_double, c_int64, c_void_p
            numbers = POINTER(c_double)
            @CFUNCTYPE(None, c_double, c_int64, numbers, numbers, numbers, c_void_p)
            def wind(t, n, q, v, g, data):
                g[0] += 2.0  # force along x on the first body [N]
            model.compiled_force(wind)

        function  void f(double t, int64_t n, const double *q, const double *v, double *g, void *data), which
                  adds to g (n, 6) what it applies to all n bodies, q (n, 7), v (n, 6), as for `user_force`:
                  an address, a function of ctypes, or a numba.cfunc of float64, int64, three pointers to
                  float64 and one to void
        data      what it gets the address of: an array of NumPy, or a number, array or structure of ctypes,
                  which the model keeps and whose content counts in `Model.hash`. Or an address, of which
                  nobody knows what is there: such a model is that of no other process; what is there must
                  live as long as the model, and not be changed between runs that are compared
        breaks    times [s] at which it is not smooth: steps that follow tolerances end there

        ModelError: nothing that has an address, or takes something else.
        """
        model = cast("ModelBuilder", self)
        name = model._named(name, "compiled force", len(model._user_forces))
        at = _address_of_data(data, name)
        times = functions.check_breaks(breaks, f"compiled force '{name}'")
        record = {"kind": "compiled_force", "name": name, "function": function, "data": data, "breaks": times}
        address = _address(function, name)
        if (safe := _guarded(function)) is not function:
            function, address = safe, _address(safe, name)
        model._core.add_compiled_force(name, address, at)
        model._core.add_breaks(times)
        place = _HERE if isinstance(function, int) else ""
        known = (_HERE, at) if isinstance(data, int | np.integer) else data
        law = CompiledLaw(function, address, data, at)
        calls = Calls(law) if law.may_remember else None
        model._user_forces.append(own := UserForce(function, place, record, calls, known if at else None))
        own.fingerprint()  # compiled as it is now


def _effort(law: object, name: str) -> TimeFunction:
    """A law that is a function of time alone. ModelError: it is none."""
    if isinstance(law, TimeFunction):
        return law
    if isinstance(law, int | float | np.number):
        return functions.constant(as_time_function(law, f"joint force '{name}'"))  # type: ignore[arg-type]
    wanted = "not a function of (t, x, x_dot), a function of time, or a number"
    raise ModelError(f"joint force '{name}': {law!r:.80} is {wanted}", code="not_callable")


def _on_bodies(
    function: Callable[..., ArrayLike], bodies: NDArray[np.int32], single: bool, name: str
) -> Callable[..., Floats]:
    """A force on some bodies as one on all."""
    if not len(bodies) or len(bodies) != len(np.unique(bodies)) or (bodies < 0).any():
        why = "must be one or more that differ, without the ground"
        raise ModelError(f"user force '{name}': its bodies {why}", code="bodies")
    chosen: Any = int(bodies[0]) if single else bodies

    def whole(t: float | Floats, q: Floats, v: Floats) -> Floats:
        out = np.zeros_like(v)
        returned = function(t, q[..., chosen, :], v[..., chosen, :])
        try:
            force = arguments.reals(returned)
        except arguments.UNREADABLE as error:
            why = f"returned {returned!r:.80} at t = {np.ravel(t)[0]:g} s, not an array of numbers"
            raise ModelError(f"user force '{name}': {why}", code="not_a_number") from error
        if force.shape != out[..., chosen, :].shape:
            wanted = f"returned shape {force.shape}, not {out[..., chosen, :].shape}"
            raise ModelError(f"user force '{name}': {wanted}", code="shape")
        out[..., chosen, :] = force
        return out

    return whole


#: Addresses say something in this process alone.
_HERE = secrets.token_hex(8)

#: Of a compiled force: t, n, q, v, g and data, as numba calls them.
_NUMBA = ("float64", "int64", "float64*", "float64*", "float64*", "void*")


def _address(function: Any, name: str) -> int:
    """Of a C function: a number, a numba.cfunc, or a function of ctypes."""
    if isinstance(function, int):
        return arguments.whole(function, 1, f"compiled force '{name}': address", ModelError)
    if isinstance(getattr(function, "address", None), int):
        _check_signature(tuple(map(str, function._sig.args)) == _NUMBA, str(function._sig), name)
        return int(function.address)
    try:
        address = ctypes.cast(function, ctypes.c_void_p).value
    except (TypeError, ctypes.ArgumentError):
        address = None
    if address and not isinstance(function, str | bytes):
        given = getattr(function, "argtypes", None)  # of a library's, unless somebody has said so
        _check_signature(given is None or _takes(given), str(given), name)
        return address
    raise ModelError(f"compiled force '{name}': {function!r} has no address", code="no_address")


def _address_of_data(data: Any, name: str) -> int:
    """ModelError: neither an address nor something that has one."""
    if isinstance(data, np.ndarray):
        if data.dtype.hasobject or not (data.flags.c_contiguous or data.flags.f_contiguous):
            why = "is an array whose numbers are not one after the other in memory"
            raise ModelError(f"compiled force '{name}': data {why}", code="data")
        return int(data.ctypes.data)
    if isinstance(data, ctypes.Structure | ctypes.Union | ctypes.Array | ctypes._SimpleCData):
        return ctypes.addressof(data)
    if not isinstance(data, int | np.integer):
        wanted = "an array of NumPy; a number, array or structure of ctypes; or an address"
        raise ModelError(f"compiled force '{name}': data {data!r:.80} is not {wanted}", code="data")
    return arguments.whole(data, 0, f"compiled force '{name}': data", ModelError)


def _takes(types: Sequence[Any]) -> bool:
    number, count = (getattr(kind, "_type_", None) for kind in (*types, None, None)[:2])
    pointers = [it for it in types[2:] if it is ctypes.c_void_p or issubclass(it, ctypes._Pointer)]
    return number == "d" and count in ("l", "q") and len(types) == 6 and len(pointers) == 4


def _check_signature(right: bool, given: str, name: str) -> None:
    if not right:
        wanted = "(double t, int64_t n, const double *q, const double *v, double *g, void *data)"
        raise ModelError(f"compiled force '{name}': takes {given}, not {wanted}", code="signature")


def _guarded(function: Any) -> Any:
    """A function of ctypes that calls one of Python: what that raises is printed and forgotten, so that the
    force would be zero. Now it is no number, which ends the run."""
    behind = called_from_ctypes(function)
    if behind is None:
        return function

    def guard(t: float, n: int, q: Any, v: Any, g: Any, data: Any) -> None:
        try:
            behind(t, n, q, v, g, data)
        except BaseException:
            ctypes.cast(g, ctypes.POINTER(ctypes.c_double))[0] = np.nan
            raise

    return type(function)(guard)
