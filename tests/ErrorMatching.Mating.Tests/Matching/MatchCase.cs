using System.Text;
using ErrorMatching.Measurement;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Mating.Tests;

/// <summary>
/// A match in text: a job with one line unless it says otherwise, points as <c>label x y[ z]; ...</c>, and a program.
/// Tool diameter 6 mm, under cutter compensation one that fits into each notch of these tests; no tolerance, a gauge without error.
/// </summary>
internal sealed record MatchCase(string Program)
{
    public string Theoretical { get; init; } = "1 10 0; 2 40 0";

    public string Part { get; init; } = "1 10 0.1; 2 40 0.1";

    public string? Counterpart { get; init; }

    public string[] Features { get; init; } = [Line("L1", "N50", "1", "2")];

    public double ToolDiameterMm { get; init; } =
        Program.Contains("G41", StringComparison.Ordinal) || Program.Contains("G42", StringComparison.Ordinal) ? 2 : 6;

    public string Frame { get; init; } = "{}";

    public string Compensation { get; init; } = "{}";

    public string Dialect { get; init; } = "fanuc";

    public string Gauge { get; init; } = """ "uncertaintyMm": 1e-7 """;

    /// <summary>More members of the job, each with a comma behind it.</summary>
    public string More { get; init; } = "";

    public static string Line(string name, string blocks, string from, string to, string more = """ "toleranceMm": [0, 0] """) =>
        Feature("line", name, blocks, $"""["{from}", "{to}"]""", more);

    public static string Feature(string kind, string name, string blocks, string points, string more = """ "toleranceMm": [0, 0] """) =>
        $$"""{ "name": "{{name}}", "kind": "{{kind}}", "points": {{points}}, "blocks": ["{{blocks.Replace(" ", "\", \"", StringComparison.Ordinal)}}"], {{more}} }""";

    public MatingJob Job => MatingJob.Parse(
        Encoding.UTF8.GetBytes(FormattableString.Invariant($$"""
            {
              "kind": "mating", "name": "Case", "part": { "theoretical": "theoretical.csv", "measured": "part.csv" },
              "gauge": { "format": "points", {{Gauge}} }, {{More}}
              "features": [ {{string.Join(", ", Features)}} ],
              "counterpart": { "program": "counterpart.nc", "dialect": "{{Dialect}}", "toolDiameterMm": {{ToolDiameterMm}}, "measured": "counterpart.csv", "frame": {{Frame}} },
              "compensation": {{Compensation}}
            }
            """)),
        "job.json");

    public MatchInput Input => new(
        Job,
        Points("theoretical.csv", Theoretical),
        Points("part.csv", Part),
        Counterpart is null ? null : Points("counterpart.csv", Counterpart),
        "counterpart.nc",
        Encoding.Latin1.GetBytes(Program));

    public Outcome<MatchResult> Outcome => Matcher.Match(Input);

    /// <summary>The match; it must not be refused, and its proof must hold.</summary>
    public MatchResult Match()
    {
        var outcome = Outcome;
        Assert.True(outcome.Result is not null, string.Join('\n', outcome.Refusals));
        Assert.Empty(outcome.Refusals);
        Assert.True(outcome.Result.Proof is { Holds: true, UntouchedBytesIdentical: true });
        return outcome.Result;
    }

    /// <summary>The only refusal; no program may come with it.</summary>
    public Refusal Refusal()
    {
        var outcome = Outcome;
        Assert.Null(outcome.Result);
        return Assert.Single(outcome.Refusals);
    }

    public MatchReport Report() => MatchReporter.Report(Match(), "out/counterpart.nc", 0.25);

    /// <summary>The new program without its marker's line.</summary>
    public string Rewritten()
    {
        var result = Match();
        var text = Encoding.Latin1.GetString(result.Program.Span);
        return result.Marker is null ? text : text.Replace(result.Marker.TextIn(NcSyntax.Iso) + "\n", "", StringComparison.Ordinal);
    }

    /// <summary>The lines that the match changed, as they are now.</summary>
    public string[] Changed() => [.. Rewritten().Split('\n').Zip(Program.Split('\n')).Where(p => p.First != p.Second).Select(p => p.First)];

    /// <summary>The motion of a block in the new program.</summary>
    public NcMotion Motion(string number)
    {
        var result = Match();
        var block = Enumerable.Range(0, result.Before.Program.BlockCount).Single(
            i => result.Before.Program.NumberOf(result.Before.Program[i]) == number);
        return result.After.Motions[result.Before.MotionOf(block)];
    }

    public static MeasurementFile Points(string file, string points)
    {
        var rows = points.Split(';', StringSplitOptions.TrimEntries).Select(r => r.Replace(' ', ',')).ToArray();
        var header = rows[0].Count(c => c == ',') == 3 ? "point,x_mm,y_mm,z_mm" : "point,x_mm,y_mm";
        return MeasurementReader.Read(
            Encoding.UTF8.GetBytes(header + "\n" + string.Join('\n', rows) + "\n"), file, MeasurementFormat.Points);
    }
}
