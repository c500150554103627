using System.Reflection;
using Object = UnityEngine.Object;

namespace UnityEditor;

/// <summary>
/// Serializes as far as tests of inspectors go: numbers and checks of one object, written when they are applied.
/// </summary>
public class SerializedObject
{
    internal Object Target { get; }
    internal Dictionary<string, object> Written { get; } = new();

    public SerializedObject(Object obj) { Target = obj; }

    public void Update() => Written.Clear();

    public bool ApplyModifiedProperties()
    {
        if (Written.Count == 0) return false;
        var before = new Dictionary<string, object>();
        foreach (string path in Written.Keys) before[path] = SerializedPath.Get(Target, path);
        SerializedPath.SetAll(Target, Written);
        Undo.Remember(() => SerializedPath.SetAll(Target, before));
        Written.Clear();
        return true;
    }

    public SerializedProperty FindProperty(string propertyPath) =>
        SerializedPath.Get(Target, propertyPath) == null ? null : new SerializedProperty(this, propertyPath);
}

public partial class SerializedProperty
{
    private readonly SerializedObject owner;
    private readonly string path;

    internal SerializedProperty(SerializedObject owner, string path) => (this.owner, this.path) = (owner, path);

    public int intValue { get => Convert.ToInt32(Value); set => Value = value; }
    public float floatValue { get => (float)Value; set => Value = value; }
    public bool boolValue { get => (bool)Value; set => Value = value; }

    public SerializedProperty FindPropertyRelative(string relativePropertyPath) =>
        owner.FindProperty(path + "." + relativePropertyPath);

    private object Value
    {
        get => owner.Written.TryGetValue(path, out object written) ? written : SerializedPath.Get(owner.Target, path);
        set => owner.Written[path] = value;
    }
}

public partial class Undo
{
    private static readonly Stack<Action> Steps = new();

    internal static void Remember(Action step) => Steps.Push(step);

    public static void RecordObject(Object objectToUndo, string name) => RecordObjects(new[] { objectToUndo }, name);

    /// <summary>Records one step for all objects, which writes the fields back.</summary>
    public static void RecordObjects(Object[] objectsToUndo, string name)
    {
        var before = new List<(Object owner, FieldInfo field, object value)>();
        foreach (Object owner in objectsToUndo)
            for (Type type = owner.GetType(); type != null; type = type.BaseType)
                foreach (FieldInfo field in type.GetFields(SerializedPath.All | BindingFlags.DeclaredOnly))
                    before.Add((owner, field, field.GetValue(owner)));
        Remember(() => before.ForEach(entry => entry.field.SetValue(entry.owner, entry.value)));
    }

    public static T AddComponent<T>(UnityEngine.GameObject gameObject) where T : UnityEngine.Component
    {
        T component = gameObject.AddComponent<T>();
        Remember(() => gameObject.Components.Remove(component));
        return component;
    }

    public static void PerformUndo()
    {
        if (Steps.Count > 0) Steps.Pop()();
    }
}

/// <summary>
/// Gets and sets a path's value by reflection; what a struct on the way holds is written back into its owner.
/// </summary>
internal static class SerializedPath
{
    internal const BindingFlags All = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic;

    internal static object Get(object owner, string path)
    {
        foreach (string name in path.Split('.'))
        {
            if (owner == null) return null;
            owner = Read(owner, name);
        }
        return owner;
    }

    internal static void SetAll(object owner, Dictionary<string, object> values)
    {
        foreach (KeyValuePair<string, object> entry in values) Set(owner, entry.Key, entry.Value);
    }

    private static void Set(object owner, string path, object value)
    {
        int dot = path.IndexOf('.');
        string name = dot < 0 ? path : path.Substring(0, dot);
        if (dot >= 0)
        {
            object inner = Read(owner, name);
            Set(inner, path.Substring(dot + 1), value);
            value = inner;
            if (!inner.GetType().IsValueType) return;
        }
        if (Property(owner, name) is PropertyInfo property) property.SetValue(owner, value);
        else owner.GetType().GetField(name, All).SetValue(owner, value);
    }

    private static object Read(object owner, string name) =>
        Property(owner, name) is PropertyInfo property ? property.GetValue(owner)
                                                        : owner.GetType().GetField(name, All)?.GetValue(owner);

    // Volume parameters keep what Unity serializes as m_Value and m_OverrideState behind their properties.
    private static PropertyInfo Property(object owner, string name) =>
        name == "m_Value" ? owner.GetType().GetProperty("value", All)
        : name == "m_OverrideState" ? owner.GetType().GetProperty("overrideState", All)
        : null;
}
