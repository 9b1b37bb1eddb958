using System.Globalization;
using System.Text;
using System.Text.Json.Nodes;
using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating.Tests;

/// <summary>Two measured pieces, assembled: a bore as the part, and a boss of 20 mm radius as the counterpart.</summary>
public sealed class VerifyPairTests
{
    // The air all around is the difference of the radii, whatever gap the job wants, and wherever the boss stands.
    [Theory]
    [InlineData(0.03, 0.01, 0, 0, 0.02)]
    [InlineData(0.01, 0.03, 0, 0, -0.02)]
    [InlineData(0.03, 0.01, 0.02, 0, 0.02)]
    [InlineData(0.03, 0.01, 0, 0.04, 0.02)]
    [InlineData(0, 0, 0, 0, 0)]
    public void The_air_is_the_difference_of_the_radii(double bore, double boss, double gap, double shift, double air)
    {
        var pair = Report(bore, boss, gap, shift).Pair!;
        Assert.Equal(air, pair.TightestMm!.Value, 5e-4);
        Assert.True(pair.Interval95Mm is { } interval && interval.From <= air + 5e-4 && air - 5e-4 <= interval.To);
        if (air != 0)
        {
            Assert.Equal(air > 0, pair.Assembles);
            Assert.Equal(air > 0 ? 1 : 0, pair.Probability, 1e-9);
        }

        // What play there is, is that air in each direction.
        if (air > 0)
        {
            Assert.Equal(shift + air, pair.Play!.XMm!.Value.To, 1e-3);
            Assert.Equal(shift - air, pair.Play.XMm.Value.From, 1e-3);
        }
    }

    [Fact]
    public void It_is_said_in_the_report_the_document_and_the_page()
    {
        var report = Report(0.03, 0.01, 0, 0);
        var sentence = VerifyWords.Of(report.Pair!, report);
        Assert.StartsWith("It goes together (more than 99.9 %), with 0.0", sentence, StringComparison.Ordinal);
        Assert.Equal(0.02, report.Pair!.TightestMm!.Value, 5e-4);

        var json = VerifyReportJson.Write(report);
        Assert.True((bool)JsonNode.Parse(json)!["pair"]!["assembles"]!);
        var again = VerifyReportJson.Read(ReportReader.Document(json));
        Assert.Equal(report.Pair!.TightestMm!.Value, again.Pair!.TightestMm!.Value, 1e-9);

        var page = Encoding.UTF8.GetString(VerifyReportHtml.Write(report));
        Assert.Contains(sentence, page, StringComparison.Ordinal);
        Assert.Contains("drawing-pair", page, StringComparison.Ordinal);
    }

    // Points of one line in one direction say nothing of a pair.
    [Fact]
    public void A_line_alone_is_no_pair()
    {
        var match = new MatchCase(Programs.ToolBelow);
        var report = VerifyRun.Report(
            new(
                match.Job,
                MatchCase.Points("theoretical.csv", match.Theoretical),
                MatchCase.Points("part.csv", match.Part),
                null,
                MatchCase.Points("counterpart-after.csv", "1 10 0.09; 2 40 0.09"),
                "counterpart.nc",
                Encoding.ASCII.GetBytes(match.Program)),
            out _)!;
        Assert.Null(report.Pair);
        Assert.Contains("\"pair\": null", Encoding.UTF8.GetString(VerifyReportJson.Write(report)), StringComparison.Ordinal);
    }

    private static VerifyReport Report(double bore, double boss, double gap, double shift)
    {
        var match = new MatchCase(
            "%\nO1000\nN10 G21 G90 G17\nN20 G0 X80. Y30.\nN40 G1 X73. F300\nN50 G2 X27. I-23. J0.\nN60 X73. I23. J0.\n"
                + "N70 G1 X80.\nN90 M30\n%\n")
        {
            Theoretical = Around(20, 0),
            Part = Around(20 + bore, 0),
            Features = [
                MatchCase.Feature(
                    "circle",
                    "B1",
                    "N50..N60",
                    """["1..8"]""",
                    string.Create(CultureInfo.InvariantCulture, $""" "toleranceMm": [-0.1, 0.1], "formMm": 0.0001, "gapMm": {gap} """))],
        };
        return VerifyRun.Report(
            new(
                match.Job,
                MatchCase.Points("theoretical.csv", match.Theoretical),
                MatchCase.Points("part.csv", match.Part),
                null,
                MatchCase.Points("counterpart-after.csv", Around(20 + boss, shift)),
                "counterpart.nc",
                Encoding.ASCII.GetBytes(match.Program)),
            out _)!;
    }

    private static string Around(double radius, double shift) => string.Join("; ", Enumerable.Range(0, 8).Select(i =>
    {
        var p = new Point2(50 + shift, 30) + (radius * Vector2.FromDirection(Angle.FromDegrees(45.0 * i)));
        return string.Create(CultureInfo.InvariantCulture, $"{i + 1} {p.X:R} {p.Y:R}");
    }));
}
