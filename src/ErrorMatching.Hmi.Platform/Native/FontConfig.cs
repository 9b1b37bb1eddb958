using System.Runtime.InteropServices;

namespace ErrorMatching.Hmi.Platform;

/// <summary>fontconfig: family and character matching.</summary>
internal static unsafe partial class FontConfig
{
    public const string Library = "libfontconfig.so.1";

    [StructLayout(LayoutKind.Sequential)]
    public struct FontSet { public int Count, Size; public nint* Fonts; }

    [LibraryImport(Library)] public static partial nint FcInitLoadConfigAndFonts();
    [LibraryImport(Library)] public static partial FontSet* FcConfigGetFonts(nint config, int set);
    [LibraryImport(Library)] public static partial nint FcPatternCreate();
    [LibraryImport(Library)] public static partial void FcPatternDestroy(nint pattern);
    [LibraryImport(Library, StringMarshalling = StringMarshalling.Utf8)]
    public static partial int FcPatternAddString(nint pattern, string name, string value);
    [LibraryImport(Library, StringMarshalling = StringMarshalling.Utf8)]
    public static partial int FcPatternAddInteger(nint pattern, string name, int value);
    [LibraryImport(Library, StringMarshalling = StringMarshalling.Utf8)]
    public static partial int FcPatternAddCharSet(nint pattern, string name, nint set);
    [LibraryImport(Library, StringMarshalling = StringMarshalling.Utf8)]
    public static partial int FcPatternGetString(nint pattern, string name, int n, out nint value);
    [LibraryImport(Library, StringMarshalling = StringMarshalling.Utf8)]
    public static partial int FcPatternGetInteger(nint pattern, string name, int n, out int value);
    [LibraryImport(Library, StringMarshalling = StringMarshalling.Utf8)]
    public static partial int FcPatternGetCharSet(nint pattern, string name, int n, out nint value);
    [LibraryImport(Library)] public static partial nint FcCharSetCreate();
    [LibraryImport(Library)] public static partial int FcCharSetAddChar(nint set, uint codepoint);
    [LibraryImport(Library)] public static partial int FcCharSetHasChar(nint set, uint codepoint);
    [LibraryImport(Library)] public static partial void FcCharSetDestroy(nint set);
    [LibraryImport(Library)] public static partial int FcConfigSubstitute(nint config, nint pattern, int kind);
    [LibraryImport(Library)] public static partial void FcDefaultSubstitute(nint pattern);
    [LibraryImport(Library)] public static partial nint FcFontMatch(nint config, nint pattern, out int result);
    [LibraryImport(Library)] public static partial int FcWeightFromOpenType(int weight);
    [LibraryImport(Library)] public static partial int FcWeightToOpenType(int weight);
}
