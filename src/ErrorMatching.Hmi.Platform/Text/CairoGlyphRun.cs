using Avalonia;
using Avalonia.Media;
using Avalonia.Media.TextFormatting;
using Avalonia.Platform;

namespace ErrorMatching.Hmi.Platform;

internal sealed class CairoGlyphRun : IGlyphRunImpl
{
    public CairoGlyphRun(GlyphTypeface typeface, double emSize, IReadOnlyList<GlyphInfo> glyphs, Point origin)
    {
        Typeface = (NativeTypeface)typeface.PlatformTypeface;
        FontRenderingEmSize = emSize;
        BaselineOrigin = origin;
        Glyphs = new LibCairo.Glyph[glyphs.Count];
        var x = 0.0;
        for (var i = 0; i < glyphs.Count; i++)
        {
            var g = glyphs[i];
            Glyphs[i] = new LibCairo.Glyph { Index = g.GlyphIndex, X = x + g.GlyphOffset.X, Y = g.GlyphOffset.Y };
            x += g.GlyphAdvance;
        }
        // For dirty rectangles and hit tests: the line box, a little wider than the ink.
        var scale = emSize / typeface.Metrics.DesignEmHeight;
        var slack = emSize / 4;
        Bounds = new Rect(origin.X - slack, origin.Y + typeface.Metrics.Ascent * scale - slack, x + 2 * slack,
            (typeface.Metrics.Descent - typeface.Metrics.Ascent) * scale + 2 * slack);
    }

    public NativeTypeface Typeface { get; }
    public LibCairo.Glyph[] Glyphs { get; }
    public double FontRenderingEmSize { get; }
    public Point BaselineOrigin { get; }
    public Rect Bounds { get; }
    public IReadOnlyList<float> GetIntersections(float lowerLimit, float upperLimit) => [];
    public void Dispose() { }

    /// <summary>Adds the outlines at the baseline origin. It uses outlines because Cairo 1.16 snaps drawn glyphs to whole pixels.</summary>
    public unsafe void AddTo(nint cr)
    {
        var moved = stackalloc LibCairo.Glyph[Math.Min(Glyphs.Length, 256)];
        LibCairo.cairo_set_font_face(cr, Typeface.CairoFace);
        LibCairo.cairo_set_font_size(cr, FontRenderingEmSize);
        for (var start = 0; start < Glyphs.Length; start += 256)
        {
            var n = Math.Min(256, Glyphs.Length - start);
            for (var i = 0; i < n; i++)
                moved[i] = Glyphs[start + i] with
                {
                    X = Glyphs[start + i].X + BaselineOrigin.X,
                    Y = Glyphs[start + i].Y + BaselineOrigin.Y
                };
            LibCairo.cairo_glyph_path(cr, moved, n);
        }
    }
}
