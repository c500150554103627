using System.IO;
using System.Linq;
using System.Text.Json;
using NUnit.Framework;
using UnityEngine;

namespace Penumbra.Samples
{
    /// <summary>
    /// The example of Documentation~/far-shadows.md is FieldObjectsExample.cs, so it compiles and does what it says.
    /// </summary>
    internal sealed class FieldObjectsExampleTests
    {
        // The file is as the program writes it.
        private const string File = @"{ ""kind"": ""distance-field-objects"", ""version"": 1, ""picture"": ""street.png"",
            ""voxels"": [74, 66, 130], ""columns"": 12, ""rows"": 11, ""ground_triangles"": 2, ""flat_triangles"": 0, ""objects"": [
            { ""first_voxel"": [0, 0, 0], ""voxels"": [64, 32, 16], ""distances_metres"": [-2.5, 2.5], ""corner_metres"": [1, 2, 3],
              ""size_metres"": [16, 8, 4], ""triangles"": 12, ""parts"": 1, ""open_edges"": 0, ""too_thin"": 0.1 },
            { ""first_voxel"": [0, 32, 0], ""voxels"": [8, 8, 8], ""distances_metres"": [-1, 1], ""corner_metres"": [-1, 0, -1],
              ""size_metres"": [1, 1, 1], ""triangles"": 12, ""parts"": 1, ""open_edges"": 0, ""too_thin"": 0 } ] }";

        private static string[] Lines(string file) =>
            System.IO.File.ReadAllLines(Path.Combine(TestContext.CurrentContext.TestDirectory, file));

        private static string[] Between(string[] lines, string first, string last) =>
            lines.Select(line => line.Trim()).SkipWhile(line => line != first).Skip(1).TakeWhile(line => line != last).ToArray();

        [Test]
        public void ThePagesExampleIsTheCompiledOne()
        {
            string[] compiled = Between(Lines("FieldObjectsExample.cs"), "// example:begin", "// example:end");
            Assert.That(compiled, Is.Not.Empty);
            Assert.That(Between(Lines("far-shadows.md"), "```csharp", "```"), Is.EqualTo(compiled));
        }

        [Test]
        public void RowsAreThoseThatTheShaderLibraryReads()
        {
            var fields = JsonSerializer.Deserialize<FieldObjects>(File, new JsonSerializerOptions { IncludeFields = true });
            var moved = Matrix4x4.identity;
            moved.m03 = 5.0f;
            fields.SetGlobal(new Texture2D(), new[] { Matrix4x4.identity, moved });
            Assert.That(Shader.Globals["_PenumbraFieldAtlas"], Is.EqualTo(new Vector4(74.0f, 66.0f, 130.0f, 2.0f)));
            var rows = (Vector4[])Shader.Globals["_PenumbraFieldObjects"];
            Assert.That(rows, Has.Length.EqualTo(96));
            Assert.That(rows.Take(12), Is.EqualTo(new[]
            {
                new Vector4(1.0f, 0.0f, 0.0f, 0.0f), new Vector4(0.0f, 1.0f, 0.0f, 0.0f), new Vector4(0.0f, 0.0f, 1.0f, 0.0f),
                new Vector4(1.0f, 2.0f, 3.0f, 2.5f), new Vector4(16.0f, 8.0f, 4.0f, 0.25f), new Vector4(0.0f, 0.0f, 0.0f, 0.0f),
                new Vector4(1.0f, 0.0f, 0.0f, 5.0f), new Vector4(0.0f, 1.0f, 0.0f, 0.0f), new Vector4(0.0f, 0.0f, 1.0f, 0.0f),
                new Vector4(-1.0f, 0.0f, -1.0f, 1.0f), new Vector4(1.0f, 1.0f, 1.0f, 0.125f), new Vector4(0.0f, 32.0f, 0.0f, 0.0f),
            }));
        }
    }
}
