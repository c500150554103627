namespace Penumbra.ApiCheck;

/// <summary>The command line of `scripts/check-unity-api`.</summary>
public sealed class Options
{
    public const string Usage = """
        usage: check-unity-api --engine DIR --core DIR --universal DIR --generation 2022.3|6000.0|6000.5 [options]
               check-unity-api DIR [DIR ...] [options]

        The first form compares our declarations of Unity's API with the C# of Unity's reference source and of the
        packages core and URP. The second compiles the package against real assemblies:
        a Unity installation, a project's folder (Library/ScriptAssemblies), or a folder of reference assemblies.

          --output FILE             the answer as JSON
          --version V               the version of Unity, where no folder is that of a project
          --package DIR             the package (default: this repository)
          --declarations DIR        the declarations (default: tests/csharp/UnityApi of the package)
          --help

        Exit: 0 nothing differs, 1 differences, 2 wrong usage or an unreadable file, 3 assemblies are missing.
        """;

    public List<string> Operands { get; } = [];
    public Dictionary<string, string> Named { get; } = [];
    public string? Generation { get; private set; }
    public string? Version { get; private set; }
    public string? Output { get; private set; }
    public string? Package { get; private set; }
    public string? Declarations { get; private set; }
    public bool Help { get; private set; }

    public static Options Parse(IReadOnlyList<string> arguments)
    {
        var options = new Options();
        for (var at = 0; at < arguments.Count; ++at)
        {
            var argument = arguments[at];
            if (argument is "--help" or "-h") options.Help = true;
            else if (!argument.StartsWith('-')) options.Operands.Add(argument);
            else if (at + 1 == arguments.Count)
                throw CheckException.Usage($"{argument} needs a value (--help lists the options)");
            else options.Set(argument, arguments[++at]);
        }
        return options;
    }

    public bool IsSourceCheck => Named.Count > 0;

    /// <summary>Refuses an option that the asked check would not look at: it is a mistake.</summary>
    public void RefuseStrangers()
    {
        var foreign = IsSourceCheck
            ? Version is null ? null : "--version does not go with --engine"
            : Generation is not null ? "--generation does not go with a folder of assemblies"
            : Declarations is not null ? "--declarations does not go with a folder of assemblies" : null;
        if (foreign is not null) throw CheckException.Usage($"{foreign} (--help says more)");
    }

    private void Set(string option, string value)
    {
        switch (option)
        {
            case "--engine" or "--core" or "--universal": Named[option[2..]] = value; break;
            case "--generation": Generation = value; break;
            case "--version": Version = value; break;
            case "--output" or "-o": Output = value; break;
            case "--package": Package = value; break;
            case "--declarations": Declarations = value; break;
            default: throw CheckException.Usage($"{option} is not an option (--help lists them)");
        }
    }
}
