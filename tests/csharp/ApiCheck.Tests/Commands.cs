namespace Penumbra.ApiCheck.Tests;

/// <summary>A run of the command: exit code and what it wrote.</summary>
public sealed record Commands(int Code, string Answers, string Notes)
{
    public IEnumerable<string> Lines => Answers.Split('\n', StringSplitOptions.RemoveEmptyEntries);

    public static Commands Run(params string[] arguments)
    {
        using var answers = new StringWriter { NewLine = "\n" };
        using var notes = new StringWriter { NewLine = "\n" };
        var code = Command.Run(arguments, answers, notes);
        return new Commands(code, answers.ToString(), notes.ToString());
    }
}
