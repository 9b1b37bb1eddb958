using System.Globalization;
using System.Text.RegularExpressions;

namespace ErrorMatching.Nc;

/// <summary>Finds selectors that name given blocks of a program: the inverse of <see cref="BlockSelector"/>.</summary>
public static class BlockNames
{
    /// <summary>Maximum number of blocks at each end of a range that are named by their text, because they have no number of their
    /// own.</summary>
    public const int MostByText = 32;

    /// <summary>Maximum length of a block that is named by its text.</summary>
    public const int LongestText = 500;

    /// <summary>Selectors that name exactly the blocks from one to another, both included: <c>N130</c>, <c>N130..N160</c>. Blocks at the
    /// ends without a number of their own are named by their whole text (<c>/^G1\ X5\.$/</c>). Where that does not tell them from others,
    /// such as those of a second pass, all are named by their lines (<c>L12..L40</c>), which other blocks have once the file is
    /// edited.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The blocks do not exist.</exception>
    public static string[] Of(NcProgram program, int first, int last)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(first);
        ArgumentOutOfRangeException.ThrowIfLessThan(last, first);
        ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual(last, program.BlockCount);
        var known = Candidates(program, first, last);
        var from = Enumerable.Range(first, Math.Min(last - first + 1, MostByText + 1)).FirstOrDefault(known.Contains, -1);
        if (from < 0)
        {
            // No block has a number, so each is named by its text.
            from = last + 1;
        }

        var to = from > last
            ? last
            : Enumerable.Range(0, Math.Min(last - from + 1, MostByText + 1)).Select(i => last - i).FirstOrDefault(known.Contains, -1);
        if (from - first > MostByText || to < 0)
        {
            return Lines(first, last);
        }

        var words = new List<string>();
        foreach (var block in Enumerable.Range(first, from - first).Concat(from > last ? [] : Enumerable.Range(to + 1, last - to)))
        {
            if (program[block].Length > LongestText || program[block].Length == 0)
            {
                return Lines(first, last);
            }

            words.Add($"/^{Regex.Escape(program.TextOf(program[block]))}$/");
        }

        if (from <= last)
        {
            words.Insert(
                from - first,
                from == to ? Number(program, from) : $"{Number(program, from)}..{Number(program, to)}");
        }

        // The selector itself decides whether they name exactly these blocks.
        var selected = BlockSelector.Select(program, [.. words.Select(BlockSelector.Parse)]);
        return selected.IsUsable && selected.Result.All(b => b >= first && b <= last) ? [.. words] : Lines(first, last);
    }

    private static string[] Lines(int first, int last) => first == last
        ? [string.Create(CultureInfo.InvariantCulture, $"L{first + 1}")]
        : [string.Create(CultureInfo.InvariantCulture, $"L{first + 1}..L{last + 1}")];

    // A number as selectors spell it: not every control writes the N.
    private static string Number(NcProgram program, int block) =>
        program.NumberOf(program[block]) is var number && char.IsAsciiDigit(number[0]) ? "N" + number : number;

    // Blocks near both ends of a range whose number is unique in the program.
    private static HashSet<int> Candidates(NcProgram program, int first, int last)
    {
        var near = Enumerable.Range(first, Math.Min(last - first + 1, MostByText + 1))
            .Concat(Enumerable.Range(Math.Max(first, last - MostByText), Math.Min(last - first, MostByText) + 1))
            .Distinct();
        var numbered = new Dictionary<NcNumber, List<int>>();
        var named = new List<(int Block, NcNumber Number)>();
        foreach (var block in near)
        {
            if (program.TryNumberValue(block, out var number))
            {
                named.Add((block, number.Trim()));
                numbered.TryAdd(number.Trim(), []);
            }
        }

        BlockSelector.Find(program, numbered);
        return [.. named.Where(n => numbered[n.Number].Count == 1).Select(n => n.Block)];
    }
}
