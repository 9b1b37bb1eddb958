using System.Diagnostics.CodeAnalysis;

namespace ErrorMatching.Nc;

/// <summary>Enumerates a block's tokens without allocating. It looks at spelling only. Every byte belongs to exactly one token; bytes
/// that no rule explains are <see cref="NcTokenKind.Invalid"/> and are never dropped.</summary>
public ref struct NcTokenizer
{
    private readonly BlockScanner _text;
    private readonly LanguageSpelling? _language;
    private BlockPlace _place;
    private bool _atStart;
    private bool _hasUnpaired;
    private NcToken _current;

    internal NcTokenizer(ReadOnlySpan<byte> bytes, int start, int end, NcSyntax syntax)
    {
        _text = new(bytes, end, syntax);
        _language = LanguageSpelling.Of(syntax);
        _place = BlockPlace.Number;
        _atStart = true;
        _hasUnpaired = false;
        _current = BlockScanner.Plain(NcTokenKind.Space, start, start);
    }

    /// <summary>The current token; it changes with the next read.</summary>
    [UnscopedRef]
    public readonly ref readonly NcToken Current => ref _current;

    /// <summary>The tokenizer itself, so that <c>foreach</c> works.</summary>
    public readonly NcTokenizer GetEnumerator() => this;

    /// <summary>Reads the next token; false at the end of the block.</summary>
    public bool MoveNext()
    {
        var at = _current.End;
        if (at >= _text.End)
        {
            return false;
        }

        if (_language is not null)
        {
            _current = _language.TokenAt(_text, at, ref _place);
            return true;
        }

        var c = _text.Bytes[at];
        if (SyntaxBytes.IsLetter(c))
        {
            var letter = (byte)(c & ~0x20);

            // Nearly every token of a program is a letter with a number: it is made where it stays, without a copy.
            var valueAt = _text.SkipSpaces(at + 1);
            if (_text.Syntax != NcSyntax.Siemens && _text.ReadNumber(valueAt, out var next, out var number))
            {
                _current = new(NcTokenKind.Word, letter, at, next - at, valueAt, next - valueAt, number, WordDistance.Modal);
                _atStart &= letter == 'N';
                return true;
            }

            _current = _text.Syntax == NcSyntax.Siemens ? _text.NameAt(at, letter) : LetterAt(at, valueAt, letter);
            _atStart &= _current is { Kind: NcTokenKind.Word, Letter: (byte)'N' };
            return true;
        }

        if (c == ' ')
        {
            var behind = _text.SkipSpaces(at + 1);
            _current = new(NcTokenKind.Space, 0, at, behind - at, at, behind - at, default, WordDistance.Modal);
            return true;
        }

        _current = SignAt(at, c);
        _atStart &= _current.Kind is NcTokenKind.Space or NcTokenKind.BlockSkip;
        return true;
    }

    private NcToken SignAt(int at, byte c)
    {
        var bytes = _text.Bytes;
        var (end, syntax) = (_text.End, _text.Syntax);
        switch (c)
        {
            case (byte)' ' or (byte)'\t':
                return BlockScanner.Plain(NcTokenKind.Space, at, _text.SkipSpaces(at + 1));
            case (byte)'(' when syntax == NcSyntax.Siemens:
                return BlockScanner.Plain(NcTokenKind.Expression, at, SyntaxBytes.BehindBracket(bytes, at, end));
            case (byte)'(':
                return CommentAt(at);
            case (byte)';':
                return BlockScanner.Plain(NcTokenKind.Comment, at, end);
            case (byte)'%':
                return BlockScanner.Plain(NcTokenKind.Percent, at, end);
            // A slash at the start of a block or after its number (N10 /1 G0) is block skip; elsewhere it divides.
            case (byte)'/' when _atStart:
                return BlockScanner.Plain(NcTokenKind.BlockSkip, at, at + 1 < end && SyntaxBytes.IsDigit(bytes[at + 1]) ? at + 2 : at + 1);
            // A program number may begin with a colon.
            case (byte)':' when _atStart && syntax == NcSyntax.Iso && _text.ReadNumber(at + 1, out var behind, out var program):
                return BlockScanner.Valued(NcTokenKind.Word, (byte)'O', at, at + 1, behind, program);
            case (byte)',':
                return CommaWordAt(at);
            case (byte)'@' or (byte)'^' when syntax == NcSyntax.LinuxCnc:
                return PolarWordAt(at, c);
            // The number of a spindle of LinuxCNC: M3 $1 S1000.
            case (byte)'$' when syntax == NcSyntax.LinuxCnc && SpindleEnd(at) is > 0 and var behindSpindle:
                return BlockScanner.Plain(NcTokenKind.Expression, at, behindSpindle);
            case (byte)'#':
                return BlockScanner.Plain(NcTokenKind.Assignment, at,
                    syntax == NcSyntax.LinuxCnc ? _text.AssignmentEnd(at) : _text.ToCommentOrEnd(at + 1));
            case (byte)'$' or (byte)'_' when syntax == NcSyntax.Siemens:
                return _text.NameAt(at, 0);
            case (byte)'[':
                return BlockScanner.Plain(NcTokenKind.Expression, at, SyntaxBytes.BehindBracket(bytes, at, end));
            case (byte)'<' when syntax == NcSyntax.Iso && SyntaxBytes.BehindProgramName(bytes, at, end) is > 0 and var behindName:
                return BlockScanner.Plain(NcTokenKind.Expression, at, behindName);
            case (byte)'"':
                return BlockScanner.Plain(syntax == NcSyntax.Siemens ? NcTokenKind.Expression : NcTokenKind.Invalid, at,
                    SyntaxBytes.BehindString(bytes, at, end));
            default:
                return _text.FillerAt(at) ?? BlockScanner.Plain(NcTokenKind.Invalid, at, at + 1);
        }
    }

    // Unless every parenthesis of the block has a partner, the first closing one ends a comment, as most controls read it.
    private NcToken CommentAt(int at)
    {
        var close = _hasUnpaired ? -1 : _text.PartnerOf(at);
        if (close < 0)
        {
            _hasUnpaired = true;
            close = _text.Bytes[at.._text.End].IndexOf((byte)')') is >= 0 and var first ? at + first : -1;
        }

        return BlockScanner.Plain(close < 0 ? NcTokenKind.Invalid : NcTokenKind.Comment, at, close < 0 ? _text.End : close + 1);
    }

    private readonly NcToken CommaWordAt(int at)
    {
        var letterAt = _text.SkipSpaces(at + 1);
        if (letterAt < _text.End && SyntaxBytes.IsLetter(_text.Bytes[letterAt]))
        {
            var letter = (byte)(_text.Bytes[letterAt] & ~0x20);
            var valueAt = _text.SkipSpaces(letterAt + 1);
            if (_text.ReadNumber(valueAt, out var next, out var number))
            {
                return BlockScanner.Valued(NcTokenKind.CommaWord, letter, at, valueAt, next, number);
            }

            if (valueAt < _text.End && _text.ComputedEnd(valueAt) is > 0 and var behind)
            {
                return BlockScanner.Valued(NcTokenKind.CommaWord, letter, at, valueAt, behind);
            }
        }

        return BlockScanner.Plain(NcTokenKind.Invalid, at, at + 1);
    }

    // 0 if no number follows.
    private readonly int SpindleEnd(int at)
    {
        var valueAt = _text.SkipSpaces(at + 1);
        return _text.ReadNumber(valueAt, out var behind, out _) ? behind : valueAt < _text.End ? _text.ComputedEnd(valueAt) : 0;
    }

    private readonly NcToken PolarWordAt(int at, byte sign)
    {
        var valueAt = _text.SkipSpaces(at + 1);
        if (!_text.ReadNumber(valueAt, out var behind, out var number))
        {
            behind = valueAt < _text.End ? _text.ComputedEnd(valueAt) : 0;
        }

        return behind <= valueAt
            ? BlockScanner.Plain(NcTokenKind.Invalid, at, at + 1)
            : BlockScanner.Valued(NcTokenKind.PolarWord, sign, at, valueAt, behind, number);
    }

    // A letter without a number.
    private readonly NcToken LetterAt(int at, int valueAt, byte letter)
    {
        if (letter == 'O' && valueAt < _text.End && _text.Bytes[valueAt] == '<')
        {
            return BlockScanner.Plain(NcTokenKind.ExpressionWord, at, _text.BehindName(valueAt), letter);
        }

        if (valueAt < _text.End && _text.ComputedEnd(valueAt) is > 0 and var behind)
        {
            return BlockScanner.Valued(NcTokenKind.ExpressionWord, letter, at, valueAt, behind);
        }

        return at + 1 < _text.End && SyntaxBytes.IsLetter(_text.Bytes[at + 1])
            ? BlockScanner.Plain(NcTokenKind.Keyword, at, _text.KeywordEnd(at))
            : BlockScanner.Plain(NcTokenKind.Invalid, at, at + 1, letter);
    }
}
