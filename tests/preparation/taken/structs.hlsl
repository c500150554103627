struct A { int a; };
struct B : A { int b; };
struct Inner { float a; struct { int b; } c; } inner;
struct Value { float a, b; };
Value Make(Value v) { return v; }
float4 Main() : SV_Target
{
    B b; b.a = b.b = 1;
    Value s = (Value)0; Value t = Make((Value)(0));
    return b.a + inner.a + s.a + t.b;
}
