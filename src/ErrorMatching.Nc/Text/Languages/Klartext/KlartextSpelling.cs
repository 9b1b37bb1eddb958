using System.Text;

namespace ErrorMatching.Nc;

/// <summary>Heidenhain Klartext: a block is its number, a path function and words (<c>12 L X+10 IY-5 R0 FMAX M3</c>), or a statement that
/// is one keyword up to its comment (<c>13 CALL LBL 1 REP 2</c>).</summary>
internal sealed class KlartextSpelling : LanguageSpelling
{
    public override bool HasCodes => false;

    public override NcToken TokenAt(in BlockScanner text, int at, ref BlockPlace place)
    {
        var token = TokenAt(text, at, place);
        place = token.Kind is NcTokenKind.Space or NcTokenKind.BlockSkip ? place
            : place == BlockPlace.Number && token is { Kind: NcTokenKind.Word, Letter: (byte)'N' } ? BlockPlace.Statement
            : place is BlockPlace.Tool or BlockPlace.Chamfer ? place
            : place == BlockPlace.Continued || token.Kind == NcTokenKind.Assignment ? BlockPlace.Continued
            : token.Kind == NcTokenKind.Keyword && place <= BlockPlace.Statement
            ? KlartextStatements.PlaceBehind(text.Bytes.Slice(token.Start, token.Length))
            : BlockPlace.Words;
        return token;
    }

    private static NcToken TokenAt(in BlockScanner text, int at, BlockPlace place)
    {
        var c = text.Bytes[at];
        switch (c)
        {
            case (byte)' ' or (byte)'\t':
                return BlockScanner.Plain(NcTokenKind.Space, at, text.SkipSpaces(at + 1));
            case (byte)';':
                return BlockScanner.Plain(NcTokenKind.Comment, at, text.End);
            case (byte)'*' when place <= BlockPlace.Statement:
                // A structure line: a heading for the list of sections.
                return BlockScanner.Plain(NcTokenKind.Comment, at, text.End);
            case (byte)'/' when place <= BlockPlace.Statement:
                return BlockScanner.Plain(NcTokenKind.BlockSkip, at, at + 1);
            case (byte)'~' when place == BlockPlace.Continued && text.SkipSpaces(at + 1) == text.End:
                // Words of a path function that continue in the next line would be missing here.
                return BlockScanner.Plain(NcTokenKind.Space, at, text.End);
            case (byte)'"' when place == BlockPlace.Tool:
                return BlockScanner.Valued(
                    NcTokenKind.ExpressionWord, (byte)'T', at, at, SyntaxBytes.BehindString(text.Bytes, at, text.End));
            case (byte)'"':
                return BlockScanner.Plain(NcTokenKind.Expression, at, SyntaxBytes.BehindString(text.Bytes, at, text.End));
        }

        if (SyntaxBytes.IsDigit(c) && place == BlockPlace.Number)
        {
            return NumberAt(text, at, at);
        }

        if (SyntaxBytes.IsLetter(c))
        {
            return place == BlockPlace.Number && (c | 0x20) == 'n' && at + 1 < text.End && SyntaxBytes.IsDigit(text.Bytes[at + 1])
                ? NumberAt(text, at, at + 1)
                : place <= BlockPlace.Statement ? KlartextStatements.At(text, at) ?? KlartextWords.At(text, at, place)
                : KlartextWords.At(text, at, place);
        }

        // Only a tool and the length of a chamfer have no letter.
        var (kind, letter) = place == BlockPlace.Tool ? (NcTokenKind.Word, (byte)'T') : (NcTokenKind.CommaWord, (byte)'C');
        return place is BlockPlace.Tool or BlockPlace.Chamfer && text.ReadNumber(at, out var next, out var number)
            ? BlockScanner.Valued(kind, letter, at, at, next, number)
            : text.FillerAt(at) ?? BlockScanner.Plain(NcTokenKind.Invalid, at, at + 1);
    }

    public override ReadOnlySpan<byte> NameOf(ReadOnlySpan<byte> keyword) => KlartextStatements.NameOf(keyword);

    public override bool IsHeading(ReadOnlySpan<byte> keyword) => Ascii.EqualsIgnoreCase(NameOf(keyword), "BEGINPGM"u8);

    public override bool HasWords(ReadOnlySpan<byte> name) => KlartextStatements.HasWords(name);

    public override bool NamesTool(ReadOnlySpan<byte> name) =>
        Ascii.EqualsIgnoreCase(name, "TOOLCALL"u8) || Ascii.EqualsIgnoreCase(name, "TOOLDEF"u8);

    public override bool IsKeyword(int function) => KlartextWords.IsOfControl(function);

    public override string? ProgramAt(ReadOnlySpan<byte> text, int at) => null;

    // The statement ends before the unit.
    public override string? HeadAt(ReadOnlySpan<byte> text, int at)
    {
        foreach (ref readonly var token in new NcTokenizer(text, 0, text.Length, NcSyntax.Klartext))
        {
            if (token.Start == at)
            {
                var statement = text.Slice(token.Start, token.Length);
                var words = NcText.Decode(statement).Split([' ', '\t'], 3, StringSplitOptions.RemoveEmptyEntries);
                return IsHeading(statement) && words is [_, _, var name] ? name.Trim().Trim('"') : null;
            }
        }

        return null;
    }

    public override ReadOnlySpan<byte> LabelOf(ReadOnlySpan<byte> keyword) =>
        Ascii.EqualsIgnoreCase(NameOf(keyword), "LBL"u8) ? keyword[3..].Trim(" \t\""u8) : [];

    public override string CommentLine(string text) => "; " + text;

    private static NcToken NumberAt(in BlockScanner text, int at, int digits)
    {
        var end = digits;
        long number = 0;
        for (; end < text.End && SyntaxBytes.IsDigit(text.Bytes[end]) && end - digits < NcNumber.MaxDigits; end++)
        {
            number = (number * 10) + (text.Bytes[end] - '0');
        }

        return BlockScanner.Valued(NcTokenKind.Word, (byte)'N', at, digits, end, new(number, 0));
    }
}
