"""The figures of results that blocks show: the head of each one's column, and what it is of a technique's records."""
import math
from typing import Callable, NamedTuple

from figures import all_fetches
from rounding import mean_text


class Column(NamedTuple):
    head: str
    figure: Callable  # of a record; None where it was not measured
    interval: str = ""  # the key of its interval within one scene
    most: float = 1.0
    scale: float = 1.0
    most_decimals: int = 4

    def estimates(self, records):
        for record in records:
            if self.figure(record) is not None:
                interval = record.get("intervals", {}).get(self.interval) or {"standard_error": 0.0}
                yield self.figure(record), interval["standard_error"]

    def cell(self, records):
        return mean_text(list(self.estimates(records)), self.most, self.scale, self.most_decimals)


def of_key(key):
    return lambda record: record.get(key)


def fetches_in_penumbra(record):
    alone = record["fetches_penumbra_mean"]
    return None if alone is None else alone + record["preprocess_fetches_per_pixel"]


def grain(record):
    return None if record.get("variance") is None else math.sqrt(record["variance"])


def step_across_tiles(record):
    step = record.get("group_step", {})
    return step["across"] / step["inside"] if step.get("across") is not None and step.get("inside") else None


PENUMBRA_ERROR = Column("RMSE in penumbra", of_key("rmse_penumbra"), "rmse_penumbra")
ERROR = Column("RMSE of all pixels", of_key("rmse_all"), "rmse_all")
LEAKS = Column("light leaks, %", of_key("leak_rate"), "leak_rate", scale=100.0)
FALSE_SHADOW = Column("false shadow, %", of_key("false_shadow_rate"), "false_shadow_rate", scale=100.0)
OVERLAP = Column("RMSE where shadows overlap", lambda record: record.get("overlap", {}).get("rmse"))
FLIP = Column("FLIP of the lit picture", of_key("flip"))
GRAIN = Column("grain", grain)
GROUP_STEP = Column("step across tiles", step_across_tiles, most=math.inf)
FETCHES = Column("fetches per pixel", all_fetches, "fetches_mean", math.inf, most_decimals=1)
PENUMBRA_FETCHES = Column("fetches in penumbrae", fetches_in_penumbra, most=math.inf, most_decimals=1)
OPERATIONS = Column("operations per pixel", of_key("operations_per_pixel"), most=math.inf, most_decimals=0)
