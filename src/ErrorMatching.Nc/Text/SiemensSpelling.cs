using System.Text;

namespace ErrorMatching.Nc;

/// <summary>Names, addresses with an equals sign, and statements in Siemens spelling.</summary>
internal static class SiemensSpelling
{
    private static readonly string[] Statements = ["IF", "WHILE", "UNTIL", "FOR", "CASE", "DEF", "PROC", "EXTERN", "GOTO", "GOTOF",
        "GOTOB", "GOTOC", "CALL", "PCALL", "REPEAT", "REPEATB"];

    private static readonly string[] WordOperators = ["DIV", "MOD", "AND", "OR", "XOR", "B_AND", "B_OR", "B_XOR"];

    /// <summary>The token that begins with a letter, or with <c>$</c> or <c>_</c> (then the letter is 0).</summary>
    public static NcToken NameAt(this in BlockScanner text, int start, byte letter)
    {
        var second = start + 1 < text.End ? text.Bytes[start + 1] : (byte)0;
        if (letter != 0 && !SyntaxBytes.IsLetter(second) && second != '_' && second != '[' && text.AddressAt(start, letter) is { } address)
        {
            return address;
        }

        var nameEnd = text.NameEnd(start);
        var name = text.Bytes[start..nameEnd];
        var at = text.SkipSpaces(nameEnd);
        var next = at < text.End ? text.Bytes[at] : (byte)0;
        var isIndexed = next == '[';
        if (isIndexed)
        {
            at = SyntaxBytes.BehindBracket(text.Bytes, at, text.End);
            nameEnd = at;
            at = text.SkipSpaces(at);
            next = at < text.End ? text.Bytes[at] : (byte)0;
        }

        if (text.IsEquals(at))
        {
            return text.ValueAt(start, isIndexed ? IndexedLetter(letter, name) : name.Length == 1 ? letter : NcAddress.Of(name), name, at);
        }

        if (next == '(')
        {
            return BlockScanner.Plain(NcTokenKind.Keyword, start, SyntaxBytes.BehindBracket(text.Bytes, at, text.End));
        }

        if (next == ':' && at == nameEnd)
        {
            return BlockScanner.Plain(NcTokenKind.Keyword, start, at + 1);
        }

        if (IsOneOf(Statements, name))
        {
            return BlockScanner.Plain(NcTokenKind.Keyword, start, text.StatementEnd(nameEnd));
        }

        return name.Length == 1 && name[0] != '_' && name[0] != '$'
            ? BlockScanner.Plain(NcTokenKind.Invalid, start, start + 1, letter)
            : BlockScanner.Plain(NcTokenKind.Keyword, start, nameEnd);
    }

    // A letter with a plain number (X10), or with an index and an equals sign (R1=5, S2=1000, I1=3). Null for anything else.
    private static NcToken? AddressAt(this in BlockScanner text, int start, byte letter)
    {
        var valueAt = text.SkipSpaces(start + 1);
        if (!text.ReadNumber(valueAt, out var next, out var number))
        {
            return null;
        }

        var at = text.SkipSpaces(next);
        if (number.Decimals == 0 && at < text.End && text.IsEquals(at) && SyntaxBytes.IsDigit(text.Bytes[next - 1]))
        {
            var name = text.Bytes[start..next];
            return text.ValueAt(start, NcAddress.Of(name) is not 0 and var code ? code : IndexedLetter(letter, name[..1]), name, at);
        }

        if (at < text.End && text.Bytes[at] == ':' && at == next)
        {
            return BlockScanner.Plain(NcTokenKind.Keyword, start, at + 1);
        }

        // A number with an exponent: 1.5EX-3.
        var hasExponent = next + 1 < text.End && (text.Bytes[next] & ~0x20) == 'E' && (text.Bytes[next + 1] & ~0x20) == 'X';
        return hasExponent
            ? BlockScanner.Valued(NcTokenKind.ExpressionWord, letter, start, valueAt, text.ValueEnd(valueAt))
            : BlockScanner.Valued(NcTokenKind.Word, letter, start, valueAt, next, number);
    }

    // S2=1000 and S[2]=1000 are the speed of a spindle; R1=5 and R[1]=5 are a variable.
    private static byte IndexedLetter(byte letter, ReadOnlySpan<byte> name) =>
        name.Length == 1 && letter is (byte)'S' or (byte)'M' or (byte)'H' or (byte)'T' or (byte)'D' ? letter : (byte)0;

