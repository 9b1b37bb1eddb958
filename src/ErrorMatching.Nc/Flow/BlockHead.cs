namespace ErrorMatching.Nc;

/// <summary>The head of a block: block skip, number, label, and the position of its first statement.</summary>
/// <param name="At">Start of the first statement, from the start of the block.</param>
/// <param name="Number">The block's number; -1 if it has none.</param>
/// <param name="LabelAt">Start of the label (Siemens, languages).</param>
/// <param name="LabelLength">Its length; 0 if there is none.</param>
/// <param name="IsSkip">True if it has a slash: the block skip switch decides whether it is executed.</param>
internal readonly record struct BlockHead(int At, long Number, int LabelAt, int LabelLength, bool IsSkip)
{
    // A language knows its own blocks: the head is what stands before the statement, and a label is a statement.
    private static BlockHead Read(ReadOnlySpan<byte> text, NcSyntax syntax, LanguageSpelling language)
    {
        var (number, isSkip, labelAt, labelLength) = (-1L, false, 0, 0);
        foreach (ref readonly var token in new NcTokenizer(text, 0, text.Length, syntax))
        {
            switch (token.Kind)
            {
                case NcTokenKind.Space:
                    break;
                case NcTokenKind.Comment when text[token.Start] == '(':
                    break;
                case NcTokenKind.BlockSkip:
                    isSkip = true;
                    break;
                case NcTokenKind.Word when token.Letter == 'N' && number < 0:
                    number = token.Number.Digits;
                    break;
                case NcTokenKind.Keyword:
                    var keyword = text.Slice(token.Start, token.Length);
                    var label = language.LabelOf(keyword);
                    return new(token.Start, number, label.Length > 0 ? token.Start + keyword.IndexOf(label) : 0, label.Length, isSkip);
                case NcTokenKind.Label when !language.IsHeading(text.Slice(token.Start, token.Length)):
                    (labelAt, labelLength) = (token.Start, token.Length);
                    break;
                default:
                    return new(token.Start, number, labelAt, labelLength, isSkip);
            }
        }

        return new(text.Length, number, labelAt, labelLength, isSkip);
    }

    /// <summary>Reads the head of a block.</summary>
    public static BlockHead Read(ReadOnlySpan<byte> text, NcSyntax syntax)
    {
        if (LanguageSpelling.Of(syntax) is { } language)
        {
            return Read(text, syntax, language);
        }

        var (at, number, labelAt, labelLength, isSkip) = (SyntaxBytes.MarkLength(text), -1L, 0, 0, false);
        while (at < text.Length)
        {
            var c = text[at];
            if (c is (byte)' ' or (byte)'\t')
            {
                at++;
            }
            else if (c == '/')
            {
                isSkip = true;
                at += at + 1 < text.Length && SyntaxBytes.IsDigit(text[at + 1]) ? 2 : 1;
            }
            else if (c == '(' && syntax != NcSyntax.Siemens && text[at..].IndexOf((byte)')') is > 0 and var close)
            {
                at += close + 1;
            }
            else if ((c | 0x20) == 'n' && number < 0 && NumberAt(text, at + 1) is { Length: > 0 } found)
            {
                (number, at) = (found.Value, found.Start + found.Length);
            }
            else if (syntax == NcSyntax.Siemens
                && labelLength == 0
                && NameLength(text, at) is > 1 and var length
                && at + length < text.Length
                && text[at + length] == ':'
                && (at + length + 1 == text.Length || text[at + length + 1] != '='))
            {
                (labelAt, labelLength, at) = (at, length, at + length + 1);
            }
            else
            {
                break;
            }
        }

        return new(at, number, labelAt, labelLength, isSkip);
    }

    /// <summary>Length of the name (letters, digits, underscores, not starting with a digit) at a position; 0 if there is none.</summary>
    public static int NameLength(ReadOnlySpan<byte> text, int at)
    {
        var end = at;
        while (end < text.Length && (SyntaxBytes.IsLetter(text[end]) || text[end] == '_' || (end > at && SyntaxBytes.IsDigit(text[end]))))
        {
            end++;
        }

        return end - at;
    }

    /// <summary>The whole number at a position, after spaces.</summary>
    public static (int Start, int Length, long Value) NumberAt(ReadOnlySpan<byte> text, int at)
    {
        while (at < text.Length && text[at] is (byte)' ' or (byte)'\t')
        {
            at++;
        }

        var (start, value) = (at, 0L);
        for (; at < text.Length && SyntaxBytes.IsDigit(text[at]) && value < 1_000_000_000_000; at++)
        {
            value = (value * 10) + (text[at] - '0');
        }

        return (start, at - start, value);
    }

    /// <summary>The name in angle brackets at a position, in capitals, and its end: <c>&lt;BORE&gt;</c>; null if there is none.</summary>
    public static (string? Name, int End) BracketedName(ReadOnlySpan<byte> text, int at)
    {
        var end = at < text.Length ? SyntaxBytes.BehindProgramName(text, at, text.Length) : 0;
        return end > 0 ? (NcText.Decode(text[(at + 1)..(end - 1)]).ToUpperInvariant(), end) : (null, at);
    }

    /// <summary>The program that begins at a position in ISO spelling: <c>O100</c>, <c>O&lt;BORE&gt;</c> or <c>&lt;BORE&gt;</c>, and the
    /// end of its name; null if none begins there.</summary>
    public static (string? Name, int End) ProgramAt(ReadOnlySpan<byte> text, int at)
    {
        var isNumbered = at < text.Length && (text[at] | 0x20) == 'o';
        return isNumbered && NumberAt(text, at + 1) is { Length: > 0 } number
            ? (FlowIndex.NumberName(number.Value), number.Start + number.Length)
            : BracketedName(text, isNumbered ? at + 1 : at);
    }

    /// <summary>True if a word is at a position, in any case.</summary>
    public static bool Stands(ReadOnlySpan<byte> text, int at, ReadOnlySpan<byte> word) =>
        text.Length - at >= word.Length && System.Text.Ascii.EqualsIgnoreCase(text.Slice(at, word.Length), word);
}
