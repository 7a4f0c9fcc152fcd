"""Formulas in t: read without executing anything, evaluated with their first two derivatives."""

from __future__ import annotations

import ast
import math
import operator
from collections.abc import Callable, Mapping
from dataclasses import dataclass

from linkwork.errors import ModelError, nearest

#: Longer text is not a formula that somebody wrote.
LONGEST = 2000


@dataclass(slots=True)  # not frozen: that would make it three times as slow
class Jet:
    """f, df/dt and d2f/dt2 at one time; derivatives are NaN where there are none, as of sqrt(t) at 0."""

    f: float
    df: float = 0.0
    ddf: float = 0.0

    def __add__(self, other: Jet) -> Jet:
        return Jet(self.f + other.f, self.df + other.df, self.ddf + other.ddf)

    def __sub__(self, other: Jet) -> Jet:
        return Jet(self.f - other.f, self.df - other.df, self.ddf - other.ddf)

    def __neg__(self) -> Jet:
        return Jet(-self.f, -self.df, -self.ddf)

    def __pos__(self) -> Jet:
        return self

    def __mul__(self, other: Jet) -> Jet:
        return Jet(
            self.f * other.f,
            self.df * other.f + self.f * other.df,
            self.ddf * other.f + 2 * self.df * other.df + self.f * other.ddf,
        )

    def __truediv__(self, other: Jet) -> Jet:
        return self * other.apply(1 / other.f, _over(-1, other.f**2), _over(2, other.f**3))

    def __pow__(self, other: Jet) -> Jet:
        if self.f < 0 and other.f != round(other.f):
            raise ValueError("a root of a negative number")
        if other.df == other.ddf == 0:
            n = other.f
            first = n * _power(self.f, n - 1) if n else 0.0
            second = n * (n - 1) * _power(self.f, n - 2) if n not in (0, 1) else 0.0
            return self.apply(self.f**n, first, second)
        if self.f <= 0:
            return Jet(self.f**other.f, math.nan, math.nan)
        return _exp(other * _log(self))

    def apply(self, g: float, dg: float, ddg: float) -> Jet:
        """g(f) for a function g with these derivatives at f."""
        return Jet(g, dg * self.df, ddg * _power(self.df, 2) + dg * self.ddf)


def _over(a: float, b: float) -> float:
    """Of a derivative that may not be: NaN."""
    return a / b if b else math.nan


def _power(x: float, n: float) -> float:
    """Of a derivative that may not be: NaN."""
    try:
        return float(x**n)
    except ArithmeticError:
        return math.nan


def _exp(x: Jet) -> Jet:
    value = math.exp(x.f)
    return x.apply(value, value, value)


def _log(x: Jet) -> Jet:
    return x.apply(math.log(x.f), 1 / x.f, _over(-1, x.f**2))


def _sqrt(x: Jet) -> Jet:
    root = math.sqrt(x.f)
    return x.apply(root, _over(0.5, root), _over(-0.25, root**3))


def _sin(x: Jet) -> Jet:
    return x.apply(math.sin(x.f), math.cos(x.f), -math.sin(x.f))


def _cos(x: Jet) -> Jet:
    return x.apply(math.cos(x.f), -math.sin(x.f), -math.cos(x.f))


def _tan(x: Jet) -> Jet:
    return _sin(x) / _cos(x)


def _tanh(x: Jet) -> Jet:
    value = math.tanh(x.f)
    return x.apply(value, 1 - value**2, -2 * value * (1 - value**2))


def _asin(x: Jet) -> Jet:
    slope = _over(1, math.sqrt(1 - x.f**2))
    return x.apply(math.asin(x.f), slope, x.f * slope**3)


def _acos(x: Jet) -> Jet:
    slope = _over(-1, math.sqrt(1 - x.f**2))
    return x.apply(math.acos(x.f), slope, x.f * slope**3)


def _atan(x: Jet) -> Jet:
    slope = 1 / (1 + x.f**2)
    return x.apply(math.atan(x.f), slope, -2 * x.f * slope**2)


def _atan2(y: Jet, x: Jet) -> Jet:
    """The angle of (x, y): its derivatives are those of atan(y / x), or of -atan(x / y) beside the y axis."""
    if x.f == y.f == 0:
        return Jet(math.atan2(y.f, x.f), math.nan, math.nan)
    along = _atan(y / x) if abs(x.f) > abs(y.f) else -_atan(x / y)
    return Jet(math.atan2(y.f, x.f), along.df, along.ddf)


