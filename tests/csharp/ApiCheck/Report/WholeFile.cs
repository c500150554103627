namespace Penumbra.ApiCheck.Report;

/// <summary>Writes a file that is there whole or not at all: it is written beside, then renamed.</summary>
public static class WholeFile
{
    public static void Write(string file, string text)
    {
        var folder = Path.GetDirectoryName(Path.GetFullPath(file))!;
        if (!Directory.Exists(folder)) throw CheckException.Usage($"{file}: the folder {folder} does not exist");
        var beside = Path.Combine(folder, $".{Path.GetFileName(file)}.{Environment.ProcessId}");
        try
        {
            File.WriteAllText(beside, text);
            File.Move(beside, file, overwrite: true);
        }
        catch (Exception error) when (error is IOException or UnauthorizedAccessException)
        {
            File.Delete(beside);
            throw CheckException.Usage($"{file} cannot be written: {error.Message}");
        }
    }
}
