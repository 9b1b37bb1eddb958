using System.Globalization;
using System.Text;

namespace ErrorMatching.Nc;

/// <summary>The first words of blocks of Klartext.</summary>
internal static class KlartextStatements
{
    // Words follow these; every other statement is one keyword up to its comment.
    private static readonly string[] PathFunctions = ["L", "LP", "C", "CC", "CR", "CT", "CP", "CTP", "RND", "CHF", "STOP"];

    // The second word belongs to the name of these.
    private static readonly string[] Pairs =
        ["BEGIN", "END", "BLK", "TOOL", "CYCL", "CALL", "TCH", "APPR", "DEP", "SEL", "FUNCTION", "PLANE", "TRANS", "PATTERN"];

    private const string CycleDefinition = "CYCLDEF";
    private const string ProbeCycle = "TCHPROBE";
    private const NumberStyles Signed = NumberStyles.AllowLeadingSign | NumberStyles.AllowDecimalPoint;

    /// <summary>The keyword or assignment that a block begins with; null if it begins with a word.</summary>
    public static NcToken? At(in BlockScanner text, int at)
    {
        if (text.ParameterEnd(at) is > 0 and var parameter)
        {
            return text.IsEquals(text.SkipSpaces(parameter))
                ? BlockScanner.Plain(NcTokenKind.Assignment, at, text.StatementEnd(at))
                : BlockScanner.Plain(NcTokenKind.Keyword, at, text.StatementEnd(at));
        }

        var end = LettersEnd(text.Bytes[..text.End], at);
        var name = text.Bytes[at..end];
        var isFollowedByValue = end < text.End && (SyntaxBytes.IsDigit(text.Bytes[end]) || text.Bytes[end] is (byte)'+' or (byte)'-');
        if (IsOneOf(PathFunctions, name) && (!isFollowedByValue || name.Length > 1))
        {
            return BlockScanner.Plain(NcTokenKind.Keyword, at, end);
        }

        var second = text.SkipSpaces(end);
        var secondEnd = LettersEnd(text.Bytes[..text.End], second);
        var pair = text.Bytes[second..secondEnd];
        if (Is(name, "APPR") || Is(name, "DEP"))
        {
            return BlockScanner.Plain(NcTokenKind.Keyword, at, secondEnd > second ? secondEnd : end);
        }

        if (Is(name, "TOOL") && Is(pair, "CALL"))
        {
            return BlockScanner.Plain(NcTokenKind.Keyword, at, secondEnd);
        }

        if (Is(name, "BEGIN"))
        {
            return BlockScanner.Plain(NcTokenKind.Keyword, at, text.BeforeUnit(text.StatementEnd(at)));
        }

        if (Is(name, "CYCL") && Is(pair, "DEF"))
        {
            return BlockScanner.Plain(NcTokenKind.Keyword, at, text.CycleEnd(at, secondEnd));
        }

        // A block that begins with one of its words: M30, X+10.
        return name.Length == 1 || IsWord(name) ? null : BlockScanner.Plain(NcTokenKind.Keyword, at, text.StatementEnd(at));
    }

    /// <summary>The name of a keyword: its words of letters without spaces, and the number of a cycle or function.</summary>
    public static ReadOnlySpan<byte> NameOf(ReadOnlySpan<byte> keyword)
    {
        var end = LettersEnd(keyword, 0);
        if (end == keyword.Length || Is(keyword, "R0"))
        {
            return keyword;
        }

        var name = new byte[keyword.Length];
        var length = Append(keyword[..end], name, 0);
        if (IsOneOf(Pairs, keyword[..end]) || (end == 1 && (keyword[0] | 0x20) == 'f'))
        {
            var second = SyntaxBytes.SkipSpaces(keyword, end, keyword.Length);
            var secondEnd = LettersEnd(keyword, second);
            length = Append(keyword[second..secondEnd], name, length);
            end = secondEnd;
        }

        if (Is(name.AsSpan(0, length), "PLANESPATIAL") && HasZeroAngles(keyword))
        {
            return "PLANERESET"u8;
        }

        var isCycle = Is(name.AsSpan(0, length), CycleDefinition) || Is(name.AsSpan(0, length), ProbeCycle);
        if (!isCycle && !Is(name.AsSpan(0, length), "FN") && !Is(name.AsSpan(0, length), "M"))
        {
            return name.AsSpan(0, length);
        }

        var digits = SyntaxBytes.SkipSpaces(keyword, end, keyword.Length);
        var digitsEnd = DigitsEnd(keyword, digits);
        var number = keyword[digits..digitsEnd].TrimStart((byte)'0');
        length = Append(number.Length > 0 ? number : digitsEnd > digits ? "0"u8 : [], name, length);
        var isLine = digitsEnd + 1 < keyword.Length && keyword[digitsEnd] == '.' && keyword[digitsEnd + 1] is > (byte)'0' and <= (byte)'9';
        return isCycle && isLine
            ? (byte[])[.. name.AsSpan(0, length), .. Resets(number, keyword[DigitsEnd(keyword, digitsEnd + 1)..]) ? "RESET"u8 : "SUB"u8]
            : name.AsSpan(0, length);
    }

    /// <summary>True for the name of a path function, an approach, a departure or a line of a cycle.</summary>
    public static bool HasWords(ReadOnlySpan<byte> name) => IsOneOf(PathFunctions, name)
        || StartsWith(name, "APPR") || StartsWith(name, "DEP") || StartsWith(name, CycleDefinition);

