// macro_of_any_arguments.hlsl:2:1: error: not supported here: macros with '...'; name the parameters, and write a macro for each number of arguments
#define SUM(x, ...) F(x, __VA_ARGS__)
float4 Main() : SV_Target { return 1; }
