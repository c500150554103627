// Stands in for the core package's file of this name.
#include "../../../../../tools/programs/shaders/unity/com.unity.render-pipelines.core/ShaderLibrary/UnityInstancing.hlsl"
