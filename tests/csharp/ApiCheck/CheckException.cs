namespace Penumbra.ApiCheck;

/// <summary>Ends the check before it has an answer; the message says what is wrong and the way out.</summary>
public sealed class CheckException(int exitCode, string message) : Exception(message)
{
    public int ExitCode { get; } = exitCode;

    /// <summary>The command or a file that it names is wrong.</summary>
    public static CheckException Usage(string message) => new(Exit.Usage, message);

    /// <summary>Real assemblies are not where they were looked for.</summary>
    public static CheckException Missing(string message) => new(Exit.Missing, message);
}

/// <summary>Exit codes of `scripts/check-unity-api`.</summary>
public static class Exit
{
    public const int Same = 0;
    public const int Differences = 1;
    public const int Usage = 2;
    public const int Missing = 3;
}
