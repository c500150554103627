using System.Diagnostics;

namespace Penumbra.ApiCheck.Tests;

/// <summary>
/// Runs scripts/check-unity-api itself: it builds the program, passes arguments and exit codes on, and says what it
/// needs.
/// </summary>
public sealed class ScriptTests
{
    [Test]
    public void PassesArgumentsOn()
    {
        var (code, output) = Run(null, "--sauce", "a");
        Assert.That(output, Is.EqualTo("check-unity-api: --sauce is not an option (--help lists them)\n"));
        Assert.That(code, Is.EqualTo(2));
    }

    [Test]
    public void SaysHowToGetTheSdk()
    {
        using var tools = new TemporaryFolder();
        foreach (var tool in new[] { "bash", "dirname" }) File.CreateSymbolicLink(tools.At(tool), $"/usr/bin/{tool}");
        var (code, output) = Run(tools.Path, "--help");
        Assert.That(output, Is.EqualTo("check-unity-api: the .NET SDK 10 is missing: https://dotnet.microsoft.com/download says how to get it\n"));
        Assert.That(code, Is.EqualTo(3));
    }

    /// <param name="path">The PATH of the script; null stands for this program's.</param>
    private static (int Code, string Output) Run(string? path, params string[] arguments)
    {
        var start = new ProcessStartInfo("/usr/bin/bash", [Repository.At("scripts/check-unity-api"), .. arguments])
        {
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        };
        if (path is not null) start.Environment["PATH"] = path;
        using var process = Process.Start(start)!;
        var errors = process.StandardError.ReadToEndAsync();
        var output = process.StandardOutput.ReadToEnd() + errors.Result;
        process.WaitForExit();
        return (process.ExitCode, output);
    }
}
