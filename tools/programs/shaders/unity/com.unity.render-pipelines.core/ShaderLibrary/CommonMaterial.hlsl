// Stands in for the core package's file of this name, of which the library's URP side uses nothing itself: URP's
// Shadows.hlsl calls LerpWhiteTo of it.
