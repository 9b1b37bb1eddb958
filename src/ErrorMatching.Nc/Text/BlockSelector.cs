using System.Collections;
using System.Globalization;
using System.Text;
using System.Text.RegularExpressions;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>Selects blocks of a program by a number (<c>N110</c>), a range of numbers (<c>N110..N130</c>), a line of the file
/// (<c>L12</c>), a range of lines (<c>L12..L40</c>), or a regular expression between slashes that is matched against each block's text
/// (<c>/^N8[0-9]{3}\b/</c>).</summary>
/// <remarks>
/// Lines are counted from 1, whatever is in them, as editors and messages do. They have nothing to do with words of the program: L12
/// selects line 12 and not the blocks that call a subprogram 12. In an edited file, the same line may be another block: a job that names
/// lines also states the program's SHA-256.
/// Numbers are compared by value, so N0110 is N110. Expressions run on the non-backtracking engine: its time depends only on the length
/// of the program, so it needs no timeout, and the result does not depend on the computer's load. That engine has no lookaround and no
/// backreferences, so expressions cannot use them.
/// </remarks>
public sealed class BlockSelector
{
    /// <summary>Maximum number of characters of an expression.</summary>
    public const int LongestPattern = 1000;

    /// <summary>Minimum number of blocks for a second thread to pay off.</summary>
    private const int Many = 100_000;

    private readonly NcNumber? _first;
    private readonly NcNumber? _last;
    private readonly Regex? _pattern;
    private readonly (int First, int Last)? _lines;

    private BlockSelector(string text, NcNumber? first, NcNumber? last, Regex? pattern, (int First, int Last)? lines = null)
    {
        Text = text;
        _first = first;
        _last = last;
        _pattern = pattern;
        _lines = lines;
    }

    /// <summary>The selector as given.</summary>
    public string Text { get; }

    /// <summary>True for lines of the file, which are other blocks once a line is inserted or removed.</summary>
    public bool IsByLine => _lines is not null;

    /// <summary>Reads a selector.</summary>
    /// <exception cref="InputException">It is not a number, a line, a range or a valid expression
    /// (<see cref="NcInputCodes.BadSelector"/>).</exception>
    public static BlockSelector Parse(string text)
    {
        if (text.Length > 2 && text[0] == '/' && text[^1] == '/')
        {
            return new(text, null, null, Compile(text[1..^1]));
        }

        var parts = text.Split("..", 2);
        if (parts[0] is ['L' or 'l', ..])
        {
            return new(text, null, null, null, (Line(parts[0], text), Line(parts[^1], text)));
        }

        return new(text, Number(parts[0], text), parts.Length == 2 ? Number(parts[1], text) : null, null);
    }

    /// <summary>All blocks that any of the selectors names: positions in ascending order, each once.</summary>
    public static Outcome<int[]> Select(NcProgram program, IReadOnlyList<BlockSelector> selectors)
    {
        var wanted = new Dictionary<NcNumber, List<int>>();
        foreach (var selector in selectors)
        {
            if (selector._first is { } first)
            {
                wanted.TryAdd(first, []);
            }

            if (selector._last is { } last)
            {
                wanted.TryAdd(last, []);
            }
        }

        if (wanted.Count > 0)
        {
            Find(program, wanted);
        }

        var chosen = new BitArray(program.BlockCount);
        foreach (var selector in selectors)
        {
            if (selector.Collect(program, wanted, chosen) is { } refusal)
            {
                return refusal;
            }
        }

        var blocks = new List<int>();
        for (var i = 0; i < chosen.Length; i++)
        {
            if (chosen[i])
            {
                blocks.Add(i);
            }
        }

        return blocks.ToArray();
    }

    /// <summary>Finds all blocks with one of several numbers.</summary>
    internal static void Find(NcProgram program, Dictionary<NcNumber, List<int>> wanted)
    {
        // For most numbers, the low bits alone show that they are not wanted.
        var bits = 0UL;
        foreach (var number in wanted.Keys)
        {
            bits |= 1UL << (int)(number.Digits & 63);
        }

        // The two halves of a long program are searched concurrently.
        var (before, behind) = program.BlockCount < Many
            ? (Find(program, 0, program.BlockCount, wanted, bits), [])
            : TwoThreads.Run(0, program.BlockCount, (from, end) => Find(program, from, end, wanted, bits));
        foreach (var block in before)
        {
            Note(block);
        }

        foreach (var block in behind)
        {
            Note(block);
        }

        void Note(int block)
        {
            program.TryNumberValue(block, out var number);
            wanted[number.Trim()].Add(block);
        }
    }

    // The blocks in a range that have one of the wanted numbers.
    private static List<int> Find(NcProgram program, int first, int end, Dictionary<NcNumber, List<int>> wanted, ulong bits)
    {
        var found = new List<int>();
        for (var i = first; i < end; i++)
        {
            if (program.TryNumberValue(i, out var number)
                && number.Trim() is var trimmed
                && (bits >> (int)(trimmed.Digits & 63) & 1) != 0
                && wanted.ContainsKey(trimmed))
            {
                found.Add(i);
            }
        }

        return found;
    }

