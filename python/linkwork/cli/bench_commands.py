"""`bench`: the commands and their options."""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import Any

import click

from linkwork.cli import base, shells


@click.group(cls=base.Group, what="benchmark")
def bench() -> None:
    """Measure how fast linkwork is on this machine.

    \b
    linkwork bench rhs --mechanism net --bodies 1740       right-hand sides by every linear solver
    linkwork bench scaling --bodies 1000,10000,100000      time and memory against the size
    linkwork bench step                                    steps of every mechanism, runs of 10 s
    linkwork bench ensemble                                many mechanisms in the lanes of the processor
    linkwork bench large                                   error against time of large models, beside peers

    Times are wall times, medians over rounds in which all take their turn; let nothing else run meanwhile.
    """
    for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):  # read when numpy is imported
        os.environ.setdefault(name, "1")


def _options(*options: Callable[[Any], Any]) -> Callable[[Any], Any]:
    """Several options in one decorator, in this order."""

    def decorate(command: Any) -> Any:
        for option in reversed(options):
            command = option(command)
        return command

    return decorate


MECHANISM = click.option(
    "--mechanism",
    default="chain",
    show_default=True,
    metavar="NAME",
    shell_complete=shells.names_of("mechanism", files=True),
    help="A mechanism of `linkwork list`, or a file.",
)
PARAMETERS = click.option(
    "--set", "parameters", multiple=True, metavar="NAME=VALUE",
    help="A parameter of the mechanism, such as joint=spherical; may be given again.",
)  # fmt: skip
FORMULATION = click.option(
    "--formulation", default="standard", show_default=True, metavar="NAME",
    help="standard, penalty or augmented_lagrangian.",
)  # fmt: skip
THREADS = click.option(
    "--threads", default=1, show_default=True, metavar="N",
    help="Threads that share one right-hand side, where the mechanism is large enough.",
)  # fmt: skip
JSON = click.option("--json", "as_json", is_flag=True, help="Print one JSON document.")


def _repeats(rounds: int) -> Callable[[Any], Any]:
    text = "Rounds of which the medians are taken."
    return click.option("--repeats", default=rounds, show_default=True, metavar="N", help=text)


def _limit(seconds: float, text: str) -> Callable[[Any], Any]:
    return click.option("--limit", default=seconds, show_default=True, metavar="SECONDS", help=text)


@bench.command()
@_options(
    MECHANISM,
    click.option(
        "--bodies",
        type=int,
        metavar="N",
        help="The largest mechanism with no more bodies.  [default: 1000 for chain, else its own]",
    ),
    PARAMETERS,
    click.option(
        "--solver", "solvers", default="all", show_default=True, metavar="NAME,...", help="Linear solvers."
    ),
    FORMULATION,
    click.option(
        "--matrix-form",
        default="auto",
        show_default=True,
        metavar="NAME",
        help="Matrix of the standard method.",
    ),
    _repeats(15),
    _limit(30.0, "Time for each solver's first step, in a process of its own."),
    THREADS,
    JSON,
)
def rhs(**values: Any) -> None:
    """Time one right-hand side by every linear solver.

    \b
    linkwork bench rhs --mechanism chain --bodies 1000
    linkwork bench rhs --mechanism net --bodies 1740 --solver block,cholmod --json

    A right-hand side is evaluation, assembly, factorization, solution for accelerations and multipliers, and
    the reactions of the joints, in the state after one step. A solver that cannot do it is listed with the
    reason. Factors: their bytes with indices and workspace, and their nonzeros over those of the matrix's
    lower triangle (fill). Peak memory is that of a process of its own that makes the first step.
    """
    from linkwork.cli import benchmarking

    benchmarking.right_hand_side(**values)


@bench.command()
@_options(
    MECHANISM,
    click.option(
        "--bodies", "sizes", default="1000,10000,100000", show_default=True, metavar="N,...",
        help="For each the largest mechanism with no more bodies.",
    ),
    PARAMETERS,
    click.option(
        "--solver", "linear_solver", default="auto", show_default=True, metavar="NAME", help="Linear solver."
    ),
    FORMULATION,
    _repeats(15),
    _limit(600.0, "Time for each size, in a process of its own."),
    THREADS,
    JSON,
)  # fmt: skip
def scaling(**values: Any) -> None:
    """Time right-hand sides of one mechanism in several sizes, and count its memory.

    \b
    linkwork bench scaling --mechanism chain --bodies 1000,10000,100000

    Building is the Python model; compiling is from there to the first evaluation: system, rank of the
    constraints, symbolic analysis. Memory is what is resident beyond the interpreter.
    """
    from linkwork.cli import benchmarking

    benchmarking.scaling(**values)


