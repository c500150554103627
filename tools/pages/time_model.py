"""Milliseconds that presets would take on GPUs, from the operations of their bytecode: a prediction, not a measurement.

A pass of the filters takes the time in which the GPU executes its operations, at a share of its peak rate that is fitted
to the times of gpu-times/1920x1080. The share of each technique differs from their mean; the spread over techniques
gives the error of a prediction. Besides, textures pass through memory at its bandwidth, and each dispatch waits for the
one before.
"""
import math
from typing import NamedTuple

from figures import STUDENT, code, distinct, groups, mean
from markdown import Problem, table

TIMED_TERAFLOPS = 67.0  # of the NVIDIA H200, of 32 bits, as its maker says; an FMA counts twice
PIXELS = 1920 * 1080
# The wait between two dispatches that depend on each other; cell-pcss's emptiest pass took 3 microseconds on the H200.
DISPATCH_MS = 0.005


class Gpu(NamedTuple):
    name: str
    teraflops: float  # of 32 bits, as the maker says
    gigabytes_per_second: float


# Makers' specifications.
GPUS = (Gpu("NVIDIA H200", TIMED_TERAFLOPS, 4800.0), Gpu("GeForce RTX 4080", 48.7, 717.0),
        Gpu("GeForce RTX 4060", 15.1, 272.0), Gpu("Radeon RX 6600", 8.9, 224.0), Gpu("Steam Deck", 1.6, 88.0))


class Fit(NamedTuple):
    log_share: float  # mean logarithm of the share of the peak rate
    error: float      # of a prediction for another technique, as a logarithm: half its 95 % interval
    shares: dict      # by technique


def peak_ms(operations_per_pixel, teraflops):
    """The time of the operations of a picture at the GPU's peak rate, at which an FMA counts twice."""
    return operations_per_pixel * PIXELS / (0.5 * teraflops * 1e9)


def fit(times, counts):
    """From the times and the operations of the same techniques in the same pictures."""
    operations = {(one["technique"], one["scene"], one["light_degrees"]): one["operations_per_pixel"]
                  for one in counts["records"]}
    shares = {}
    for (technique,), records in groups(times["records"], "technique"):
        pairs = [(peak_ms(operations[key], TIMED_TERAFLOPS), one["time_ms_median"] - DISPATCH_MS) for one in records
                 if (key := (technique, one["scene"], one["light_degrees"])) in operations]
        if pairs:
            shares[technique] = math.exp(mean(math.log(peak / taken) for peak, taken in pairs))
    if len(shares) < 3:
        raise Problem("the times and the operations of fewer than three techniques say nothing of another")
    logs = [math.log(share) for share in shares.values()]
    centre = mean(logs)
    deviation = math.sqrt(sum((each - centre) ** 2 for each in logs) / (len(logs) - 1))
    return Fit(centre, STUDENT[len(logs) - 2] * deviation * math.sqrt(1.0 + 1.0 / len(logs)), shares)


def left_out(times, counts):
    """The ratio of the predicted time of each technique to the measured one, when the others alone are fitted."""
    return {technique: math.exp(math.log(share) - mean(math.log(other) for name, other in shares.items()
                                                       if name != technique))
            for shares in (fit(times, counts).shares,) for technique, share in shares.items()}


def memory_ms(record, gpu):
    """Every texel that a pass writes goes to memory and comes back, and the map comes once; 4 bytes each."""
    texels = sum(one["texels_written_per_pixel"] for one in record["passes"]) * PIXELS
    return 4.0 * (2.0 * texels + record["map_size"] ** 2) / (gpu.gigabytes_per_second * 1e6)


def predicted_ms(record, gpu, fitted):
    """(lowest, middle, highest) milliseconds."""
    rest = memory_ms(record, gpu) + DISPATCH_MS * len(record["passes"])
    return tuple(peak_ms(record["operations_per_pixel"], gpu.teraflops) / math.exp(fitted.log_share + sign * fitted.error)
                 + rest for sign in (1.0, 0.0, -1.0))


def predictions(results, times, counts, light):
    """One row per preset, one column per GPU; under one light, means over the scenes."""
    fitted = fit(times, counts)
    rows = []
    for (technique,), records in groups(results["records"], "technique"):
        own = [record for record in records if record["light_degrees"] == light]
        if not technique.startswith("preset-"):
            continue
        cells = []
        for gpu in GPUS:
            low, middle, high = (mean(each) for each in zip(*(predicted_ms(record, gpu, fitted) for record in own)))
            cells.append(f"{middle:.2f} ({low:.2f} to {high:.2f})")
        rows.append([code(technique), *cells])
    shares = ", ".join(f"{code(name)} {share:.2f}" for name, share in fitted.shares.items())
    missed = ", ".join(f"{code(name)} {ratio:.2f}" for name, ratio in left_out(times, counts).items())
    return (f"Predicted, not measured: milliseconds at 1920 x 1080 under a light of {light:g}°, mean of"
            f" {len(distinct(results['records'], 'scene'))} scenes, and the 95 % interval for a technique that was not"
            f" fitted. Share of the peak rate on an {times['device']}: {shares}. Predicted time over measured time of each"
            f" of these, when it is left out of the fit: {missed}. Commands: `{times['command']}`,"
            f" `{counts['command']}`, `{results['command']}`.\n\n"
            + table(["preset", *(f"{gpu.name}, ms" for gpu in GPUS)], rows, 1))
