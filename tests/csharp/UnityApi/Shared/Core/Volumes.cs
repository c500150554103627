namespace UnityEngine.Rendering;

public partial class VolumeComponent : ScriptableObject { public bool active = true; }

public abstract class VolumeParameter { public virtual bool overrideState { get; set; } }

public class VolumeParameter<T> : VolumeParameter
{
#if UNITY_6000_0_OR_NEWER
    protected VolumeParameter(T value, bool overrideState = false)
#else
    protected VolumeParameter(T value, bool overrideState)
#endif
    {
        this.value = value;
        this.overrideState = overrideState;
    }

    public virtual T value { get; set; }
}

public class BoolParameter : VolumeParameter<bool>
{
    public BoolParameter(bool value, bool overrideState = false) : base(value, overrideState) { }
}

public class IntParameter : VolumeParameter<int>
{
    public IntParameter(int value, bool overrideState = false) : base(value, overrideState) { }
}

public class ClampedIntParameter : IntParameter
{
    public int min, max;

    public ClampedIntParameter(int value, int min, int max, bool overrideState = false) : base(value, overrideState) =>
        (this.min, this.max) = (min, max);
}

public class FloatParameter : VolumeParameter<float>
{
    public FloatParameter(float value, bool overrideState = false) : base(value, overrideState) { }
}

public class ClampedFloatParameter : FloatParameter
{
    public float min, max;

    public ClampedFloatParameter(float value, float min, float max, bool overrideState = false)
        : base(value, overrideState) =>
        (this.min, this.max) = (min, max);
}

public sealed partial class VolumeProfile : ScriptableObject
{
    public List<VolumeComponent> components = new();

    public bool TryGet<T>(out T component) where T : VolumeComponent
    {
        component = null;
        foreach (VolumeComponent one in components) component = component ?? one as T;
        return component != null;
    }
}

public sealed class VolumeStack : IDisposable
{
    [OwnBehaviour] public VolumeStack() { }

    [OwnBehaviour] public Dictionary<Type, VolumeComponent> Components { get; } = new();

    public T GetComponent<T>() where T : VolumeComponent =>
        Components.TryGetValue(typeof(T), out VolumeComponent found) ? (T)found : null;

    public void Dispose() { }
}

public sealed partial class VolumeManager
{
    private VolumeManager() { }

    public static VolumeManager instance { get; } = new VolumeManager();

    public VolumeStack stack { get; set; } = new VolumeStack();

#if UNITY_6000_0_OR_NEWER
    public VolumeProfile qualityDefaultProfile { get; [OwnBehaviour] set; }
    public System.Collections.ObjectModel.ReadOnlyCollection<VolumeProfile> customDefaultProfiles
    {
        get;
        [OwnBehaviour] set;
    }
#endif
}
