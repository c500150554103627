using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Penumbra.Samples
{
    /// <summary>
    /// The tests say what only the files can show: assemblies see what they name, uniforms have the same names in C#
    /// and in shaders, and the Package Manager is told of every sample.
    /// </summary>
    internal sealed class SampleFilesTests
    {
        private static readonly string package = Path.Combine(TestContext.CurrentContext.TestDirectory, "package");
        private static readonly string samples = Path.Combine(package, "Samples~");

        // The assembly that a namespace needs. Everything else is in assemblies that Unity always references.
        private static readonly Dictionary<string, string> assemblies = new Dictionary<string, string>
        {
            ["UnityEngine.Rendering.Universal"] = "Unity.RenderPipelines.Universal.Runtime",
        };

        private static IEnumerable<string> Files(string folder, string pattern) =>
            Directory.GetFiles(folder, pattern, SearchOption.AllDirectories);

        private static IEnumerable<string> Asmdefs() => Files(samples, "*.asmdef");

        private static JsonElement Json(string file) => JsonDocument.Parse(File.ReadAllText(file)).RootElement;

        private static string[] Strings(JsonElement list) =>
            list.EnumerateArray().Select(item => item.GetString()).ToArray();

        // A source belongs to the nearest definition above it.
        private static IEnumerable<string> SourcesOf(string asmdef)
        {
            string folder = Path.GetDirectoryName(asmdef);
            return Files(folder, "*.cs").Where(source => !Asmdefs().Any(
                other => other != asmdef && Path.GetDirectoryName(other).StartsWith(folder) &&
                         source.StartsWith(Path.GetDirectoryName(other) + Path.DirectorySeparatorChar)));
        }

        [TestCaseSource(nameof(Asmdefs))]
        public void AnAssemblySeesWhatItsSourcesUse(string asmdef)
        {
            JsonElement definition = Json(asmdef);
            string[] references = Strings(definition.GetProperty("references"));
            bool editor = Strings(definition.GetProperty("includePlatforms")).Contains("Editor");
            string root = definition.GetProperty("rootNamespace").GetString();
            Assert.That(definition.GetProperty("name").GetString(),
                        Is.EqualTo(Path.GetFileNameWithoutExtension(asmdef)));
            Assert.That(SourcesOf(asmdef), Is.Not.Empty);
            foreach (string source in SourcesOf(asmdef))
            {
                string text = File.ReadAllText(source);
                Assert.That(text, Does.Contain("namespace " + root + "\n"), source);
                foreach (Match use in Regex.Matches(text, @"^using ([\w.]+);", RegexOptions.Multiline))
                {
                    string name = use.Groups[1].Value;
                    if (assemblies.TryGetValue(name, out string assembly))
                        Assert.That(references, Does.Contain(assembly), source);
                    if (name.StartsWith("UnityEditor")) Assert.That(editor, source);
                }
                if (Regex.IsMatch(text, @"\b(AtlasLayout|ShadowUniforms|SoftShadowParameters|CascadeScales)\b"))
                    Assert.That(references, Does.Contain("Penumbra.Runtime"), source);
            }
        }

        [Test]
        public void WhoeverUsesUrpSeesTheCorePackageThatItsTypesAreMadeOf()
        {
            foreach (string asmdef in Asmdefs())
            {
                string[] references = Strings(Json(asmdef).GetProperty("references"));
                Assert.That(references.Contains("Unity.RenderPipelines.Universal.Runtime"),
                            Is.EqualTo(references.Contains("Unity.RenderPipelines.Core.Runtime")), asmdef);
            }
        }

        private static SortedSet<string> Names(IEnumerable<string> files, string pattern) =>
            new SortedSet<string>(files.SelectMany(file => Regex.Matches(File.ReadAllText(file), pattern))
                                       .Select(match => match.Groups[1].Value));

        // C# sets a uniform by name, by the number of a parameter struct's vector (PcssAngularParameters.Uniform0), or
        // all of a struct's at once (uniforms.PcssAngular.SetGlobal).
        private static SortedSet<string> SetByCSharp(string sample)
        {
            string[] files = Files(Path.Combine(samples, sample), "*.cs").ToArray();
            SortedSet<string> set = Names(files, @"PropertyToID\(""(\w+)""\)");
            foreach (string text in files.Select(File.ReadAllText))
            {
                foreach (Match match in Regex.Matches(text, @"\b(\w+Parameters)\.Uniform(\d)"))
                    set.Add("_Penumbra" + match.Groups[1].Value + match.Groups[2].Value);
                foreach (Match match in Regex.Matches(text, @"\.(\w+)\.SetGlobal\("))
                    set.UnionWith(UniformsOf(match.Groups[1].Value + "Parameters"));
            }
            return set;
        }

        private static IEnumerable<string> UniformsOf(string name) =>
            typeof(ShadowUniforms).Assembly.GetType("Penumbra." + name, true).GetFields()
                .Where(field => field.Name.StartsWith("Uniform"))
                .Select(field => "_Penumbra" + name + field.Name.Substring("Uniform".Length));

        [Test]
        public void TheCustomPipelineSetsEveryUniformOfItsShadersAndNoOther()
        {
            IEnumerable<string> shaders = Files(Path.Combine(samples, "CustomPipeline"), "*.hlsl");
            SortedSet<string> declared = Names(shaders, @"(?:^|\n)float4(?:x4)? (_\w+)(?:\[4\])?;");
            declared.UnionWith(Names(shaders, @"TEXTURE2D_SHADOW\((_\w+)\);"));
            // The colour is the material's own.
            declared.Remove("_BaseColor");
            Assert.That(SetByCSharp("CustomPipeline"), Is.EqualTo(declared));
        }

        // The sample's material does not offer these techniques, because an enum of materials has nine entries at most.
        private static IEnumerable<string> UniformsOfOtherTechniques() =>
            Names(new[] { Path.Combine(package, "Runtime", "Techniques", "Techniques.txt") }, @"\nvector\t(\w+)");

        [Test]
        public void TheForwardShaderSetsEveryUniformOfTheLibrarysThatItsTechniquesHave()
        {
            SortedSet<string> declared =
                Names(Files(Path.Combine(package, "ShaderLibrary"), "*.hlsl"), @"\nfloat4 (_Penumbra\w+);");
            declared.ExceptWith(UniformsOfOtherTechniques());
            Assert.That(declared.Count, Is.EqualTo(8));
            Assert.That(SetByCSharp("ForwardShader"), Is.EqualTo(declared));
        }

        [Test]
        public void ThePackageManagerIsToldOfEverySample()
        {
            JsonElement manifest = Json(Path.Combine(package, "package.json"));
            JsonElement[] listed = manifest.GetProperty("samples").EnumerateArray().ToArray();
            IEnumerable<string> folders =
                Directory.GetDirectories(samples).Select(folder => "Samples~/" + Path.GetFileName(folder));
            Assert.That(listed.Select(sample => sample.GetProperty("path").GetString()), Is.EquivalentTo(folders));
            foreach (JsonElement sample in listed)
            {
                Assert.That(sample.GetProperty("displayName").GetString(), Is.Not.Empty);
                Assert.That(sample.GetProperty("description").GetString(), Has.Length.GreaterThan(20));
                Assert.That(Path.Combine(package, sample.GetProperty("path").GetString(), "README.md"), Does.Exist);
            }
        }

        // Each scene takes the same clicks: a command of the menu, which the README names.
        [Test]
        public void EverySceneThatBuildsItselfHasACommandInTheMenu()
        {
            string[] scenes = Files(samples, "*.cs").Where(file => File.ReadAllText(file).Contains("[ContextMenu(\"Build\")]"))
                                                    .Select(Path.GetDirectoryName).ToArray();
            Assert.That(scenes, Has.Length.EqualTo(4));
            foreach (string folder in scenes)
            {
                string commands = string.Concat(Files(Path.Combine(folder, "Editor"), "*.cs").Select(File.ReadAllText));
                Assert.That(commands, Does.Contain("\"GameObject/Penumbra Samples/").And.Contain("[MenuItem("), folder);
                Assert.That(commands, Does.Contain("Undo.RegisterCreatedObjectUndo("), folder);
                Assert.That(File.ReadAllText(Path.Combine(folder, "README.md")),
                            Does.Contain("*GameObject, Penumbra Samples"), folder);
            }
        }
    }
}
