"""Content hashes of models and studies: equal for equal values, in any process, on any machine."""

from linkwork.fingerprints.laws import law
from linkwork.fingerprints.origins import called_from_ctypes
from linkwork.fingerprints.writing import canonical, digest, digests, plain

__all__ = ["called_from_ctypes", "canonical", "digest", "digests", "law", "plain"]
