"""The description of a mechanism: it is built, kept in files, and begun from another state."""

from __future__ import annotations

import copy
import hashlib
import html
import os
from collections import Counter
from collections.abc import Mapping
from inspect import isfunction
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from linkwork import _core, arguments
from linkwork.arrays import Floats, VectorLike
from linkwork.errors import ModelError, OptionError, counted
from linkwork.fingerprints import under_way
from linkwork.functions import TimeFunction
from linkwork.modeling.bodies import Bodies
from linkwork.modeling.builder import ModelBuilder
from linkwork.modeling.tables import COLUMNS, Table, tables

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from linkwork.modeling.handles import Body, Force, Joint
    from linkwork.view.page import Page

__all__ = ["Model", "check_bodies", "check_model", "model_of"]

#: What others call our joints and forces.
SYNONYMS = {
    **dict.fromkeys(("hinge", "pin", "pin_joint", "continuous"), "revolute"),
    **dict.fromkeys(("prismatic", "slider", "slide"), "translational"),
    **dict.fromkeys(("ball", "ball_joint", "ball_and_socket"), "spherical"),
    **dict.fromkeys(("weld", "rigid", "lock", "welded"), "fixed"),
    **dict.fromkeys(("cardan", "hooke", "u_joint"), "universal"),
    **dict.fromkeys(("motor", "actuator", "driver"), "drive"),
    **dict.fromkeys(("spring", "damper", "spring_dampers"), "spring_damper"),
}


