float First(float x)
{
    x = uno;
    return x;
}
