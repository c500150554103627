using System;
using System.IO;
using System.Linq;
using System.Text;

namespace Penumbra.Editor
{
    /// <summary>
    /// A shader's text as its file holds it. Written back it has the encoding, the byte order mark and the permissions that
    /// it had, and at no time does the file hold a part of it: a diff shows the changed lines alone.
    /// </summary>
    internal sealed class ShaderFile
    {
        // In the order in which they are tried, the longer of two marks that begin alike first. The last one takes any bytes:
        // a character each, so that those of an unknown code page are carried along.
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

        /// <param name="path">Of the project or one of its packages, as all paths here.</param>
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
        /// Puts `changed` into an existing file, in this one's encoding. Throws IOException with what to do; the file is
        /// then as it was.
        /// </summary>
        internal void Write(string path, string changed)
        {
            string full = Path.GetFullPath(path);
            if ((File.GetAttributes(full) & FileAttributes.ReadOnly) != 0)
                throw new IOException(path + " is read-only, and stays as it is. Check it out in your version control, or " +
                                      "clear the read-only attribute, and try again.");
            // Unity does not import files of this ending.
            string temporary = full + "." + Guid.NewGuid().ToString("N") + ".tmp";
            try
            {
                File.Copy(full, temporary);  // for its permissions
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
                throw new IOException(path + " stays as it is: its encoding lacks a character that is to be added. Save it as " +
                                      "UTF-8, and try again.");
            }
            catch (Exception failure) when (failure is IOException || failure is UnauthorizedAccessException)
            {
                throw new IOException(path + " cannot be written, and stays as it is. Close it in other programs, check that " +
                                      "its folder can be written, and try again. (" + failure.Message + ")", failure);
            }
            finally
            {
                File.Delete(temporary);
            }
        }

        /// <summary>For a copy of a package's file, which may be read-only as the package is.</summary>
        internal static void MakeWritable(string path)
        {
            string full = Path.GetFullPath(path);
            File.SetAttributes(full, File.GetAttributes(full) & ~FileAttributes.ReadOnly);
        }
    }
}
