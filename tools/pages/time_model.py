"""Milliseconds that presets would take on GPUs, from what their passes count: a prediction, not a measurement.

A pass of the filters takes the time in which the GPU executes its operations at its peak rate, times one factor, and that
in which its texture units answer its fetches at theirs, times another. Both factors are fitted to the times of
gpu-times/1920x1080; divergence and what a driver's compiler changes are in them. Every fetch of these filters asks for
four texels of four bytes, so the bytes that they read would give the same fit. What it leaves of each technique's time
gives the error of a prediction. Besides, textures pass through memory at its bandwidth, and each dispatch waits for the
one before.
"""
import math
from typing import NamedTuple

from figures import STUDENT, all_fetches, code, distinct, groups, mean
from markdown import Problem, table

PIXELS = 1920 * 1080
# Every dispatch costs this beside its work. It is a little more than the 3 microseconds that the emptiest pass of
# cell-pcss took on the H200.
DISPATCH_MS = 0.005


class Gpu(NamedTuple):
    name: str
    teraflops: float  # of 32 bits, as the maker says
    gigatexels_per_second: float  # filtered texels
    gigabytes_per_second: float


# Makers' specifications.
GPUS = (Gpu("NVIDIA H200", 67.0, 1045.0, 4800.0), Gpu("GeForce RTX 4080", 48.7, 762.0, 717.0),
        Gpu("GeForce RTX 4060", 15.1, 236.0, 272.0), Gpu("Radeon RX 6600", 8.9, 279.0, 224.0),
        Gpu("Steam Deck", 1.6, 51.2, 88.0))


def gpu_of(device):
    for gpu in GPUS:
        if gpu.name in device:
            return gpu
    raise Problem(f"the peak rate of '{device}' is not known: add it to GPUS of tools/pages/time_model.py")


class Work(NamedTuple):
    """Milliseconds at the GPU's peak rates."""
    operations: float
    fetches: float


def work_of(record, gpu):
    """An FMA counts twice in a GPU's teraflops."""
    return Work(record["operations_per_pixel"] * PIXELS / (0.5 * gpu.teraflops * 1e9),
                all_fetches(record) * PIXELS / (gpu.gigatexels_per_second * 1e6))


class Fit(NamedTuple):
    factors: Work     # time per time at the peak rates
    deviation: float  # of the logarithm of a technique's time
    freedom: int
    shares: tuple     # of operations in the time, by technique

    def ms(self, work):
        return self.factors.operations * work.operations + self.factors.fetches * work.fetches

    def leverage(self, work):
        """How uncertain the factors are for such work, as a multiple of the deviation's square."""
        share = self.factors.operations * work.operations / self.ms(work)
        centre = mean(self.shares)
        spread = sum((each - centre) ** 2 for each in self.shares)
        return 1.0 / len(self.shares) + ((share - centre) ** 2 / spread if spread > 0.0 else 0.0)

    def error(self, work):
        """Of the logarithm of a prediction: half its 95 % interval."""
        return STUDENT[self.freedom - 1] * self.deviation * math.sqrt(1.0 + self.leverage(work))


def geometric_mean(values):
    return math.exp(mean(math.log(value) for value in values))


def timed_work(times, counts):
    """By technique: (work, milliseconds), geometric means over the same pictures; of techniques of one pass."""
    gpu = gpu_of(times["device"])
    counted = {(one["technique"], one["scene"], one["light_degrees"]): one for one in counts["records"]}
    found = {}
    for (technique,), records in groups(times["records"], "technique"):
        pairs = [(work_of(counted[key], gpu), one["time_ms_median"] - DISPATCH_MS - map_ms(one, gpu))
                 for one in records
                 if (key := (technique, one["scene"], one["light_degrees"])) in counted]
        if pairs:
            works, taken = zip(*pairs)
            found[technique] = Work(*map(geometric_mean, zip(*works))), geometric_mean(taken)
    return found


