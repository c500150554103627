"""Breaks each rule on package.json once: the problem has the place of the value."""
import json
import unittest

from scratch import UnpackedTarball

PATH = "package.json"
URP = "com.unity.render-pipelines.universal"
NOT_THERE = "is not in the package, and every package has one: write it, or add it to 'files' of package.json"
NO_FOLDER = "the sample's 'path' is not a folder of Samples~ with files in it: write \"Samples~/NAME\""


class Manifest(UnpackedTarball):
    def assert_value(self, key, value, message):
        """The one problem, at the value of the key."""
        self.change_manifest(**{key: value})
        at_the_top = f"\n  {json.dumps(key)}: "  # samples have keys of the same names
        self.assert_problems(f"{self.place(PATH, at_the_top, len(at_the_top))}: {message}")

    def assert_missing(self, key, message):
        self.change_manifest(**{key: None})
        self.assert_problems(f"{PATH}:1:1: {message}")

    def test_the_name(self):
        self.assert_value("name", "com.penumbra.shadow", "'name' is not \"com.penumbra.shadows\": write that")

    def test_the_version_of_unity(self):
        self.assert_value("unity", "2021.3", "'unity' is not \"2022.3\": write that")

    def test_a_key_that_is_missing_is_told_at_the_object(self):
        self.assert_missing("unity", "'unity' is not \"2022.3\": write that")

    def test_what_the_package_manager_shows(self):
        self.assert_value("displayName", " ", "'displayName' is empty, and the Package Manager shows it: write one")
        self.change_manifest(displayName="Penumbra")
        self.assert_missing("description", "'description' is empty, and the Package Manager shows it: write one")

    def test_versions(self):
        for version in ("0.1", "v0.1.0", "0.01.0", "0.1.0-", "0.1.0-01", "0.1.0+build", "٠.1.0", 1, None):
            self.change_manifest(version=version)
            self.assertIn("'version' is not a semantic version: write one like \"1.2.3\" or \"1.2.3-pre.1\"",
                          [line.split(": ", 1)[1] for line in self.problems()], version)

    def test_versions_that_are_right(self):
        for version in ("0.1.0", "10.20.30", "1.0.0-pre.1", "1.0.0-0a.x-y"):
            self.change_manifest(version=version)
            self.assertFalse([line for line in self.problems() if "semantic" in line], version)

    def test_the_dependency_on_urp(self):
        text = f"the dependency on {URP} is not \"14.0.0\", the first version for Unity 2022.3: write that"
        self.change_manifest(dependencies={URP: "14.0.8"})
        self.assert_problems(f"{self.place(PATH, json.dumps(URP), len(URP) + 4)}: {text}")
        self.change_manifest(dependencies={})
        self.assertIn(f"{self.place(PATH, '{}')}: {text}", self.problems())
        self.change_manifest(dependencies=[])
        self.assertIn(f"{self.place(PATH, '[]')}: 'dependencies' is not an object: write {{\"{URP}\": \"14.0.0\"}}",
                      self.problems())

    def test_other_dependencies(self):
        self.change_manifest(dependencies={URP: "14.0.0", "com.unity.burst": "1.8"})
        self.assert_problems(f"{self.place(PATH, json.dumps('1.8'))}: the version of com.unity.burst is not a semantic "
                             "version: write one like \"1.2.3\"")

    def test_addresses(self):
        for key in ("documentationUrl", "changelogUrl", "licensesUrl"):
            for wrong in ("http://example.com/", "example.com", "https://example", "https://", "https://a.com/a b", "", 5):
                self.assert_value(key, wrong,
                                  f"'{key}' is not an address: write one that begins with https://, or leave it out")
            self.change_manifest(**{key: "https://docs.example.com/penumbra/index.html"})
            self.assert_problems()
            self.change_manifest(**{key: None})

    def test_what_every_package_has(self):
        for name in ("README.md", "LICENSE.md", "CHANGELOG.md", "Third Party Notices.md"):
            (self.folder / name).rename(self.folder / "hidden~")
            self.assertIn(f"{name}: {NOT_THERE}", self.problems())
            (self.folder / "hidden~").rename(self.folder / name)

    def test_without_it(self):
        (self.folder / PATH).unlink()
        self.assertIn(f"{PATH}: {NOT_THERE}", self.problems())

    def test_text_that_is_no_manifest(self):
        for text, message in (('{\n  "name": }', f"{PATH}:2:11: is not JSON: Expecting value"),
                              ("[]", f"{PATH}:1:1: is not a JSON object: write one with name, version and unity"),
                              ('{"name": "a", "name": "b"}', f"{PATH}:1:15: the key 'name' is there twice: remove one"),
                              ("[" * 100000, f"{PATH}: is JSON nested too deeply to read"),
                              ("1" * 10000, f"{PATH}: is not JSON that can be read: ")):
            self.write(PATH, text)
            self.assertTrue(any(line.startswith(message) for line in self.problems()), self.problems())


class Samples(UnpackedTarball):
    def test_a_sample(self):
        self.add_sample("Made", "Made.cs", "class Made {}\n")
        self.assert_problems()

    def test_one_without_a_name_and_a_text(self):
        self.add_sample("Made", "Made.cs", "class Made {}\n")
        for key in ("displayName", "description"):
            manifest = json.loads(self.text(PATH))
            del manifest["samples"][-1][key]
            self.change_manifest(samples=manifest["samples"])
        place = self.place(PATH, '"path": "Samples~/Made"').split(":")
        where = f"{PATH}:{int(place[1]) - 1}:{int(place[2]) - 2}"  # the brace of the entry
        self.assert_problems(f"{where}: the sample has no 'description', which the Package Manager shows: write one",
                             f"{where}: the sample has no 'displayName', which the Package Manager shows: write one")

    def test_one_whose_folder_is_not_there(self):
        self.add_sample("Made", "Made.cs", "class Made {}\n")
        for path in ("Made.cs", "Made.cs.meta"):
            (self.folder / "Samples~/Made" / path).unlink()
        self.assert_problems(f"{self.place(PATH, json.dumps('Samples~/Made'))}: {NO_FOLDER}")

    def test_one_that_lies_elsewhere(self):
        self.add_sample("Made", "Made.cs", "class Made {}\n")
        self.replace(PATH, '"Samples~/Made"', '"Samples/Made"')
        self.assertIn(f"{self.place(PATH, json.dumps('Samples/Made'))}: {NO_FOLDER}", self.problems())

    def test_a_folder_that_nobody_can_import(self):
        self.add("Samples~/Unlisted/Made.cs", "class Made {}\n")
        lines = self.problems()
        self.assertEqual([line.split(": ", 1)[1] for line in lines],
                         ["Samples~/Unlisted is in no entry of 'samples', so nobody can import it: add one"])

    def test_no_list(self):
        self.change_manifest(samples="Samples~")
        self.assertIn(f"{self.place(PATH, json.dumps('samples') + ': ', 11)}: 'samples' is not a list: write one of "
                      "{displayName, description, path}", self.problems())


if __name__ == "__main__":
    unittest.main()
