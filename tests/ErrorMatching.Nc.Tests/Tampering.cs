using System.Globalization;
using System.Text.RegularExpressions;

namespace ErrorMatching.Nc.Tests;

/// <summary>One way to damage a result: what is done to which block. It says nothing of the spelling, so that it can be done to any program
/// with blocks of these numbers.</summary>
/// <param name="Name">What is done, for the message of a test.</param>
/// <param name="Apply">The damaged lines, or null where the program has nothing that could be damaged so.</param>
internal sealed partial record Tampering(string Name, Func<string[], string[]?> Apply)
{
    private const string CutLines = "N110 N130";

    public static IReadOnlyList<Tampering> All { get; } =
    [
        .. new[] { "N110", "N120", "N130" }.SelectMany(Named),
        .. CutLines.Split(' ').SelectMany(
            b => new[] { InBlock(b, "as a rapid", l => Code(l, 1, 0)), InBlock(b, "as an arc", l => Code(l, 1, 2)) }),
        InBlock("N120", "other sense", l => Code(l, 3, 2)), InBlock("N120", "as a line", l => Code(l, 3, 1)),
        InBlock("N120", "leading zero", l => Spelled(l, 'G', v => "03", onlyIf: "3")),
        .. "IJR".SelectMany(
            c => new[]
            {
                Add("N120", c, 0.1m),
                Add("N120", c, -0.1m),
                Negate("N120", c),
                Drop("N120", c),
                Add("N150", c, 0.1m),
                LongerZero("N150", c)
            }),
        Add("N100", 'X', 0.1m), Add("N100", 'X', -0.1m), Add("N100", 'Y', 0.1m), Add("N100", 'F', 1m), Drop("N100", 'X'), Drop("N100", 'F'),
        .. new[]
        {
            "N140",
            "N150",
            "N160",
            "N170"
        }.SelectMany(b => "XY".SelectMany(c => new[] { Add(b, c, 0.05m), Negate(b, c), Drop(b, c) })),
        .. new[] { "N150", "N160", "N170" }.SelectMany(b => "XY".Select(c => LongerZero(b, c))),
        Add("N10", 'X', 0.1m), Add("N10", 'Z', -1m), Add("N20", 'Z', -0.1m), Add("N20", 'F', 1m), Negate("N180", 'Z'),
        InBlock("N180", "as a cut", l => Code(l, 0, 1)),
        InBlock("N180", "sideways", l => l + " X1."), InBlock("N20", "sideways", l => l + " X-19.9"),
        .. new[] { (21, 20), (17, 18), (40, 41), (54, 55) }.Select(g => InBlock("N1", $"G{g.Item2}", l => Code(l, g.Item1, g.Item2))),
        Add("N2", 'T', 1m), Add("N3", 'S', 6000m), Add("N4", 'H', 1m), Add("N165", 'P', 900m), Add("N190", 'M', 69m),
        .. new[] { "N3", "N110", "N130", "N165", "N180" }.Select(b => new Tampering($"{b} deleted", l => Without(l, Index(l, b)))),
        .. new[]
        {
            "N3",
            "N120",
            "N130",
            "N180"
        }.Select(b => new Tampering($"{b} twice", l => [.. l[..Index(l, b)], l[Index(l, b)], .. l[Index(l, b)..]])),
        .. new[]
        {
            ("N110", "N130"),
            ("N140", "N150"),
            ("N120", "N130"),
            ("N20", "N100")
        }.Select(p => new Tampering($"{p.Item1} and {p.Item2} swapped", l => Swapped(l, Index(l, p.Item1), Index(l, p.Item2)))),
        new("a stop inserted", l => [.. l[..Index(l, "N130")], "M0", .. l[Index(l, "N130")..]]),
        new("an empty line inserted", l => [.. l[..Index(l, "N130")], "", .. l[Index(l, "N130")..]]),
        new(
            "another line end",
            l => [.. l[..Index(l, "N130")], l[Index(l, "N130")] + "\n" + l[Index(l, "N130") + 1], .. l[(Index(l, "N130") + 2)..]]),
        InBlock("N100", "a space at its end", l => l + " "), InBlock("N130", "skipped", l => "/" + l),
        InBlock("N165", "no longer skipped", l => l.TrimStart('/')),
        InBlock("N130", "another number", l => l.Replace("130", "131", StringComparison.Ordinal)),
        new("another program number", l => [.. l.Select(x => x.Replace("0001", "0002", StringComparison.Ordinal))]),
        new("another comment", l => [.. l.Select(x => x.Replace("LEAD", "LAED", StringComparison.OrdinalIgnoreCase))]),
        new("a byte behind the end", l => [.. l[..^1], l[^1] + "\u001a"]), new("the end lost", l => l[..^1]),
        new("nothing left", _ => [""]),
    ];

