using System.Runtime.InteropServices;

namespace ErrorMatching.Hmi.Platform;

/// <summary>HarfBuzz: shaping and font table access.</summary>
internal static unsafe partial class HarfBuzz
{
    public const string Library = "libharfbuzz.so.0";
    public const int MemoryModeReadOnly = 1;
    public const int Ltr = 4, Rtl = 5;

    [StructLayout(LayoutKind.Sequential)]
    public struct GlyphInfo { public uint Codepoint, Mask, Cluster, Var1, Var2; }

    [StructLayout(LayoutKind.Sequential)]
    public struct GlyphPosition { public int XAdvance, YAdvance, XOffset, YOffset; public uint Var; }

    [StructLayout(LayoutKind.Sequential)]
    public struct Feature { public uint Tag, Value, Start, End; }

    [LibraryImport(Library)] public static partial nint hb_blob_create(nint data, uint length, int mode, nint userData, nint destroy);
    [LibraryImport(Library)] public static partial byte* hb_blob_get_data(nint blob, out uint length);
    [LibraryImport(Library)] public static partial void hb_blob_destroy(nint blob);
    [LibraryImport(Library)] public static partial nint hb_face_create(nint blob, uint index);
    [LibraryImport(Library)] public static partial uint hb_face_get_upem(nint face);
    [LibraryImport(Library)] public static partial nint hb_face_reference_table(nint face, uint tag);
    [LibraryImport(Library)] public static partial nint hb_font_create(nint face);
    [LibraryImport(Library)] public static partial void hb_ot_font_set_funcs(nint font);
    [LibraryImport(Library)] public static partial nint hb_buffer_create();
    [LibraryImport(Library)] public static partial void hb_buffer_destroy(nint buffer);
    [LibraryImport(Library)]
    public static partial void hb_buffer_add_utf16(nint buffer, char* text, int textLength, uint itemOffset, int itemLength);
    [LibraryImport(Library)] public static partial void hb_buffer_guess_segment_properties(nint buffer);
    [LibraryImport(Library)] public static partial void hb_buffer_set_direction(nint buffer, int direction);
    [LibraryImport(Library)] public static partial void hb_buffer_set_language(nint buffer, nint language);
    [LibraryImport(Library, StringMarshalling = StringMarshalling.Utf8)]
    public static partial nint hb_language_from_string(string text, int length);
    [LibraryImport(Library)] public static partial GlyphInfo* hb_buffer_get_glyph_infos(nint buffer, out uint length);
    [LibraryImport(Library)] public static partial GlyphPosition* hb_buffer_get_glyph_positions(nint buffer, out uint length);
    [LibraryImport(Library)] public static partial void hb_shape(nint font, nint buffer, Feature* features, uint count);
}
