using System.Runtime.InteropServices;

namespace ErrorMatching.Hmi.Platform;

/// <summary>FreeType: only opens a face for Cairo.</summary>
internal static partial class FreeType
{
    public const string Library = "libfreetype.so.6";
    public const int LoadNoHinting = 2;

    [LibraryImport(Library)] public static partial int FT_Init_FreeType(out nint library);
    [LibraryImport(Library)] public static partial int FT_New_Memory_Face(nint library, nint data, nint size, nint index, out nint face);
}