#: By the number of their arguments.
FUNCTIONS: Mapping[str, Callable[..., Jet]] = {
    "sin": _sin, "cos": _cos, "tan": _tan, "exp": _exp, "log": _log, "sqrt": _sqrt, "tanh": _tanh,
    "asin": _asin, "acos": _acos, "atan": _atan, "atan2": _atan2,
}  # fmt: skip
TWO_ARGUMENTS = ("atan2",)
CONSTANTS: Mapping[str, float] = {"pi": math.pi, "e": math.e}
BINARY: Mapping[type[ast.operator], Callable[[Jet, Jet], Jet]] = {
    ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul, ast.Div: operator.truediv,
    ast.Pow: operator.pow,
}  # fmt: skip
UNARY: Mapping[type[ast.unaryop], Callable[[Jet], Jet]] = {ast.USub: operator.neg, ast.UAdd: operator.pos}

#: A part of a formula, as a function of t.
Part = Callable[[Jet], Jet]


class Formula:
    """A formula in t. ModelError: text that is none."""

    def __init__(self, text: str) -> None:
        self.text = text
        if not isinstance(text, str) or len(text) > LONGEST:
            raise ModelError(f"expression: not a text of up to {LONGEST} characters", code="expression")
        try:
            tree = ast.parse(text.strip(), mode="eval")
            self._part = self._read(tree.body)
        except (SyntaxError, ValueError, OverflowError, RecursionError, MemoryError) as error:
            raise self._refuse("is not a formula") from error
        self._last = (math.nan, Jet(math.nan, math.nan, math.nan))

    def derivative(self, t: float, order: int) -> float:
        """Of order 0, 1 or 2 at t [s]; NaN where there is none of this order."""
        time, jet = self._last
        if t != time:  # a run asks for all three of each time
            jet = self._at(t)
            self._last = (t, jet)
        return (jet.f, jet.df, jet.ddf)[order]

    def _at(self, t: float) -> Jet:
        try:
            return self._part(Jet(t, 1.0))
        except (ArithmeticError, ValueError):
            return Jet(math.nan, math.nan, math.nan)

    def _refuse(self, why: str) -> ModelError:
        return ModelError(f"expression '{self.text[:80]}' {why}", code="expression")

    def _read(self, node: ast.expr) -> Part:
        if isinstance(node, ast.Constant) and type(node.value) in (int, float):
            number = Jet(float(node.value))
            return lambda t: number
        if isinstance(node, ast.Name):
            return self._name(node.id)
        if isinstance(node, ast.UnaryOp) and type(node.op) in UNARY:
            sign, inner = UNARY[type(node.op)], self._read(node.operand)
            return lambda t: sign(inner(t))
        if isinstance(node, ast.BinOp) and type(node.op) in BINARY:
            combine, left, right = BINARY[type(node.op)], self._read(node.left), self._read(node.right)
            return lambda t: combine(left(t), right(t))
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and not node.keywords:
            return self._call(node.func.id, node.args)
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.BitXor):
            raise self._refuse("has a ^: powers are written with **, such as t**2")
        raise self._refuse(f"has a part that formulas cannot have: {ast.unparse(node)[:40]}")

    def _name(self, name: str) -> Part:
        if name == "t":
            return lambda t: t
        if name in CONSTANTS:
            number = Jet(CONSTANTS[name])
            return lambda t: number
        raise self._refuse(f"has the unknown name '{name}'{nearest(name, ['t', *CONSTANTS, *FUNCTIONS])}")

    def _call(self, name: str, arguments: list[ast.expr]) -> Part:
        if name not in FUNCTIONS:
            raise self._refuse(f"has the unknown function '{name}'{nearest(name, FUNCTIONS)}")
        count = 2 if name in TWO_ARGUMENTS else 1
        if len(arguments) != count:
            raise self._refuse(f"gives {name} {len(arguments)} arguments, not {('one', 'two')[count - 1]}")
        function, inner = FUNCTIONS[name], [self._read(argument) for argument in arguments]
        return lambda t: function(*(part(t) for part in inner))
