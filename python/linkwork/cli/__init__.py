"""The command `linkwork`. Errors are lines on standard error: `error: what, which, which value`.

With `--json` they are {"error": {type, code, message, ...}} on standard output, too.

Exit codes: 0 done, 1 the model, the options or the run failed, 2 the command line is wrong, 130 interrupted,
143 asked to end (SIGTERM).
"""

from __future__ import annotations

import logging
import os
import sys
import warnings
from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any, NoReturn

import click

from linkwork.cli import base, logs, shells, streams
from linkwork.cli.commands import linkwork
from linkwork.errors import LinkworkError, cause
from linkwork.running.interrupts import Terminated, honor_termination

__all__ = ["main"]

log = logging.getLogger(__name__)

#: Exit codes by ctrl-C and by SIGTERM.
INTERRUPTED = (130, 143)


def main(arguments: Sequence[str] | None = None) -> None:
    """Run one command and exit.

    Anywhere on the line, `--debug` lets exceptions through, and `--force` replaces files that are there.
    """
    streams.replace_closed()
    streams.escape_letters()
    if shells.VARIABLE in os.environ:
        sys.exit(shells.complete(linkwork))
    words = list(sys.argv[1:] if arguments is None else arguments)
    debug = "--debug" in words
    base.replace_files("--force" in words)
    honor_termination()
    warnings.showwarning = _show_warning
    logging.getLogger("matplotlib").setLevel(logging.ERROR)  # its remarks on fonts and caches
    code = run([word for word in words if word not in ("--debug", "--force")], debug)
    if code in INTERRUPTED:
        _leave(code)
    sys.exit(code)


def _leave(code: int) -> NoReturn:
    """At once: what a large model takes up is not given back piece by piece."""
    streams.flush()
    logging.shutdown()
    os._exit(code)


def run(words: list[str], debug: bool) -> int:
    """The exit code of one command; its errors are told in one line."""
    try:
        code = _run(words, debug)
    finally:
        log_failure = logs.close()
    if log_failure is None:
        return code
    streams.say("error", str(log_failure))
    return code or 1


def _run(words: list[str], debug: bool) -> int:
    tell = partial(_complain, as_json="--json" in words)
    try:
        return _invoke(words)
    except click.ClickException as error:
        return tell(_sentence(error), 2)
    except (KeyboardInterrupt, click.Abort) as stop:
        return tell(str(stop) or "interrupted", INTERRUPTED[isinstance(stop, Terminated)])
    except BrokenPipeError:
        streams.print_no_more()
        return 1
    except LinkworkError as error:
        if debug:
            raise
        return tell(str(error), 1, error.facts())
    except MemoryError:
        return tell("not enough memory", 1)
    except Exception as error:
        if debug:
            raise
        if streams.error_of_output(error):
            streams.print_no_more()
            return tell(f"standard output: {cause(error)}", 1)
        return tell(f"{type(error).__name__}: {error} (unexpected; --debug shows where)", 1)


def _invoke(words: list[str]) -> int:
    code = 0
    try:
        with linkwork.make_context("linkwork", words) as context:  # not main(), which prints at Ctrl-C
            linkwork.invoke(context)
    except click.exceptions.Exit as end:
        code = end.exit_code
    sys.stdout.flush()  # what is wrong with it is to be told here, not at the end of Python
    return code


def _complain(
    message: str, code: int, facts: Mapping[str, Any] | None = None, *, as_json: bool = False
) -> int:
    log.error("%s", " ".join(message.split()))
    if as_json:
        from linkwork.cli.output import print_json

        word = {2: "usage", **dict.fromkeys(INTERRUPTED, "interrupted")}.get(code, "failed")
        usual = {"type": "UsageError" if code == 2 else "Error", "code": word}
        try:
            print_json({"error": {**usual, "message": message, **(facts or {}), "exit_code": code}})
            sys.stdout.flush()
        except OSError:  # it is told on standard error
            streams.print_no_more()
    for line in message.splitlines() or [""]:
        streams.say("error", line)
    return code


#: click's words, and ours.
_WORDS = {
    "is not a valid float range": "is not a number",
    "is not a valid float": "is not a number",
    "is not a valid integer range": "is not a whole number",
    "is not a valid integer": "is not a whole number",
    "requires an argument": "needs a value, which you give after it",
    "Choose from:": "choose from",
}

#: A message with one of these says what to do.
_ADVICE = ("the nearest is", "choose from", "not one of", "needs a", "write ", "give ", "such as")


def _sentence(error: click.ClickException) -> str:
    """click's messages in the manner of ours: one line, no capital, no full stop, and what to do."""
    message = " ".join(error.format_message().split()).rstrip(".")
    for theirs, ours in _WORDS.items():
        message = message.replace(theirs, ours)
    context = getattr(error, "ctx", None)
    if context is not None and not any(advice in message for advice in _ADVICE):
        message += f"; `{context.command_path} --help` shows what is possible"
    return message[:1].lower() + message[1:]


def _show_warning(message: Warning | str, *_: Any, **__: Any) -> None:
    log.warning("%s", " ".join(str(message).split()))
    streams.say("warning", str(message))
