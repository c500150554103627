using Penumbra.ApiCheck.Assemblies;

namespace Penumbra.ApiCheck;

/// <summary>
/// Takes arguments, writes text and returns an exit code: all that the program does besides the checks themselves.
/// </summary>
public static class Command
{
    public static int Run(string[] arguments, TextWriter answers, TextWriter notes)
    {
        try
        {
            var options = Options.Parse(arguments);
            if (options.Help)
            {
                answers.WriteLine(Options.Usage);
                return Exit.Same;
            }
            options.RefuseStrangers();
            if (options.IsSourceCheck) return CheckSources(options, answers);
            if (options.Operands.Count == 0)
                throw CheckException.Usage("neither sources (--engine DIR) nor a folder of assemblies is given (--help says more)");
            return CheckAssemblies(options, answers);
        }
        catch (CheckException error)
        {
            notes.WriteLine($"check-unity-api: {error.Message}");
            return error.ExitCode;
        }
        catch (Exception error) when (Unreadable(error) is { } cause)
        {
            notes.WriteLine($"check-unity-api: {cause.Message}");
            return Exit.Usage;
        }
    }

    /// <summary>The error of a file that cannot be read or written; many are read at once.</summary>
    private static Exception? Unreadable(Exception error) => error switch
    {
        IOException or UnauthorizedAccessException => error,
        AggregateException many => many.InnerExceptions.Select(Unreadable).FirstOrDefault(),
        _ => null,
    };

    private static string PackageOf(Options options) => Path.GetFullPath(
        options.Package ?? throw CheckException.Usage("--package DIR is needed where the script does not give it"));

    private static int CheckSources(Options options, TextWriter answers)
    {
        if (options.Generation is null || !Generation.All.Contains(options.Generation))
            throw CheckException.Usage($"--generation {string.Join('|', Generation.All)} says which declarations to check");
        var package = PackageOf(options);
        var declarations = Path.GetFullPath(options.Declarations ?? Path.Combine(package, "tests/csharp/UnityApi"));
        var check = SourceCheck.Run(new SourceRequest(options.Generation, package, declarations, options.Named));
        var report = SourceReport.Of(options.Generation, check);
        if (options.Output is not null) WholeFile.Write(options.Output, report.Json());
        foreach (var problem in report.Problems) answers.WriteLine(problem);
        var counts = report.Counts;
        var sources = report.Sources.Select(source => $"{source.Source} {source.Version}");
        answers.WriteLine($"{counts.Types} types with {counts.Declarations} declarations, {counts.Differences} differences from " +
                          string.Join(", ", sources));
        return counts.Differences == 0 ? Exit.Same : Exit.Differences;
    }

    private static int CheckAssemblies(Options options, TextWriter answers)
    {
        var check = AssemblyCheck.Run(PackageOf(options), options.Operands, options.Version);
        if (options.Output is not null) WholeFile.Write(options.Output, check.Json());
        foreach (var line in check.Problems) answers.WriteLine(line);
        foreach (var line in check.Notes) answers.WriteLine(line);
        return check.Problems.Count == 0 ? Exit.Same : Exit.Differences;
    }
}
