// Stands in for the core package's file of this name.
#include "../../../../platform/unity/com.unity.render-pipelines.core/ShaderLibrary/UnityInstancing.hlsl"
