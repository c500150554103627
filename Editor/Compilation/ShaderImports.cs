using System.Linq;
using UnityEditor;

namespace Penumbra.Editor
{
    /// <summary>
    /// Tells chains that shaders or the file of techniques were imported, as after an edit or an update of a package:
    /// shaders that include a changed file are imported again, too.
    /// </summary>
    internal sealed class ShaderImports : AssetPostprocessor
    {
        // Unity calls this method by its name.
        internal static void OnPostprocessAllAssets(string[] importedAssets, string[] deletedAssets, string[] movedAssets,
                                                    string[] movedFromAssetPaths)
        {
            bool techniques = importedAssets.Contains(PassAssets.PathInProject(TechniqueTable.File));
            if (techniques) TechniqueTable.Forget();
            if (techniques || importedAssets.Any(path => path.EndsWith(".shader") || path.EndsWith(".compute")))
                ++ChainDraw.Imports;
        }
    }
}