@bench.command()
@_options(
    click.option(
        "--mechanism", "mechanisms", default="all", show_default=True, metavar="NAME,...",
        help="Mechanisms of `linkwork list`.",
    ),
    _repeats(5),
    click.option("--runs/--no-runs", default=True, show_default=True, help="Make the runs of 10 s, too."),
    JSON,
)  # fmt: skip
def step(**values: Any) -> None:
    """Time the steps of every mechanism, and runs of 10 s.

    \b
    linkwork bench step
    linkwork bench step --mechanism chain,net --no-runs --json

    Steps are those of RK4 with the settings that the mechanism recommends, four right-hand sides each.
    Watching is what following the steps takes, and is part of them; verdict is what is taken again
    afterwards, beside them: of runs of so many steps, at most 3 % from 10 000 on. The runs go through
    `simulate`, from the model to the result: bricard, and a row of 40 four-bars.
    """
    from linkwork.cli import benchmarking

    benchmarking.step(**values)


@bench.command()
@_options(
    click.option(
        "--mechanism", "mechanisms", default="all", show_default=True, metavar="NAME,...",
        help="Mechanisms of `linkwork list`; all: a chain, a ladder of four-bars, three with loops in space.",
    ),
    _repeats(9),
    click.option(
        "--threads", default="1,2", show_default=True, metavar="N,...",
        help="Threads, each with a pack of its own.",
    ),
    JSON,
)  # fmt: skip
def ensemble(**values: Any) -> None:
    """Time right-hand sides of many equal mechanisms in the lanes of the processor.

    \b
    linkwork bench ensemble
    linkwork bench ensemble --mechanism chain,bricard --threads 1,4 --json

    Beside that of one mechanism by itself, and where they are installed beside MuJoCo's rollout of the
    chain and Pinocchio: aba of trees, constrained dynamics of loops. Accelerations are compared first: other
    ones are an error, and of Pinocchio have no time.
    """
    from linkwork.cli import benchmarking

    benchmarking.ensemble(**values)


@bench.command()
@_options(
    click.option(
        "--models", default="all", show_default=True, metavar="NAME,...",
        help="net, chain, lattice, hexagonal net, net capture, scissors, tracked vehicle, rope, ladder.",
    ),
    click.option(
        "--size", default="small", show_default=True, metavar="NAME",
        help="small: some hundred bodies; full: as published, up to 1,076,748 of them.",
    ),
    click.option(
        "--links", type=int, metavar="N", help="Instead: of each model the largest with no more bodies."
    ),
    click.option(
        "--method", "methods", default="semi_implicit_euler,abm4,rk4,dop853", show_default=True,
        metavar="NAME,...", help="Integrators.",
    ),
    click.option(
        "--steps", "halvings", default=4, show_default=True, metavar="N",
        help="How many are tried: the model's longest, half of it, and so on.",
    ),
    click.option(
        "--repeats", default=3, show_default=True, metavar="N", help="Of each run; the least time counts."
    ),
    THREADS,
    click.option(
        "--peers/--no-peers", default=True, show_default=True,
        help="MuJoCo and Exudyn beside, where they are installed.",
    ),
    _limit(300.0, "CPU time for the runs of one model; what would take longer is left out, and said."),
    JSON,
)  # fmt: skip
def large(**values: Any) -> None:
    """Measure the error of large models against the CPU time of their steps.

    \b
    linkwork bench large
    linkwork bench large --models chain,net --links 10000 --repeats 1
    linkwork bench large --models chain --size full --json

    Methods run at several steps; the error is the largest distance of a body from its place in a run by
    dop853 with the shortest step, over the farthest way of one. A time counts only where the run kept its
    joints, its energy and its width. Beyond 100,000 bodies only the cost of a step is measured.
    """
    from linkwork.cli import benchmarking

    benchmarking.large(**values)
