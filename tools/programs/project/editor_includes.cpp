#include "project/editor_includes.h"

#include "hlsl/name_set.h"
#include "input/ascii_case.h"

namespace penumbra::project {

namespace {

const std::vector<std::string>& names() {
  static const std::vector<std::string> all = hlsl::names_in(
      "AutoLight.cginc EditorUIE.cginc GLSLSupport.glslinc GraniteShaderLib3.cginc HLSLSupport.cginc "
      "Lighting.cginc ShaderApiReflectionSupport.hlsl SpeedTree8Common.cginc "
      "SpeedTreeBillboardCommon.cginc SpeedTreeCommon.cginc SpeedTreeShaderLibrary.cginc "
      "SpeedTreeVertex.cginc SpeedTreeWind.cginc TerrainEngine.cginc TerrainPreview.cginc "
      "TerrainSplatmapCommon.cginc TerrainTool.cginc Tessellation.cginc TextCoreProperties.cginc "
      "TextCore_Properties.cginc TextCore_SDF_SSD.cginc UnityBuiltin2xTreeLibrary.cginc "
      "UnityBuiltin3xTreeLibrary.cginc UnityCG.cginc UnityCG.glslinc UnityColorGamut.cginc "
      "UnityCustomRenderTexture.cginc UnityDeferredLibrary.cginc UnityDeprecated.cginc "
      "UnityGBuffer.cginc UnityGlobalIllumination.cginc UnityImageBasedLighting.cginc "
      "UnityIndirect.cginc UnityInstancing.cginc UnityLegacyTextureStack.cginc "
      "UnityLightingCommon.cginc UnityMetaPass.cginc UnityPBSLighting.cginc UnityRayQuery.cginc "
      "UnityRayTracingMeshUtils.cginc UnityShaderUtilities.cginc UnityShaderVariables.cginc "
      "UnityShadowLibrary.cginc UnitySprites.cginc UnityStandardBRDF.cginc UnityStandardConfig.cginc "
      "UnityStandardCore.cginc UnityStandardCoreForward.cginc UnityStandardCoreForwardSimple.cginc "
      "UnityStandardInput.cginc UnityStandardMeta.cginc UnityStandardParticleEditor.cginc "
      "UnityStandardParticleInstancing.cginc UnityStandardParticleShadow.cginc "
      "UnityStandardParticles.cginc UnityStandardShadow.cginc UnityStandardUtils.cginc "
      "UnityStereoExtensions.glslinc UnityStereoSupport.glslinc UnityUI.cginc UnityUIE.cginc "
      "UnityUIEFilter.cginc");
  return all;
}

}  // namespace

std::string_view editor_include(std::string_view name) {
  const auto found = std::find_if(names().begin(), names().end(), [name](std::string_view known) {
    return equal_ignoring_case(known, name);
  });
  return found == names().end() ? std::string_view() : *found;
}

}  // namespace penumbra::project
