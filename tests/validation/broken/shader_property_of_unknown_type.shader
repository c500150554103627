// shader_property_of_unknown_type.shader:6:36: error: expected a type for _Smoothness (did you mean 'Float'?), found 'Flaot'
Shader "Broken/Test"
{
    Properties
    {
        _Smoothness ("Smoothness", Flaot) = 0.5
    }
    SubShader { Pass { } }
}
