using System.Diagnostics.CodeAnalysis;
using Avalonia.Media;
using Avalonia.Media.Fonts;
using HarfBuzzSharp;
using SkiaSharp;

namespace ErrorMatching.Hmi.Platform;

/// <summary>A face, opened by HarfBuzz (tables, shaping) and by Skia (outlines), both over the same memory.</summary>
internal sealed class SkiaTypeface : IPlatformTypeface
{
    private readonly FontMemory _memory;
    private readonly Face _face;

    /// <summary>Opens a face.</summary>
    /// <exception cref="InvalidDataException">It is no font.</exception>
    public SkiaTypeface(
        FontMemory memory,
        int index,
        FontSimulations simulations,
        string? family = null,
        FontWeight? weight = null,
        FontStyle? style = null)
    {
        _memory = memory;
        _face = new Face(memory.Shaped, index);
        Shaped = new Font(_face); // the default scale is the font's units per em
        Shaped.SetFunctionsOpenType();
        UnitsPerEm = _face.UnitsPerEm;
        Drawn = SKTypeface.FromData(memory.Drawn, index) ?? throw new InvalidDataException("This is no font that can be drawn.");
        FontSimulations = simulations;

        // Name and style come from the tables, unless the caller already knows them.
        var self = family is null || weight is null || style is null ? new GlyphTypeface(this, simulations) : null;
        FamilyName = family ?? self!.FamilyName;
        Weight = weight ?? self!.Weight;
        Style = style ?? self!.Style;
        Stretch = self?.Stretch ?? FontStretch.Normal;
    }

    public Font Shaped { get; }

    public SKTypeface Drawn { get; }

    public double UnitsPerEm { get; }

    public string FamilyName { get; } = "";

    public FontWeight Weight { get; } = FontWeight.Normal;

    public FontStyle Style { get; }

    public FontStretch Stretch { get; } = FontStretch.Normal;

    public FontSimulations FontSimulations { get; }

    public bool TryGetTable(OpenTypeTag tag, out ReadOnlyMemory<byte> table)
    {
        table = _memory.Table(_face, (uint)tag);
        return !table.IsEmpty;
    }

    public bool TryGetStream([NotNullWhen(true)] out Stream? stream)
    {
        stream = _memory.Read();
        return true;
    }

    public void Dispose()
    {
        // Faces live as long as the process, because Skia's caches refer to them.
    }
}
