using System.Diagnostics.CodeAnalysis;
using System.Runtime.InteropServices;
using Avalonia.Media;
using Avalonia.Media.Fonts;

namespace ErrorMatching.Hmi.Platform;

/// <summary>A font file in pinned memory, opened by HarfBuzz (tables, shaping) and FreeType (outlines, for Cairo).</summary>
internal sealed unsafe class NativeTypeface : IPlatformTypeface
{
    private static readonly nint s_freeType = FreeType.FT_Init_FreeType(out var library) == 0
        ? library
        : throw new InvalidOperationException("FreeType");
    private readonly byte[] _data;
    private readonly nint _hbFace;
    private readonly Dictionary<OpenTypeTag, byte[]?> _tables = [];

    public NativeTypeface(
        byte[] pinned, int index, FontSimulations simulations, string? family = null, FontWeight? weight = null, FontStyle? style = null)
    {
        _data = pinned;
        var address = Marshal.UnsafeAddrOfPinnedArrayElement(pinned, 0);
        var blob = HarfBuzz.hb_blob_create(address, (uint)pinned.Length, HarfBuzz.MemoryModeReadOnly, 0, 0);
        _hbFace = HarfBuzz.hb_face_create(blob, (uint)index);
        HarfBuzz.hb_blob_destroy(blob);
        HbFont = HarfBuzz.hb_font_create(_hbFace); // the default scale is the font's units per em
        HarfBuzz.hb_ot_font_set_funcs(HbFont);
        UnitsPerEm = HarfBuzz.hb_face_get_upem(_hbFace);
        if (FreeType.FT_New_Memory_Face(s_freeType, address, pinned.Length, index, out var face) != 0)
            throw new InvalidDataException("not a font FreeType can open");
        CairoFace = LibCairo.cairo_ft_font_face_create_for_ft_face(face, FreeType.LoadNoHinting);
        FontSimulations = simulations;
        var synthesize = (simulations.HasFlag(FontSimulations.Bold) ? 1u : 0) | (simulations.HasFlag(FontSimulations.Oblique) ? 2u : 0);
        if (synthesize != 0) LibCairo.cairo_ft_font_face_set_synthesize(CairoFace, synthesize);

        // Name and style come from the tables, unless the matcher already knows them.
        var self = family is null || weight is null || style is null ? new GlyphTypeface(this, simulations) : null;
        FamilyName = family ?? self!.FamilyName;
        Weight = weight ?? self!.Weight;
        Style = style ?? self!.Style;
        Stretch = self?.Stretch ?? FontStretch.Normal;
    }

    public nint HbFont { get; }
    public nint CairoFace { get; }
    public double UnitsPerEm { get; }
    public string FamilyName { get; } = "";
    public FontWeight Weight { get; } = FontWeight.Normal;
    public FontStyle Style { get; }
    public FontStretch Stretch { get; } = FontStretch.Normal;
    public FontSimulations FontSimulations { get; }

    public bool TryGetTable(OpenTypeTag tag, out ReadOnlyMemory<byte> table)
    {
        lock (_tables)
        {
            if (!_tables.TryGetValue(tag, out var bytes))
            {
                var blob = HarfBuzz.hb_face_reference_table(_hbFace, (uint)tag);
                var data = HarfBuzz.hb_blob_get_data(blob, out var length);
                bytes = length == 0 ? null : new ReadOnlySpan<byte>(data, (int)length).ToArray();
                HarfBuzz.hb_blob_destroy(blob);
                _tables[tag] = bytes;
            }
            table = bytes;
            return bytes is not null;
        }
    }

    public bool TryGetStream([NotNullWhen(true)] out Stream? stream)
    {
        stream = new MemoryStream(_data, writable: false);
        return true;
    }

    public void Dispose() { } // faces live as long as the process, because Cairo's caches refer to them

    public static byte[] Pin(Stream stream)
    {
        using var copy = new MemoryStream();
        stream.CopyTo(copy);
        var pinned = GC.AllocateUninitializedArray<byte>((int)copy.Length, pinned: true);
        copy.GetBuffer().AsSpan(0, pinned.Length).CopyTo(pinned);
        return pinned;
    }
}
