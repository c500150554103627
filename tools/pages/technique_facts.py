"""What is known of a technique besides its measurements: the advice of its manifest, the size of its maps, and a
compiler's cycles for its programs."""
import functools
import re

from figures import RESULTS, ROOT, read_json

FAMILY = "navi21"  # the GPUs whose cycles are shown
COSTS = ("cost", "variants-cost")  # the second is of the studies' variants
FOLDERS = ("ShaderLibrary", "Shaders")
VARIANTS = ROOT / "tests" / "study" / "StudyVariants.technique.json"


class Techniques:
    """The techniques of the library and of the studies, as the manifests give them."""

    def __init__(self, manifests):
        self.entries = {entry["name"]: entry for each in manifests for entry in each.get("techniques", [])}
        self.graphs = {graph["name"]: graph for each in manifests for graph in each.get("graphs", [])}

    def of_graph(self, name, key):
        graph = self.graphs[name]
        return [*(one for part in graph.get("parts", []) for one in self.of_graph(part, key)), *graph.get(key, [])]

    def graph_of(self, name):
        """The name of a technique's graph; None of a filter alone."""
        entry = self.entries.get(name, {})
        if "graph" in entry or "filter" in entry or "like" not in entry:
            return entry.get("graph")
        return self.graph_of(entry["like"])

    def advice(self, name):
        entry = self.entries.get(name, {})
        return [entry.get("use_when", ""), entry.get("not_when", "")]

    def textures(self, name):
        graph = self.graph_of(name)
        return self.of_graph(graph, "textures") if graph else []

    def visibility_entry(self, name):
        """The program that gives the visibility: that of the pass that writes it, or the filter."""
        graph = self.graph_of(name)
        for one in self.of_graph(graph, "passes") if graph else []:
            targets = one.get("writes", [])
            targets = targets.values() if isinstance(targets, dict) else targets
            if self.visibility(graph) in targets:
                return one.get("kernel") or one.get("pass") or one["name"]
        return "Fragment"

    def visibility(self, graph):
        own = self.graphs[graph]
        return own.get("visibility") or next(filter(None, map(self.visibility, own.get("parts", []))), None)


@functools.cache
def known():
    files = [file for folder in FOLDERS for file in sorted((ROOT / folder).glob("**/*.technique.json"))]
    return Techniques([read_json(file) for file in (*files, VARIANTS)])


def texel_bytes(form):
    channels, bits = re.fullmatch(r"(r|rg|rgba|depth)(\d+)(?:f|ui)?", form).groups()
    return (1 if channels == "depth" else len(channels)) * int(bits) / 8


def texture_bytes(texture, record):
    """Of a texture that is a share of the map, or of a fixed size; those of the picture's size have none."""
    extent = texture.get("extent", "screen")
    if extent == "screen" or "previous_of" in texture:
        return 0.0
    size = texture["size"] if extent == "fixed" else [
        -(-record["map_size"] // texture.get("divisor", 1))] * 2 + [1]
    levels = max(size).bit_length()
    texels = sum(max(size[0] >> level, 1) * max(size[1] >> level, 1) * max(size[2] >> level, 1)
                 for level in range(min(texture.get("mips", 1) or levels, levels)))
    return texels * texture.get("layers", 1) * texture.get("samples", 1) * texel_bytes(texture["format"])


def map_mebibytes(record, textures):
    """The shadow map, of one or four tiles, and what is made of it."""
    of_map = record["map_size"] ** 2 * (2 if record["map_format"] == "D16" else 4)
    return (of_map + sum(texture_bytes(texture, record) for texture in textures)) / 2 ** 20


def fitness(row, technique):
    """How well the row stands for what a desktop runs of the technique; 0: not at all."""
    return max((1 + ("UNITY_REVERSED_Z" in variant["keywords"]) for variant in row["variants"]
                if variant["technique"] == technique
                and not {"PENUMBRA_UNLIMITED", "_ALPHATEST_ON"} & set(variant["keywords"])), default=0)


@functools.cache
def cost_rows():
    return [row for name in COSTS for row in read_json(RESULTS / f"{name}.json")["rows"]]


def cycles(technique, visibility_entry, rows):
    """"182 + 992": of the program that gives the visibility, and of the other passes."""
    best = {}
    for row in rows:
        of_row = row.get("figures", {}).get("inverse_throughput_cycles")
        if row["family"] != FAMILY or row["stage"] == "vertex" or of_row is None:
            continue
        fit = fitness(row, technique)
        if fit > best.get(row["entry"], (0, None))[0]:
            best[row["entry"]] = fit, of_row
    if visibility_entry not in best:
        return "–"
    others = sum(of_row for entry, (_, of_row) in best.items() if entry != visibility_entry)
    return f"{best[visibility_entry][1]}" + (f" + {others}" if others else "")
