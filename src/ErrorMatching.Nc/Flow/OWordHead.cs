using System.Globalization;

namespace ErrorMatching.Nc;

/// <summary>The beginning of an O word block of LinuxCNC.</summary>
/// <param name="Label">Its label; empty if it is computed.</param>
/// <param name="LabelEnd">End of the label.</param>
/// <param name="Keyword">Its keyword in upper case; empty if there is none.</param>
/// <param name="KeywordEnd">End of the keyword.</param>
internal readonly record struct OWordHead(string Label, int LabelEnd, string Keyword, int KeywordEnd)
{
    private static readonly string[] Keywords =
    [
        "SUB", "ENDSUB", "CALL", "RETURN", "IF", "ELSEIF", "ELSE", "ENDIF", "WHILE", "ENDWHILE", "DO", "REPEAT", "ENDREPEAT", "BREAK",
        "CONTINUE",
    ];

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
            // Names of variables and bracketed expressions may have letters: o#<n> call, o[#<n>+1] call.
            for (var depth = 0; end < text.Length && (depth > 0 || !SyntaxBytes.IsLetter(text[end])); end++)
            {
                depth += text[end] is (byte)'[' or (byte)'<' ? 1 : text[end] is (byte)']' or (byte)'>' ? -1 : 0;
            }
        }

        var (keyword, behind) = KeywordAt(text, end);
        return new(label, end, keyword, behind);
    }

    // The longest keyword here. LinuxCNC passes over spaces between letters, too: end sub.
    private static (string Keyword, int End) KeywordAt(ReadOnlySpan<byte> text, int at)
    {
        var found = ("", at);
        foreach (var keyword in Keywords)
        {
            var (end, length) = (at, 0);
            for (; end < text.Length && length < keyword.Length; end++)
            {
                if (text[end] is (byte)' ' or (byte)'\t')
                {
                    continue;
                }

                if ((text[end] & ~0x20) != keyword[length])
                {
                    break;
                }

                length++;
            }

            found = length == keyword.Length && length > found.Item1.Length ? (keyword, end) : found;
        }

        return found;
    }
}