class Model(ModelBuilder):
    """A mechanism under construction. SI units, angles in rad.

    Every kind of joint is a method: `revolute`, `spherical`, ... (`help(linkwork.Model)` has them all).
    Bodies are given by handle or by name. Everything is checked when it is added: bad input is a ModelError
    that names the object and the value, and leaves the model as it was.
    """

    if not TYPE_CHECKING:  # a type checker knows the methods that there are

        def __getattr__(self, name: str) -> Any:
            """AttributeError: it leads from another name of a joint to ours."""
            meant = f": that is called '{SYNONYMS[name]}' here" if name in SYNONYMS else ""
            raise AttributeError(f"'Model' has no attribute '{name}'{meant}", name=name, obj=self)

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Model:
        """The model in a file: YAML (.yaml, .yml) or JSON (.json); `linkwork schema` says what they may have.

            model = lw.Model.load("crank.yaml")

        ModelFileError: what is wrong in it, all at once: where fields are, names and what they stand for are
        looked at when these are right. FileError: it cannot be read. ModelError: of a class of your own that
        is not made of gravity and name alone.
        """
        from linkwork.modeling import files

        begun = cls._begun()
        found = files.read(arguments.path(path, "model file"), cls).model
        vars(found).update(begun._added())
        return found

    @classmethod
    def _begun(cls) -> Model:
        """Empty. ModelError: its class makes something else."""
        try:
            begun = cls((0.0, 0.0, 0.0), "")
        except TypeError:
            begun = None
        if begun is None or begun.body_count or begun.joint_count or begun.force_count:
            raise ModelError(
                f"{cls.__name__}.load: __init__ of this class takes or adds what no file has: "
                "linkwork.Model.load gives a plain model",
                code="class",
            )
        return begun

    @classmethod
    def _blank(cls, gravity: VectorLike, name: str) -> Model:
        """With nothing in it, also where the __init__ of a class of the user's own would put something."""
        out = object.__new__(cls)
        ModelBuilder.__init__(out, gravity, name)
        return out

    def _added(self) -> dict[str, Any]:
        """Attributes that a class of the user's own has beside ours."""
        return {name: x for name, x in vars(self).items() if name not in ATTRIBUTES}

    def save(
        self,
        path: str | os.PathLike[str],
        *,
        simulation: Mapping[str, Any] | None = None,
        overwrite: bool = False,
    ) -> None:
        """Write the model to a file (.yaml, .yml, .json), exactly: what is loaded has the same bits.

            model.save("crank.yaml", simulation={"t_end": 2.0, "step": 1e-3})

        simulation  arguments of `simulate` that the file recommends, such as {"t_end": 2.0, "step": 1e-3}
        overwrite   whether a file that is there may be replaced

        ModelError: a Python function in the model, which a file cannot hold. OptionError: `simulation` is
        nothing that a run takes. FileError: it cannot be written, or could not be read again: YAML may have
        16 MiB, JSON 2 GiB.
        """
        from linkwork.modeling import files

        if simulation is not None and not isinstance(simulation, Mapping):
            raise OptionError(
                f"simulation {simulation!r:.80} is no mapping of names to values", code="option"
            )
        settings = {} if simulation is None else simulation
        files.write(self, arguments.path(path, "model file"), settings, overwrite)

    def with_initial_state(self, q: ArrayLike, v: ArrayLike, history: ArrayLike = ()) -> Model:
        """The same mechanism from another state, such as a frame of a result.

            onward = model.with_initial_state(result.q[-1], result.v[-1])

        q  position and Euler parameters of each body (n, 7)
        v  velocity (inertial) and angular velocity (body axes) of each body (n, 6)
        history  history variables of couplers and force elements (h,), such as `result.history[-1]`: full
                 turns, speeds at which contacts began, see linkwork.System; without, they begin anew

        Joints and forces stay where they are on the bodies. ModelError: another shape, or no possible state.
        Elements with history variables that are added later make another number of them necessary.
        """
        n = self.body_count
        q, v = (
            arguments.shaped(q, [(n, 7), (7 * n,)], "model", "q"),
            arguments.shaped(v, [(n, 6), (6 * n,)], "model", "v"),
        )
        past = arguments.array(history, "model: history", ModelError).ravel().tolist()
        return self._with_core(self._core.with_initial_state(q.ravel(), v.ravel(), past))

    def with_gravity(self, gravity: VectorLike) -> Model:
        """The same mechanism elsewhere; this one stays as it is.

            on_the_moon = model.with_gravity((0, 0, -1.62))

        gravity  acceleration (3,), inertial [m/s2]; `Model.gravity` is that of this model

        ModelError: not three finite numbers.
        """
        g = arguments.shaped(gravity, [(3,)], "model", "gravity")
        return self._with_core(self._core.with_weights(g, [], [], []))

    def _with_core(self, core: _core.Model) -> Model:
        """The same names, functions and shapes with other numbers."""
        out = object.__new__(type(self))
        vars(out).update(self._added())
        own = {name: vars(self)[name].copy() for name in _COLLECTIONS}
        vars(out).update(own, _name=self._name, _core=core, _bodies=Bodies(out, core))
        return out

    # --- to read and to change ---

    def table(self, what: Literal["bodies", "joints", "forces"] = "bodies") -> Table:
        """The bodies, joints or force elements, one a row: printed, or as a table in a notebook.

            print(model.table("joints"))

        `len(model.table("joints"))` counts them; `model.table("joints")[3]` is a mapping of columns to texts.
        """
        return tables(self, what)

    def values(self, name: str | Body | Joint | Force) -> dict[str, Any]:
        """Everything that a body, joint or force was made of, as in a file of the model.

            length = model.values("spring")["free_length"]

        Of a force of the user's own, and where a function of Python is a parameter, the function itself.
        ModelError: no object of this name.
        """
        from linkwork.modeling import editing

        return editing.values(self, name)

    def without(self, *names: str | Body | Joint | Force, attached: bool = False) -> Model:
        """A model without these bodies, joints or force elements; this one stays as it is.

            free = model.without("pin")

        attached  what hangs on them goes, too: joints and forces of a body, couplers and drivers of a joint

        ModelError: no object of this name; without `attached`, something that would hang on nothing; a body,
        where a force of the user's own stays that counts all bodies by number.
        """
        from linkwork.modeling import editing

        return editing.without(self, names, attached)

    def replaced(self, name: str | Body | Joint | Force, /, **values: Any) -> Model:
        """A model with other values of one object, in the words of a model file; this one stays as it is.

            stiffer = model.replaced("spring", stiffness=2e4)
            moved = model.replaced("pin", at=(0.2, 0, 0))

        `values(name)` has those that there are; a joint between two bodies or a force element takes the
        arguments of its method, too, and stays where it was in all that is not said; with another body alone
        at the same body coordinates. With another axis it keeps its x axis, but for
        one that is taken without `x_axis`. Joints stay where they are on a body that is moved, and what
        drives a joint goes with it.
        Forces of the user's own stay as they are, too, or get another `function`.
        ModelError: no object of this name, or a value that it cannot have.
        """
        from linkwork.modeling import editing

        return editing.replaced(self, name, values)

    def _repr_html_(self) -> str:
        parts = [tables(self, what) for what in COLUMNS]
        shown = "".join(part._repr_html_() for part in parts if len(part))
        return f"<p>{html.escape(self.describe())}</p>{shown}"

    # --- to look at, before anything is computed ---

    def view(self, path: str | os.PathLike[str] | None = None) -> Page:
        """The initial pose as a page for any browser, without a network; written to `path` when given.

            model.view("model.html")

        Bodies, joints, names, frames. Joints that the pose violates are red, with the gap: nothing needs to
        be consistent. In a notebook the page shows itself; `model.view().open()` shows it in the browser.

        ModelError: no bodies. FileError: `path` cannot be written.
        """
        from linkwork.results.initial_pose import view_model

        return view_model(self, path)

    def plot(self, path: str | os.PathLike[str] | None = None) -> Figure:
        """The initial pose as a picture, written to `path` when given; joints that it violates are red.

            model.plot("model.png")

        ModelError: no bodies. FileError: `path` cannot be written. OptionError: too much to paint.
        """
        from linkwork.results.initial_pose import plot_model

        return plot_model(self, path)

    def __copy__(self) -> Model:
        """On its own, and exact; functions of Python are those of the model."""
        return self._with_core(self._core.with_weights(self.gravity, [], [], []))

    def __deepcopy__(self, memo: dict[int, Any]) -> Model:
        out = memo[id(self)] = copy.copy(self)  # so that handles in attributes are its own
        vars(out).update(copy.deepcopy(self._added(), memo))
        return out

    def __reduce__(self) -> tuple[Any, ...]:
        """To other processes, exactly, with functions of Python that pickle: those of modules, no lambdas.

        ModelError: a compiled force, whose address is that of this process.
        """
        from linkwork.modeling import files

        for it in self._user_forces:
            it.check_leaves()
        return model_of, (*files.whole_record(self), type(self)), self._added() or None

    def hash(self) -> str:
        """
        Equal for models of equal motion, whatever the names.

        A function of Python counts by its code and what it reads, as defaults, from around it or of its
        module and others that nobody has installed; that of an object by its class and attributes, whoever
        has set them; a compiled one by those of Python that it is made from, or by the file of its library,
        and by its data. What functions read counts by its type, too: an array of int8 is none of int64, and a
        list no tuple. Attributes that calls of it change, as counters, count as they were when the process
        first looked at them, in this or a run.

            assert lw.mechanisms.chain(2).hash() == lw.mechanisms.chain(2).hash()
        """
        core = self._core
        joints, forces = core.joint_arrays(), core.force_arrays()
        used = self._in_order_of_use(joints["signals"], forces["signals"])
        for arrays in (joints, forces):
            arrays["signals"] = _renumbered(arrays["signals"], list(used))
        elements = [*joints.values(), *forces.values()]
        digest = hashlib.blake2b(digest_size=16)
        for array in (core.gravity, core.mass, core.inertia, core.q0, core.v0, *elements, _history(core)):
            digest.update(np.ascontiguousarray(array).data)
        for joint, special in self._special.items():
            digest.update(f"{joint} {special.facts(core)}".encode())
        with under_way(self):
            # Those of joint forces count twice, as they did when hashes were first written.
            laws = [it.law for it in self._user_forces if isinstance(it.law, TimeFunction)]
            for function in (*used.values(), *laws):
                digest.update(function.fingerprint())
            for own in self._user_forces:
                digest.update(own.fingerprint().encode())
        return digest.hexdigest()

    def _in_order_of_use(self, *signals: NDArray[np.int32]) -> dict[int, TimeFunction]:
        """Functions by their numbers in the model, in the order of the elements: the numbers are in that in
        which they were added, to joints and forces in turn."""
        numbers = np.concatenate(signals)
        _, first = np.unique(numbers, return_index=True)
        return {k: self._functions[k] for k in numbers[np.sort(first)].tolist() if k >= 0}

    def __fingerprint__(self) -> str:
        """For those who tell one value from another: see linkwork.fingerprints."""
        core = self._core
        bodies = [core.body_name(body) for body in range(core.body_count)]
        joints = [core.joint_name(joint) for joint in range(core.joint_count)]
        return repr((self.hash(), self.name, bodies, joints))

    def describe(self) -> str:
        """
        One line: what the model consists of.

            print(model.describe())
        """
        found = self._counts + Counter(it.record["kind"] for it in self._user_forces)
        kinds = "".join(f", {count} {kind}" for kind, count in sorted(found.items()))
        gravity = ", ".join(f"{g:g}" for g in self._core.gravity)
        bodies, equations = (
            counted(self.body_count, "body"), counted(self.row_count, "constraint equation")
        )  # fmt: skip
        return f"{self.name or 'model'}: {bodies}{kinds}; {equations}; gravity ({gravity}) m/s2"

    def __repr__(self) -> str:
        return f"<Model {self.describe()}>"


