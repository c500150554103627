using System;
using System.IO;
using System.Linq;
using System.Text;

namespace Penumbra.Editor
{
    /// <summary>
    /// The text of a shader file. Writing preserves the encoding, the byte order mark and the permissions, and is
    /// atomic, so that a diff shows only the changed lines.
    /// </summary>
    internal sealed class ShaderFile
    {
        // Encodings are tried in this order; if two byte order marks start alike, the longer is first. The last
        // encoding accepts any bytes, one character each, so that text in an unknown code page is preserved.
        private static readonly Encoding[] Encodings =
        {
            new UTF8Encoding(true, true), new UTF32Encoding(false, true, true), new UTF32Encoding(true, true, true),
            new UnicodeEncoding(false, true, true), new UnicodeEncoding(true, true, true), new UTF8Encoding(false, true),
            Encoding.GetEncoding("iso-8859-1", EncoderFallback.ExceptionFallback, DecoderFallback.ExceptionFallback),
        };

        internal readonly string text;
        private readonly Encoding encoding;

        private ShaderFile(string text, Encoding encoding)
        {
            this.text = text;
            this.encoding = encoding;
        }

        /// <param name="path">A path in the project or one of its packages, like all paths here.</param>
        internal static ShaderFile Read(string path)
        {
            byte[] bytes = File.ReadAllBytes(Path.GetFullPath(path));
            return Encodings.Select(encoding => Decoded(bytes, encoding)).First(file => file != null);
        }

        private static ShaderFile Decoded(byte[] bytes, Encoding encoding)
        {
            byte[] mark = encoding.GetPreamble();
            if (!bytes.Take(mark.Length).SequenceEqual(mark)) return null;
            try
            {
                return new ShaderFile(encoding.GetString(bytes, mark.Length, bytes.Length - mark.Length), encoding);
            }
            catch (DecoderFallbackException)
            {
                return null;
            }
        }

        /// <summary>
        /// Replaces an existing file's content by `changed` in this file's encoding. Throws IOException with the
        /// remedy; the file is then unchanged.
        /// </summary>
        internal void Write(string path, string changed)
        {
            string full = Path.GetFullPath(path);
            if ((File.GetAttributes(full) & FileAttributes.ReadOnly) != 0)
                throw new IOException(path + " is read-only, and was not changed. Check it out in your version control, " +
                                      "or clear the read-only attribute, and try again.");
            // Unity does not import files with this extension.
            string temporary = full + "." + Guid.NewGuid().ToString("N") + ".tmp";
            try
            {
                File.Copy(full, temporary);  // copies the permissions
                using (var stream = new FileStream(temporary, FileMode.Truncate))
                {
                    byte[] bytes = encoding.GetPreamble().Concat(encoding.GetBytes(changed)).ToArray();
                    stream.Write(bytes, 0, bytes.Length);
                    stream.Flush(true);
                }
                File.Replace(temporary, full, null);
            }
            catch (EncoderFallbackException)
            {
                throw new IOException(path + " was not changed: its encoding lacks a character that has to be added. " +
                                      "Save it as UTF-8, and try again.");
            }
            catch (Exception failure) when (failure is IOException || failure is UnauthorizedAccessException)
            {
                throw new IOException(path + " cannot be written, and was not changed. Close it in other programs, " +
                                      "check that its folder is writable, and try again. (" + failure.Message + ")", failure);
            }
            finally
            {
                File.Delete(temporary);
            }
        }

        /// <summary>Makes a copy of a package's file writable, since files of packages may be read-only.</summary>
        internal static void MakeWritable(string path)
        {
            string full = Path.GetFullPath(path);
            File.SetAttributes(full, File.GetAttributes(full) & ~FileAttributes.ReadOnly);
        }
    }
}
