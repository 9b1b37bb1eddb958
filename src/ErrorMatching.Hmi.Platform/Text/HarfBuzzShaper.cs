using System.Globalization;
using Avalonia;
using Avalonia.Media;
using Avalonia.Media.Fonts;
using Avalonia.Media.TextFormatting;
using Avalonia.Platform;

namespace ErrorMatching.Hmi.Platform;

internal sealed unsafe class HarfBuzzShaper : ITextShaperImpl
{
    private sealed class Shaped : ITextShaperTypeface
    {
        public void Dispose() { }
    }

    public ITextShaperTypeface CreateTypeface(GlyphTypeface glyphTypeface) => new Shaped(); // all state is in NativeTypeface

    public ShapedBuffer ShapeText(ReadOnlyMemory<char> text, TextShaperOptions options)
    {
        if (text.Length == 0) return new ShapedBuffer(text, 0, options.GlyphTypeface, options.FontRenderingEmSize, options.BidiLevel);
        var typeface = (NativeTypeface)options.GlyphTypeface.PlatformTypeface;
        var scale = options.FontRenderingEmSize / typeface.UnitsPerEm;
        var span = text.Span;
        var buffer = HarfBuzz.hb_buffer_create();
        try
        {
            fixed (char* chars = span)
                HarfBuzz.hb_buffer_add_utf16(buffer, chars, span.Length, 0, span.Length); // clusters count from the start of this run
            HarfBuzz.hb_buffer_guess_segment_properties(buffer);
            HarfBuzz.hb_buffer_set_direction(buffer, (options.BidiLevel & 1) == 0 ? HarfBuzz.Ltr : HarfBuzz.Rtl);
            HarfBuzz.hb_buffer_set_language(
                buffer, HarfBuzz.hb_language_from_string((options.Culture ?? CultureInfo.CurrentCulture).Name, -1));
            var features = stackalloc HarfBuzz.Feature[options.FontFeatures?.Count ?? 0];
            for (var i = 0; i < (options.FontFeatures?.Count ?? 0); i++)
            {
                var f = options.FontFeatures![i];
                features[i] = new HarfBuzz.Feature
                {
                    Tag = (uint)OpenTypeTag.Parse(f.Tag),
                    Value = (uint)f.Value,
                    Start = (uint)f.Start,
                    End = (uint)f.End
                };
            }
            HarfBuzz.hb_shape(typeface.HbFont, buffer, features, (uint)(options.FontFeatures?.Count ?? 0));
            var infos = HarfBuzz.hb_buffer_get_glyph_infos(buffer, out var count);
            var positions = HarfBuzz.hb_buffer_get_glyph_positions(buffer, out _);
            var shaped = new ShapedBuffer(text, (int)count, options.GlyphTypeface, options.FontRenderingEmSize, options.BidiLevel);
            for (var i = 0; i < count; i++)
            {
                var cluster = (int)infos[i].Cluster;
                var glyph = (ushort)infos[i].Codepoint;
                var advance = positions[i].XAdvance * scale + options.LetterSpacing;
                var c = span[cluster];
                if (c == '\t')
                {
                    glyph = options.GlyphTypeface.CharacterToGlyphMap[' '];
                    options.GlyphTypeface.TryGetHorizontalGlyphAdvance(glyph, out var space);
                    advance = options.IncrementalTabWidth > 0 ? options.IncrementalTabWidth : 4 * space * scale;
                }
                else if (c is '\r' or '\n' or '\u2028' or '\u2029' or '\u0085' or '\u200B')
                {
                    glyph = options.GlyphTypeface.CharacterToGlyphMap[' ']; // line breaks have no ink and no width
                    advance = 0;
                }
                shaped[i] = new GlyphInfo(glyph, cluster, advance, new Vector(positions[i].XOffset * scale, -positions[i].YOffset * scale));
            }
            return shaped;
        }
        finally { HarfBuzz.hb_buffer_destroy(buffer); }
    }
}
