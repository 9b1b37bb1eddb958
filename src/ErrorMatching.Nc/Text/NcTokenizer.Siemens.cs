using System.Text;

namespace ErrorMatching.Nc;

/// <content>Names, addresses with an equals sign, and statements in Siemens spelling.</content>
public ref partial struct NcTokenizer
{
    private static readonly string[] Statements = ["IF", "WHILE", "UNTIL", "FOR", "CASE", "DEF", "PROC", "EXTERN", "GOTO", "GOTOF", "GOTOB", "GOTOC", "CALL", "PCALL", "REPEAT", "REPEATB"];

    private static readonly string[] WordOperators = ["DIV", "MOD", "AND", "OR", "XOR", "B_AND", "B_OR", "B_XOR"];

    private void ReadName(byte letter)
    {
        var second = _position + 1 < _end ? _bytes[_position + 1] : (byte)0;
        if (letter != 0 && !SyntaxBytes.IsLetter(second) && second != '_' && second != '[' && ReadAddress(letter))
        {
            return;
        }

        var nameEnd = NameEnd(_position);
        var name = _bytes[_position..nameEnd];
        var at = SkipSpaces(nameEnd);
        var next = at < _end ? _bytes[at] : (byte)0;
        var isIndexed = next == '[';
        if (isIndexed)
        {
            at = SyntaxBytes.BehindBracket(_bytes, at, _end);
            nameEnd = at;
            at = SkipSpaces(at);
            next = at < _end ? _bytes[at] : (byte)0;
        }

        if (IsEquals(at))
        {
            ReadValue(isIndexed ? IndexedLetter(letter, name) : name.Length == 1 ? letter : NcAddress.Of(name), name, at);
        }
        else if (next == '(')
        {
            Plain(NcTokenKind.Keyword, SyntaxBytes.BehindBracket(_bytes, at, _end));
        }
        else if (next == ':' && at == nameEnd)
        {
            Plain(NcTokenKind.Keyword, at + 1);
        }
        else if (IsOneOf(Statements, name))
        {
            Plain(NcTokenKind.Keyword, StatementEnd(nameEnd));
        }
        else if (name.Length == 1 && name[0] != '_' && name[0] != '$')
        {
            Plain(NcTokenKind.Invalid, _position + 1, letter);
        }
        else
        {
            Plain(NcTokenKind.Keyword, nameEnd);
        }
    }

    // A letter with a plain number (X10), or with an index and an equals sign (R1=5, S2=1000, I1=3). False where it is none of these.
    private bool ReadAddress(byte letter)
    {
        var valueAt = SkipSpaces(_position + 1);
        if (!ReadNumber(valueAt, out var next, out var number))
        {
            return false;
        }

        var at = SkipSpaces(next);
        if (number.Decimals == 0 && at < _end && IsEquals(at) && SyntaxBytes.IsDigit(_bytes[next - 1]))
        {
            var name = _bytes[_position..next];
            ReadValue(NcAddress.Of(name) is not 0 and var code ? code : IndexedLetter(letter, name[..1]), name, at);
        }
        else if (at < _end && _bytes[at] == ':' && at == next)
        {
            Plain(NcTokenKind.Keyword, at + 1);
        }
        else if (next < _end && SyntaxBytes.IsLetter(_bytes[next]) && next + 1 < _end && (_bytes[next] & ~0x20) == 'E' && (_bytes[next + 1] & ~0x20) == 'X')
        {
            // A number with an exponent: 1.5EX-3.
            Computed(letter, valueAt, ValueEnd(valueAt), WordDistance.Modal);
        }
        else
        {
            Word(letter, valueAt, next, number);
        }

        return true;
    }

    // S2=1000 and S[2]=1000 are the speed of a spindle; R1=5 and R[1]=5 are a variable.
    private static byte IndexedLetter(byte letter, ReadOnlySpan<byte> name) =>
        name.Length == 1 && letter is (byte)'S' or (byte)'M' or (byte)'H' or (byte)'T' or (byte)'D' ? letter : (byte)0;

    // What stands behind the equals sign. Letter 0: a variable or an address that the dialect must know.
    private void ReadValue(byte letter, ReadOnlySpan<byte> name, int equals)
    {
        var value = SkipSpaces(equals + 1);
        var end = ValueEnd(value);
        var corner = NcAddress.CornerOf(name);
        if (letter == 0 && corner == 0)
        {
            Plain(NcTokenKind.Assignment, end);
        }
        else if (ReadNumber(value, out var next, out var number) && next == end)
        {
            _current = new(corner == 0 ? NcTokenKind.Word : NcTokenKind.CommaWord, corner == 0 ? letter : corner, _position, end - _position, value, end - value, number, WordDistance.Modal);
            _position = end;
        }
        else if (corner == 0 && Distance(value, end, out var inside) is not WordDistance.Modal and var distance)
        {
            if (ReadNumber(inside, out next, out number) && SkipSpaces(next) == end - 1)
            {
                _current = new(NcTokenKind.Word, letter, _position, end - _position, inside, next - inside, number, distance);
                _position = end;
            }
            else
            {
                _current = new(NcTokenKind.ExpressionWord, letter, _position, end - _position, inside, end - 1 - inside, default, distance);
                _position = end;
            }
        }
        else
        {
            Computed(corner == 0 ? letter : corner, value, end, WordDistance.Modal, corner == 0 ? NcTokenKind.ExpressionWord : NcTokenKind.CommaWord);
        }
    }

    private void Computed(byte letter, int value, int end, WordDistance distance, NcTokenKind kind = NcTokenKind.ExpressionWord)
    {
        _current = new(kind, letter, _position, end - _position, value, end - value, default, distance);
        _position = end;
    }

    // AC(..) and IC(..), with the place behind the parenthesis.
    private readonly WordDistance Distance(int at, int end, out int inside)
    {
        inside = at;
        var nameEnd = NameEnd(at);
        var open = SkipSpaces(nameEnd);
        if (open >= end || _bytes[open] != '(' || _bytes[end - 1] != ')' || SyntaxBytes.BehindBracket(_bytes, open, end) != end)
        {
            return WordDistance.Modal;
        }

        inside = SkipSpaces(open + 1);
        var name = _bytes[at..nameEnd];
        return Ascii.EqualsIgnoreCase(name, "AC"u8) ? WordDistance.Absolute : Ascii.EqualsIgnoreCase(name, "IC"u8) ? WordDistance.Incremental : WordDistance.Modal;
    }

    // Operands and operators in turn; spaces may stand between them.
    private readonly int ValueEnd(int at)
    {
        while (true)
        {
            at = SkipSpaces(at);
            while (at < _end && _bytes[at] is (byte)'+' or (byte)'-')
            {
                at = SkipSpaces(at + 1);
            }

            var end = OperandEnd(at);
            var behind = SkipSpaces(end);
            var operation = OperatorEnd(behind);
            if (end == at || operation == behind)
            {
                return end;
            }

            at = operation;
        }
    }

    private readonly int OperandEnd(int at)
    {
        for (var name = NameEnd(at); Ascii.EqualsIgnoreCase(_bytes[at..name], "NOT"u8); name = NameEnd(at))
        {
            at = SkipSpaces(name);
        }

        if (at >= _end || _bytes[at] == ';')
        {
            return at;
        }

        if (_bytes[at] == '"')
        {
            return SyntaxBytes.BehindString(_bytes, at, _end);
        }

        if (_bytes[at] is (byte)'(' or (byte)'[')
        {
            return SyntaxBytes.BehindBracket(_bytes, at, _end);
        }

        if (SyntaxBytes.IsDigit(_bytes[at]) || _bytes[at] == '.')
        {
            return ConstantEnd(at);
        }

        var end = NameEnd(at);
        while (end < _end && _bytes[end] is (byte)'(' or (byte)'[')
        {
            end = SyntaxBytes.BehindBracket(_bytes, end, _end);
        }

        return end;
    }

    // 10, 1.5 or 1.5EX-3. A letter behind it begins the next word: X=10Y=5.
    private readonly int ConstantEnd(int at)
    {
        var end = DigitsEnd(at);
        if (end + 1 < _end && (_bytes[end] & ~0x20) == 'E' && (_bytes[end + 1] & ~0x20) == 'X')
        {
            var sign = end + 2 < _end && _bytes[end + 2] is (byte)'+' or (byte)'-' ? 1 : 0;
            var exponent = DigitsEnd(end + 2 + sign);
            return exponent > end + 2 + sign ? exponent : end;
        }

        return end;
    }

    private readonly int DigitsEnd(int at)
    {
        while (at < _end && (SyntaxBytes.IsDigit(_bytes[at]) || _bytes[at] == '.'))
        {
            at++;
        }

        return at;
    }

    private readonly int OperatorEnd(int at)
    {
        if (at >= _end)
        {
            return at;
        }

        var length = 0;
        while (at + length < _end && length < 2 && _bytes[at + length] is (byte)'+' or (byte)'-' or (byte)'*' or (byte)'/' or (byte)'<' or (byte)'>' or (byte)'=')
        {
            length++;
        }

        // A single equals sign assigns; it compares nothing.
        if (length == 2 || (length == 1 && _bytes[at] != '='))
        {
            return at + length;
        }

        var end = NameEnd(at);
        return IsOneOf(WordOperators, _bytes[at..end]) ? end : at;
    }

    private readonly bool IsEquals(int at) => at < _end && _bytes[at] == '=' && !(at + 1 < _end && _bytes[at + 1] == '=');

    private readonly int NameEnd(int at)
    {
        while (at < _end && SyntaxBytes.IsNamePart(_bytes[at]))
        {
            at++;
        }

        return at;
    }

    private readonly int StatementEnd(int at)
    {
        while (at < _end && _bytes[at] != ';')
        {
            at = _bytes[at] == '"' ? SyntaxBytes.BehindString(_bytes, at, _end) : at + 1;
        }

        return at;
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
