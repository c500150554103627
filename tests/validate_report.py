"""The JSON reports of penumbra validate, as tests read them."""


def results(report):
    """Every result with the names of its variant and with its messages."""
    return [{**{name: value for name, value in variant.items() if name != "results"}, **result,
             "messages": [report["messages"][index] for index in result["messages"]]}
            for kind in ("sources", "variants") for variant in report[kind] for result in variant["results"]]
