namespace Penumbra.ApiCheck.Tests;

/// <summary>A declared and a real type on one line each, and the lines that the check must write.</summary>
public sealed record Difference(string Name, string Declared, string Real, params string[] Messages)
{
    public override string ToString() => Name;
}

/// <summary>The table of differences, and of what is none.</summary>
public static class Differences
{
    private const string Seen = " (see engine/Runtime/Export/Thing.cs:4)";

    private static Difference Case(string name, string declared, string real, params string[] messages) =>
        new(name, declared, real, [.. messages.Select(message => $"tests/csharp/UnityApi/Shared/Thing.cs:5:{message}{Seen}")]);

    private static Difference Struct(string name, string declared, string real, params string[] messages) =>
        Case(name, $"public struct Thing {{ {declared} }}", $"public struct Thing {{ {real} }}", messages);

    private static Difference Class(string name, string declared, string real, params string[] messages) =>
        Case(name, $"public class Thing {{ {declared} }}", $"public class Thing {{ {real} }}", messages);

    public static IEnumerable<Difference> All =>
        Kinds.Concat(Inheritance).Concat(Names).Concat(Parameters).Concat(Members).Concat(Values).Concat(Generic);

    private static IEnumerable<Difference> Kinds =>
    [
        Case("another kind", "public struct Thing { }", "public class Thing { }", "15: UnityEngine.Thing: a struct here, a class in the real source"),
        Case("an internal type", "public struct Thing { }", "internal struct Thing { }", "15: UnityEngine.Thing: public here, internal in the real source"),
        Case("a static class", "public static class Thing { }", "public abstract class Thing { }", "21: UnityEngine.Thing: static here, abstract in the real source"),
        Case("a sealed class", "public class Thing { }", "public sealed class Thing { }", "14: UnityEngine.Thing: open here, sealed in the real source"),
        Case("a ref struct", "public struct Thing { }", "public ref struct Thing { }", "15: UnityEngine.Thing: no ref struct here, a ref struct in the real source"),
        Case("an obsolete type", "public class Thing { }", "[Obsolete(\"Use Other\", true)] public class Thing { }",
             "14: UnityEngine.Thing: usable here, [Obsolete] as an error (Use Other) in the real source"),
        Case("no constructor", "public class Thing { }", "public class Thing { internal Thing() { } }",
             "14: UnityEngine.Thing: can be made with new() here, not in the real source: declare a private constructor, or those that it has"),
        Case("an attribute's targets", "[AttributeUsage(AttributeTargets.All)] public class Thing : Attribute { }", "[AttributeUsage(AttributeTargets.Field)] public class Thing : Attribute { }",
             "53: UnityEngine.Thing: may stand on All here, on Field in the real source"),
        Case("a repeated attribute", "[AttributeUsage(AttributeTargets.Field, AllowMultiple = true)] public class Thing : Attribute { }", "[AttributeUsage(AttributeTargets.Field)] public class Thing : Attribute { }",
             "77: UnityEngine.Thing: may stand on one thing several times here, not in the real source"),
    ];

    private static IEnumerable<Difference> Inheritance =>
    [
        Case("another base", "public class Thing : Exception { }", "public class Base { } public class Thing : Base { }",
             "14: UnityEngine.Thing: derives from System.Exception here, from UnityEngine.Base in the real source"),
        Case("no base", "public class Thing : Exception { }", "public class Thing { }",
             "14: UnityEngine.Thing: derives from System.Exception here, from object in the real source"),
        Case("an interface", "public struct Thing : IDisposable { public void Dispose() { } }", "public struct Thing { public void Dispose() { } }",
             "15: UnityEngine.Thing: implements System.IDisposable here, not in the real source"),
        Class("not virtual", "public virtual void Do() { }", "public void Do() { }", "42: UnityEngine.Thing.Do(): can be overridden here, not in the real source"),
        Case("abstract", "public abstract class Thing { public virtual void Do() { } }", "public abstract class Thing { public abstract void Do(); }",
             "51: UnityEngine.Thing.Do(): not abstract here, abstract in the real source"),
        Case("sealed", "public class Thing { public virtual int GetOne() => 1; }", "public class Base { public virtual int GetOne() => 1; } public class Thing : Base { public sealed override int GetOne() => 2; }",
             "41: UnityEngine.Thing.GetOne(): can be overridden here, not in the real source"),
    ];

    private static IEnumerable<Difference> Names =>
    [
        Struct("a misspelt method", "public static int Clmp(int value) => value;", "public static int Clamp(int value) => value;",
             "41: UnityEngine.Thing.Clmp(int): the real type has no such member; the nearest is Clamp"),
        Struct("a member of no name alike", "public int Elsewhere;", "public int here;", "34: UnityEngine.Thing.Elsewhere: the real type has no such member"),
        Struct("a field that is a property", "public int size;", "public int size { get; }", "34: UnityEngine.Thing.size: a field here, a property in the real source"),
        Struct("a nested type", "public struct Inner { }", "public struct Iner { }",
             "37: UnityEngine.Thing.Inner: the real type has no such member; the nearest is Iner"),
        Struct("a member of a nested type", "public struct Inner { public int a; }", "public struct Inner { public float a; }",
             "56: UnityEngine.Thing.Inner.a: is of type int here, float in the real source"),
    ];

