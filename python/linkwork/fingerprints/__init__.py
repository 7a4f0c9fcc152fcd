"""Content hashes of models and studies: equal for equal values, in any process, on any machine."""

from linkwork.fingerprints.laws import law, under_way
from linkwork.fingerprints.numbers import plain
from linkwork.fingerprints.origins import called_from_ctypes, is_users
from linkwork.fingerprints.writing import canonical, digest, digests, together

__all__ = [
    "called_from_ctypes",
    "canonical",
    "digest",
    "digests",
    "is_users",
    "law",
    "plain",
    "together",
    "under_way",
]
