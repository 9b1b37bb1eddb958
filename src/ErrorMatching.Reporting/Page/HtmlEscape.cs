using System.Globalization;
using System.Text;

namespace ErrorMatching.Reporting;

/// <summary>Turns text from files, names and programs into text that a browser shows and never obeys.</summary>
public static class HtmlEscape
{
    /// <summary>
    /// The text with markup characters as entities. Characters that XML does not know and lone surrogates become U+FFFD, marks that would turn the direction of what follows are spelled out:
    /// a block must be read in the order in which the control reads it.
    /// </summary>
    public static void Append(StringBuilder target, ReadOnlySpan<char> text)
    {
        while (!text.IsEmpty)
        {
            var plain = 0;
            while (plain < text.Length && IsPlain(text[plain]))
            {
                plain++;
            }

            target.Append(text[..plain]);
            text = text[plain..];
            if (!text.IsEmpty)
            {
                // Of a lone surrogate it makes U+FFFD.
                Rune.DecodeFromUtf16(text, out var rune, out var length);
                Append(target, rune);
                text = text[length..];
            }
        }
    }

    private static bool IsPlain(char c) => c is >= ' ' and < '\x7F' and not ('&' or '<' or '>' or '"' or '\'');

    private static void Append(StringBuilder target, Rune rune)
    {
        switch (rune.Value)
        {
            case '&': target.Append("&amp;"); break;
            case '<': target.Append("&lt;"); break;
            case '>': target.Append("&gt;"); break;
            case '"': target.Append("&quot;"); break;
            case '\'': target.Append("&#39;"); break;
            case '\t' or '\n' or '\r': target.Append(' '); break;
            case < 0x20 or (>= 0x7F and < 0xA0) or 0xFFFE or 0xFFFF: target.Append('\uFFFD'); break;
            case 0x061C or 0x200E or 0x200F or (>= 0x202A and <= 0x202E) or (>= 0x2066 and <= 0x2069): target.Append(CultureInfo.InvariantCulture, $"[U+{rune.Value:X4}]"); break;
            default: target.Append(rune.ToString()); break;
        }
    }
}
