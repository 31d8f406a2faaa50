"""`certify`: a mesher against all families of domains."""

from __future__ import annotations

import random
from dataclasses import dataclass
from typing import Any, Collection, Dict, Iterable, List, Optional, Tuple, Union

import numpy.typing as npt
from hypothesis import Phase, Verbosity, find, settings
from hypothesis.errors import Flaky, NoSuchExample

from ..checking import Certificate
from ..domain import Domain
from ..errors import UsageError
from ..scalars import number, whole
from .code import code_of
from .families import Family, named
from .judging import Mesher, Verdict, judged, plain


@dataclass(frozen=True)
class Summary:
    """What `certify` did: the number of domains of each family, and of triangles. All meshes were right."""

    domains: Dict[str, int]
    triangles: int

    def __str__(self) -> str:
        return (f"certified: {sum(self.domains.values())} domains of {len(self.domains)} families, "
                f"{self.triangles} triangles")


class NotCertified(AssertionError):
    """A mesher failed on a domain. The text has the reason, and one line of Python that repeats the run.

    domain: the smallest domain found. family: the name of its family. min_angle: the bound. reason: lines of text.
    code: the line. certificate: that of the wrong mesh; None if there was none. If the mesher raised an exception, it
    is the ``__cause__``.
    """

    def __init__(self, mesher: Mesher, domain: Domain, min_angle: float, verdict: Verdict, family: str,
                 ignore: Collection[str], note: str = "") -> None:
        rules = f", ignore={sorted(ignore)!r}" if ignore else ""
        self.domain, self.family, self.min_angle = domain, family, min_angle
        self.reason = verdict.text + note
        self.certificate: Optional[Certificate] = verdict.certificate
        self.code = f"pardel.testing.replay({_name_of(mesher)}, {code_of(domain)}, min_angle={min_angle:.17g}{rules})"
        of = f" of the family {family}" if family else ""
        super().__init__(f"{self.reason}\non the domain{of}: {len(domain.points)} points, {len(domain.segments)} "
                         f"segments, {len(domain.holes)} holes. This line repeats it:\n{self.code}")


class _Search:
    """Runs the mesher on the domains that Hypothesis draws, and remembers the smallest one that failed."""

    def __init__(self, mesher: Mesher, min_angle: float, ignore: Collection[str]) -> None:
        self._mesher, self._min_angle, self._ignore = mesher, min_angle, ignore
        self._failed: List[Tuple[Domain, Verdict]] = []
        self.tried = self.triangles = 0

    def fails(self, drawn: Domain) -> bool:
        """Once a domain has failed, others count only if they fail in the same way, so that one mistake is shrunk."""
        if not isinstance(drawn, Domain):
            raise UsageError(f"a strategy of families drew a {type(drawn).__name__}; a Domain is needed")
        domain = plain(drawn)
        verdict = judged(self._mesher, domain, self._min_angle, self._ignore)
        if not self._failed:
            self.tried += 1
            self.triangles += verdict.certificate.triangles if verdict.certificate and not verdict.kind else 0
        if not verdict.kind or self._failed and not _is_alike(verdict, self._failed[0][1]):
            return False
        self._failed.append((domain, verdict))
        return True

    def smallest(self) -> Tuple[Domain, Verdict]:
        return min(reversed(self._failed), key=lambda found: (len(found[0].points), len(found[0].segments)))


def _name_of(mesher: Mesher) -> str:
    """What the mesher is called in code."""
    name = getattr(mesher, "__name__", "")
    return name if name.isidentifier() else "mesher"


def _is_alike(verdict: Verdict, first: Verdict) -> bool:
    return verdict.kind == first.kind and type(verdict.error) is type(first.error)


def _check_arguments(mesher: Any, min_angle: Any, ignore: Any) -> None:
    if not callable(mesher):
        raise UsageError(f"mesher is a {type(mesher).__name__}; a function of points, segments, holes and min_angle "
                         "is needed")
    if isinstance(ignore, str):
        raise UsageError(f"ignore is {ignore!r}; a list of kinds of violations is needed")
    if not 0 <= number("min_angle", min_angle) < 60:
        raise UsageError(f"min_angle is {min_angle}; a number from 0 to below 60 degrees is needed")