def model_of(
    record: Mapping[str, Any],
    held: Mapping[str, TimeFunction] = MappingProxyType({}),
    kind: type[Model] = Model,
) -> Model:
    """From what `linkwork.modeling.files.whole_record` made of one; of version 0.1 it is the record alone."""
    from linkwork.modeling import files

    return files.from_record(record, kind, held)


#: Attributes of every model.
ATTRIBUTES = frozenset(vars(Model()))
_COLLECTIONS = sorted(ATTRIBUTES - {"_name", "_core", "_bodies"})


def check_model(model: object) -> None:
    """ModelError: it is no model."""
    if not isinstance(model, Model):
        what = f"the function {model.__name__}: call it" if isfunction(model) else f"{model!r:.80}"
        raise ModelError(f"a linkwork.Model is wanted, not {what}", code="not_a_model")


def check_bodies(model: Model) -> None:
    """ModelError: no model, or nothing to simulate in it."""
    check_model(model)
    if not model.body_count:
        raise ModelError(f"model '{model.name}': has no bodies", code="empty")


def _renumbered(signals: NDArray[np.int32], order: list[int]) -> NDArray[np.int32]:
    """Places in `order`; -1 stays."""
    place = np.full(max(order, default=-1) + 2, -1, np.int32)
    place[order] = np.arange(len(order))
    return place[signals]


def _history(core: _core.Model) -> Floats:
    return np.asarray(core.initial_history, dtype=float)
