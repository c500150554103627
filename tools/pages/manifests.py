"""The keys of manifests in docs/add-technique.md, from their JSON schema."""
from figures import DOCS, ROOT, code, read_json
from markdown import table

SCHEMA = ROOT / "tools" / "programs" / "techniques" / "technique.schema.json"
# The page has these words for one object of each kind, and for several.
OBJECTS = {"manifest": ("a manifest", ""), "struct": ("a struct", "structs"), "field": ("a field", "fields"),
           "filter": ("a filter", ""), "entry": ("an entry", "entries"), "bias": ("a bias", ""),
           "rule": ("a rule", "rules"), "graph": ("a graph", "graphs"), "texture": ("a texture", "textures"),
           "pass": ("a pass", "passes"), "groups": ("`groups`", ""),
           "selection": ("a selection", "selections"), "preset": ("a preset", "presets"),
           "option": ("an option", "options"), "look": ("a look", "looks")}
TABLES = (("manifest",), ("entry", "filter", "struct", "field", "bias", "rule"), ("selection", "option", "preset", "look"),
          ("graph", "texture", "pass", "groups"))
TYPES = {"string": "text", "integer": "whole number"}
UNBOUNDED = 10 ** 6  # a bound as large as this is the program's, not the key's


def merged(rule, definitions):
    """The rule with what it refers to; "object" is the kind of object, where that has a table."""
    for part in [rule, *rule.get("allOf", [])]:
        if "$ref" in part:
            name = part["$ref"].split("/")[-1]
            return {**merged(definitions[name], definitions), "object": name if name in OBJECTS else None, **rule}
    return rule


def items(rule, definitions):
    item = merged(rule["items"], definitions)
    if item.get("object"):
        return OBJECTS[item["object"]][1]
    count = f"{rule['minItems']} " if rule.get("minItems") == rule.get("maxItems") else ""
    return f"{count}{TYPES.get(item['type'], {'array': 'list'}.get(item['type'], item['type']))}s"


def value(rule, definitions):
    """What a key has as its value, in words."""
    if rule.get("object"):
        return OBJECTS[rule["object"]][0]
    if "enum" in rule:
        return ", ".join(code(choice) for choice in rule["enum"])
    kind = rule.get("type", ["array", "object"])
    if isinstance(kind, list):
        return " or ".join("list" if one == "array" else one for one in kind)
    if kind == "array":
        return f"list of {items(rule, definitions)}"
    if kind == "boolean":
        return "`true` or `false`"
    least = f" from {rule['minimum']}" if rule.get("minimum", -UNBOUNDED) > -UNBOUNDED else ""
    least = f" above {rule['exclusiveMinimum']}" if "exclusiveMinimum" in rule else least
    most = f" to {rule['maximum']}" if rule.get("maximum", UNBOUNDED) < UNBOUNDED else ""
    return TYPES.get(kind, kind) + least + most


def keys(names, definitions):
    """One table of the keys of these kinds of objects, the first of which its head names."""
    rows = []
    for name in names:
        if name != names[0]:
            rows.append([f"**{OBJECTS[name][0]}**", "", ""])
        for key, given in definitions[name]["properties"].items():
            rule = merged(given, definitions)
            required = ", required" if key in definitions[name].get("required", []) else ""
            rows.append([code(key), value(rule, definitions) + required, rule["description"]])
    return table([f"key of {OBJECTS[names[0]][0]}", "value", "meaning"], rows, 3)


def parts(_program):
    schema = read_json(SCHEMA)
    definitions = {**schema["definitions"], "manifest": schema}
    return {DOCS / "add-technique.md": {f"keys: {names[0]}": keys(names, definitions) for names in TABLES}}
