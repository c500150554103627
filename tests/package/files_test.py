"""The rules of files and their .meta: the unpacked tarball keeps each, and breaks it where a test breaks it."""
import unittest

from scratch import UnpackedTarball, metas

SHADER = "ShaderLibrary/Core/Disk.hlsl"
META = f"{SHADER}.meta"
REMAKE = "remove it and run scripts/package --metas"


class Whole(UnpackedTarball):
    def test_the_tarball_keeps_every_rule(self):
        self.assertEqual(self.before, [])

    def test_so_it_does_with_folders_that_are_new(self):
        self.add("Editor/Made/Made.asmdef", '{"name": "Made.Editor", "includePlatforms": ["Editor"]}')
        self.add("Editor/Made/Made.cs", "class Made {}\n")
        self.add("Shaders/Made/Made.compute", "#pragma kernel Main\n")
        self.assert_problems()


class Paths(UnpackedTarball):
    def test_native_code(self):
        for name in ("Runtime/Plugin.cpp", "Runtime/Plugin.h", "ShaderLibrary/Plugin.mm", "Shaders/Plugin.C"):
            self.write(name, "")
            self.write(f"{name}.meta", metas.meta_text(name, "PluginImporter", False))
            end = name[name.rindex("."):].lower()
            self.assertIn(f"{name}: Unity imports '{end}' files as native code of players: move it below a folder "
                          "whose name ends in '~'", self.problems())

    def test_native_code_below_a_hidden_folder_is_nobodys_plugin(self):
        self.write("Documentation~/example/host.cpp", "")
        self.assert_problems()

    def test_hidden_files(self):
        self.write("Runtime/.DS_Store2", "")
        self.write("Runtime/.git2/config", "")
        text = "is hidden, so Unity never sees it: remove it or take it out of 'files' of package.json"
        self.assert_problems(f"Runtime/.DS_Store2: {text}", f"Runtime/.git2/config: {text}")

    def test_files_that_change_what_npm_packs(self):
        self.write("Runtime/.npmignore", "*.cs\n")
        self.assert_problems("Runtime/.npmignore: changes what npm packs of this folder: "
                             "remove it and use 'files' of package.json")

    def test_links(self):
        (self.folder / "Documentation~" / "linked.txt").symlink_to("filters.md")
        (self.folder / "Documentation~" / "linked").symlink_to("results", target_is_directory=True)
        text = "is a link, which npm leaves out: put the file itself there"
        self.assert_problems(f"Documentation~/linked: {text}", f"Documentation~/linked.txt: {text}")

    def test_names_that_some_systems_refuse(self):
        names = ("Documentation~/a:b.txt", "Documentation~/dot./c.txt", "Documentation~/é.txt")
        for name in names:
            self.write(name, "")
        text = "has a name that not every system can hold: use ASCII letters, digits and ' ._~-()' for it"
        self.assert_problems(*(f"{name}: {text}" for name in names))

    def test_names_that_differ_in_case_alone(self):
        self.write("Documentation~/Results/x.txt", "")
        self.assert_problems("Documentation~/results: differs from Documentation~/Results only in case, which Windows and "
                             "macOS do not distinguish: rename one")


class Metas(UnpackedTarball):
    def test_a_file_without_one(self):
        (self.folder / META).unlink()
        self.assert_problems(f"{SHADER}: has no {META} in the package: run scripts/package --metas")

    def test_a_folder_without_one(self):
        (self.folder / "ShaderLibrary/Core.meta").unlink()
        self.assert_problems("ShaderLibrary/Core: has no ShaderLibrary/Core.meta in the package: "
                             "run scripts/package --metas")

    def test_one_without_its_file(self):
        self.write("Runtime/Gone.cs.meta", metas.meta_text("Runtime/Gone.cs", "MonoImporter", False))
        self.assert_problems("Runtime/Gone.cs.meta: belongs to Runtime/Gone.cs, which is not in the package: "
                             "remove it, or bring that back")

    def test_a_guid_that_is_none(self):
        right = metas.guid(SHADER)
        for wrong in (right[:-1], right.upper(), right + "0", "", right[:-1] + "g"):
            self.write(META, metas.meta_text(SHADER, "ShaderIncludeImporter", False).replace(right, wrong))
            self.assert_problems(f"{META}:2:1: has no guid of 32 digits 0-9a-f: {REMAKE}")

    def test_no_guid(self):
        self.replace(META, f"guid: {metas.guid(SHADER)}\n", "")
        self.assert_problems(f"{META}: has no guid of 32 digits 0-9a-f: {REMAKE}")

    def test_the_guid_of_another_path(self):
        self.replace(META, metas.guid(SHADER), metas.guid("ShaderLibrary/Core"))
        self.assert_problems(f"{META}:2:7: has the guid of ShaderLibrary/Core: {REMAKE}")

    def test_a_guid_that_is_not_the_paths(self):
        self.replace(META, metas.guid(SHADER), "0" * 32)
        self.assert_problems(f"{META}:2:7: has another guid than the {metas.guid(SHADER)} that its path gives: "
                             f"{REMAKE}")

    def test_the_importer_of_another_kind(self):
        self.replace(META, "ShaderIncludeImporter", "DefaultImporter")
        self.assert_problems(f"{META}: names no ShaderIncludeImporter, which imports such files: {REMAKE}")

    def test_a_folder_that_is_not_said_to_be_one(self):
        self.replace("ShaderLibrary/Core.meta", "folderAsset: yes\n", "")
        self.assert_problems(f"ShaderLibrary/Core.meta: does not say that its path is a folder: {REMAKE}")

    def test_hidden_folders_have_none(self):
        self.write("Documentation~/filters.md.meta", "")
        self.assert_problems("Documentation~/filters.md.meta: is in a folder where Unity reads no .meta files: remove it")

    def test_a_file_of_a_sample_without_one(self):
        (self.folder / "Samples~/Scenes/SampleScene.cs.meta").unlink()
        self.assert_problems("Samples~/Scenes/SampleScene.cs: has no Samples~/Scenes/SampleScene.cs.meta in the package: "
                             "run scripts/package --metas")

    def test_a_file_of_a_sample_with_the_guid_of_another(self):
        meta = "Samples~/Scenes/SampleScene.cs.meta"
        self.replace(meta, metas.guid("Samples~/Scenes/SampleScene.cs"), metas.guid("Samples~/Scenes/SceneConstruction.cs"))
        self.assert_problems(f"{meta}:2:7: has the guid of Samples~/Scenes/SceneConstruction.cs: {REMAKE}")

    def test_a_samples_own_folder_has_none(self):
        self.write("Samples~/Scenes.meta", metas.meta_text("Samples~/Scenes", "DefaultImporter", True))
        self.assert_problems("Samples~/Scenes.meta: is in a folder where Unity reads no .meta files: remove it")


if __name__ == "__main__":
    unittest.main()
