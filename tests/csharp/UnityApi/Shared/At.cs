namespace Penumbra.UnityApi;

/// <summary>The versions our declarations were read at; Engine, Core and Universal are those of the generation.</summary>
public static class At
{
    public const string Unity2022 = "2022.3.17f1", Core14 = "14.0.9", Universal14 = "14.0.9";
    public const string Unity6 = "6000.0.23f1", Core17 = "17.0.3", Universal17 = "17.0.3";
    public const string Unity65 = "6000.5.2f1", Core175 = "17.5.0", Universal175 = "17.5.0";

#if UNITY_6000_0_OR_NEWER
    public const string Engine = Unity6, Core = Core17, Universal = Universal17;
#else
    public const string Engine = Unity2022, Core = Core14, Universal = Universal14;
#endif
}
