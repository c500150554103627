using System.Runtime;

namespace Penumbra.Tests;

/// <summary>What frames leave to the garbage collector.</summary>
internal static class Allocations
{
    /// <summary>
    /// Returns the bytes that the action allocates on this thread. A collection, which other threads may cause, would
    /// count the rest of the thread's allocation buffer too, so that none runs meanwhile.
    /// </summary>
    internal static long Of(Action action)
    {
        GC.TryStartNoGCRegion(64 << 20);
        try
        {
            long before = GC.GetAllocatedBytesForCurrentThread();
            action();
            return GC.GetAllocatedBytesForCurrentThread() - before;
        }
        finally
        {
            if (GCSettings.LatencyMode == GCLatencyMode.NoGCRegion) GC.EndNoGCRegion();
        }
    }
}
