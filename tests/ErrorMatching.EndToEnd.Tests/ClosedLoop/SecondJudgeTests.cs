using System.Globalization;
using ErrorMatching.Mating;
using ErrorMatching.Testing;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>Matches of random parts, judged by tools/judge.py.</summary>
public sealed class SecondJudgeTests
{
    private static readonly int Parts = Environment.GetEnvironmentVariable("ERRORMATCH_JUDGE") == "full" ? 400 : 24;

    [Fact]
    public void Matches_of_random_parts_are_accepted()
    {
        Python.IsNeeded();
        using var folder = new TemporaryFolder();
        var matched = 0;
        foreach (var part in Enumerable.Range(0, 8 * Parts).Select(RandomParts.Generate).Where(p => !p.Flavor.Compensated))
        {
            var input = (part.Seed % 3) switch
            {
                0 => RandomMatch.Rough(part, 0.06),
                1 => RandomMatch.FeedForward(part),
                _ => RandomMatch.Feedback(part, 0.5),
            };
            if (matched < Parts && Matcher.Match(input).Result is { } match)
            {
                var name = folder[part.Seed.ToString("D5", CultureInfo.InvariantCulture)];
                File.WriteAllBytes(name + ".base", match.Before.Program.Bytes.ToArray());
                File.WriteAllBytes(name + ".result", match.Program.ToArray());
                File.WriteAllBytes(name + ".json", match.Certificate().ToBytes());
                matched++;
            }
        }

        var (_, said) = Python.Run(folder.Path, "tests/judge/attack.py", folder.Path, "--mutants", "0");
        Assert.StartsWith(string.Create(CultureInfo.InvariantCulture, $"true: {Parts}, accepted {Parts} "), said, StringComparison.Ordinal);
        Assert.EndsWith("\n0 wrong\n", said, StringComparison.Ordinal);
    }
}