    private static IEnumerable<Difference> Parameters =>
    [
        Struct("a type", "public void Set(int name) { }", "public void Set(string name) { }",
             "35: UnityEngine.Thing.Set(int): parameter 1, name, is int here, string in the real source"),
        Struct("a count", "public void Set(int a) { }", "public void Set(int a, int b) { }",
             "35: UnityEngine.Thing.Set(int): has 1 parameter here, 2 parameters in the real source"),
        Struct("an order", "public void Set(int a, float b) { }", "public void Set(float b, int a) { }",
             "35: UnityEngine.Thing.Set(int, float): parameter 1, a, is int here, float in the real source; parameter 1, a, is named a here, b in the real source; parameter 2, b, is float here, int in the real source; parameter 2, b, is named b here, a in the real source"),
        Struct("a reference", "public void Set(ref int a) { }", "public void Set(in int a) { }",
             "35: UnityEngine.Thing.Set(ref int): parameter 1, a, is passed by ref here, by in in the real source"),
        Struct("a name", "public void Set(int a) { }", "public void Set(int b) { }",
             "35: UnityEngine.Thing.Set(int): parameter 1, a, is named a here, b in the real source"),
        Struct("a default", "public void Set(int a = 1) { }", "public void Set(int a = 2) { }",
             "35: UnityEngine.Thing.Set(int): parameter 1, a, is optional with 1 here, optional with 2 in the real source"),
        Struct("optional", "public void Set(int a = 1) { }", "public void Set(int a) { }",
             "35: UnityEngine.Thing.Set(int): parameter 1, a, is optional with 1 here, required in the real source"),
        Struct("params", "public void Set(params int[] a) { }", "public void Set(int[] a) { }",
             "35: UnityEngine.Thing.Set(params int[]): parameter 1, a, is a params array here, a plain array in the real source"),
        Case("an extension", "public static class Thing { public static void Set(this int a) { } }", "public static class Thing { public static void Set(int a) { } }",
             "48: UnityEngine.Thing.Set(int): an extension here, no extension in the real source"),
        Struct("no overload", "public void Set(bool a) { }", "public void Set(int a) { } public void Set(float a) { }",
             "35: UnityEngine.Thing.Set(bool): no overload has these parameters; the real ones are Set(int a), Set(float a)"),
        Struct("an indexer", "public int this[long at] => 0;", "public int this[int at] => 0;",
             "34: UnityEngine.Thing.this[long]: parameter 1, at, is long here, int in the real source"),
        Case("a delegate", "public delegate void Thing(int a);", "public delegate void Thing(float a);",
             "22: UnityEngine.Thing: parameter 1, a, is int here, float in the real source"),
        Struct("a conversion", "public static implicit operator int(Thing a) => 0;", "public static implicit operator float(Thing a) => 0;",
             "55: UnityEngine.Thing.implicit operator int(UnityEngine.Thing): no overload has these parameters; the real ones are implicit operator float(Thing a)"),
    ];

    private static IEnumerable<Difference> Members =>
    [
        Struct("internal", "public int size;", "internal int size;", "34: UnityEngine.Thing.size: public here, internal in the real source"),
        Class("protected", "public virtual void Do() { }", "protected virtual void Do() { }", "42: UnityEngine.Thing.Do(): public here, protected in the real source"),
        Struct("static", "public static int Get() => 1;", "public int Get() => 1;", "41: UnityEngine.Thing.Get(): static here, an instance's in the real source"),
        Struct("a return type", "public int Get() => 1;", "public long Get() => 1;", "34: UnityEngine.Thing.Get(): is of type int here, long in the real source"),
        Class("a returned reference", "int a; public ref int Get() => ref a;", "int a; public int Get() => a;",
             "44: UnityEngine.Thing.Get(): returns a reference here, a value in the real source"),
        Struct("no setter", "public int size { get; set; }", "public int size => 1;", "34: UnityEngine.Thing.size: set is public here, missing in the real source"),
        Struct("an internal setter", "public int size { get; set; }", "public int size { get; internal set; }",
             "34: UnityEngine.Thing.size: set is public here, internal in the real source"),
        Struct("a field's type", "public Func<int> get;", "public Func<float> get;",
             "40: UnityEngine.Thing.get: is of type System.Func<int> here, System.Func<float> in the real source"),
        Case("a type of the same name elsewhere", "public struct Thing { public Guid id; }", "namespace Other { public struct Guid { } } public struct Thing { public Other.Guid id; }",
             "35: UnityEngine.Thing.id: is of type System.Guid here, UnityEngine.Other.Guid in the real source"),
        Struct("an element's type", "public int[] all;", "public int[,] all;", "36: UnityEngine.Thing.all: is of type int[] here, int[,] in the real source"),
        Struct("readonly", "public static int size;", "public static readonly int size;", "41: UnityEngine.Thing.size: writable here, readonly in the real source"),
        Class("an event's type", "public event Action changed;", "public event Action<int> changed;",
             "42: UnityEngine.Thing.changed: is of type System.Action here, System.Action<int> in the real source"),
        Class("obsolete as an error", "public void Do() { }", "[Obsolete(\"Use Other\", true)] public void Do() { }",
             "34: UnityEngine.Thing.Do(): usable here, [Obsolete] as an error (Use Other) in the real source"),
        Class("a setter that is obsolete as an error", "public int size { get; set; }", "public int size { get; [Obsolete(\"Never\", true)] set { } }",
             "33: UnityEngine.Thing.size: set is public here, public, [Obsolete] as an error (Never) in the real source"),
    ];

