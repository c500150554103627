using System.Reflection;
using System.Text.RegularExpressions;

namespace Penumbra.Tests;

/// <summary>
/// Every parameter struct packs as the program that measures it does, to the bit, by
/// tests/golden/parameter_packing.json, which `penumbra emit` writes.
/// </summary>
public sealed class PackingTests
{
    private static readonly Assembly Package = typeof(ShadowUniforms).Assembly;

    private static JsonProperty[] Structs()
    {
        string file = Path.Combine(TestContext.CurrentContext.TestDirectory, "parameter_packing.json");
        return JsonDocument.Parse(File.ReadAllText(file)).RootElement.EnumerateObject().ToArray();
    }

    private static float Number(JsonElement value) =>
        value.ValueKind == JsonValueKind.String ? float.NaN : (float)value.GetDouble();

    private static object Value(Type type, JsonElement value)
    {
        if (type == typeof(int)) return value.GetInt32();
        if (type == typeof(float)) return Number(value);
        float[] numbers = value.EnumerateArray().Select(Number).ToArray();
        return type == typeof(Vector2) ? new Vector2(numbers[0], numbers[1])
                                       : (object)new Vector4(numbers[0], numbers[1], numbers[2], numbers[3]);
    }

    private static Vector4[] Packed(Type type, JsonElement values)
    {
        object parameters = Activator.CreateInstance(type);
        foreach (JsonProperty value in values.EnumerateObject())
        {
            FieldInfo field = type.GetField(value.Name);
            field.SetValue(parameters, Value(field.FieldType, value.Value));
        }
        return type.GetProperties().Where(property => Regex.IsMatch(property.Name, "^Vector[0-9]+$"))
            .OrderBy(property => property.Name).Select(property => (Vector4)property.GetValue(parameters)).ToArray();
    }

    [Test]
    public void EveryStructIsPackedAsItIsMeasured()
    {
        Assert.That(Structs().Length, Is.GreaterThanOrEqualTo(6));
        foreach (JsonProperty entry in Structs())
        {
            Type type = Package.GetType("Penumbra." + entry.Name);
            Assert.That(type, Is.Not.Null, entry.Name);
            foreach (JsonElement one in entry.Value.EnumerateArray())
            {
                Vector4[] expected = one.GetProperty("vectors").EnumerateArray()
                    .Select(v => (Vector4)Value(typeof(Vector4), v)).ToArray();
                for (int i = 0; i < expected.Length; ++i)
                    Assert.That(type.GetField("Uniform" + i).GetValue(null),
                                Is.EqualTo(Shader.PropertyToID("_Penumbra" + entry.Name + i)));
                Assert.That(Packed(type, one.GetProperty("values")), Is.EqualTo(expected), entry.Name + " " + one);
            }
        }
    }
}
