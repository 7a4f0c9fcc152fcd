"""`linkwork sweep`: the cases of a study, here or as one of many jobs."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from linkwork.cli import base, streams

if TYPE_CHECKING:
    from linkwork.studies import Study

__all__ = ["sweep"]


@click.command(cls=base.Command)
@click.argument("file", type=click.Path())
@click.option("--shard", metavar="K/N", help="Only every Nth case: job K of N, from 0 or from 1 on.")
@click.option("--gather", is_flag=True, help="Run nothing; collect what the shards have done.")
@click.option("--retry", is_flag=True, help="Run the cases that failed again, too.")
@click.option("--processes", type=click.IntRange(1), metavar="N", help="Local processes; one a processor.")
@click.option(
    "--case-seconds",
    type=base.Positive(),
    metavar="S",
    help="Wall time that a case may take by itself [s]; one that takes longer counts as failed.",
)
@click.option("--output", "-o", type=click.Path(), metavar="FILE", help="All cases: .csv, or netCDF (.nc).")
@click.option("--plot", "picture", type=click.Path(), metavar="FILE", help="A picture of the cases.")
@click.option(
    "--kind", type=click.Choice(("scatter", "histogram", "bands", "surface", "tornado")), default="scatter",
    show_default=True, help="What the picture shows.",
)  # fmt: skip
@click.option("--page", type=click.Path(), metavar="FILE", help="A page of parallel coordinates (.html).")
@click.option("--json", "as_json", is_flag=True, help="Print JSON.")
def sweep(file: str, shard: str | None, gather: bool, retry: bool, processes: int | None,
          case_seconds: float | None, output: str | None, picture: str | None, kind: str,
          page: str | None, as_json: bool) -> None:  # fmt: skip
    """Simulate a mechanism in many variants, as a file says.

    \b
    linkwork sweep study.yaml --output study.csv
    linkwork sweep study.yaml --shard $SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT
    linkwork sweep study.yaml --gather --output study.nc --plot study.png

    Cases are kept in the study's directory as they end: the same command again runs what is missing, with
    --retry also what failed.
    """
    from linkwork.cli import output as out
    from linkwork.studies.files import read_study
    from linkwork.studies.sweeping import sweep as run

    part = None if shard is None else _shard(shard)
    if output is not None:
        out.check_writable(output, "table of cases")
    if picture is not None:
        from linkwork.plots.figures import check_format

        out.check_writable(picture, "picture")
        check_format(picture)
    if page is not None:
        out.check_writable(page, "page")
    given = read_study(file)
    if picture is not None:
        from linkwork.studies.pictures import check_possible

        check_possible(kind, len(given["parameters"]), given.get("times"))
    study = run(**given, shard=part, gather=gather, retry=retry, processes=processes,
                case_seconds=case_seconds)  # fmt: skip
    if output is not None:
        _save(study, output)
    if picture is not None:
        study.plot(kind, picture)
    if page is not None:
        study.view(page)
    if as_json:
        out.print_json(_document(study, given, output))
    else:
        _print(study)
        files = [("output", output or ""), ("picture", picture or ""), ("page", page or "")]
        out.print_pairs([("directory", str(given["directory"])), *files])
    if message := _failure(study):
        streams.say("error", message)
        raise click.exceptions.Exit(1)


def _save(study: Study, output: str) -> None:
    from linkwork.arguments import SUFFIXES

    save = study.save if Path(output).suffix.lower() in SUFFIXES["data set"] else study.to_csv
    save(output, overwrite=True)


def _failure(study: Study) -> str:
    """In words, where all cases of a study have failed, other than a shard's."""
    failed = int((study.status == "failed").sum())
    if failed < len(study):
        return ""
    return f"no case has finished, {failed} failed: {study.errors[min(study.errors)]['message']}"


def _shard(text: str) -> tuple[int, int]:
    found = re.fullmatch(r"(\d{1,9})/(\d{1,9})", text)
    if found is None:
        raise click.UsageError(f"--shard '{text}' is no K/N, such as 3/100")
    return int(found[1]), int(found[2])


def _counts(study: Study) -> dict[str, int]:
    return {name: int((study.status == name).sum()) for name in ("finished", "failed", "skipped")}


def _document(study: Study, given: dict[str, Any], output: str | None) -> dict[str, Any]:
    table, message = study.to_table(), _failure(study)
    error = {"type": "Error", "code": "failed", "message": message, "exit_code": 1}
    return {
        **({"error": error} if message else {}),
        "cases": len(study), **_counts(study), "directory": str(given["directory"]), "output": output,
        "table": {name: table[name] for name in table.dtype.names or ()},
        "errors": {str(number): dict(error) for number, error in study.errors.items()},
        "remarks": {str(number): text for number, text in study.remarks.items()}, "notes": dict(study.notes),
        "units": dict(study.units),
    }  # fmt: skip


def _print(study: Study) -> None:
    """How the cases ended, and the spread of the outputs that are numbers."""
    import numpy as np

    from linkwork.cli import output as out

    print(str(study)[1:].split(">", 1)[0] + "\n" + "\n".join(str(study).splitlines()[1:]))
    rows = []
    for name, values in study.outputs.items():
        kept = values[np.isfinite(values)] if values.ndim == 1 else np.zeros(0)
        if len(kept):
            spread = (kept.min(), np.median(kept), kept.max())
            rows.append([name, *(f"{it:.6g}" for it in spread), study.units.get(name, "")])
    if rows:
        out.print_table(["output", "least", "median", "most", "unit"], rows)
