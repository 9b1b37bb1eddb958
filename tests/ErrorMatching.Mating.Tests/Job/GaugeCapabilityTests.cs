using ErrorMatching.Refusals;

namespace ErrorMatching.Mating.Tests;

/// <summary>A gauge is compared with each tolerance: fine up to a third of it, warned of up to all of it, then refused.</summary>
public sealed class GaugeCapabilityTests
{
    // Limits of L1 0.1 mm apart, expanded uncertainty 2 u.
    [Theory]
    [InlineData("0.0166", "part", "")]
    [InlineData("0.0167", "part", "gauge-coarse|L1|0.0334|0.1|33")]
    [InlineData("0.05", "part", "gauge-coarse|L1|0.1|0.1|100")]
    [InlineData("0.0117", "counterpart", "")]
    [InlineData("0.0118", "counterpart", "gauge-coarse|L1|0.0334|0.1|33")]
    public void More_than_a_third_of_the_tolerance_is_warned_of(string uncertainty, string from, string expected)
    {
        var match = Match(uncertainty, """[-0.05, 0.05]""") with
        {
            Compensation = $$"""{ "from": "{{from}}" }""",
            Counterpart = "1 10 0; 2 40 0"
        };
        Assert.Equal(
            expected,
            string.Join('|', match.Report().Warnings.Where(w => w.Code == "gauge-coarse").SelectMany(w => w.Values.Prepend(w.Code))));
        Assert.Equal(
            expected.Length > 0 ? ["gauge-coarse $.features[0].toleranceMm L1"] : [],
            GaugeCapability.ItemsOf(match.Job).Select(r => $"{r.Code} {r.Place.Path} {r.Place.Feature}"));
    }

    [Fact]
    public void The_warning_names_the_feature_and_its_numbers()
    {
        var warning = Assert.Single(Match("0.02", "[-0.05, 0.05]").Report().Warnings);
        Assert.Equal("gauge-coarse", warning.Code);
        Assert.Equal(["L1", "0.04", "0.1", "40"], warning.Values);
    }

    [Theory]
    [InlineData("0.05", "part", false)]
    [InlineData("0.0501", "part", true)]
    [InlineData("0.0353", "counterpart", false)]
    [InlineData("0.0354", "counterpart", true)]
    public void More_than_the_tolerance_is_refused_by_name(string uncertainty, string from, bool isRefused)
    {
        var problems = Problems(Match(uncertainty, "[-0.05, 0.05]") with { Compensation = $$"""{ "from": "{{from}}" }""" });

        Assert.Equal(isRefused ? ["gauge-too-coarse $.features[0].toleranceMm"] : [], problems.Select(p => $"{p.Code} {p.Place.Path}"));
        Assert.All(problems, p => Assert.True(p.Place is { Line: > 1, Column: > 1 }));
        Assert.All(problems, p => Assert.Contains(" L1", p.Message, StringComparison.Ordinal));
        Assert.All(problems, p => Assert.Contains("0.100", p.Expected, StringComparison.Ordinal));
        Assert.All(problems, p => Assert.Contains("\"acceptCoarse\": true", p.Message, StringComparison.Ordinal));
    }

    [Fact]
    public void A_job_can_accept_it_and_is_still_warned()
    {
        var match = Match("0.06", "[-0.05, 0.05]");
        match = match with { Gauge = match.Gauge + ", \"acceptCoarse\": true" };

        Assert.Empty(Problems(match));
        Assert.Contains(match.Report().Warnings, w => w.Code == "gauge-coarse");
    }

    [Fact]
    public void Limits_without_width_ask_for_a_correction_and_not_for_a_gauge()
    {
        var match = Match("0.06", "[0, 0]") with { Part = "1 10 0.3; 2 40 0.3" };

        Assert.Empty(match.Report().Warnings);
        Assert.Equal(Decision.Compensated, match.Match().Decision.Features[0].Decision);
        Assert.Null(match.Report().ProbabilityBefore);
    }

    [Fact]
    public void A_uncertainty_in_micrometers_is_one_problem() =>
        Assert.Equal(["uncertainty-implausible"], Problems(Match("5.4", "[-0.05, 0.05]")).Select(p => p.Code));

    // 2 * 1.645 * u = 0.1 at u = 0.0304.
    [Theory]
    [InlineData("0.0303", "[-0.05, 0.05]", "")]
    [InlineData("0.0305", "[-0.05, 0.05]", "guard-bands-overlap $.features[0].toleranceMm")]
    [InlineData("0.0305", "[0, 0]", "")]
    public void Guard_bands_must_leave_something_to_accept(string uncertainty, string toleranceMm, string expected)
    {
        var match = Match(uncertainty, toleranceMm) with { More = """ "decision": { "rule": "guard-band" }, """ };

        Assert.Equal(expected, string.Join('|', Problems(match).Select(p => $"{p.Code} {p.Place.Path}")));
    }

    private static MatchCase Match(string uncertainty, string toleranceMm) => new(Programs.ToolBelow)
    {
        Gauge = $"\"uncertaintyMm\": {uncertainty}",
        Features = [MatchCase.Line("L1", "N50", "1", "2", $"\"toleranceMm\": {toleranceMm}")],
        Part = "1 10 0; 2 40 0",
    };

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
