namespace Penumbra.ApiCheck.Package;

/// <summary>A JSON file that others wrote: what is wrong with it is told with its place.</summary>
public static class JsonFile
{
    public static T Read<T>(string file, Func<JsonElement, T> read)
    {
        try
        {
            using var document = JsonDocument.Parse(File.ReadAllText(file));
            return read(document.RootElement);
        }
        catch (JsonException error)
        {
            var place = $"{file}:{error.LineNumber + 1}:{error.BytePositionInLine + 1}";
            throw CheckException.Usage($"{place}: no JSON: {error.Message.Split(" LineNumber")[0]}");
        }
        catch (Exception error) when (error is InvalidOperationException or KeyNotFoundException)
        {
            throw CheckException.Usage($"{file}:1:1: a field is missing or has the wrong type: {error.Message}");
        }
    }
}
