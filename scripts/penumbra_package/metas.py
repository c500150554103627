"""The .meta file that Unity requires beside every path that it imports, with a GUID that is derived from the path.

The GUID is the MD5 of the package's name and the path: whoever refers to an asset of the package finds it again in
every version, as long as its path stays. So do scenes that refer to scripts of a sample when the sample is imported again.
"""
import hashlib
import posixpath

from .package import NAME, folders_above, is_imported
from .problem import Problem

NAMES_OF_FILES = {"package.json": "PackageManifestImporter"}
IMPORTERS = {".cs": "MonoImporter", ".hlsl": "ShaderIncludeImporter", ".cginc": "ShaderIncludeImporter",
             ".shader": "ShaderImporter", ".compute": "ComputeShaderImporter",
             ".asmdef": "AssemblyDefinitionImporter", ".asmref": "AssemblyDefinitionReferenceImporter",
             ".json": "TextScriptImporter", ".md": "TextScriptImporter", ".txt": "TextScriptImporter"}
SETTINGS = {
    "MonoImporter": ["serializedVersion: 2", "defaultReferences: []", "executionOrder: 0", "icon: {instanceID: 0}"],
    "ShaderImporter": ["defaultTextures: []", "nonModifiableTextures: []", "preprocessorOverride: 0"],
    "ComputeShaderImporter": ["preprocessorOverride: 0"]}


def guid(path):
    return hashlib.md5(f"{NAME}/{path}".encode(), usedforsecurity=False).hexdigest()


def importer(path):
    """The importer of a file by its name; None for kinds whose settings only Unity knows."""
    return NAMES_OF_FILES.get(path) or IMPORTERS.get(posixpath.splitext(path)[1])


def meta_text(path, importer_name, is_folder):
    lines = ["fileFormatVersion: 2", f"guid: {guid(path)}", *(["folderAsset: yes"] if is_folder else []),
             f"{importer_name}:", "  externalObjects: {}",
             *(f"  {setting}" for setting in SETTINGS.get(importer_name, ())),
             "  userData: ", "  assetBundleName: ", "  assetBundleVariant: "]
    return "\n".join(lines) + "\n"


def wants_meta(package):
    """The imported files and folders, each of which has a .meta."""
    imported = {path for path in package.paths if is_imported(path) and not path.endswith(".meta")}
    return imported | {above for path in imported for above in folders_above(path) if is_imported(above)}


def missing_metas(package):
    """The texts of the .meta files that are not there by their path, and what is in the way of others."""
    texts, problems = {}, []
    for path in sorted(wants_meta(package)):
        if (package.root / f"{path}.meta").exists():
            continue
        is_folder = path in package.folders
        importer_name = "DefaultImporter" if is_folder else importer(path)
        if importer_name:
            texts[f"{path}.meta"] = meta_text(path, importer_name, is_folder)
        else:
            problems.append(Problem(path, "has no .meta, and the settings of its kind are Unity's: "
                                          f"let Unity write {path}.meta and put 'guid: {guid(path)}' into it"))
    return texts, problems


def orphaned_metas(package):
    """Metas of imported paths that are gone; on disk the path may be there without shipping."""
    return [Problem(path, f"belongs to {path[:-5]}, which is gone: remove it")
            for path in package.ending(".meta") if is_imported(path) and not (package.root / path[:-5]).exists()]
