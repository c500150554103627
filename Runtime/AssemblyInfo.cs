using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("Penumbra.Editor")]
[assembly: InternalsVisibleTo("Penumbra.EditMode.Tests")]