    // Where a line runs tangentially into an arc, their joint may lie a tenth of the displacement further along both: the boundary is the
    // same. So 0.02 mm, for displacements of 0.1, is the least that must show.
    private static IEnumerable<Tampering> Named(string block) =>
    [
        .. "XY".SelectMany(
            c => new[] { Add(block, c, 0.1m), Add(block, c, -0.1m), Add(block, c, 0.02m), Negate(block, c), Drop(block, c) }),
        InBlock(block, "a feed", l => l + " F90."), InBlock(block, "a stop", l => l + " M0"), InBlock(block, "deeper", l => l + " Z-3.5"),
        InBlock(block, "a comment", l => l + " (new)"),
        InBlock(block, "a corner", l => l + " ,R1."), InBlock(block, "a space", l => l + " "),
        InBlock(block, "a variable", l => Spelled(l, 'X', _ => "#1")),
        InBlock(
            block,
            "another case",
            l => WordOf(l, 'X') is { Success: true } m ? l[..m.Index] + (char)(l[m.Index] ^ 0x20) + l[(m.Index + 1)..] : null),
    ];

    private static Tampering InBlock(string block, string name, Func<string, string?> change) => new($"{block}: {name}", lines =>
    {
        var at = Index(lines, block);
        return change(lines[at]) is { } changed ? [.. lines[..at], changed, .. lines[(at + 1)..]] : null;
    });

    private static Tampering Add(string block, char letter, decimal delta) =>
        InBlock(block, FormattableString.Invariant($"{letter} by {delta}"), l => Spelled(l, letter, v =>
        (decimal.Parse(v, CultureInfo.InvariantCulture) + delta).ToString(
            v.Contains('.', StringComparison.Ordinal) ? "0.0##" : "0", CultureInfo.InvariantCulture)));

    private static Tampering Negate(string block, char letter) => InBlock(block, $"{letter} negated", l => Spelled(l, letter, v =>
        decimal.Parse(v, CultureInfo.InvariantCulture) == 0 ? null : v[0] == '-' ? v[1..] : "-" + v));

    // A zero more changes nothing but bytes, in blocks that nobody asked to change.
    private static Tampering LongerZero(string block, char letter) => InBlock(
        block, $"{letter} with one zero more", l => Spelled(l, letter, v => v.Contains('.', StringComparison.Ordinal) ? v + "0" : null));

    private static Tampering Drop(string block, char letter) =>
        InBlock(block, $"{letter} lost", l => WordOf(l, letter) is { Success: true } m ? l[..m.Index] + l[(m.Index + m.Length)..] : null);

    private static string? Code(string line, int was, int now) =>
        Regex.IsMatch(line, $"(?i)G{was}(?![0-9])", RegexOptions.None, TimeSpan.FromSeconds(1))
            ? Regex.Replace(line, $"(?i)(G){was}(?![0-9])", "${1}" + now, RegexOptions.None, TimeSpan.FromSeconds(1))
            : null;

    private static string? Spelled(string line, char letter, Func<string, string?> value, string? onlyIf = null) =>
        WordOf(line, letter) is { Success: true } m
            && (onlyIf is null || m.Groups["value"].Value == onlyIf)
            && value(m.Groups["value"].Value) is { } text
            ? line[..m.Groups["value"].Index] + text + line[(m.Index + m.Length)..]
            : null;

    private static Match WordOf(string line, char letter) =>
        Words().Matches(line).FirstOrDefault(m => char.ToUpperInvariant(m.Value[0]) == letter) ?? Match.Empty;

    private static int Index(string[] lines, string block) =>
        Array.FindIndex(lines, l => Regex.IsMatch(l, $"^/?(?i:{block})(?![0-9])", RegexOptions.None, TimeSpan.FromSeconds(1)));

    private static string[] Without(string[] lines, int at) => [.. lines[..at], .. lines[(at + 1)..]];

    private static string[] Swapped(string[] lines, int a, int b)
    {
        string[] swapped = [.. lines];
        (swapped[a], swapped[b]) = (lines[b], lines[a]);
        return swapped;
    }

    [GeneratedRegex("[A-Za-z] ?(?<value>[-+]?[0-9]+\\.?[0-9]*|[-+]?\\.[0-9]+)(?![^(]*\\))", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Words();
}
