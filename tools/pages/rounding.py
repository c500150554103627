"""Means over scenes with no more digits than their 95 % intervals justify: "0.147 ± 0.031", "0.07 [0, 0.17]". They are
those of report.html: tools/measurement/study/interval.h has the method and its sources."""
import math

NORMAL = 1.959963984540054  # 97.5 % of the normal distribution


def student(degrees):
    """97.5 % of Student's t: exact for one and two degrees of freedom, else the expansion of interval.cpp, whose error
    is below 1 %."""
    if degrees < 3:
        return (12.706204736, 4.302652730)[degrees - 1]
    z, square = NORMAL, NORMAL ** 2
    terms = ((square + 1.0) / 4.0, ((5.0 * square + 16.0) * square + 3.0) / 96.0,
             (((3.0 * square + 19.0) * square + 17.0) * square - 15.0) / 384.0)
    return z + sum(z * term / degrees ** power for power, term in enumerate(terms, 1))


def mean_with_interval(values, errors):
    """(mean, half width) over scenes, each with its value and standard error; of one scene from its error alone."""
    count = len(values)
    if count == 1:
        return values[0], NORMAL * errors[0]
    centre = sum(values) / count
    squares = sum((value - centre) ** 2 + error ** 2 for value, error in zip(values, errors))
    return centre, student(count - 1) * math.sqrt(squares / count / (count - 1))


def decimals_of(half, most):
    """Of a half width: its second digit up to 35, else its first (the rule of the Particle Data Group's reviews)."""
    exponent = math.floor(math.log10(half))
    return min(max((half / 10.0 ** exponent < 3.55) - exponent, 0), most)


def plain(value, most):
    """Three significant digits: "4", "40.0"."""
    if value == round(value):
        return f"{value:.0f}"
    return f"{value:.{min(max(2 - math.floor(math.log10(abs(value))), 0), 3, most)}f}"


def end(value, decimals):
    return f"{value:.{0 if value == round(value) else decimals}f}"


def rounded(value, low, high, most_decimals):
    """The figure with the longer side of its interval, or with both ends where that was cut off."""
    half = max(value - low, high - value)
    if half < 0.5 * 10.0 ** -most_decimals:
        return plain(value, most_decimals)
    decimals = decimals_of(half, most_decimals)
    if abs((value - low) - (high - value)) <= 1e-6 * half:
        return f"{value:.{decimals}f} ± {half:.{decimals}f}"
    return f"{value:.{decimals}f} [{end(low, decimals)}, {end(high, decimals)}]"


def mean_text(estimates, most=1.0, scale=1.0, most_decimals=4):
    """Of (value, standard error) of each scene; the interval ends at 0 and at `most`."""
    if not estimates:
        return "–"
    centre, half = mean_with_interval(*zip(*estimates))
    low, high = max(centre - half, 0.0), min(centre + half, most)
    return rounded(*(scale * figure for figure in (centre, low, high)), most_decimals)
