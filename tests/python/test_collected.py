"""What becomes of cases, in columns: memory follows the outputs, and the first case decides on shapes."""

from __future__ import annotations

import tracemalloc
from typing import Any

import numpy as np
import pytest
from linkwork.studies.cases import Run
from linkwork.studies.collected import Collected, Todo
from linkwork.studies.sampling import Cases
from numpy.testing import assert_array_equal


def run(key: str, outputs: dict[str, Any], **more: Any) -> Run:
    return Run(key, "finished", outputs, verdict={"level": "good", "error": 1e-6, "sentence": "s"}, **more)


def test_a_case_takes_a_hundred_bytes_beyond_its_outputs() -> None:
    count, numbers = 20_000, 39
    keys = [f"{k:032x}" for k in range(count)]
    tracemalloc.start()
    found = Collected(keys)
    for key in keys:
        found.add(run(key, {"q": list(np.full(numbers, 1.5))}, values={"mass": [1.0] * 50}, seconds=1.0))
    kept, _ = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert kept / count < 8 * numbers + 200


@pytest.mark.parametrize("order", [[0, 1, 2, 3], [3, 1, 0, 2], [1, 3, 2, 0]])
def test_the_shape_of_the_first_case_counts_whichever_came_first(order: list[int]) -> None:
    shapes = {0: 2, 1: 3, 2: 2, 3: 3}
    found = Collected(["a", "b", "c", "d"])
    for k in order:
        found.add(run("abcd"[k], {"x": [float(k)] * shapes[k], "y": 1.0}))
    outputs = found.outputs({"x": (), "y": ()})
    assert_array_equal(outputs["x"], [[0, 0], [np.nan] * 2, [2, 2], [np.nan] * 2])
    assert_array_equal(outputs["y"], [1, np.nan, 1, np.nan])
    assert found.status({}, "abcd").tolist() == ["finished", "failed", "finished", "failed"]
    assert (
        found.errors({}, "abcd")[3]["message"] == "output 'x' has shape (3,), not (2,) as in the first case"
    )


def test_cases_with_one_key_are_one_and_what_is_lost_says_so() -> None:
    keys = ["a", "b", "a", "c", "d"]
    found = Collected(keys)
    assert len(Todo.of(Cases({"m": [1, 2, 1, 3, 4]}, "table"), keys, found, None)) == 4
    found.add(run("a", {"x": 5.0}, remarks="slow"))
    todo = Todo.of(Cases({"m": [1, 2, 1, 3, 4]}, "table"), keys, found, (1, 2))
    assert [case.number for case in todo] == [1, 3] and todo[1:][0].values == {"m": 3}
    lost = {"b": "its process ended"}
    assert_array_equal(found.outputs({"x": ()})["x"], [5, np.nan, 5, np.nan, np.nan])
    assert found.status(lost, keys).tolist() == ["finished", "failed", "finished", "skipped", "skipped"]
    assert found.errors(lost, keys)[1]["code"] == "lost" and found.remarks() == {0: "slow", 2: "slow"}
    assert found.level.tolist() == ["good", "", "good", "", ""]


def test_of_two_tries_the_one_that_finished_counts_whichever_comes_first() -> None:
    good, bad = run("a", {"x": 5.0}), Run("a", "failed", error={"message": "m"}, remarks="late", seconds=2.0)
    for tries in ([good, bad], [bad, good], [bad, bad, good, bad]):
        found = Collected(["a", "b"])
        for it in tries:
            if found.wants(it):
                found.add(it)
        assert found.status({}, "ab").tolist() == ["finished", "skipped"]
        assert found.errors({}, "ab") == {} and found.remarks() == {} and found.level[0] == "good"
