using System.Text;

namespace ErrorMatching.Nc;

/// <summary>Okuma OSP: letters with numbers as on ISO controls, and besides them names of blocks and programs (<c>NLAP</c>, <c>OPART</c>),
/// addresses and variables with an equals sign (<c>X=VC1+5</c>, <c>XPOS=10</c>), and statements (<c>IF [VC1 EQ 1] NLAP</c>).</summary>
internal sealed class OkumaSpelling : LanguageSpelling
{
    // A block of OSP has at most 158 characters. Of a longer comment, the partner is not looked for from each parenthesis again.
    private const int LongestComment = 200;
    private const int LongestName = 100;

    // A statement contains all up to its comment.
    private static readonly string[] Statements = ["IF", "GOTO", "CALL", "MODIN", "MODOUT", "RTS"];

    // Words of the control that could be names of blocks.
    private static readonly string[] Commands = ["NCYL", "NOEX"];

    public override bool HasCodes => true;

    public override NcToken TokenAt(in BlockScanner text, int at, ref BlockPlace place)
    {
        var token = TokenAt(text, at, place);
        place = token.Kind is NcTokenKind.Space or NcTokenKind.BlockSkip or NcTokenKind.Comment ? place
            : place == BlockPlace.Number && token is { Kind: NcTokenKind.Label } or { Kind: NcTokenKind.Word, Letter: (byte)'N' }
            ? BlockPlace.Statement : BlockPlace.Words;
        return token;
    }

    public override ReadOnlySpan<byte> NameOf(ReadOnlySpan<byte> keyword) => keyword[..NameLength(keyword, 0)];

    public override bool HasWords(ReadOnlySpan<byte> name) => !IsOneOf(Statements, name);

    public override bool NamesTool(ReadOnlySpan<byte> name) => false;

    public override bool IsKeyword(int function) => false;

    public override bool IsHeading(ReadOnlySpan<byte> keyword) => keyword.Length > 1 && (keyword[0] | 0x20) == 'o';

    public override string? ProgramAt(ReadOnlySpan<byte> text, int at)
    {
        var length = NameLength(text, at);
        return text[at] == '$' ? ""
            : IsHeading(text.Slice(at, length)) ? NcText.Decode(text.Slice(at, length)).ToUpperInvariant()
            : null;
    }

    public override ReadOnlySpan<byte> LabelOf(ReadOnlySpan<byte> keyword) => IsHeading(keyword) ? [] : keyword;

    public override string CommentLine(string text) => $"({text})";

    private static NcToken TokenAt(in BlockScanner text, int at, BlockPlace place)
    {
        var c = text.Bytes[at];
        switch (c)
        {
            case (byte)' ' or (byte)'\t':
                return BlockScanner.Plain(NcTokenKind.Space, at, text.SkipSpaces(at + 1));
            case (byte)'(':
                return CommentAt(text, at);
            case (byte)';':
                return BlockScanner.Plain(NcTokenKind.Comment, at, text.End);
            case (byte)'%':
                return BlockScanner.Plain(NcTokenKind.Percent, at, text.End);
            case (byte)'$' when place == BlockPlace.Number:
                // The name of the file: $PART.MIN%
                return BlockScanner.Plain(NcTokenKind.Percent, at, text.End);
            case (byte)'/' when place <= BlockPlace.Statement:
                return BlockScanner.Plain(
                    NcTokenKind.BlockSkip, at, at + 1 < text.End && SyntaxBytes.IsDigit(text.Bytes[at + 1]) ? at + 2 : at + 1);
            case (byte)'[':
                return BlockScanner.Plain(NcTokenKind.Expression, at, SyntaxBytes.BehindBracket(text.Bytes, at, text.End));
        }

        return SyntaxBytes.IsLetter(c) ? LetterAt(text, at, place)
            : text.FillerAt(at) ?? BlockScanner.Plain(NcTokenKind.Invalid, at, at + 1);
    }

    // Unless it has a partner, the first closing parenthesis ends a comment, as most controls read it.
    private static NcToken CommentAt(in BlockScanner text, int at)
    {
        var close = text.PartnerOf(at, LongestComment) is >= 0 and var partner ? partner
            : text.Bytes[at..text.End].IndexOf((byte)')') is >= 0 and var first ? at + first
            : -1;
        return BlockScanner.Plain(close < 0 ? NcTokenKind.Invalid : NcTokenKind.Comment, at, close < 0 ? text.End : close + 1);
    }

