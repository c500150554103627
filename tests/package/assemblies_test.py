"""Assembly definitions and the scripts that they cover."""
import json
import unittest

from scratch import UnpackedTarball, metas

PATH = "Runtime/Made/Made.asmdef"
EDITOR = "Editor/Made/Made.Editor.asmdef"


class Assemblies(UnpackedTarball):
    def define(self, path, **values):
        self.add(path, json.dumps(values, indent=2))

    def assert_value(self, text, message, path=PATH):
        self.assert_problems(f"{self.place(path, text)}: {message}")

    def test_those_that_are_right(self):
        self.define(PATH, name="Made", references=["Penumbra.Runtime", "Unity.RenderPipelines.Universal.Runtime",
                                                   f"GUID:{metas.guid('Runtime/Penumbra.Runtime.asmdef')}"],
                    versionDefines=[{"name": "com.unity.burst", "expression": expression, "define": "MADE"} for expression in
                                    ("", "17.0.3", "1.0.0-pre.1", "[17.0,17.4)", "(1.2,2022.3.1f1]", "[14]")])
        self.define(EDITOR, name="Made.Editor", references=["Made", "Unity.RenderPipelines.Core.Editor"],
                    includePlatforms=["Editor"])
        self.assert_problems()

    def test_text_that_is_no_json(self):
        self.add(PATH, '{"name": "Made",}')
        lines = self.problems()
        self.assertEqual(len(lines), 1)
        self.assertRegex(lines[0], rf"^{PATH}:1:\d+: is not JSON: ")

    def test_no_name(self):
        self.add(PATH, "[]")
        self.assert_problems(f"{PATH}:1:1: has no 'name': write the assembly's")
        self.define(PATH, name="")
        self.assert_value('""', "has no 'name': write the assembly's")

    def test_a_name_twice(self):
        self.define("Runtime/Made/Again/Again.asmdef", name="Made")
        self.define(PATH, name="Made")
        self.assert_value('"Made"', "'Made' is the name of Runtime/Made/Again/Again.asmdef, too: take another")

    def test_references_that_lead_nowhere(self):
        for reference in ("Penumbra.Runtimes", "Unity.RenderPipelines.HighDefinition.Runtime", "GUID:" + "0" * 32, 5):
            self.define(PATH, name="Made", references=["Penumbra.Runtime", reference])
            self.assert_value(json.dumps(reference), f"'{reference}' is not an assembly of this package, nor one of Unity's "
                              "that it may use: write the name of one, or add it to scripts/penumbra_package/assembly_rules.py")

    def test_references_that_are_no_list(self):
        self.define(PATH, name="Made", references="Penumbra.Runtime")
        self.assert_value('"Penumbra.Runtime"', "'references' is not a list: write one of assembly names")

    def test_editor_code_in_players(self):
        self.define(PATH, name="Made", references=["Unity.RenderPipelines.Universal.Editor"])
        text = "is not in players: refer to it from an assembly for the platform Editor alone"
        self.assert_value('"Unity.RenderPipelines.Universal.Editor"', f"'Unity.RenderPipelines.Universal.Editor' {text}")
        self.define(EDITOR, name="Made.Editor", includePlatforms=["Editor"])
        self.define(PATH, name="Made", references=["Made.Editor"])
        self.assert_value('"Made.Editor"', f"'Made.Editor' {text}")

    def test_an_editor_folder_whose_assembly_is_for_players(self):
        self.define(EDITOR, name="Made.Editor", includePlatforms=["Editor", "Android"])
        self.assert_value('[\n    "Editor"', "an assembly of an Editor folder is not for the platform Editor alone: "
                          'write "includePlatforms": ["Editor"]', EDITOR)

    def test_platforms_given_both_ways(self):
        self.define(PATH, name="Made", includePlatforms=["Editor"], excludePlatforms=["Android"])
        self.assert_value('[\n    "Android"',
                          "'excludePlatforms' and 'includePlatforms' are both given: Unity takes one")

    def test_version_defines(self):
        right = {"name": "com.unity.burst", "expression": "1.8.0", "define": "MADE"}
        for key, meaning, wrong in (("name", "a package's name or Unity", ("burst", "Com.Unity", "")),
                                    ("expression", "a version or a range like [14.0,17.0)",
                                     (">=14", "[14.0, 17.0)", "(14.0)", "[14.0,17.0", "v1")),
                                    ("define", "a C# symbol", ("1MADE", "MADE UP", ""))):
            for value in wrong:
                self.define(PATH, name="Made", versionDefines=[{**right, key: value}])
                self.assert_problems(f"{self.place(PATH, f'{json.dumps(key)}: {json.dumps(value)}', len(key) + 4)}: "
                                     f"'{key}' of the version define is not {meaning}: write one")

    def test_version_defines_that_are_no_list(self):
        self.define(PATH, name="Made", versionDefines={})
        self.assert_value("{}", "'versionDefines' is not a list: write one of {name, expression, define}")

    def test_a_script_that_no_assembly_covers(self):
        self.add("Shaders/Made.cs", "class Made {}\n")
        self.assert_problems("Shaders/Made.cs: belongs to no assembly definition, so Unity does not compile it: "
                             "add one to its folder")


if __name__ == "__main__":
    unittest.main()
