using System;
using UnityEngine;

namespace Penumbra.Samples
{
    // example:begin
    // The file of penumbra bake distance-field --objects; fields have its keys.
    [Serializable]
    public sealed class FieldObjects
    {
        public int[] voxels;
        public FieldObject[] objects;

        // picture: the file's, imported as a 3D texture. worldToField: for each object what takes a world position to where it was
        // when it was baked: Matrix4x4.identity while it stands there, else bakedPose * transform.worldToLocalMatrix, in which
        // bakedPose is the transform's localToWorldMatrix of that time.
        public void SetGlobal(Texture picture, Matrix4x4[] worldToField)
        {
            var rows = new Vector4[6 * 16]; // all 16 objects' always, as Unity keeps the length that an array is first set with
            for (int i = 0; i < objects.Length; ++i)
            {
                FieldObject one = objects[i];
                for (int row = 0; row < 3; ++row) rows[6 * i + row] = worldToField[i].GetRow(row);
                rows[6 * i + 3] = Row(one.corner_metres, one.distances_metres[1]);
                rows[6 * i + 4] = Row(one.size_metres, one.size_metres[0] / one.voxels[0]);
                rows[6 * i + 5] = new Vector4(one.first_voxel[0], one.first_voxel[1], one.first_voxel[2], 0.0f);
            }
            Shader.SetGlobalTexture(Shader.PropertyToID("_FieldAtlas"), picture);
            Shader.SetGlobalVector(Shader.PropertyToID("_PenumbraFieldAtlas"),
                                   new Vector4(voxels[0], voxels[1], voxels[2], objects.Length));
            Shader.SetGlobalVectorArray(Shader.PropertyToID("_PenumbraFieldObjects"), rows);
        }

        private static Vector4 Row(float[] three, float last) => new Vector4(three[0], three[1], three[2], last);
    }

    [Serializable]
    public sealed class FieldObject
    {
        public int[] first_voxel, voxels;
        public float[] corner_metres, size_metres, distances_metres;
    }
    // example:end
}
