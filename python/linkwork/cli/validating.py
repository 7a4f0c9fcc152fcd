"""`linkwork validate`: the reference problems in one table."""

from __future__ import annotations

import time
from collections.abc import Sequence

from linkwork.cli import output as out
from linkwork.running.progress import counting
from linkwork.validation import PROBLEMS, Verdict, validate


def validate_and_show(names: Sequence[str], as_json: bool) -> bool:
    """Whether every problem passed."""
    started = time.perf_counter()
    chosen = list(names) or list(PROBLEMS)
    verdicts: list[Verdict] = []
    with counting(None, len(chosen)) as report:
        for verdict in validate(chosen):
            verdicts.append(verdict)
            report(len(verdicts), f"{len(verdicts)} of {len(chosen)} problems")
    passed = all(verdict.passed for verdict in verdicts)
    seconds = time.perf_counter() - started
    if as_json:
        problems = [verdict.document() for verdict in verdicts]
        out.print_json({"passed": passed, "seconds": seconds, "problems": problems})
    else:
        _print(verdicts, seconds)
    return passed


def _print(verdicts: Sequence[Verdict], seconds: float) -> None:
    rows = []
    for verdict in verdicts:
        head = (verdict.problem, f"{verdict.seconds:.2f}")
        for it in verdict.figures:
            error, required = (f"{value:.1e} {it.unit}".strip() for value in (it.error, it.required))
            rows.append((head[0], it.quantity, error, required, head[1], "passed" if it.passed else "FAILED"))
            head = ("", "")
        if not verdict.figures:
            rows.append((head[0], "", "", "", head[1], "FAILED"))
    out.print_table(("problem", "error of", "is", "may be", "time [s]", ""), rows, left=2)
    print()
    for verdict in verdicts:
        print(f"{verdict.problem}: {verdict.source}; {verdict.method or verdict.reason}")
    failed, count = sum(not verdict.passed for verdict in verdicts), len(verdicts)
    said = f"{failed} of {count} problems FAILED" if failed else f"all {count} problems passed"
    print(f"\n{said}, in {seconds:.1f} s. Errors without a unit are relative; all are the largest over time.")
