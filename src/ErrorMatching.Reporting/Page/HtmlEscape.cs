using System.Globalization;
using System.Text;

namespace ErrorMatching.Reporting;

/// <summary>Escapes text from files, names and programs, so that a browser shows it but never executes it.</summary>
internal static class HtmlEscape
{
    /// <summary>Appends text with markup characters as entities. Characters that are invalid in XML and lone surrogates become U+FFFD.
    /// Marks that change the text direction are spelled out, because a block must be read in the same order as on the control.</summary>
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
                // A lone surrogate becomes U+FFFD.
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
            case 0x061C or 0x200E or 0x200F or (>= 0x202A and <= 0x202E) or (>= 0x2066 and <= 0x2069):
                target.Append(CultureInfo.InvariantCulture, $"[U+{rune.Value:X4}]");
                break;
            default: target.Append(rune.ToString()); break;
        }
    }
}
