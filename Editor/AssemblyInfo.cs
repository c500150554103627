using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("Penumbra.EditMode.Tests")]
