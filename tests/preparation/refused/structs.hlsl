// structs.hlsl:7:17: error: 'Later' is not a struct declared before 'Before', which derives from it
// structs.hlsl:9:36: error: 'k' is a static member, which is not supported: declare it outside of the structure
// structs.hlsl:10:33: error: 'a' is already declared, at structs.hlsl:10: remove one of the two
// structs.hlsl:11:32: error: 'F' of 'Method' has no body: write it into the struct
// structs.hlsl:14:17: error: unknown function 'Method::F'; did you mean 'Method'?
// structs.hlsl:15:15: error: HLSL has no constructors of structs: write Later value = {...}; or assign the members of a 'Later' one by one
struct Before : Later { int b; };
struct Later { int a; };
struct Member { static const float k = 2; float a; };
struct Twice { float a; half b, a; };
struct Method { float a; float F(float x); float G(float x); };
float4 Main() : SV_Target
{
    Method m; m.F(1);
    Later l = Later(1);
    return l.a;
}
