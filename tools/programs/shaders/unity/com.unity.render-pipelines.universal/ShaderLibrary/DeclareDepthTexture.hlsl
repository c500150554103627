// Stands in for URP's DeclareDepthTexture.hlsl.
#ifndef UNITY_DECLARE_DEPTH_TEXTURE_INCLUDED
#define UNITY_DECLARE_DEPTH_TEXTURE_INCLUDED

TEXTURE2D_X_FLOAT(_CameraDepthTexture);

#endif
