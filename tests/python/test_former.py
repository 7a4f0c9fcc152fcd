"""What version 0.1.0 pickled loads, though its modules stand in other places now."""

import pickle
from typing import Any

import linkwork as lw
import numpy as np
import pytest
from linkwork.former import PLACES


def as_before(thing: Any) -> bytes:
    """Pickled, with the modules by their former names; protocol 0 is text."""
    text = pickle.dumps(thing, protocol=0)
    for former, places in reversed(PLACES.items()):
        for place in places:
            text = text.replace(f"clinkwork.{place}\n".encode(), f"c{former}\n".encode())
    return text


@pytest.fixture(scope="module")
def result() -> lw.Result:
    return lw.simulate(lw.mechanisms.pendulum(), t_end=0.1, step=1e-2, progress=False, verify=True)


@pytest.mark.filterwarnings("ignore:linkwork.* now:DeprecationWarning")
def test_a_result_loads_with_its_finer_run(result: lw.Result) -> None:
    text = as_before(result)
    assert b"clinkwork.header\nHeader" in text and b"linkwork.motion" not in text
    loaded = pickle.loads(text)
    assert np.array_equal(loaded.q, result.q)
    assert np.array_equal(loaded.error_of("energy"), result.error_of("energy"))
    assert loaded.verdict == result.verdict


@pytest.mark.filterwarnings("ignore:linkwork.* now:DeprecationWarning")
def test_a_model_and_a_snapshot_load(result: lw.Result) -> None:
    model = lw.mechanisms.pendulum()
    text = as_before(model)
    assert b"clinkwork.model_file.reading\nmodel_of" in text
    assert pickle.loads(text).hash() == model.hash()
    assert np.array_equal(pickle.loads(as_before(result.snapshot())).q, result.q[-1])


def test_a_pickled_result_is_read_with_former_keys(result: lw.Result) -> None:
    former = pickle.loads(pickle.dumps(result))
    crossing = {"t": 0.05, "joints": ["pin"], "pivot": 1e-9, "taken_over": 3, "rows_changed": False}
    statistics = {**vars(former).pop("_statistics"), "passages": [crossing]}
    del statistics["singularity_crossings"]
    vars(former)["statistics"] = statistics
    options = former.header.manifest["options"]
    options["system"] = options.pop("matrix_form")
    today = pickle.loads(pickle.dumps(former))
    assert today.singular_poses == (lw.SingularPose(0.05, ("pin",), 1e-9, 3),)
    assert today.manifest["options"] == result.manifest["options"]


def test_code_is_told_where_a_name_is_now() -> None:
    with pytest.warns(
        DeprecationWarning, match=r"linkwork\.result\.Snapshot is linkwork\.motion\.records\.Snapshot now"
    ):
        from linkwork.result import Snapshot  # type: ignore[import-not-found]
    assert Snapshot is lw.Snapshot
    with pytest.raises(ImportError, match="no_such_name"):
        from linkwork.result import no_such_name  # noqa: F401
    with pytest.raises(AttributeError, match=r"'system'; its names are in linkwork\.equations\.system now"):
        _ = lw.system
    with pytest.raises(ModuleNotFoundError, match="no_such_module"):
        import linkwork.no_such_module  # type: ignore[import-not-found] # noqa: F401


def test_a_renamed_attribute_is_an_error_that_gives_the_new_name(result: lw.Result) -> None:
    with pytest.raises(AttributeError, match="'memory' is called 'history' now"):
        _ = result.snapshot().memory
    with pytest.raises(AttributeError, match="'work' is called 'cost' now"):
        _ = lw.Comparison([], None, 1.0, {}, []).work  # type: ignore[arg-type]
