using System.Diagnostics.CodeAnalysis;

namespace ErrorMatching.Nc;

/// <summary>
/// Walks over a block's tokens without allocating. Spelling only: every byte belongs to exactly one token, and what no rule explains is
/// <see cref="NcTokenKind.Invalid"/>, never dropped.
/// </summary>
public ref partial struct NcTokenizer
{
    private readonly ReadOnlySpan<byte> _bytes;
    private readonly int _end;
    private readonly NcSyntax _syntax;
    private int _position;
    private bool _atStart;
    private bool _hasUnpaired;
    private NcToken _current;

    internal NcTokenizer(ReadOnlySpan<byte> bytes, int start, int end, NcSyntax syntax)
    {
        _bytes = bytes;
        _end = end;
        _syntax = syntax;
        _position = start;
        _atStart = true;
        _hasUnpaired = false;
        _current = default;
    }

    /// <summary>The token last read; another one as soon as the next is read.</summary>
    [UnscopedRef]
    public readonly ref readonly NcToken Current => ref _current;

    /// <summary>The tokenizer itself, so that <c>foreach</c> works.</summary>
    public readonly NcTokenizer GetEnumerator() => this;

    /// <summary>Reads the next token; false at the end of the block.</summary>
    public bool MoveNext()
    {
        if (_position >= _end)
        {
            return false;
        }

        var c = _bytes[_position];
        if (SyntaxBytes.IsLetter(c))
        {
            var letter = (byte)(c & ~0x20);
            if (_syntax == NcSyntax.Siemens)
            {
                ReadName(letter);
            }
            else
            {
                ReadLetter(letter);
            }

            _atStart &= Current is { Kind: NcTokenKind.Word, Letter: (byte)'N' };
            return true;
        }

        ReadSign(c);
        _atStart &= Current.Kind is NcTokenKind.Space or NcTokenKind.BlockSkip;
        return true;
    }

    private void ReadSign(byte c)
    {
        switch (c)
        {
            case (byte)' ' or (byte)'\t':
                Plain(NcTokenKind.Space, SkipSpaces(_position + 1));
                break;
            case (byte)'(' when _syntax == NcSyntax.Siemens:
                Plain(NcTokenKind.Expression, SyntaxBytes.BehindBracket(_bytes, _position, _end));
                break;
            case (byte)'(':
                ReadComment();
                break;
            case (byte)';':
                Plain(NcTokenKind.Comment, _end);
                break;
            case (byte)'%':
                Plain(NcTokenKind.Percent, _end);
                break;
            // A slash stands at the beginning of a block or behind its number (N10 /1 G0); elsewhere it divides.
            case (byte)'/' when _atStart:
                Plain(NcTokenKind.BlockSkip, _position + 1 < _end && SyntaxBytes.IsDigit(_bytes[_position + 1]) ? _position + 2 : _position + 1);
                break;
            // A program number may begin with a colon.
            case (byte)':' when _atStart && _syntax == NcSyntax.Iso && ReadNumber(_position + 1, out var behind, out var program):
                Word((byte)'O', _position + 1, behind, program);
                break;
            case (byte)',':
                ReadCommaWord();
                break;
            case (byte)'@' or (byte)'^' when _syntax == NcSyntax.LinuxCnc:
                ReadPolarWord(c);
                break;
            case (byte)'#':
                Plain(NcTokenKind.Assignment, _syntax == NcSyntax.LinuxCnc ? AssignmentEnd(_position) : ToCommentOrEnd(_position + 1));
                break;
            case (byte)'$' or (byte)'_' when _syntax == NcSyntax.Siemens:
                ReadName(0);
                break;
            case (byte)'[':
                Plain(NcTokenKind.Expression, SyntaxBytes.BehindBracket(_bytes, _position, _end));
                break;
            case (byte)'"':
                Plain(_syntax == NcSyntax.Siemens ? NcTokenKind.Expression : NcTokenKind.Invalid, SyntaxBytes.BehindString(_bytes, _position, _end));
                break;
            case 0xEF when _position == 0 && SyntaxBytes.MarkLength(_bytes) is > 0 and var mark:
                Plain(NcTokenKind.Space, mark);
                break;
            case 0 or SyntaxBytes.EndOfFile:
                var filled = SyntaxBytes.BehindPadding(_bytes, _position, _end);
                Plain(SyntaxBytes.IsFiller(_bytes, _position, filled, _end) ? NcTokenKind.Space : NcTokenKind.Invalid, filled);
                break;
            default:
                Plain(NcTokenKind.Invalid, _position + 1);
                break;
        }
    }

    private void Plain(NcTokenKind kind, int next, byte letter = 0)
    {
        _current = new(kind, letter, _position, next - _position, _position, next - _position, default, WordDistance.Modal);
        _position = next;
    }

    private void Word(byte letter, int valueAt, int next, NcNumber number)
    {
        _current = new(NcTokenKind.Word, letter, _position, next - _position, valueAt, next - valueAt, number, WordDistance.Modal);
        _position = next;
    }

    private readonly int SkipSpaces(int at) => SyntaxBytes.SkipSpaces(_bytes, at, _end);

    // Without a partner for every parenthesis of the block the first closing one ends a comment, as most controls read it.
    private void ReadComment()
    {
        var close = _hasUnpaired ? -1 : PartnerOf(_position);
        if (close < 0)
        {
            _hasUnpaired = true;
            close = _bytes[_position.._end].IndexOf((byte)')') is >= 0 and var first ? _position + first : -1;
        }

        Plain(close < 0 ? NcTokenKind.Invalid : NcTokenKind.Comment, close < 0 ? _end : close + 1);
    }

    private readonly int PartnerOf(int open)
    {
        var depth = 0;
        for (var at = open; at < _end; at++)
        {
            depth += _bytes[at] == '(' ? 1 : _bytes[at] == ')' ? -1 : 0;
            if (depth == 0)
            {
                return at;
            }
        }

        return -1;
    }

    private void ReadCommaWord()
    {
        var letterAt = SkipSpaces(_position + 1);
        if (letterAt < _end && SyntaxBytes.IsLetter(_bytes[letterAt]))
        {
            var valueAt = SkipSpaces(letterAt + 1);
            if (ReadNumber(valueAt, out var next, out var number))
            {
                _current = new(NcTokenKind.CommaWord, (byte)(_bytes[letterAt] & ~0x20), _position, next - _position, valueAt, next - valueAt, number, WordDistance.Modal);
                _position = next;
                return;
            }

            if (valueAt < _end && ComputedEnd(valueAt) is > 0 and var behind)
            {
                _current = new(NcTokenKind.CommaWord, (byte)(_bytes[letterAt] & ~0x20), _position, behind - _position, valueAt, behind - valueAt, default, WordDistance.Modal);
                _position = behind;
                return;
            }
        }

        Plain(NcTokenKind.Invalid, _position + 1);
    }

    private void ReadPolarWord(byte sign)
    {
        var valueAt = SkipSpaces(_position + 1);
        if (!ReadNumber(valueAt, out var behind, out var number))
        {
            behind = valueAt < _end ? ComputedEnd(valueAt) : 0;
        }

        if (behind <= valueAt)
        {
            Plain(NcTokenKind.Invalid, _position + 1);
            return;
        }

        _current = new(NcTokenKind.PolarWord, sign, _position, behind - _position, valueAt, behind - valueAt, number, WordDistance.Modal);
        _position = behind;
    }

    private void ReadLetter(byte letter)
    {
        var valueAt = SkipSpaces(_position + 1);
        if (ReadNumber(valueAt, out var next, out var number))
        {
            Word(letter, valueAt, next, number);
        }
        else if (letter == 'O' && valueAt < _end && _bytes[valueAt] == '<')
        {
            Plain(NcTokenKind.ExpressionWord, BehindName(valueAt), letter);
        }
        else if (valueAt < _end && ComputedEnd(valueAt) is > 0 and var behind)
        {
            _current = new(NcTokenKind.ExpressionWord, letter, _position, behind - _position, valueAt, behind - valueAt, default, WordDistance.Modal);
            _position = behind;
        }
        else if (_position + 1 < _end && SyntaxBytes.IsLetter(_bytes[_position + 1]))
        {
            Plain(NcTokenKind.Keyword, KeywordEnd());
        }
        else
        {
            Plain(NcTokenKind.Invalid, _position + 1, letter);
        }
    }

    // Sign, digits, point, digits. More digits than are exact make the word invalid rather than wrong.
    private readonly bool ReadNumber(int at, out int next, out NcNumber number)
    {
        next = at;
        number = default;
        if (at >= _end)
        {
            return false;
        }

        var negative = _bytes[at] == '-';
        if (negative || _bytes[at] == '+')
        {
            at = Inside(at + 1);
        }

        long digits = 0;
        var (whole, significant, decimals) = (0, 0, 0);
        var end = at;
        for (; at < _end && SyntaxBytes.IsDigit(_bytes[at]) && significant <= NcNumber.MaxDigits; at = Inside(end))
        {
            digits = (digits * 10) + (_bytes[at] - '0');
            significant += digits == 0 ? 0 : 1;
            whole++;
            end = at + 1;
        }

        if (at < _end && _bytes[at] == '.')
        {
            end = at + 1;
            for (at = Inside(end); at < _end && SyntaxBytes.IsDigit(_bytes[at]) && significant <= NcNumber.MaxDigits && decimals <= NcNumber.MaxDigits; at = Inside(end))
            {
                digits = (digits * 10) + (_bytes[at] - '0');
                significant += digits == 0 ? 0 : 1;
                decimals++;
                end = at + 1;
            }
        }

        if (whole + decimals == 0 || significant > NcNumber.MaxDigits || decimals > NcNumber.MaxDigits)
        {
            return false;
        }

        next = end;
        number = new(negative ? -digits : digits, decimals);
        return true;
    }

    // LinuxCNC reads spaces inside numbers as if they were not there.
    private readonly int Inside(int at) => _syntax == NcSyntax.LinuxCnc ? SkipSpaces(at) : at;
}