    private static NcToken LetterAt(in BlockScanner text, int at, BlockPlace place)
    {
        var letter = (byte)(text.Bytes[at] & ~0x20);
        var length = NameLength(text.Bytes[..text.End], at);
        var name = text.Bytes.Slice(at, length);
        if (BehindIndex(text, at + length) is var target && text.IsEquals(text.SkipSpaces(target)) && IsVariable(name))
        {
            var end = ValueEnd(text, text.SkipSpaces(target) + 1);
            return BlockScanner.Plain(NcTokenKind.Assignment, at, end);
        }

        if (length > 1 && SyntaxBytes.IsLetter(text.Bytes[at + 1]))
        {
            return place == BlockPlace.Number && letter is (byte)'N' or (byte)'O' && !IsOneOf(Commands, name)
                ? BlockScanner.Plain(NcTokenKind.Label, at, at + length)
                : BlockScanner.Plain(NcTokenKind.Keyword, at, IsOneOf(Statements, name) ? text.ToCommentOrEnd(at) : at + length);
        }

        if (place == BlockPlace.Number && letter == 'O' && length > 1 && name[1..].IndexOfAnyExceptInRange((byte)'0', (byte)'9') >= 0)
        {
            return BlockScanner.Plain(NcTokenKind.Label, at, at + length);
        }

        var valueAt = text.SkipSpaces(at + 1);
        return text.ReadNumber(valueAt, out var next, out var number)
            ? BlockScanner.Valued(NcTokenKind.Word, letter, at, valueAt, next, number)
            : text.IsEquals(valueAt) ? AssignedAt(text, at, letter, text.SkipSpaces(valueAt + 1))
            : BlockScanner.Plain(NcTokenKind.Invalid, at, at + 1, letter);
    }

    // X=10 is the word X10.
    private static NcToken AssignedAt(in BlockScanner text, int at, byte letter, int value)
    {
        var end = ValueEnd(text, value);
        return text.ReadNumber(value, out var next, out var number) && next == end
            ? BlockScanner.Valued(NcTokenKind.Word, letter, at, value, end, number)
            : BlockScanner.Valued(NcTokenKind.ExpressionWord, letter, at, value, end);
    }

    // Two letters, or V with a number; a single letter is an address.
    private static bool IsVariable(ReadOnlySpan<byte> name) =>
        name.Length > 1 && (SyntaxBytes.IsLetter(name[1]) || (name[0] | 0x20) == 'v');

    private static int BehindIndex(in BlockScanner text, int at) =>
        at < text.End && text.Bytes[at] == '[' ? SyntaxBytes.BehindBracket(text.Bytes, at, text.End) : at;

    // Operands with + - * / between them; other operators are in brackets only. Spaces may separate them.
    private static int ValueEnd(in BlockScanner text, int at)
    {
        for (var start = at; ;)
        {
            at = text.SkipSpaces(at);
            while (at < text.End && text.Bytes[at] is (byte)'+' or (byte)'-')
            {
                at = text.SkipSpaces(at + 1);
            }

            var end = OperandEnd(text, at);
            var behind = text.SkipSpaces(end);
            if (end == at)
            {
                return Math.Max(start, end);
            }

            if (behind >= text.End || text.Bytes[behind] is not ((byte)'+' or (byte)'-' or (byte)'*' or (byte)'/'))
            {
                return end;
            }

            at = behind + 1;
        }
    }

    private static int OperandEnd(in BlockScanner text, int at)
    {
        if (at >= text.End)
        {
            return at;
        }

        switch (text.Bytes[at])
        {
            case (byte)'[':
                return SyntaxBytes.BehindBracket(text.Bytes, at, text.End);
            case (byte)'\'':
                return text.Bytes[(at + 1)..text.End].IndexOf((byte)'\'') is >= 0 and var length ? at + length + 2 : text.End;
            case (byte)'#':
                // A hexadecimal number: #81H
                return text.NameEnd(at + 1);
            case var c when SyntaxBytes.IsLetter(c):
                return BehindIndex(text, at + NameLength(text.Bytes[..text.End], at));
            default:
                return text.ReadNumber(at, out var next, out _) ? next : at;
        }
    }

    // Letters, digits and underscores, not beginning with a digit. OSP has at most 16 of them in a name; what is longer is words.
    private static int NameLength(ReadOnlySpan<byte> text, int at)
    {
        var (end, last) = (at, Math.Min(text.Length, at + LongestName));
        while (end < last && (SyntaxBytes.IsLetter(text[end]) || text[end] == '_' || (end > at && SyntaxBytes.IsDigit(text[end]))))
        {
            end++;
        }

        return end - at;
    }

    private static bool IsOneOf(string[] words, ReadOnlySpan<byte> name)
    {
        foreach (var word in words)
        {
            if (Ascii.EqualsIgnoreCase(name, word))
            {
                return true;
            }
        }

        return false;
    }
}
