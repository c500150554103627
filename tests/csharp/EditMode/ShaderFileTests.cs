using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using NUnit.Framework;
using Penumbra.Editor;

namespace Penumbra.Tests
{
    public sealed class ShaderFileTests
    {
        private const string Before = "#pragma one // Größe\r\nsecond\nthird\r\n";
        private const string After = "#pragma one two // Größe\r\nsecond\nthird\r\n";

        private string folder, path;

        [SetUp]
        public void AFolder()
        {
            folder = Path.Combine(Path.GetTempPath(), Path.GetRandomFileName());
            Directory.CreateDirectory(folder);
            path = Path.Combine(folder, "Water.shader");
        }

        [TearDown]
        public void NoFolder()
        {
            ShaderFile.MakeWritable(path);
            Directory.Delete(folder, true);
        }

        private static IEnumerable<Encoding> Encodings() => new Encoding[]
        {
            new UTF8Encoding(false), new UTF8Encoding(true), new UnicodeEncoding(false, true), new UnicodeEncoding(true, true),
            new UTF32Encoding(false, true), new UTF32Encoding(true, true), Encoding.GetEncoding("iso-8859-1"),
        };

        private static byte[] Bytes(string text, Encoding encoding) =>
            encoding.GetPreamble().Concat(encoding.GetBytes(text)).ToArray();

        [TestCaseSource(nameof(Encodings))]
        public void EncodingMarkAndLineEndsStay(Encoding encoding)
        {
            File.WriteAllBytes(path, Bytes(Before, encoding));
            ShaderFile file = ShaderFile.Read(path);
            Assert.That(file.text, Is.EqualTo(Before));
            file.Write(path, After);
            Assert.That(File.ReadAllBytes(path), Is.EqualTo(Bytes(After, encoding)));
            Assert.That(Directory.GetFiles(folder), Is.EqualTo(new[] { path }));
        }

        [TestCase(new byte[0])]
        [TestCase(new byte[] { 0x2f, 0x2f, 0x83, 0x80, 0x0a })]
        [TestCase(new byte[] { 0xef, 0xbb, 0xbf, 0xff, 0x0a })]
        [TestCase(new byte[] { 0xff, 0xfe, 0x41 })]
        public void BytesOfAnyEncodingStay(byte[] bytes)
        {
            File.WriteAllBytes(path, bytes);
            ShaderFile file = ShaderFile.Read(path);
            file.Write(path, file.text + "//");
            Assert.That(File.ReadAllBytes(path), Is.EqualTo(bytes.Concat(Encoding.ASCII.GetBytes("//")).ToArray()));
        }

        [Test]
        public void AReadOnlyFileIsNamedWithTheWayOut()
        {
            File.WriteAllText(path, Before);
            File.SetAttributes(path, FileAttributes.ReadOnly);
            ShaderFile file = ShaderFile.Read(path);
            Assert.That(() => file.Write(path, After), Throws.InstanceOf<IOException>().With.Message.StartsWith(path)
                            .And.Message.Contains("read-only").And.Message.Contains("version control"));
            Assert.That(File.ReadAllText(path), Is.EqualTo(Before));
            ShaderFile.MakeWritable(path);
            file.Write(path, After);
            Assert.That(File.ReadAllText(path), Is.EqualTo(After));
        }

        [Test]
        public void WhatTheEncodingLacksLeavesTheFileAlone()
        {
            byte[] bytes = Bytes(Before, Encoding.GetEncoding("iso-8859-1"));
            File.WriteAllBytes(path, bytes);
            ShaderFile file = ShaderFile.Read(path);
            Assert.That(() => file.Write(path, "水"), Throws.InstanceOf<IOException>().With.Message.Contains("UTF-8"));
            Assert.That(File.ReadAllBytes(path), Is.EqualTo(bytes));
            Assert.That(Directory.GetFiles(folder), Is.EqualTo(new[] { path }));
        }

        [Test]
        public void TheReportChangesTheKeywordAlone()
        {
            const string pragma = "HLSLPROGRAM\r\n#pragma multi_compile _ _MAIN_LIGHT_SHADOWS{0}\r\nENDHLSL // Größe\n";
            File.WriteAllBytes(path, Bytes(string.Format(pragma, ""), new UTF8Encoding(true)));
            ReceiverReport.Apply(new ReceiverProblem(path, ReceiverFix.AddKeyword));
            Assert.That(File.ReadAllBytes(path),
                        Is.EqualTo(Bytes(string.Format(pragma, " _MAIN_LIGHT_SHADOWS_SCREEN"), new UTF8Encoding(true))));
        }
    }
}