    /// <summary>What may follow behind a keyword.</summary>
    public static BlockPlace PlaceBehind(ReadOnlySpan<byte> keyword) =>
        Is(keyword, "CHF") ? BlockPlace.Chamfer
        : NameOf(keyword) is var name && Is(name, "TOOLCALL") ? BlockPlace.Tool
        : HasWords(name) && !StartsWith(name, CycleDefinition) ? BlockPlace.Words
        : BlockPlace.Continued;

    // A line of a cycle that ends its transformation: mirroring of no axis, tilting and rotation by zero, scaling by one.
    private static bool Resets(ReadOnlySpan<byte> cycle, ReadOnlySpan<byte> arguments)
    {
        if (Is(cycle, "8") || Is(cycle, "19"))
        {
            return arguments.Trim(" \t"u8).Length == 0;
        }

        var (word, value) = Is(cycle, "10") ? ("ROT", 0.0) : ("SCL", 1.0);
        var text = NcText.Decode(arguments).Trim();
        return (Is(cycle, "10") || Is(cycle, "11")) && text.StartsWith(word, StringComparison.OrdinalIgnoreCase)
            && double.TryParse(text.AsSpan(word.Length).Trim(), Signed, CultureInfo.InvariantCulture, out var number) && number == value;
    }

    private static bool HasZeroAngles(ReadOnlySpan<byte> plane)
    {
        var angles = NcText.Decode(plane).Split(' ', StringSplitOptions.RemoveEmptyEntries)
            .Where(w => w.StartsWith("SP", StringComparison.OrdinalIgnoreCase) && w.Length > 3 && !char.IsAsciiLetter(w[3]))
            .ToArray();
        return angles.Length == 3 && Array.TrueForAll(angles, a => double.TryParse(a.AsSpan(3), Signed, CultureInfo.InvariantCulture,
            out var degrees) && degrees == 0);
    }

    private static int DigitsEnd(ReadOnlySpan<byte> bytes, int at)
    {
        while (at < bytes.Length && SyntaxBytes.IsDigit(bytes[at]))
        {
            at++;
        }

        return at;
    }

    // CYCL DEF 7.1 X+60 has coordinates; what follows the head of other cycles is text or arguments, which belong to the keyword.
    private static int CycleEnd(this in BlockScanner text, int at, int defEnd)
    {
        var number = text.SkipSpaces(defEnd);
        var first = number;
        while (number < text.End && (SyntaxBytes.IsDigit(text.Bytes[number]) || text.Bytes[number] == '.'))
        {
            number++;
        }

        var statementEnd = text.StatementEnd(at);
        if (!text.Bytes[first..number].StartsWith("7."u8))
        {
            return statementEnd;
        }

        for (var next = text.SkipSpaces(number); next < statementEnd; next = text.SkipSpaces(next))
        {
            var word = SyntaxBytes.IsLetter(text.Bytes[next]) ? KlartextWords.At(text, next, BlockPlace.Words) : default;
            if (word.Kind is not (NcTokenKind.Word or NcTokenKind.ExpressionWord) || word.Letter is < (byte)'A' or > (byte)'Z'
                || word.Letter is (byte)'M' or (byte)'R' or (byte)'F' or (byte)'S')
            {
                return statementEnd;
            }

            next = word.End;
        }

        return number;
    }

    // The end of a statement, without the spaces and the mark of a continued line before a comment.
    private static int StatementEnd(this in BlockScanner text, int at)
    {
        var end = at;
        while (at < text.End && text.Bytes[at] != ';')
        {
            var next = text.Bytes[at] == '"' ? SyntaxBytes.BehindString(text.Bytes, at, text.End) : at + 1;
            end = SyntaxBytes.IsSpace(text.Bytes[at]) || (text.Bytes[at] == '~' && text.SkipSpaces(next) == text.End) ? end : next;
            at = next;
        }

        return end;
    }

    // BEGIN PGM NAME without the unit, which is a word of its own.
    private static int BeforeUnit(this in BlockScanner text, int end)
    {
        var unit = end;
        while (unit > 0 && SyntaxBytes.IsLetter(text.Bytes[unit - 1]))
        {
            unit--;
        }

        var name = text.Bytes[unit..end];
        if (!Is(name, "MM") && !Is(name, "INCH"))
        {
            return end;
        }

        while (unit > 0 && SyntaxBytes.IsSpace(text.Bytes[unit - 1]))
        {
            unit--;
        }

        return unit;
    }

    // Words of several letters that a block without a path function can begin with.
    private static bool IsWord(ReadOnlySpan<byte> name) => IsOneOf(["FMAX", "RL", "RR", "DR", "PR", "PA", "IPR", "IPA"], name)
        || (name.Length == 2 && (name[0] | 0x20) == 'i' && (name[1] | 0x20) is >= 'a' and <= 'c' or >= 'u' and <= 'z')
        || (name.Length == 2 && (name[1] | 0x20) == 'q');

    private static int LettersEnd(ReadOnlySpan<byte> bytes, int at)
    {
        while (at < bytes.Length && SyntaxBytes.IsLetter(bytes[at]))
        {
            at++;
        }

        return at;
    }

    private static int Append(ReadOnlySpan<byte> word, Span<byte> name, int length)
    {
        word.CopyTo(name[length..]);
        return length + word.Length;
    }

    private static bool Is(ReadOnlySpan<byte> name, string word) => Ascii.EqualsIgnoreCase(name, word);

    private static bool StartsWith(ReadOnlySpan<byte> name, string word) =>
        name.Length >= word.Length && Is(name[..word.Length], word);

    private static bool IsOneOf(ReadOnlySpan<string> words, ReadOnlySpan<byte> name)
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
