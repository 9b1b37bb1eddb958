using System.Globalization;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;

namespace ErrorMatching.Mating.Tests;

/// <summary>Micrometers or inches where millimeters are meant are asked about, and what is only wide, precise or small is not.</summary>
public sealed class MistakenUnitTests
{
    // The part is 0.09 mm off.
    private static readonly MatchCase Off = new(Programs.ToolBelow) { Part = "1 10 0.09; 2 40 0.09" };

    [Theory]
    [InlineData("[-30, 30]", "", "$.features[0].toleranceMm[0] -30|$.features[0].toleranceMm[1] 30")]
    [InlineData("[-0.05, 50]", "", "$.features[0].toleranceMm[1] 50")]
    [InlineData("[-0.3, 0.2]", "\"limitMm\": 0.25", "$.features[0].toleranceMm[0] -0.3")]
    public void A_limit_beyond_the_one_that_stops_the_job_is_no_job(string toleranceMm, string compensation, string expected)
    {
        var problems = Problems(Limited(toleranceMm) with { Compensation = $"{{ {compensation} }}" });
        Assert.Equal(expected, string.Join('|', problems.Select(p => $"{p.Place.Path} {p.Found}")));
        Assert.All(problems, p => Assert.Equal("limit-implausible", p.Code));
        Assert.All(problems, p => Assert.Contains("(\"limitMm\"). µm? ", p.Message, StringComparison.Ordinal));
        Assert.All(problems, p => Assert.True(p.Place.Line > 1 && p.Place.Column > 1));
    }

    [Theory]
    [InlineData("chain:worst-case", 1)]
    [InlineData("chain:rss", 1)]
    public void So_are_limits_that_a_chain_comes_to(string source, int count)
    {
        const string Chain = """
            "toleranceChain": [{ "name": "a", "nominalMm": 10, "toleranceMm": [-20, 30], "sign": 1 },
              { "name": "b", "nominalMm": 4, "toleranceMm": [-0.04, 0.04], "sign": -1 }],
            """;
        var problems = Problems(Limited($"\"{source}\"") with { More = Chain });
        Assert.Equal(count, problems.Count);
        Assert.Equal(("limit-implausible", "$.features[0].toleranceMm"), (problems[0].Code, problems[0].Place.Path));
        Assert.Contains("of which a has -20 to 30", problems[0].Message, StringComparison.Ordinal);
        Assert.NotNull(
            (
                Limited($"\"{source}\"") with { More = Chain.Replace("[-20, 30]", "[-0.02, 0.03]", StringComparison.Ordinal) })
                .Outcome.Result);
    }

    // Twice 0.5 mm is the limit of 1 mm; compared with a measured counterpart the uncertainty is 1.414 times as large.
    [Theory]
    [InlineData("0.5", "part", true)]
    [InlineData("0.49", "part", false)]
    [InlineData("0.36", "counterpart", true)]
    [InlineData("0.35", "counterpart", false)]
    [InlineData("[{ \"name\": \"probe\", \"valueMm\": 3 }, { \"name\": \"warmth\", \"valueMm\": 4 }]", "part", true)]
    public void A_gauge_that_can_tell_no_deviation_from_noise_is_no_job(string uncertainty, string from, bool isRefused)
    {
        var match = Off with { Gauge = $"\"uncertaintyMm\": {uncertainty}", Compensation = $$"""{ "from": "{{from}}" }""" };
        Assert.Equal(
            isRefused ? ["uncertainty-implausible $.gauge.uncertaintyMm"] : [],
            Problems(match).Select(p => $"{p.Code} {p.Place.Path}"));
    }

    [Fact]
    public void Deviations_of_more_than_a_centimeter_are_no_deviations()
    {
        var problems = Problems(Off with { Compensation = """{ "limitMm": 1000 }""" });
        Assert.Equal(["too-large $.compensation.limitMm"], problems.Select(p => $"{p.Code} {p.Place.Path}"));
    }

    [Fact]
    public void An_origin_may_be_no_further_off_than_the_points_behind_it()
    {
        var match = Off with { More = """ "originCheck": { "point": "1", "limitMm": 10 }, """ };
        Assert.Equal(["limit-implausible $.originCheck.limitMm"], Problems(match).Select(p => $"{p.Code} {p.Place.Path}"));
        Assert.Empty(Problems(match with { More = match.More + """ "alignment": { "kind": "best-fit" }, """ }));
    }

