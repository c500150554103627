using UnityEngine;

namespace UnityEditor.Rendering;

public static class CoreEditorUtils
{
    /// <summary>The messages that were drawn; tests press their buttons.</summary>
    [OwnBehaviour] public static List<(string message, string button, System.Action action)> Boxes
    {
        get;
    } = new List<(string, string, System.Action)>();

    public static void DrawFixMeBox(string message, MessageType messageType, string buttonLabel, System.Action action) =>
        Boxes.Add((message, buttonLabel, action));
}

public sealed class SerializedDataParameter { internal SerializedDataParameter() { } }

public partial class VolumeComponentEditor : Editor
{
    public virtual void OnEnable() { }
    public override void OnInspectorGUI() { }
    public virtual GUIContent GetDisplayTitle() => new GUIContent(GetType().Name, "");

    protected SerializedDataParameter Unpack(SerializedProperty property) => new SerializedDataParameter();
    protected bool PropertyField(SerializedDataParameter property, GUIContent title) => false;
}