    // The token including its value after the equals sign. Letter 0: a variable, or an address that the dialect must know.
    private static NcToken ValueAt(this in BlockScanner text, int start, byte letter, ReadOnlySpan<byte> name, int equals)
    {
        var value = text.SkipSpaces(equals + 1);
        var end = text.ValueEnd(value);
        var corner = NcAddress.CornerOf(name);
        if (letter == 0 && corner == 0)
        {
            return BlockScanner.Plain(NcTokenKind.Assignment, start, end);
        }

        if (text.ReadNumber(value, out var next, out var number) && next == end)
        {
            return BlockScanner.Valued(corner == 0 ? NcTokenKind.Word : NcTokenKind.CommaWord, corner == 0 ? letter : corner, start, value,
                end, number);
        }

        if (corner != 0)
        {
            return BlockScanner.Valued(NcTokenKind.CommaWord, corner, start, value, end);
        }

        var distance = text.Distance(value, end, out var inside);
        if (distance == WordDistance.Modal)
        {
            return BlockScanner.Valued(NcTokenKind.ExpressionWord, letter, start, value, end);
        }

        return text.ReadNumber(inside, out next, out number) && text.SkipSpaces(next) == end - 1
            ? new(NcTokenKind.Word, letter, start, end - start, inside, next - inside, number, distance)
            : new(NcTokenKind.ExpressionWord, letter, start, end - start, inside, end - 1 - inside, default, distance);
    }

    // AC(..) and IC(..), and the position after the opening parenthesis.
    private static WordDistance Distance(this in BlockScanner text, int at, int end, out int inside)
    {
        inside = at;
        var nameEnd = text.NameEnd(at);
        var open = text.SkipSpaces(nameEnd);
        if (open >= end || text.Bytes[open] != '(' || text.Bytes[end - 1] != ')' || SyntaxBytes.BehindBracket(text.Bytes, open, end) != end)
        {
            return WordDistance.Modal;
        }

        inside = text.SkipSpaces(open + 1);
        var name = text.Bytes[at..nameEnd];
        return Ascii.EqualsIgnoreCase(name, "AC"u8) ? WordDistance.Absolute : Ascii.EqualsIgnoreCase(name, "IC"u8)
            ? WordDistance.Incremental : WordDistance.Modal;
    }

    // Operands and operators alternate; spaces may separate them.
    private static int ValueEnd(this in BlockScanner text, int at)
    {
        while (true)
        {
            at = text.SkipSpaces(at);
            while (at < text.End && text.Bytes[at] is (byte)'+' or (byte)'-')
            {
                at = text.SkipSpaces(at + 1);
            }

            var end = text.OperandEnd(at);
            var behind = text.SkipSpaces(end);
            var operation = text.OperatorEnd(behind);
            if (end == at || operation == behind)
            {
                return end;
            }

            at = operation;
        }
    }

    private static int OperandEnd(this in BlockScanner text, int at)
    {
        for (var name = text.NameEnd(at); Ascii.EqualsIgnoreCase(text.Bytes[at..name], "NOT"u8); name = text.NameEnd(at))
        {
            at = text.SkipSpaces(name);
        }

        if (at >= text.End || text.Bytes[at] == ';')
        {
            return at;
        }

        if (text.Bytes[at] == '"')
        {
            return SyntaxBytes.BehindString(text.Bytes, at, text.End);
        }

        if (text.Bytes[at] is (byte)'(' or (byte)'[')
        {
            return SyntaxBytes.BehindBracket(text.Bytes, at, text.End);
        }

        if (SyntaxBytes.IsDigit(text.Bytes[at]) || text.Bytes[at] == '.')
        {
            return text.ConstantEnd(at);
        }

        var end = text.NameEnd(at);
        while (end < text.End && text.Bytes[end] is (byte)'(' or (byte)'[')
        {
            end = SyntaxBytes.BehindBracket(text.Bytes, end, text.End);
        }

        return end;
    }

    // 10, 1.5 or 1.5EX-3. A letter after it begins the next word: X=10Y=5.
    private static int ConstantEnd(this in BlockScanner text, int at)
    {
        var end = text.DigitsEnd(at);
        if (end + 1 < text.End && (text.Bytes[end] & ~0x20) == 'E' && (text.Bytes[end + 1] & ~0x20) == 'X')
        {
            var sign = end + 2 < text.End && text.Bytes[end + 2] is (byte)'+' or (byte)'-' ? 1 : 0;
            var exponent = text.DigitsEnd(end + 2 + sign);
            return exponent > end + 2 + sign ? exponent : end;
        }

        return end;
    }

    private static int DigitsEnd(this in BlockScanner text, int at)
    {
        while (at < text.End && (SyntaxBytes.IsDigit(text.Bytes[at]) || text.Bytes[at] == '.'))
        {
            at++;
        }

        return at;
    }

    private static int OperatorEnd(this in BlockScanner text, int at)
    {
        if (at >= text.End)
        {
            return at;
        }

        var length = 0;
        while (at + length < text.End && length < 2
            && text.Bytes[at + length] is (byte)'+' or (byte)'-' or (byte)'*' or (byte)'/' or (byte)'<' or (byte)'>' or (byte)'=')
        {
            length++;
        }

        // A single equals sign assigns and does not compare.
        if (length == 2 || (length == 1 && text.Bytes[at] != '='))
        {
            return at + length;
        }

        var end = text.NameEnd(at);
        return IsOneOf(WordOperators, text.Bytes[at..end]) ? end : at;
    }

    private static int StatementEnd(this in BlockScanner text, int at)
    {
        while (at < text.End && text.Bytes[at] != ';')
        {
            at = text.Bytes[at] == '"' ? SyntaxBytes.BehindString(text.Bytes, at, text.End) : at + 1;
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
