"""scripts/package --metas writes each .meta that is missing, in the form of those that are there, and nothing else."""
import hashlib
import unittest

from scratch import ROOT, CopiedRepository, metas, whitelist


class Forms(unittest.TestCase):
    def test_are_those_of_every_meta_that_ships(self):
        package = whitelist.shipped(ROOT)
        kinds = {path: "DefaultImporter" if path in package.folders else metas.importer(path)
                 for path in metas.wants_meta(package)}
        made = {f"{path}.meta": metas.meta_text(path, kind, path in package.folders)
                for path, kind in kinds.items() if kind}
        self.assertEqual(made, {path: package.text(path) for path in made})
        self.assertGreater(len(made), 30)

    def test_of_kinds_that_may_not_ship_yet(self):
        head = "fileFormatVersion: 2\nguid: {}\n{}:\n  externalObjects: {{}}\n"
        tail = "  userData: \n  assetBundleName: \n  assetBundleVariant: \n"
        script = "  serializedVersion: 2\n  defaultReferences: []\n  executionOrder: 0\n  icon: {instanceID: 0}\n"
        shader = "  defaultTextures: []\n  nonModifiableTextures: []\n  preprocessorOverride: 0\n"
        for name, importer, settings in (("A.cs", "MonoImporter", script), ("A.shader", "ShaderImporter", shader),
                                         ("A.compute", "ComputeShaderImporter", "  preprocessorOverride: 0\n"),
                                         ("A.hlsl", "ShaderIncludeImporter", ""), ("A.md", "TextScriptImporter", ""),
                                         ("A.asmdef", "AssemblyDefinitionImporter", ""),
                                         ("A.json", "TextScriptImporter", "")):
            guid = hashlib.md5(f"com.penumbra.shadows/Editor/{name}".encode()).hexdigest()
            self.assertEqual(metas.meta_text(f"Editor/{name}", metas.importer(f"Editor/{name}"), False),
                             head.format(guid, importer) + settings + tail)
        self.assertEqual(metas.importer("package.json"), "PackageManifestImporter")


class Metas(CopiedRepository):
    def test_those_taken_away_come_back(self):
        before = self.contents()
        gone = [path for path in before if path.endswith(".meta")]
        self.assertTrue({"Runtime.meta", "Samples~/Scenes/SampleScene.cs.meta"} <= set(gone))
        for path in gone:
            (self.folder / path).unlink()
        self.assertEqual(self.assert_run(0, "--metas").stdout.splitlines(), sorted(gone))
        self.assertEqual(self.contents(), before)

    def test_those_of_new_files_and_folders(self):
        self.write("Shaders/Made/Deep/Made.compute", "#pragma kernel Main\n")
        self.write("Samples~/Made/Deep/Made.cs", "")
        self.write("Samples~/Made/Hidden~/made.md", "")
        self.write("Documentation~/made.md", "")
        self.assertEqual([line for line in self.assert_run(0, "--metas").stdout.splitlines() if line != "Shaders.meta"],
                         ["Samples~/Made/Deep.meta", "Samples~/Made/Deep/Made.cs.meta", "Shaders/Made.meta",
                          "Shaders/Made/Deep.meta", "Shaders/Made/Deep/Made.compute.meta"])
        self.assertEqual(self.text("Shaders/Made.meta"), metas.meta_text("Shaders/Made", "DefaultImporter", True))

    def test_nothing_is_missing(self):
        before = self.contents()
        self.assertEqual(self.assert_run(0, "--metas").stdout, "")
        self.assertEqual(self.contents(), before)

    def test_one_that_is_there_stays(self):
        self.write("Runtime.meta", "mine")
        self.assert_run(0, "--metas")
        self.assertEqual(self.text("Runtime.meta"), "mine")

    def test_one_whose_file_is_gone_is_told_and_stays(self):
        (self.folder / "ShaderLibrary/Core/Disk.hlsl").unlink()
        self.assert_refused(1, "ShaderLibrary/Core/Disk.hlsl.meta: belongs to ShaderLibrary/Core/Disk.hlsl, which is gone: "
                            "remove it\nscripts/package: 1 problem left", "--metas")
        self.assertTrue((self.folder / "ShaderLibrary/Core/Disk.hlsl.meta").exists())

    def test_a_kind_whose_settings_are_unitys(self):
        self.write("Runtime/Made.png", "")
        self.assert_refused(1, "Runtime/Made.png: has no .meta, and the settings of its kind are Unity's: let Unity write "
                            f"Runtime/Made.png.meta and put 'guid: {metas.guid('Runtime/Made.png')}' into it\n"
                            "scripts/package: 1 problem left", "--metas")


if __name__ == "__main__":
    unittest.main()
