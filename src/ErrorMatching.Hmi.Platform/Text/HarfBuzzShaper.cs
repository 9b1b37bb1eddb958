using System.Collections.Concurrent;
using System.Globalization;
using Avalonia;
using Avalonia.Media;
using Avalonia.Media.TextFormatting;
using Avalonia.Platform;
using HarfBuzzSharp;
using Buffer = HarfBuzzSharp.Buffer;

namespace ErrorMatching.Hmi.Platform;

/// <summary>Turns text into glyphs with HarfBuzz.</summary>
internal sealed class HarfBuzzShaper : ITextShaperImpl
{
    private static readonly Feature[] AsWritten = [new(Tag.Parse("calt"), 0, 0, uint.MaxValue)];
    private readonly ConcurrentDictionary<string, Language> _languages = new(StringComparer.Ordinal);

    [ThreadStatic]
    private static Buffer? t_buffer;

    public ITextShaperTypeface CreateTypeface(GlyphTypeface glyphTypeface) => new Stateless();

    public ShapedBuffer ShapeText(ReadOnlyMemory<char> text, TextShaperOptions options)
    {
        var typeface = (SkiaTypeface)options.GlyphTypeface.PlatformTypeface;
        var scale = options.FontRenderingEmSize / typeface.UnitsPerEm;
        var span = text.Span;
        var buffer = t_buffer ??= new Buffer();
        buffer.Reset();

        // Clusters count from the start of this run.
        buffer.AddUtf16(span);
        buffer.GuessSegmentProperties();
        buffer.Direction = (options.BidiLevel & 1) == 0 ? Direction.LeftToRight : Direction.RightToLeft;
        buffer.Language = _languages.GetOrAdd((options.Culture ?? CultureInfo.CurrentCulture).Name, name => new Language(name));
        typeface.Shaped.Shape(buffer, Features(options));

        var infos = buffer.GetGlyphInfoSpan();
        var positions = buffer.GetGlyphPositionSpan();
        var shaped = new ShapedBuffer(text, infos.Length, options.GlyphTypeface, options.FontRenderingEmSize, options.BidiLevel);
        for (var i = 0; i < infos.Length; i++)
        {
            var cluster = (int)infos[i].Cluster;
            var glyph = (ushort)infos[i].Codepoint;
            var advance = (positions[i].XAdvance * scale) + options.LetterSpacing;
            var c = span[cluster];
            if (c == '\t')
            {
                glyph = options.GlyphTypeface.CharacterToGlyphMap[' '];
                options.GlyphTypeface.TryGetHorizontalGlyphAdvance(glyph, out var space);
                advance = options.IncrementalTabWidth > 0 ? options.IncrementalTabWidth : 4 * space * scale;
            }
            else if (c is '\r' or '\n' or '\u2028' or '\u2029' or '\u0085' or '\u200B')
            {
                // Line breaks have no ink and no width.
                glyph = options.GlyphTypeface.CharacterToGlyphMap[' '];
                advance = 0;
            }

            shaped[i] = new Avalonia.Media.TextFormatting.GlyphInfo(
                glyph, cluster, advance, new Vector(positions[i].XOffset * scale, -positions[i].YOffset * scale));
        }

        return shaped;
    }

    // Contextual alternates make another sign of 0.05x0.05 or ->, and here each sign is shown as it stands in its file. What the text wants
    // comes last, and so goes before.
    private static Feature[] Features(TextShaperOptions options) =>
        options.FontFeatures is not { Count: > 0 } wanted ? AsWritten
            : [
                .. AsWritten,
                .. wanted.Select(w => new Feature(Tag.Parse(w.Tag), (uint)w.Value, (uint)w.Start, (uint)w.End)),
            ];

    // All state is in SkiaTypeface.
    private sealed class Stateless : ITextShaperTypeface
    {
        public void Dispose()
        {
            // It has none.
        }
    }
}