def fit_of(timed):
    """The factors with the least squared errors of the logarithms of (work, milliseconds)."""
    if len(timed) < 3:
        raise Problem("the times and the counts of fewer than three techniques say nothing of another")

    def logs(share):
        return [math.log(taken / ((1.0 - share) * work.operations + share * work.fetches)) for work, taken in timed]

    def squares(share):
        centre = mean(logs(share))
        return sum((each - centre) ** 2 for each in logs(share))

    low, high = 0.0, 1.0
    for _ in range(60):
        third = (high - low) / 3.0
        if squares(low + third) < squares(high - third):
            high -= third
        else:
            low += third
    share = 0.5 * (low + high)
    scale = math.exp(mean(logs(share)))
    factors = Work(scale * (1.0 - share), scale * share)
    freedom = len(timed) - 2
    shares = tuple(factors.operations * work.operations /
                   (factors.operations * work.operations + factors.fetches * work.fetches) for work, _ in timed)
    return Fit(factors, math.sqrt(squares(share) / freedom), freedom, shares)


def fit(times, counts):
    return fit_of(list(timed_work(times, counts).values()))


def left_out(times, counts):
    """The ratio of the predicted time of each technique to the measured one, when the others alone are fitted."""
    timed = timed_work(times, counts)
    return {technique: fit_of([other for name, other in timed.items() if name != technique]).ms(work) / taken
            for technique, (work, taken) in timed.items()}


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
    work = work_of(record, gpu)
    return tuple(fitted.ms(work) * math.exp(sign * fitted.error(work)) + rest for sign in (-1.0, 0.0, 1.0))


def measured_ms(times, technique, light):
    """The mean over the scenes; None where the technique was not timed."""
    own = [one["time_ms_median"] for one in times["records"]
           if one["technique"] == technique and one["light_degrees"] == light]
    return mean(own) if own else None


def predictions(results, times, counts, light):
    """One row per preset, one column per GPU; under one light, means over the scenes. Where the GPU was timed, its time
    stands in place of a prediction."""
    fitted = fit(times, counts)
    rows = []
    is_timed = False
    for (technique,), records in groups(results["records"], "technique"):
        own = [record for record in records if record["light_degrees"] == light]
        if not technique.startswith("preset-"):
            continue
        cells = []
        for gpu in GPUS:
            taken = measured_ms(times, technique, light) if gpu.name in times["device"] else None
            if taken is not None:
                is_timed = True
                cells.append(f"{taken:.2f}, measured")
                continue
            low, middle, high = (mean(each) for each in zip(*(predicted_ms(record, gpu, fitted) for record in own)))
            cells.append(f"{middle:.2f} ({low:.2f} to {high:.2f})")
        rows.append([code(technique), *cells])
    missed = ", ".join(f"{code(name)} {ratio:.2f}" for name, ratio in left_out(times, counts).items())
    measured = (f" The {times['device']} was timed, over {len(distinct(times['records'], 'scene'))} scenes; the other"
                " columns are predictions." if is_timed else "")
    return (f"Predicted, not measured: milliseconds at 1920 x 1080 under a light of {light:g}°, mean of"
            f" {len(distinct(results['records'], 'scene'))} scenes.{measured} In parentheses: the 95 % prediction interval"
            f" over the"
            f" {len(fitted.shares)} filters that were fitted, all of one pass; it covers neither other GPUs, nor the choice"
            f" of scenes, nor kernels that wait for each other. On the {times['device']} a filter takes"
            f" {fitted.factors.operations:.2f} times as long as its operations of FXC's bytecode at the peak rate, and"
            f" {fitted.factors.fetches:.2f} times as long as its fetches. Predicted time over measured time of each of"
            f" these, when it is left out of the fit: {missed}. Commands: `{times['command']}`, `{counts['command']}`,"
            f" `{results['command']}`.\n\n"
            + table(["preset", *(f"{gpu.name}, ms" for gpu in GPUS)], rows, 1))
