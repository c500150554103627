"""Follows the includes of shader files: the tests say where each leads, and what is said where it leads nowhere."""
import unittest

from scratch import UnpackedTarball

PATH = "Shaders/Made/Made.shader"
URP = "com.unity.render-pipelines.universal"
CORE = "com.unity.render-pipelines.core"


class Includes(UnpackedTarball):
    def including(self, directive, path=PATH):
        self.add(path, f"Shader {{\n  HLSLPROGRAM\n  {directive}\n  ENDHLSL\n}}\n")

    def assert_include(self, target, message, path=PATH, **roots):
        """The one problem of `#include TARGET`."""
        self.including(f"#include {target}", path)
        self.assert_problems(f"{path}:3:12: {message}", **roots)

    def test_those_that_lead_somewhere(self):
        for target in ("../../ShaderLibrary/Shadows.hlsl", "Packages/com.penumbra.shadows/ShaderLibrary/Shadows.hlsl",
                       "./../Made/../../ShaderLibrary/Core/Disk.hlsl", f"Packages/{URP}/ShaderLibrary/Core.hlsl",
                       f"Packages/{CORE}/ShaderLibrary/Common.hlsl"):
            self.including(f'#include "{target}"')
            self.assert_problems()
            self.including(f' #  include_with_pragmas "{target}"  // a reason')
            self.assert_problems()

    def test_one_that_leads_nowhere(self):
        self.assert_include('"Nothing.hlsl"', "there is no Shaders/Made/Nothing.hlsl in the package: correct the path")
        self.assert_include('"Packages/com.penumbra.shadows/Nothing.hlsl"',
                            "there is no Nothing.hlsl in the package: correct the path")

    def test_every_kind_of_shader_file_is_read(self):
        for path in ("Shaders/Made/Made.compute", "ShaderLibrary/Made.hlsl", "Documentation~/Made.hlsl",
                     "Shaders/Made/Made.cginc"):
            folder = path.rpartition("/")[0]
            self.assert_include('"Nothing.hlsl"', f"there is no {folder}/Nothing.hlsl in the package: correct the path", path)
            self.write(path, "")

    def test_one_in_another_case(self):
        self.assert_include('"../../shaderLibrary/shadows.hlsl"',
                            "shaderLibrary/shadows.hlsl is written ShaderLibrary/Shadows.hlsl in the package: write it so")

    def test_comments_include_nothing(self):
        for comment in ('// #include "Nothing.hlsl"', '/*\n#include "Nothing.hlsl"\n*/',
                        '/* // */ // "\n//#include "Nothing.hlsl"'):
            self.including(comment)
            self.assert_problems()

    def test_a_comment_does_not_hide_what_follows(self):
        self.assert_include('"Nothing.hlsl" // "x"', "there is no Shaders/Made/Nothing.hlsl in the package: correct the path")
        self.add(PATH, 'float a; /* "\n*/\n#include "Nothing.hlsl"\n')
        self.assert_problems(f"{PATH}:3:10: there is no Shaders/Made/Nothing.hlsl in the package: correct the path")
        self.add(PATH, 'Tooltip("/*")\n#include "Nothing.hlsl"\n')
        self.assert_problems(f"{PATH}:2:10: there is no Shaders/Made/Nothing.hlsl in the package: correct the path")

    def test_one_that_leaves_the_package(self):
        self.assert_include('"../../../Other.hlsl"', "../../../Other.hlsl leads out of the package: "
                            "write \"Packages/NAME/...\" for a file of another one")

    def test_one_that_leaves_a_sample(self):
        self.add_sample("Made", "Made.shader", '\n#include "Own.hlsl"\n#include "../../ShaderLibrary/Shadows.hlsl"\n')
        self.add("Samples~/Made/Own.hlsl", "")
        self.assert_problems("Samples~/Made/Made.shader:3:10: ../../ShaderLibrary/Shadows.hlsl leads out of the sample, "
                             "which is copied into projects: write \"Packages/com.penumbra.shadows/...\"")

    def test_separators_of_windows(self):
        self.assert_include('"..\\Made.hlsl"',
                            "..\\Made.hlsl has '\\', which is not a separator on Linux and macOS: write '/'")

    def test_paths_that_are_not_written_out(self):
        self.assert_include("<Nothing.hlsl>", "what <Nothing.hlsl> leads to is not known here: write the path in quotes")
        self.assert_include("MADE_PATH", "what MADE_PATH leads to is not known here: write the path in quotes")

    def test_a_package_that_is_no_dependency(self):
        self.assert_include('"Packages/com.unity.render-pipelines.high-definition/Runtime/A.hlsl"',
                            "com.unity.render-pipelines.high-definition is not a dependency of package.json: "
                            "add it there, or do without its file")


class OtherPackages(UnpackedTarball):
    def fill(self):
        super().fill()
        self.root = self.outside / "packages" / URP
        for path in ("ShaderLibrary/Core.hlsl", "ShaderLibrary/Shadows.hlsl", "ShaderLibrary/Lighting.hlsl"):
            (self.root / path).parent.mkdir(parents=True, exist_ok=True)
            (self.root / path).write_text("")

    def assert_include(self, target, *messages):
        self.add(PATH, f'#include "Packages/{URP}/{target}"\n')
        found = [line for line in self.problems(**{URP: self.root}) if line.startswith(PATH)]
        self.assertEqual(found, [f"{PATH}:1:10: {message}" for message in messages])

    def test_files_that_are_there(self):
        self.assert_include("ShaderLibrary/Core.hlsl")

    def test_files_that_are_not(self):
        self.assert_include("ShaderLibrary/Nothing.hlsl", f"there is no ShaderLibrary/Nothing.hlsl in {URP}: correct the path")
        self.assert_include("Nowhere/Core.hlsl", f"there is no Nowhere/Core.hlsl in {URP}: correct the path")

    def test_files_in_another_case(self):
        self.assert_include("Shaderlibrary/core.hlsl",
                            f"Shaderlibrary/core.hlsl is written ShaderLibrary/Core.hlsl in {URP}: write it so")


if __name__ == "__main__":
    unittest.main()
