using System.Security.Cryptography;
using System.Text;
using System.Text.RegularExpressions;
using ErrorMatching.Refusals;
using ErrorMatching.Testing;

namespace ErrorMatching.Jobs.Tests;

/// <summary>The sample's program without its numbers, named by the lines of its file.</summary>
public sealed partial class LineSelectorTests
{
    private static readonly string[] Files = ["job.json", "theoretical.csv", "part.csv", "counterpart.nc", "counterpart.csv"];

    [Fact]
    public void A_program_without_numbers_is_cut_as_the_one_with_numbers()
    {
        using var folder = Copied();
        var numbered = Matched(folder);
        Renumber(folder);
        var matched = Matched(folder);
        Assert.Equal(
            numbered.Report.KeyPoints.Select(p => p.Correction),
            matched.Report.KeyPoints.Select(p => p.Correction));
        Assert.Equal(
            Blocks(numbered.Program).Select(l => NumberWord().Replace(l, "")).ToArray(),
            Blocks(matched.Program));
    }

    [Fact]
    public void An_edited_program_is_refused_and_not_cut_at_the_wrong_lines()
    {
        using var folder = Copied();
        Renumber(folder);
        File.WriteAllText(folder["counterpart.nc"], "(edited)\n" + File.ReadAllText(folder["counterpart.nc"]));
        var run = MatingRun.Run(new JobFiles(folder["job.json"]), new(), TestContext.Current.CancellationToken);
        var refusal = run.Refusal!;
        Assert.Equal("program-changed", refusal.Code);
        Assert.Contains(Hash(folder), refusal.Message, StringComparison.Ordinal);
    }

    // The hash alone must not be renewed: each line is one further on.
    [Fact]
    public void A_corrected_program_has_one_line_more_and_its_refusal_says_so()
    {
        using var folder = Copied();
        Renumber(folder);
        File.WriteAllBytes(folder["counterpart.nc"], Matched(folder).Program.ToArray());
        File.WriteAllText(
            folder["job.json"],
            File.ReadAllText(folder["job.json"]).Replace("\"from\": \"part\"", "\"from\": \"counterpart\"", StringComparison.Ordinal));
        var request = new MatingRequest { Counterpart = new(folder["counterpart.csv"]) };
        var refusal = MatingRun.Run(new JobFiles(folder["job.json"]), request, TestContext.Current.CancellationToken).Refusal!;
        Assert.Equal("program-changed", refusal.Code);
        Assert.Contains("one line further on behind it", refusal.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_job_with_lines_and_without_the_hash_is_warned_of_with_the_hash_to_write()
    {
        using var folder = Copied();
        Renumber(folder);
        File.WriteAllText(
            folder["job.json"],
            HashKey().Replace(File.ReadAllText(folder["job.json"]), ""));
        var warning = Assert.Single(Matched(folder).Report.Warnings, w => w.Code == "lines-without-hash");
        Assert.Equal(Hash(folder), warning.Values[1]);
        Assert.StartsWith("L", warning.Values[0], StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("L0")]
    [InlineData("L1..5")]
    [InlineData("L1..N5")]
    [InlineData("L9999999999")]
    public void What_is_no_line_is_refused_by_the_schema(string selector)
    {
        using var folder = Copied();
        File.WriteAllText(
            folder["job.json"],
            File.ReadAllText(folder["job.json"]).Replace("\"N120\"", $"\"{selector}\"", StringComparison.Ordinal));
        Assert.Equal("pattern-mismatch", Assert.Throws<InputException>(() => new JobFiles(folder["job.json"])).Code);
    }

    private static MatchedProgram Matched(TemporaryFolder folder)
    {
        var run = MatingRun.Run(new JobFiles(folder["job.json"]), new(), TestContext.Current.CancellationToken);
        Assert.True(run.IsUsable, run.Refusal?.ToString());
        return run.Result;
    }

    // The marker, a line of its own, has the hash of the base.
    private static string[] Blocks(ReadOnlyMemory<byte> program) =>
        [.. Encoding.Latin1.GetString(program.Span).Split('\n').Where(l => !l.Contains("ERRORMATCH", StringComparison.Ordinal))];

    private static string Hash(TemporaryFolder folder) =>
        Convert.ToHexStringLower(SHA256.HashData(File.ReadAllBytes(folder["counterpart.nc"])));

    private static void Renumber(TemporaryFolder folder)
    {
        var lines = File.ReadAllLines(folder["counterpart.nc"]);
        int Line(string number) => 1 + Array.FindIndex(lines, l => l.StartsWith(number + " ", StringComparison.Ordinal));
        var job = File.ReadAllText(folder["job.json"]);
        foreach (var number in (string[])["N120", "N130", "N160", "N170", "N1190"])
        {
            job = Regex.Replace(
                job,
                $@"\b{number}\b",
                FormattableString.Invariant($"L{Line(number)}"),
                RegexOptions.CultureInvariant,
                TimeSpan.FromSeconds(1));
        }

        File.WriteAllText(
            folder["counterpart.nc"],
            string.Join('\n', File.ReadAllText(folder["counterpart.nc"]).Split('\n').Select(l => NumberWord().Replace(l, ""))));
        File.WriteAllText(
            folder["job.json"],
            job.Replace(
                "\"program\": \"counterpart.nc\",",
                $"\"program\": \"counterpart.nc\", \"programSha256\": \"{Hash(folder).ToUpperInvariant()}\",",
                StringComparison.Ordinal));
    }

    private static TemporaryFolder Copied()
    {
        var folder = new TemporaryFolder();
        foreach (var file in Files)
        {
            File.Copy(Repository.PathTo("samples", "complex-mating", file), folder[file]);
        }

        return folder;
    }

    [GeneratedRegex("^N[0-9]+ ", RegexOptions.CultureInvariant, 1000)]
    private static partial Regex NumberWord();

    [GeneratedRegex("\"programSha256\": \"[0-9A-F]{64}\",", RegexOptions.CultureInvariant, 1000)]
    private static partial Regex HashKey();
}
