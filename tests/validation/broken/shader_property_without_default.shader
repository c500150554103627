// shader_property_without_default.shader:7:9: error: expected '=' and the default of _BaseColor, found '_Smoothness'
Shader "Broken/Test"
{
    Properties
    {
        _BaseColor ("Base colour", Color)
        _Smoothness ("Smoothness", Range(0, 1)) = 0.5
    }
    SubShader { Pass { } }
}
