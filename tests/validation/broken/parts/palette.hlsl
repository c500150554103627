static const float paletteScale = 0.5;
