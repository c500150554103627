namespace Penumbra.ApiCheck.Compare;

/// <summary>Members of a real type by name, its own first and then those of the types it derives from.</summary>
public static class MemberSearch
{
    /// <summary>The members of that name in the nearest type that has any which can be reached.</summary>
    public static IReadOnlyList<ISymbol> Find(INamedTypeSymbol type, string name)
    {
        var own = type.GetMembers(name);
        if (own.Any(Access.IsReachable) || name == WellKnownMemberNames.InstanceConstructorName) return own;
        foreach (var other in Above(type))
        {
            var members = other.GetMembers(name);
            if (members.Any(Access.IsReachable)) return members;
        }
        return own;
    }

    public static IEnumerable<INamedTypeSymbol> Above(INamedTypeSymbol type)
    {
        for (var at = type.BaseType; at is not null; at = at.BaseType) yield return at;
        if (type.TypeKind == TypeKind.Interface)
        {
            foreach (var other in type.AllInterfaces) yield return other;
        }
    }

    /// <summary>Overloads in all types above, for a declaration that none of the nearest matches.</summary>
    public static IEnumerable<ISymbol> Everywhere(INamedTypeSymbol type, string name) =>
        type.GetMembers(name).Concat(Above(type).SelectMany(other => other.GetMembers(name)));
}
