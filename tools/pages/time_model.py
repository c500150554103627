"""Milliseconds that presets would take on GPUs, from the operations of their bytecode: a prediction, not a measurement.

A pass of the filters takes the time in which the GPU executes its operations, at a share of its peak rate that is fitted
to the times of gpu-times/1920x1080. Fetches, divergence and what a driver's compiler changes are in that share. The
share of each technique differs from their mean; the spread over techniques gives the error of a prediction. Besides,
textures pass through memory at its bandwidth, and each dispatch waits for the one before.
"""
import math
from typing import NamedTuple

from figures import STUDENT, code, distinct, groups, mean
from markdown import Problem, table

PIXELS = 1920 * 1080
# Every dispatch costs this beside its work. It is a little more than the 3 microseconds that the emptiest pass of
# cell-pcss took on the H200.
DISPATCH_MS = 0.005


class Gpu(NamedTuple):
    name: str
    teraflops: float  # of 32 bits, as the maker says
    gigabytes_per_second: float


# Makers' specifications.
GPUS = (Gpu("NVIDIA H200", 67.0, 4800.0), Gpu("GeForce RTX 4080", 48.7, 717.0),
        Gpu("GeForce RTX 4060", 15.1, 272.0), Gpu("Radeon RX 6600", 8.9, 224.0), Gpu("Steam Deck", 1.6, 88.0))


def gpu_of(device):
    for gpu in GPUS:
        if gpu.name in device:
            return gpu
    raise Problem(f"the peak rate of '{device}' is not known: add it to GPUS of tools/pages/time_model.py")


class Fit(NamedTuple):
    log_share: float  # mean logarithm of the share of the peak rate
    error: float      # of a prediction for another technique, as a logarithm: half its 95 % interval
    shares: dict      # by technique


def peak_ms(operations_per_pixel, teraflops):
    """The time of the operations of a picture at the GPU's peak rate, at which an FMA counts twice."""
    return operations_per_pixel * PIXELS / (0.5 * teraflops * 1e9)


def fit(times, counts):
    """From the times and the operations of the same techniques, of one pass each, in the same pictures."""
    gpu = gpu_of(times["device"])
    operations = {(one["technique"], one["scene"], one["light_degrees"]): one["operations_per_pixel"]
                  for one in counts["records"]}
    shares = {}
    for (technique,), records in groups(times["records"], "technique"):
        pairs = [(peak_ms(operations[key], gpu.teraflops), one["time_ms_median"] - DISPATCH_MS - map_ms(one, gpu))
                 for one in records
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


def map_ms(record, gpu):
    """The map comes from memory once, with 4 bytes for each texel."""
    return 4.0 * record["map_size"] ** 2 / (gpu.gigabytes_per_second * 1e6)


def memory_ms(record, gpu):
    """Every texel that a pass writes goes to memory and comes back, too."""
    texels = sum(one["texels_written_per_pixel"] for one in record["passes"]) * PIXELS
    return map_ms(record, gpu) + 8.0 * texels / (gpu.gigabytes_per_second * 1e6)


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
            f" {len(distinct(results['records'], 'scene'))} scenes. In parentheses: the 95 % prediction interval over the"
            f" {len(fitted.shares)} filters that were fitted, all of one pass; it covers neither other GPUs, nor the choice"
            f" of scenes, nor kernels that wait for each other. Operations of FXC's bytecode per operation that the"
            f" {times['device']} could execute at its peak: {shares}. Predicted time over measured time of each of these,"
            f" when it is left out of the fit: {missed}. Commands: `{times['command']}`,"
            f" `{counts['command']}`, `{results['command']}`.\n\n"
            + table(["preset", *(f"{gpu.name}, ms" for gpu in GPUS)], rows, 1))
