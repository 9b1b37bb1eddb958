using System.Globalization;

namespace ErrorMatching.Nc;

/// <summary>The beginning of an O word block of LinuxCNC.</summary>
/// <param name="Label">Its label; empty if it is computed.</param>
/// <param name="LabelEnd">End of the label.</param>
/// <param name="Keyword">Its keyword in upper case; empty if there is none.</param>
/// <param name="KeywordEnd">End of the keyword.</param>
internal readonly record struct OWordHead(string Label, int LabelEnd, string Keyword, int KeywordEnd)
{
    /// <summary>Reads the O word at a position.</summary>
    public static OWordHead Read(ReadOnlySpan<byte> text, int at)
    {
        var number = BlockHead.NumberAt(text, at + 1);
        var (label, end) = ("", number.Start + number.Length);
        if (number.Length > 0)
        {
            label = number.Value.ToString(CultureInfo.InvariantCulture);
        }
        else if (end < text.Length && text[end] == '<')
        {
            var length = text[end..].IndexOf((byte)'>');
            label = length > 0
                ? NcText.Decode(text.Slice(end + 1, length - 1)).Replace(" ", "", StringComparison.Ordinal).ToUpperInvariant()
                : "";
            end = length > 0 ? end + length + 1 : text.Length;
        }
        else
        {
            for (var depth = 0; end < text.Length && (depth > 0 || !SyntaxBytes.IsLetter(text[end])); end++)
            {
                depth += text[end] == '[' ? 1 : text[end] == ']' ? -1 : 0;
            }
        }

        var start = end;
        while (start < text.Length && text[start] is (byte)' ' or (byte)'\t')
        {
            start++;
        }

        var keyword = BlockHead.NameLength(text, start);
        return new(label, end, NcText.Decode(text.Slice(start, keyword)).ToUpperInvariant(), start + keyword);
    }
}