    [Fact]
    public void Limits_more_than_a_hundred_times_as_wide_as_what_the_part_is_off_are_asked_about()
    {
        var refusal = (Limited("[-9.5, 9.5]") with { Compensation = """{ "limitMm": 10 }""" }).Refusal();
        Assert.Equal(("limit-implausible", "L1", "$.features[0].toleranceMm"), (refusal.Code, refusal.Place.Feature, refusal.Place.Path));
        Assert.True(refusal.Place is { Line: > 1, Column: > 1 });
        Assert.Equal(["L1", "9.5"], refusal.Values.Take(2));
        Assert.Equal(
            [0.09, 0.0095], refusal.Values.Skip(2).Select(v => Math.Round(double.Parse(v, CultureInfo.InvariantCulture), 9)));
    }

    // Wide beside what is off, and meant: one good piece, a general tolerance, a part as designed, what the gauge cannot see.
    [Theory]
    [InlineData("[-0.05, 0.05]", "0.001", "1e-7", 1)]
    [InlineData("[-1, 1]", "0.001", "1e-7", 1)]
    [InlineData("[-2, 2]", "0.03", "1e-7", 10)]
    [InlineData("[-10, 10]", "0", "0", 10)]
    [InlineData("[-8, 8]", "0.01", "0.005", 10)]
    public void Limits_that_are_only_wide_are_not(string toleranceMm, string off, string uncertainty, double limitMm)
    {
        var match = Limited(toleranceMm) with
        {
            Part = $"1 10 {off}; 2 40 {off}",
            Gauge = $"\"uncertaintyMm\": {uncertainty}",
            Compensation = FormattableString.Invariant($$"""{ "limitMm": {{limitMm}} }"""),
        };
        Assert.Equal(Decision.WithinTolerance, match.Match().Decision.Features[0].Decision);
    }

    [Theory]
    [InlineData("1 10 0; 2 40 0", "1 0.3937 0.0039; 2 1.5748 0.0039", "{ \"kind\": \"none\" }")]
    [InlineData("1 10 0; 2 40 0", "1 254 2.5; 2 1016 2.5", "{ \"kind\": \"none\" }")]
    [InlineData("1 10 0; 2 40 0", "1 7 0.3937; 2 7 1.5748", "{ \"kind\": \"best-fit\" }")] // elsewhere, and turned
    [InlineData("1 24.6 0; 2 25.4 0", "1 0.9685 0; 2 1 0", "{ \"kind\": \"datum\", \"origin\": \"1\", \"direction\": \"2\" }")] // small
    public void Points_in_inches_are_asked_about_however_the_piece_lies(string theoretical, string part, string alignment)
    {
        var match = Off with { Theoretical = theoretical, Part = part, More = $"\"alignment\": {alignment}, " };
        var refusal = match.Refusal();
        Assert.Equal("unit-differs", refusal.Code);
        Assert.Equal(("part.csv", "theoretical.csv"), (refusal.Values[0], refusal.Values[2]));
    }

    [Fact]
    public void So_are_those_of_a_counterpart_when_it_is_compensated_and_when_it_is_verified()
    {
        const string Inches = "1 0.3937 0; 2 1.5748 0";
        var feedback = Off with { Counterpart = Inches, Compensation = """{ "from": "counterpart" }""" };
        Assert.Equal("unit-differs", feedback.Refusal().Code);
        Assert.Equal("unit-differs", Verified(Off.Part, Inches));
        Assert.Equal("unit-differs", Verified(Inches, Off.Part));
        Assert.Null(Verified(Off.Part, Off.Part));

        string? Verified(string before, string after)
        {
            var input = Off.Input;
            MeasurementFile Points(string file, string points) => MatchCase.Points(file, points);
            var (one, other) = (Points("before.csv", before), Points("after.csv", after));
            VerifyInput verify = new(input.Job, input.Theoretical, input.Part, one, other, "counterpart.nc", input.Program);
            return VerifyRun.Report(verify, out var refusals) is null ? Assert.Single(refusals).Code : null;
        }
    }

    private static MatchCase Limited(string toleranceMm) =>
        Off with { Features = [MatchCase.Line("L1", "N50", "1", "2", $"\"toleranceMm\": {toleranceMm}")] };

    private static IReadOnlyList<Refusal> Problems(MatchCase match)
    {
        try
        {
            _ = match.Job;
            return [];
        }
        catch (InputException e)
        {
            return e.Refusals;
        }
    }
}
