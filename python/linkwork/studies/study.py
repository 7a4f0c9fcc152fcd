"""What a study found: parameters, outputs and status of every case, as arrays and as tables."""

from __future__ import annotations

import csv
import json
import os
import warnings
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from linkwork.arguments import check_new, optional_package
from linkwork.arrays import Floats, ReadOnly, by_value
from linkwork.errors import OptionError, counted, unwritable
from linkwork.fingerprints import plain
from linkwork.replacement import replacing
from linkwork.results.result import Result
from linkwork.studies.cases import Runner
from linkwork.studies.collected import Collected
from linkwork.studies.datasets import dimensions, for_netcdf, without_groups
from linkwork.studies.followed import summary
from linkwork.studies.sampling import Cases
from linkwork.studies.told import lines

if TYPE_CHECKING:
    import pandas
    import xarray
    from matplotlib.figure import Figure

    from linkwork.studies.page import Server
    from linkwork.studies.pictures import Swing
    from linkwork.view.page import Page

__all__ = ["Study", "array_of", "assembled"]


@by_value
@dataclass(frozen=True, repr=False)
class Study(ReadOnly):
    """n cases of a study: `parameters`, `outputs` and `status`, case by case.

    parameters  by name: values (n, ...)
    outputs     by label: (n, ...) in SI units, see `units`; NaN in cases that did not finish
    status      (n,) "finished", "failed", or "skipped": of another shard, or not yet run
    errors      by case: type, code, message of what failed, and `reached`, the simulated time [s]; why a
                case was lost
    verdict     (n,) "good", "coarse" or "wrong", see linkwork.Verdict; empty where there is none
    accuracy    (n,) the estimated relative error of the run, Verdict.error; NaN where there is none
    unstable    (n,) by how much errors of steps grow where motion is unstable or chaotic, 1 where that is not
                much more than in regular motion; NaN in cases of which it is not known, as their errors were
                not followed (`follow_errors`), or not to the end, see Verdict.growth
    seconds     (n,) wall time
    remarks     by case: warnings of the run, and what its summary says of what the outputs are
    units       of parameters and outputs that are known
    times       (k,) [s] of outputs that are arrays over time, whose second axis they are; None: of none
    manifest    what was run: hashes, versions, seed, machines
    notes       by output: what it is in all cases but those whose remarks say otherwise, such as a reaction
                that redundant equations leave open
    """

    parameters: Mapping[str, NDArray[Any]]
    outputs: Mapping[str, Floats]
    status: NDArray[np.str_]
    errors: Mapping[int, Mapping[str, Any]]
    verdict: NDArray[np.str_]
    accuracy: Floats
    unstable: Floats
    seconds: Floats
    remarks: Mapping[int, str]
    units: Mapping[str, str]
    times: Floats | None
    manifest: Mapping[str, Any]
    notes: Mapping[str, str] = field(default_factory=dict)
    described: Mapping[str, str] = field(default_factory=dict)  #: outputs in words
    over_time: frozenset[str] = frozenset()  #: outputs that are arrays over `times`
    runner: Runner | None = field(default=None, compare=False)  #: what runs a case
    cases: Cases | None = field(default=None, compare=False)  #: what was asked for

    def __len__(self) -> int:
        return len(self.status)

    def __repr__(self) -> str:
        counts = Counter(self.status.tolist())
        parts = [f"{counts[name]} {name}" for name in ("finished", "failed", "skipped") if counts[name]]
        doubtful = Counter(self.verdict.tolist())
        parts += [f"{doubtful[name]} of them {name}" for name in ("coarse", "wrong") if doubtful[name]]
        head = f"<Study: {len(self)} cases of {', '.join(self.parameters)}: {', '.join(parts)}>"
        told = [*lines(self.errors, self.remarks, self.notes, counted(len(self), "case"))]
        every = self.runner is None or self.runner.follows_all
        if others := summary(self.unstable, self.status, "cases", every=every):
            told.append(f"  {others}")
        return "\n".join([head, *told])

    def case(self, number: int) -> dict[str, Any]:
        """Everything of one case.

            study.case(0)["verdict"]

        OptionError: there is no such case.
        """
        k = self._number(number)
        found = {name: values[k] for name, values in (*self.parameters.items(), *self.outputs.items())}
        return {**found, "status": str(self.status[k]), "verdict": str(self.verdict[k]),
                "accuracy": float(self.accuracy[k]), "unstable": float(self.unstable[k]),
                "seconds": float(self.seconds[k]),
                "error": dict(self.errors.get(k, {})), "remarks": self.remarks.get(k, "")}  # fmt: skip

    def simulate(self, number: int) -> Result:
        """The whole motion of one case, run again, to the same bits on a processor of the same kind.

            study.simulate(2).view("third.html")

        OptionError: there is no such case. What the run raises where it failed.
        """
        k = self._number(number)
        assert self.runner is not None
        assert self.cases is not None
        return self.runner.result(self.cases.case(k))

    def _number(self, number: int) -> int:
        whole = isinstance(number, int | np.integer) and not isinstance(number, bool)
        if not whole or not -len(self) <= number < len(self):
            raise OptionError(f"case {number!r:.40} is none of the {len(self)} of this study", code="case")
        return int(number) % len(self)

    # --- pictures ---

    def plot(
        self,
        kind: str = "scatter",
        path: str | os.PathLike[str] | None = None,
        *,
        outputs: str | Sequence[str] | None = None,
        parameters: str | Sequence[str] | None = None,
    ) -> Figure:
        """A picture of finished cases, also written to `path`, by its suffix.

            study.plot("scatter", "cases.png")

        kind        "scatter": every parameter and output over every other; failed cases are crosses
                    "histogram": outputs, with median, 5th and 95th percentile
                    "bands": outputs that are arrays over time: median, half and nine tenths of the cases
                    "surface": outputs over the first two parameters; at one point the mean of its cases
                    "tornado": the change of outputs with each parameter, see `swings`
        outputs, parameters   which; None: all that are numbers and not the same in every case

        OptionError: no such kind or name, or nothing to draw. FileError: `path` cannot be written, or is the
        name of a kind. A picture that is there is replaced.
        """
        from linkwork.studies import pictures

        return pictures.plot(self, kind, path, outputs=outputs, parameters=parameters)

    def swings(self, output: str) -> list[Swing]:
        """What each parameter does to an output, the strongest first, by the linear fit to all cases.

            for swing in study.swings("height"):
                print(swing)

        `change` is that of the output while a parameter goes from the 5th to the 95th percentile of its
        values, the others held; `explained` is the share of the variance that the fit explains: where it is
        far from 1, the output is not linear there, and indices of Sobol tell more.

        LinkworkWarning: parameters that are the same in all cases that have the output are left out.
        OptionError: no such output, too few cases, or parameters that move together.
        """
        from linkwork.studies import pictures

        return pictures.swings(self, output)

    def view(self, path: str | os.PathLike[str] | None = None) -> Page:
        """A page of parallel coordinates, a line a case, written to `path` when given; needs no network.

            study.view("cases.html")

        Drag along an axis to choose cases, click its name to color by it, click a line for its case. From
        `serve` the click opens the motion.

        OptionError: nothing that varies is a number. FileError: `path` cannot be written.
        """
        from linkwork.studies.page import page

        found = page(self)
        if path is not None:
            found.save(path)
        return found

    def serve(self, port: int = 0) -> Server:
        """The page of `view` by a server for this machine alone, where a click on a case opens its motion,
        simulated again to the same bits. A context manager; `close()` ends it.

            with study.serve() as server:
                print(server.url)

        port  0: a free one, see `url`

        OptionError: the port is taken.
        """
        from linkwork.studies.page import Server

        return Server(self, port)

    # --- tables ---

    def to_table(self) -> NDArray[Any]:
        """
        A structured array (n,): parameters, outputs, "status", "verdict", "accuracy", "unstable",
        "seconds".

            study.to_table()["status"]
        """
        columns = {**self.parameters, **self.outputs, "status": self.status, "verdict": self.verdict,
                   "accuracy": self.accuracy, "unstable": self.unstable, "seconds": self.seconds}  # fmt: skip
        kinds = [(name, values.dtype, values.shape[1:]) for name, values in columns.items()]
        table = np.empty(len(self), dtype=kinds)
        for name, values in columns.items():
            table[name] = values
        return table

    def to_frame(self) -> pandas.DataFrame:
        """A table of pandas, a row a case; arrays have a column a number: "path[0]". Units and notes are in
        `attrs`.

            study.to_frame().sort_values("height")

        OptionError: pandas is not installed, or two columns have one name.
        """
        package = optional_package("pandas", "pandas", "to_frame", instead="to_table needs nothing")
        columns = dict(self._flat())
        frame: pandas.DataFrame = package.DataFrame(columns, index=package.RangeIndex(len(self), name="case"))
        for name, texts in self._texts():
            frame[name] = texts
        frame.attrs.update(units=dict(self.units), notes=dict(self.notes))
        return frame

    def to_csv(self, path: str | os.PathLike[str], *, overwrite: bool = False) -> None:
        """Write the table of `to_frame` as text (.csv), a row a case, numbers to the last bit.

            study.to_csv("cases.csv")

        overwrite  whether it may replace a file

        FileError: there is a file, it has another suffix, or cannot be written.
        """
        target = check_new(path, "table", overwrite)
        columns = {**{name: it.tolist() for name, it in self._flat()}, **dict(self._texts())}
        rows = zip(range(len(self)), *columns.values(), strict=True)
        with replacing(target, "table") as beside, open(beside, "w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(["case", *columns])
            writer.writerows(rows)

    def _texts(self) -> Iterator[tuple[str, list[str]]]:
        """Of each case why it failed, and what is remarked."""
        yield "error", [self.errors.get(k, {}).get("message", "") for k in range(len(self))]
        yield "remarks", [self.remarks.get(k, "") for k in range(len(self))]

    def _flat(self) -> Iterator[tuple[str, NDArray[Any]]]:
        """Columns (n,) of the table; of arrays one a number. OptionError: two of one name."""
        seen = set()
        for name in (table := self.to_table()).dtype.names or ():
            values = table[name]
            for place in np.ndindex(values.shape[1:]):
                label = name + "".join(f"[{k}]" for k in place)
                if label in seen:
                    raise OptionError(
                        f"table: two columns are '{label}': give an output another name", code="outputs"
                    )
                seen.add(label)
                yield label, values[(slice(None), *place)]

    def to_xarray(self) -> xarray.Dataset:
        """A data set of xarray over the dimension "case": parameters, status, verdict, ... as coordinates,
        outputs as variables, units and notes ("comment") as attributes, the manifest as text. Names have "_"
        for "/", by which files would put them into groups; the attribute `name` has what it was.

            study.to_xarray().height.max()

        OptionError: xarray is not installed. LinkworkWarning: a name has a "/".
        """
        package = optional_package("xarray", "xarray", "to_xarray", instead="to_table needs nothing")
        coordinates: dict[str, Any] = {"case": np.arange(len(self))}
        for name, values in self.parameters.items():
            coordinates[name] = self._variable(name, values, "parameter")
        for name in ("status", "verdict", "accuracy", "unstable", "seconds"):
            unit = {"seconds": "s", "accuracy": "1", "unstable": "1"}.get(name)
            coordinates[name] = ("case", getattr(self, name), {"units": unit} if unit else {})
        coordinates |= {name: ("case", np.array(texts, dtype=object)) for name, texts in self._texts()}
        if self.over_time:
            coordinates["time"] = "time", self.times, {"units": "s"}
        variables = {name: self._variable(name, it, self.described.get(name, ""))
                     for name, it in self.outputs.items()}  # fmt: skip
        attributes = {"manifest": json.dumps(self.manifest, default=str)}
        return without_groups(package.Dataset(variables, coordinates, attributes).copy(deep=True))

    def _variable(self, name: str, values: NDArray[Any], about: str) -> tuple[Any, Any, dict[str, str]]:
        dims = dimensions(name, values.ndim - 1, {*self.parameters, *self.outputs})
        if name in self.over_time:
            dims[0] = "time"
        attributes = {"units": self.units.get(name, ""), "long_name": about,
                      "comment": self.notes.get(name, "")}  # fmt: skip
        return ("case", *dims), values, {key: text for key, text in attributes.items() if text}

    def save(self, path: str | os.PathLike[str], *, overwrite: bool = False) -> None:
        """Write the data set of `to_xarray` as netCDF: .nc, which xarray.load_dataset reads. As Zarr
        `study.to_xarray().to_zarr("cases.zarr")` writes it.

            study.save("cases.nc")

        overwrite  whether it may replace a file

        A parameter with a space in its name comes back as a variable: netCDF has no such coordinates. Whole
        numbers of more than 32 bits come back as floats, exactly, where netCDF4 and h5netcdf are not there.

        OptionError: xarray is not installed. FileError: there is a file, it has another suffix, or cannot be
        written.
        """
        target = check_new(path, "data set", overwrite)
        data = self.to_xarray()
        with replacing(target, "data set") as beside, warnings.catch_warnings():
            warnings.filterwarnings("ignore", "coordinate .* has a space in its name")
            try:
                for_netcdf(data).to_netcdf(beside)
            except UnicodeEncodeError as error:
                why = ValueError("a name is not of Latin letters: install h5netcdf, or take to_csv")
                raise unwritable("data set", target, why) from error
            except ValueError as error:
                raise unwritable("data set", target, error) from error


# --- from runs ---


def assembled(
    cases: Cases, keys: Sequence[str], found: Collected, lost: Mapping[str, str],
    runner: Runner, manifest: Mapping[str, Any],
) -> Study:  # fmt: skip
    """Case by case; of a function whose arrays differ in shape, those unlike the first are failures."""
    count = () if runner.times is None else (len(runner.times),)
    return Study(
        parameters={name: array_of(values) for name, values in cases.columns.items()},
        outputs=found.outputs({it.label: count if it.over_time else () for it in runner.outputs}),
        status=found.status(lost, keys),
        errors=found.errors(lost, keys),
        verdict=found.level,
        accuracy=found.accuracy,
        unstable=found.unstable,
        seconds=found.seconds,
        remarks=found.remarks(),
        units={name: unit for name, unit in {
            **runner.source.units(list(cases.columns)), **{it.label: it.unit for it in runner.outputs}
        }.items() if unit},
        times=runner.times,
        manifest=manifest,
        notes={it.label: it.note for it in runner.outputs if it.note},
        described={it.label: it.about for it in runner.outputs},
        over_time=frozenset(it.label for it in runner.outputs if it.over_time),
        runner=runner,
        cases=cases,
    )  # fmt: skip


def array_of(values: Sequence[Any]) -> NDArray[Any]:
    """(n, ...); what a function takes, and no array can hold, in words."""
    values = [plain(value) for value in values]
    try:
        found = np.array(values)
    except (ValueError, OverflowError):
        found = np.array([], dtype=object)
    if found.dtype.kind in "biufU" and _tells_apart(found, values):
        return found
    with_texts = any(isinstance(value, str) for value in values)
    return np.array([repr(value) if with_texts else str(value) for value in values])


def _tells_apart(found: NDArray[Any], values: Sequence[Any]) -> bool:
    """An array makes True and 2 numbers, 1 and "1" texts, and rounds large whole numbers beside others."""
    kinds = {kind for value in values for kind in (bool, str) if isinstance(value, kind)}
    if kinds and not all(isinstance(value, kind) for value in values for kind in kinds):
        return False
    return found.dtype.kind != "f" or all(int(float(it)) == it for it in values if isinstance(it, int))
