using System.Globalization;

namespace ErrorMatching.Nc.Tests;

/// <summary>
/// Random programs, displaced at random: the result is proved, or refused for a reason of the program's; a proof that fails is a defect.
/// <c>ERRORMATCH_DISPLACED_PROGRAMS</c> sets how many (1500 if not set), <c>ERRORMATCH_DISPLACED_SEED</c> the first seed.
/// </summary>
public sealed class RandomProgramTests
{
    private static readonly int Programs = Setting("ERRORMATCH_DISPLACED_PROGRAMS", 1500);
    private static readonly int FirstSeed = Setting("ERRORMATCH_DISPLACED_SEED", 1);

    [Fact]
    public void Random_displacements_of_random_programs_are_proved_or_refused_for_a_reason()
    {
        var failures = new List<string>();
        var codes = new SortedDictionary<string, int>(StringComparer.Ordinal);
        for (var seed = FirstSeed; seed < FirstSeed + Programs; seed++)
        {
            var code = Displace(seed, failures);
            codes[code] = codes.GetValueOrDefault(code) + 1;
        }

        var counts = string.Join(", ", codes.Select(c => $"{c.Key} {c.Value}"));
        Assert.True(failures.Count == 0, $"{failures.Count} of {Programs} ({counts}):\n{string.Join("\n\n", failures.Take(10))}");
        Assert.InRange(codes.GetValueOrDefault("proved"), Programs / 2, Programs);
    }

    private static string Displace(int seed, List<string> failures)
    {
        var random = new RandomProgram(seed);
        var path = Bench.Read(random.Text, random.Dialect);
        var named = Named(path, random);
        var d = Math.Round(random.Uniform(-0.3, 0.3), 3);
        var isNormal = random.Below(2) == 0;
        var wish = isNormal
            ? DisplacementWish.Normal(path, named, d)
            : DisplacementWish.EndsBy(path, named, new(d, Math.Round(random.Uniform(-0.3, 0.3), 3), 0));
        if (!wish.IsUsable)
        {
            return wish.Refusal.Code;
        }

        var rewrite = Rewriter.Apply(path, wish.Result);
        if (!rewrite.IsUsable)
        {
            return rewrite.Refusal.Code;
        }

        var proof = Prover.Check(path, rewrite.Result.Program, wish.Result, rewrite.Result.LeastIncrementMm);
        var wrong = proof.Failures.Select(f => f.ToString()).Concat(MovedElsewhere(path, rewrite.Result.Program, wish.Result)).ToArray();
        if (wrong.Length == 0)
        {
            return "proved";
        }

        var blocks = string.Join(",", named.Select(b => path.Program.NameOf(path.Program[b])));
        var how = string.Create(CultureInfo.InvariantCulture, $"{(isNormal ? "--normal" : "--by")} {d},{wish.Result.By.Y}");
        var sides = SideBySide(random.Text, Bench.Text(rewrite.Result.Program));
        failures.Add($"seed {seed}, {random.Dialect.Name}, {blocks} {how}:\n{string.Join("\n", wrong)}\n{sides}");
        return "failed";
    }

    // A stretch of cuts between two liftings of the tool stays as it was, unless one of them is named.
    private static IEnumerable<string> MovedElsewhere(NcPath path, NcProgram result, DisplacementWish wish)
    {
        var (was, now) = (path.Motions, NcInterpreter.Run(result, path.Dialect).Motions);
        var named = wish.Elements.Select(e => e.Motion).Concat(wish.EndPoints).ToHashSet();
        for (var first = 0; first < was.Length; first++)
        {
            var behind = first;
            while (behind < was.Length && was[behind].IsCut)
            {
                behind++;
            }

            var stretch = Enumerable.Range(first, behind - first).ToArray();
            var moved = stretch.FirstOrDefault(i => was[i].MovesInPlane && was[i] != now[i], -1);
            if (moved >= 0 && !stretch.Any(named.Contains))
            {
                yield return $"{path.Program.NameOf(path.Program[was[moved].Block])} moved, although nothing connected with it was named.";
            }

            first = behind;
        }
    }

    private static int[] Named(NcPath path, RandomProgram random)
    {
        var first = 1 + random.Below(random.Count);
        var last = Math.Min(random.Count, first + random.Below(5));
        var numbers = Enumerable.Range(first, last - first + 1).ToHashSet();
        if (random.Below(4) == 0)
        {
            numbers.Add(1 + random.Below(random.Count));
        }

        return Bench.Blocks(path, [.. numbers.Select(n => "N" + n.ToString(CultureInfo.InvariantCulture))]);
    }

    private static string SideBySide(string was, string now)
    {
        var (a, b) = (was.Split('\n'), now.Split('\n'));
        return string.Join("\n", a.Select((line, i) => i < b.Length && b[i] != line ? $"{line,-40} -> {b[i]}" : line));
    }

    private static int Setting(string name, int otherwise) =>
        Environment.GetEnvironmentVariable(name) is { } text ? int.Parse(text, CultureInfo.InvariantCulture) : otherwise;
}