def certify(mesher: Mesher, *, min_angle: float = 20.7, max_examples: int = 100,
            families: Optional[Union[Family, Iterable[Family]]] = None, seed: int = 0,
            ignore: Collection[str] = ()) -> Summary:
    """Runs a mesher on random domains, and checks each mesh in exact arithmetic with `pardel.check`.

    mesher: any function of (points, segments, holes, min_angle) that returns (points, triangles). It gets arrays of
        the shapes (n, 2), (m, 2) and (h, 2), which it may change; the bound is in degrees. Without segments, the domain
        is the convex hull of the points. The mesh may number the points in any order.
    min_angle: the least angle in degrees; 0: none. Smaller angles are allowed where small angles of the domain make
        them unavoidable.
    max_examples: the number of domains per family.
    families: names, see `domains`, or strategies of your own for domains; None: all.
    seed: other seeds give other domains. The same seed gives the same ones with one version of Hypothesis.
    ignore: kinds of violations that do not count, for example ``["not_delaunay"]`` for meshers that promise less.

    Returns a `Summary` if all meshes are right. Else raises `NotCertified`, an AssertionError, for the first family
    with a failure: a wrong mesh, an exception, or a result that is no mesh. The domain is shrunk, and the text has one
    line of Python that repeats the run. A mesher that does not end is not stopped. Raises `UsageError`.

    >>> import pardel
    >>> def mine(points, segments, holes, min_angle):
    ...     made = pardel.mesh(points, segments, holes=holes, min_angle=min_angle)
    ...     return made.points, made.triangles
    >>> certify(mine, max_examples=5).domains["holes"]
    5
    """
    _check_arguments(mesher, min_angle, ignore)
    strategies = named(families)
    if whole("max_examples", max_examples) == 0:
        raise UsageError("max_examples is 0; at least 1 is needed")
    options = settings(max_examples=max_examples, database=None, deadline=None, phases=(Phase.generate, Phase.shrink),
                       verbosity=Verbosity.quiet)
    tried: Dict[str, int] = {}
    triangles = 0
    for family, strategy in strategies.items():
        search, note = _Search(mesher, min_angle, ignore), ""
        try:
            find(strategy, search.fails, settings=options, random=random.Random(whole("seed", seed)))
        except NoSuchExample:
            tried[family] = search.tried
            triangles += search.triangles
            continue
        except Flaky:
            note = "\nanother run on the same domain gave another result"
        domain, verdict = search.smallest()
        raise NotCertified(mesher, domain, min_angle, verdict, family, ignore, note) from verdict.error
    return Summary(tried, triangles)


def replay(mesher: Mesher, points: npt.ArrayLike, segments: Optional[npt.ArrayLike] = None,
           holes: Optional[npt.ArrayLike] = None, *, min_angle: float = 20.7,
           ignore: Collection[str] = ()) -> Certificate:
    """Runs a mesher on one domain, as `certify` does: what the line that it prints calls.

    The arguments are those of `certify` and of `pardel.Domain`. Returns the certificate of the mesh. Raises
    `NotCertified`, `UsageError`, and `InvalidInput` if the domain is not valid.

    >>> import pardel
    >>> replay(lambda points, *_: (points, [(0, 1, 2)]), [(0, 0), (1, 0), (0, 1)]).valid
    True
    """
    _check_arguments(mesher, min_angle, ignore)
    domain = Domain(points, segments, holes=holes)
    verdict = judged(mesher, domain, min_angle, ignore)
    if verdict.kind:
        raise NotCertified(mesher, domain, min_angle, verdict, "", ignore) from verdict.error
    if verdict.certificate is None:
        raise AssertionError("a mesh that is right has a certificate")
    return verdict.certificate