    private static IEnumerable<Difference> Values =>
    [
        Case("a missing enum value", "public enum Thing { One = 1, Too = 2 }", "public enum Thing { One = 1, Two = 2 }",
             "30: UnityEngine.Thing.Too: the real type has no such member; the nearest is Two"),
        Case("another enum value", "public enum Thing { One, Two }", "public enum Thing { Zero, One, Two = One << 3 }", "21: UnityEngine.Thing.One: const 0 here, const 1 in the real source",
             "26: UnityEngine.Thing.Two: const 1 here, const 8 in the real source"),
        Case("the values' type", "public enum Thing { One }", "public enum Thing : byte { One }",
             "13: UnityEngine.Thing: its values are int here, byte in the real source"),
        Struct("a const", "public const float Scale = 2F / 3F;", "public const float Scale = 2F / 4F;",
             "42: UnityEngine.Thing.Scale: const 0.6666667f here, const 0.5f in the real source"),
        Struct("no const", "public const int Size = 1;", "public static readonly int Size = 1;", "40: UnityEngine.Thing.Size: const 1 here, readonly in the real source"),
    ];

    private static IEnumerable<Difference> Generic =>
    [
        Class("arity", "public void Do<T>() { }", "public void Do<T, U>() { }",
             "34: UnityEngine.Thing.Do<T>(): no overload has these parameters; the real ones are Do<T, U>()"),
        Case("a constraint", "public class Thing<T> where T : class { }", "public class Thing<T> where T : class, new() { }",
             "14: UnityEngine.Thing<T>: type parameter T is constrained to class here, to class, new() in the real source"),
        Case("a constraint's type", "public class Thing<T> where T : class { }", "public class Thing<T> where T : class, IDisposable { }",
             "14: UnityEngine.Thing<T>: type parameter T is constrained to class here, to class, System.IDisposable in the real source"),
        Class("a method's constraint", "public T Do<T>() => default;", "public T Do<T>() where T : struct, IDisposable => default;",
             "31: UnityEngine.Thing.Do<T>(): type parameter T is constrained to nothing here, to struct, System.IDisposable in the real source"),
        Case("variance", "public interface Thing<T> { }", "public interface Thing<out T> { }",
             "18: UnityEngine.Thing<T>: type parameter T is invariant here, out in the real source"),
        Case("a type's arity", "public class Thing<T> { }", "public class Thing { }",
             "14: UnityEngine.Thing<T>: no source has such a type, but UnityEngine.Thing"),
    ];

    /// <summary>Declarations that read differently and are the same to who uses them.</summary>
    public static IEnumerable<Difference> None =>
    [
        Struct("fewer members", "public int a;", "public float b; public int a;"),
        Case("a subset of values", "public enum Thing { Two = 2 }", "[Flags] public enum Thing { One = 1 << 0, Two = 1 << 1, Four = 1 << 2 }"),
        Case("an alias", "public struct Thing { public float a; }", "using Number = System.Single; public struct Thing { public Number a; }"),
        Class("a tuple's names", "public (int x, int y) Get() => default;", "public ValueTuple<int, int> Get() => default;"),
        Case("type parameters by place", "public class Thing<A> { public A Get<B>(B b) => default; }", "public class Thing<T> { public T Get<U>(U b) => default; }"),
        Case("nullable annotations", "public class Thing { public string Name; }", "\n#nullable enable\npublic class Thing { public string? Name; }"),
        Case("a member of a base that is left out", "public class Thing { public void Do() { } }",
             "public class Base { public void Do() { } } public class Thing : Base { }"),
        Case("an override of what is virtual", "public class Thing { public virtual int Get() => 1; }",
             "public class Base { public virtual int Get() => 1; } public class Thing : Base { public override int Get() => 2; }"),
        Class("protected internal", "protected virtual void Do() { }", "protected internal virtual void Do() { }"),
        Class("what is ours", "[OwnBehaviour] public int Calls; [OwnBehaviour] public Thing(int a) { } public Thing() { } public int size { get; [OwnBehaviour] set; } internal int rest;",
             "public int size => 1;"),
        Struct("an evaluated const", "public const float Rad = 0.5f;", "const float Half = 1F / 2F; public const float Rad = Half;"),
        Case("an attribute's own limits", "[AttributeUsage(AttributeTargets.Field)] public class Thing : Attribute { }", "public class Thing : Attribute { }"),
    ];
}
