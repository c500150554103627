namespace Penumbra.ApiCheck.Assemblies;
public sealed class AssemblyCheck { public List<string> Problems = [], Notes = [];
 public static AssemblyCheck Run(string package, IReadOnlyList<string> folders, string? version) => new(); }
