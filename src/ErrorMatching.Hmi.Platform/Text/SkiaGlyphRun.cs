using Avalonia;
using Avalonia.Media;
using Avalonia.Media.TextFormatting;
using Avalonia.Platform;
using SkiaSharp;

namespace ErrorMatching.Hmi.Platform;

/// <summary>Glyphs in a row, prepared once for all frames that show them.</summary>
internal sealed class SkiaGlyphRun : IGlyphRunImpl
{
    // The slant of a face that has no slanted form, as of the shears that typesetters use: about 12 degrees.
    private const float Shear = -0.21f;

    // Skia guesses what a color is drawn on and changes the coverage of pixels for that, which makes dark text of small sizes too thin.
    // It leaves that out where a filter changes the coverage; this one keeps every value.
    private static readonly SKMaskFilter AsCovered = SKMaskFilter.CreateTable([.. Enumerable.Range(0, 256).Select(i => (byte)i)]);
    private readonly SkiaTypeface _typeface;
    private readonly ushort[] _glyphs;
    private readonly SKPoint[] _places;
    private SKTextBlob? _blob;

    public SkiaGlyphRun(GlyphTypeface typeface, double emSize, IReadOnlyList<GlyphInfo> glyphs, Point origin)
    {
        _typeface = (SkiaTypeface)typeface.PlatformTypeface;
        FontRenderingEmSize = emSize;
        BaselineOrigin = origin;
        (_glyphs, _places) = (new ushort[glyphs.Count], new SKPoint[glyphs.Count]);
        var x = 0.0;
        for (var i = 0; i < glyphs.Count; i++)
        {
            var g = glyphs[i];
            _glyphs[i] = g.GlyphIndex;
            _places[i] = new((float)(x + g.GlyphOffset.X), (float)g.GlyphOffset.Y);
            x += g.GlyphAdvance;
        }

        // For dirty rectangles and hit tests: the line box, a little wider than the ink.
        var scale = emSize / typeface.Metrics.DesignEmHeight;
        var slack = emSize / 4;
        Bounds = new Rect(
            origin.X - slack,
            origin.Y + (typeface.Metrics.Ascent * scale) - slack,
            x + (2 * slack),
            ((typeface.Metrics.Descent - typeface.Metrics.Ascent) * scale) + (2 * slack));
    }

    public double FontRenderingEmSize { get; }

    public Point BaselineOrigin { get; }

    public Rect Bounds { get; }

    public IReadOnlyList<float> GetIntersections(float lowerLimit, float upperLimit) => [];

    /// <summary>Draws the glyphs.</summary>
    public void Draw(SKCanvas canvas, SKPaint paint)
    {
        if (_glyphs.Length == 0)
        {
            return;
        }

        if (_blob is null)
        {
            using var font = Font();
            using var builder = new SKTextBlobBuilder();
            builder.AddPositionedRun(_glyphs, font, _places);
            _blob = builder.Build();
        }

        paint.MaskFilter = AsCovered;
        canvas.DrawText(_blob, (float)BaselineOrigin.X, (float)BaselineOrigin.Y, paint);
    }

    /// <summary>The outlines at the baseline origin.</summary>
    public SKPath Outlines()
    {
        using var font = Font();
        using var builder = new SKPathBuilder { FillType = SKPathFillType.Winding };
        for (var i = 0; i < _glyphs.Length; i++)
        {
            using var outline = font.GetGlyphPath(_glyphs[i]);
            if (outline is not null)
            {
                var place = _places[i] + new SKPoint((float)BaselineOrigin.X, (float)BaselineOrigin.Y);
                builder.AddPath(outline, place.X, place.Y, SKPathAddMode.Append);
            }
        }

        return builder.Detach();
    }

    public void Dispose()
    {
        _blob?.Dispose();
        _blob = null;
    }

    private SKFont Font() => new(_typeface.Drawn, (float)FontRenderingEmSize)
    {
        Subpixel = true,
        LinearMetrics = true,
        Hinting = SKFontHinting.None,
        Edging = SKFontEdging.Antialias,
        BaselineSnap = false,
        Embolden = _typeface.FontSimulations.HasFlag(FontSimulations.Bold),
        SkewX = _typeface.FontSimulations.HasFlag(FontSimulations.Oblique) ? Shear : 0,
    };
}
