"""Statistics of runs in pairs: the median of ratios, and a bootstrap interval for it."""
import fractions
import math
import random
import statistics

RESAMPLES = 5000


def bootstrap_interval(values, confidence, seed=2004):
    """The interval between the (1 - confidence) / 2 and (1 + confidence) / 2 quantiles of the medians of bootstrap
    samples (Efron, "Bootstrap methods: another look at the jackknife", 1979). A sample has as many values as there are,
    drawn with replacement. The seed is fixed, so the same values give the same interval."""
    draw = random.Random(seed)
    medians = sorted(statistics.median(draw.choices(values, k=len(values))) for _ in range(RESAMPLES))
    outside = (1 - confidence) / 2
    return medians[int(outside * RESAMPLES)], medians[min(RESAMPLES - 1, int((1 - outside) * RESAMPLES))]


def sign_interval(values, confidence):
    """The narrowest interval between the k-th least and the k-th greatest value that contains the median of their
    distribution with at least this confidence, whatever the distribution: at most k - 1 of n values lie on one side of
    the median with the probability of at most k - 1 heads in n throws of a coin. (0, infinity) if n is too small."""
    n, below, k = len(values), 0, 0
    most = fractions.Fraction(1 - confidence) * 2 ** n  # for many values, larger than any double
    while 2 * (below + math.comb(n, k)) <= most:
        below += math.comb(n, k)
        k += 1
    ordered = sorted(values)
    return (ordered[k - 1], ordered[n - k]) if k > 0 else (0.0, math.inf)


def median_interval(values, confidence):
    """The median of positive values, and an interval for the median of their distribution: the bootstrap interval,
    widened to the sign interval. For few values the bootstrap interval alone is too narrow: of 15 values, that of 99 %
    begins at the fourth least one, and in 1.8 % of all cases at most three of 15 lie below the median. Precondition:
    there are values, and 0 < confidence < 1."""
    intervals = bootstrap_interval(values, confidence), sign_interval(values, confidence)
    return statistics.median(values), min(low for low, _ in intervals), max(high for _, high in intervals)


def in_pairs(first, second, pairs, draw):
    """Calls both functions `pairs` times, in pairs. `draw`, a random.Random, decides which one of a pair is called first,
    so that neither a machine that gets slower nor the call before favours one of them. Returns the pairs of results."""
    results = []
    for _ in range(pairs):
        if draw.random() < 0.5:
            one = first()
            results.append((one, second()))
        else:
            two = second()
            results.append((first(), two))
    return results


def verdict(low, high, confidence):
    """What an interval of ratios, the time of B divided by that of A, says."""
    if low == 0:
        return f"too few pairs for an interval of {100 * confidence:g} %"
    if low <= 1 <= high:
        return f"no difference shown: the {100 * confidence:g} % interval includes 1"
    return "B is slower" if low > 1 else "B is faster"
