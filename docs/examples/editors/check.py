"""Holds scenario files against the schema that their "$schema" names, as an editor does while one types."""
import json
import pathlib
import sys

import jsonschema

for name in sys.argv[1:]:
    file = pathlib.Path(name)
    scenario = json.loads(file.read_text(encoding="utf-8"))
    schema = json.loads((file.parent / scenario["$schema"]).read_text(encoding="utf-8"))
    faults = sorted(jsonschema.Draft7Validator(schema).iter_errors(scenario), key=str)
    # Of the errors in the alternatives of a member, the deepest says most.
    for fault in faults:
        best = jsonschema.exceptions.best_match([fault])
        print(f"{file.name}: /{'/'.join(map(str, best.absolute_path))}: {best.message}")
    if not faults:
        print(f"{file.name}: fits {scenario['$schema']}")
