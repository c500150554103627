namespace Penumbra.Tests;

/// <summary>A search reads every shader of the project: it runs when it is asked for, and never else.</summary>
public sealed class ReceiverWindowTests
{
    private const BindingFlags All =
        BindingFlags.Instance | BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic;
    private const string Search = "Search the project";
    private const string Outdated = "The project has changed since this search.";

    private EditorWindow window;

    [SetUp]
    public void AnOpenWindow()
    {
        AssetDatabase.Listed = 0;
        window = EditorWindow.Shown = ScriptableObject.CreateInstance<ReceiverWindow>();
        Call("OnEnable");
    }

    [TearDown]
    public void TearDown()
    {
        if (EditorApplication.Listeners > 0) Call("OnDisable");
        EditorWindow.Shown = null;
        GUILayout.Pressed = null;
        AssetDatabase.Paths = new string[0];
    }

    private void Call(string method) => typeof(ReceiverWindow).GetMethod(method, All).Invoke(window, null);

    private List<string> Draw(string pressed = null)
    {
        EditorGUILayout.Boxes.Clear();
        GUILayout.Pressed = pressed;
        Call("OnGUI");
        return EditorGUILayout.Boxes;
    }

    [Test]
    public void DrawingTheWindowReadsNothing()
    {
        Assert.That(Draw().Single(), Does.Contain("not been searched yet"));
        Assert.That(AssetDatabase.Listed, Is.Zero);
        Assert.That(Draw(Search).Single(), Does.StartWith("Every opaque shader"));
        Assert.That(AssetDatabase.Listed, Is.EqualTo(1));
        Draw();
        Assert.That(AssetDatabase.Listed, Is.EqualTo(1));
    }

    [Test]
    public void TheMenuSearchesOnceUntilTheProjectChanges()
    {
        Call("Open");
        Call("Open");
        Assert.That(AssetDatabase.Listed, Is.EqualTo(1));
        EditorApplication.ChangeProject();
        Assert.That(Draw(), Has.Member(Outdated));
        Assert.That(AssetDatabase.Listed, Is.EqualTo(1));
        Call("Open");
        Assert.That(AssetDatabase.Listed, Is.EqualTo(2));
        Assert.That(Draw(), Has.No.Member(Outdated));
    }

    [Test]
    public void AClosedWindowHearsOfNothing()
    {
        Assert.That(EditorApplication.Listeners, Is.EqualTo(1));
        Call("OnDisable");
        Assert.That(EditorApplication.Listeners, Is.Zero);
    }

    /// <summary>These are Unity's rules of what it keeps when scripts are compiled.</summary>
    [Test]
    public void WhatWasFoundOutlivesACompile()
    {
        Assert.That(typeof(ReceiverWindow).GetField("search", All).GetCustomAttribute<SerializeField>(), Is.Not.Null);
        foreach (Type kept in new[] { typeof(ReceiverSearch), typeof(ReceiverProblem) })
        {
            Assert.That(kept.GetCustomAttribute<SerializableAttribute>(), Is.Not.Null, kept.Name);
            foreach (FieldInfo field in kept.GetFields(All).Where(field => !field.IsLiteral))
                Assert.That(field.GetCustomAttribute<SerializeField>() != null && !field.IsInitOnly, field.Name);
        }
        // Unity writes an empty text where there is none.
        var problem = new ReceiverProblem("Assets/A.shader", ReceiverFix.CopyToProject) { passes = "" };
        Assert.That(problem.Explanation,
                    Is.EqualTo(new ReceiverProblem("Assets/A.shader", ReceiverFix.CopyToProject).Explanation));
    }

    [Test]
    public void AMendedProblemLeavesTheListWithoutAnotherSearch()
    {
        string before = Directory.GetCurrentDirectory();
        DirectoryInfo project = Directory.CreateTempSubdirectory();
        try
        {
            Directory.SetCurrentDirectory(project.FullName);
            Directory.CreateDirectory("Assets");
            AssetDatabase.Paths = new[] { "Assets/A.hlsl" };
            File.WriteAllText("Assets/A.hlsl", "HLSLPROGRAM\n#pragma multi_compile _ _MAIN_LIGHT_SHADOWS\nENDHLSL\n");
            Assert.That(Draw(Search).Single(), Does.StartWith("1 problem"));
            Draw("Add the keyword");
            Assert.That(Draw().Single(), Does.StartWith("Every opaque shader"));
            Assert.That(AssetDatabase.Listed, Is.EqualTo(1));
            Assert.That(Draw(Search).Single(), Does.StartWith("Every opaque shader"));
        }
        finally
        {
            Directory.SetCurrentDirectory(before);
            project.Delete(true);
        }
    }
}