    private static NcNumber Number(string part, string whole)
    {
        var token = default(NcToken);
        var bytes = Encoding.UTF8.GetBytes(part);
        var tokens = new NcTokenizer(bytes, 0, bytes.Length, NcSyntax.Iso);
        var valid = tokens.MoveNext() && (token = tokens.Current) is { Kind: NcTokenKind.Word, Letter: (byte)'N' } && !tokens.MoveNext();
        return valid
            ? token.Number.Trim()
            : throw new InputException(new Refusal(
                NcInputCodes.BadSelector,
                $"\"{whole}\" names no block. Expected a number (N110), a range (N110..N130), lines of the file (L12..L40) or an "
                    + $"expression between slashes (/^N8[0-9]{{3}}/)."));
    }

    private static int Line(string part, string whole) =>
        part is ['L' or 'l', _, ..]
        && int.TryParse(part.AsSpan(1), NumberStyles.None, CultureInfo.InvariantCulture, out var line) && line > 0
            ? line
            : throw new InputException(new Refusal(
                NcInputCodes.BadSelector,
                $"\"{whole}\" names no lines. Expected a line of the file (L12), counted from 1, or a range of lines (L12..L40)."));

    private static Regex Compile(string expression)
    {
        if (expression.Length > LongestPattern)
        {
            var length = expression.Length.ToString(CultureInfo.InvariantCulture);
            throw Bad(expression[..20] + "...", $"it has {length} characters, at most {LongestPattern} are allowed.");
        }

        try
        {
            return new(expression, RegexOptions.CultureInvariant | RegexOptions.NonBacktracking, Regex.InfiniteMatchTimeout);
        }
        catch (Exception e) when (e is ArgumentException or NotSupportedException)
        {
            throw Bad(expression, e.Message);
        }

        static InputException Bad(string shown, string why) => new(new Refusal(
            NcInputCodes.BadSelector,
            $"\"/{shown}/\" cannot be used; expected a regular expression without look-around and back references: {why}"));
    }

    private Refusal? Collect(NcProgram program, Dictionary<NcNumber, List<int>> wanted, BitArray chosen)
    {
        if (_pattern is not null)
        {
            return CollectByPattern(program, _pattern, chosen);
        }

        if (_lines is var (first, last))
        {
            return CollectLines(program, first, last, chosen);
        }

        if (Single(program, wanted, _first!.Value, out var from) is { } missing)
        {
            return missing;
        }

        var to = from;
        if (_last is { } end && Single(program, wanted, end, out to) is { } missingEnd)
        {
            return missingEnd;
        }

        if (to < from)
        {
            return BlockRefusal.At(
                program,
                to,
                NcRefusalCodes.BlockNotFound,
                $"the range {Text} ends before it begins: {Show(_last!.Value)} stands in line {to + 1}, {Show(_first.Value)} in line "
                    + $"{from + 1}. Swap the two.");
        }

        for (var i = from; i <= to; i++)
        {
            chosen[i] = true;
        }

        return null;
    }

    private Refusal? CollectLines(NcProgram program, int first, int last, BitArray chosen)
    {
        if (last < first)
        {
            return new(NcRefusalCodes.BlockNotFound, $"The range {Text} ends before it begins. Swap the two.");
        }

        if (last > program.BlockCount)
        {
            return new(
                NcRefusalCodes.BlockNotFound,
                $"The program has {program.BlockCount.ToString(CultureInfo.InvariantCulture)} lines; {Text} is beyond them. Is it the "
                    + $"program for which the lines were chosen?");
        }

        for (var i = first - 1; i < last; i++)
        {
            chosen[i] = true;
        }

        return null;
    }

    private Refusal? CollectByPattern(NcProgram program, Regex expression, BitArray chosen)
    {
        var any = false;
        for (var i = 0; i < program.BlockCount; i++)
        {
            if (expression.IsMatch(program.TextOf(program[i])))
            {
                any = true;
                chosen[i] = true;
            }
        }

        return any ? null : new(NcRefusalCodes.BlockNotFound, $"The expression {Text} matches no block of the program.");
    }

    private static Refusal? Single(NcProgram program, Dictionary<NcNumber, List<int>> wanted, NcNumber number, out int block)
    {
        var found = wanted[number];
        block = found.Count > 0 ? found[0] : -1;
        return found.Count switch
        {
            1 => null,
            0 => new(
                NcRefusalCodes.BlockNotFound,
                $"No block of the program is numbered {Show(number)}. Check the number, or name the block by an expression.",
                new() { Block = Show(number) }),
            _ => BlockRefusal.At(
                program,
                found[1],
                NcRefusalCodes.BlockAmbiguous,
                $"{Show(number)} numbers {found.Count} blocks (lines "
                    + $"{string.Join(", ", found.Take(5).Select(i => (i + 1).ToString(CultureInfo.InvariantCulture)))}). Renumber the "
                    + $"program, or name the block by an expression."),
        };
    }

    private static string Show(NcNumber number) => "N" + number;
}
