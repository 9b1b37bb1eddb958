namespace ErrorMatching.Mating.Tests;

public sealed class VerifyReportHtmlTests
{
    [Fact]
    public void Points_show_the_counterpart_less_the_part()
    {
        var table = PageReader.Read(VerifyReportHtml.Write(HandMadeReport.Verified)).Table("points-table");

        Assert.Equal("1|0.000|0.000|+0.300|-0.400|-0.400|0.000|+0.050|+0.050", table.Row("1"));
        Assert.Equal("2|50.000|0.000|0.000|+0.100|+0.100|0.000|0.000|0.000", table.Row("2"));
    }

    [Fact]
    public void Features_show_what_was_wanted_found_and_gained()
    {
        var table = PageReader.Read(VerifyReportHtml.Write(HandMadeReport.Verified)).Table("features-table");

        // The straight line of the paper's complex part: 17.649 wanted, 17.308 and 17.562 found; (0.341 - 0.087) / 0.341.
        Assert.Equal("L1|length|mm|17.649|17.308|17.562|-0.341|-0.087|+74.5", table.Row("L1"));
        Assert.Equal("T1|angle|°|60.000|60.000|60.000|0.000|0.000|–", table.Row("T1"));
    }

    [Fact]
    public void Summary_says_whether_it_helped()
    {
        var page = PageReader.Read(VerifyReportHtml.Write(HandMadeReport.Verified));

        Assert.Equal(
            "✓ The largest mating error is smaller with compensation. Without: 0.400 mm. With: 0.050 mm.",
            page.ById("summary").Elements("p").First().Value);
        Assert.Contains(
            "Worst before" + "-0.400 mm at point 1, a gap.",
            page.ById("summary").Value.Replace("\n", "", StringComparison.Ordinal),
            StringComparison.Ordinal);
        Assert.Equal(
            "errormatch verify \"jobs/two lines.json\" --before before.csv --after after.csv --part part.csv",
            page.WithClass("p", "command").Single().Value);
    }

    [Fact]
    public void Plot_and_drawings_show_the_measured_errors_with_their_signs()
    {
        var page = PageReader.Read(VerifyReportHtml.Write(HandMadeReport.Verified));
        var plotted = page.WithClass("svg", "plot")
            .Single()
            .Descendants("title")
            .Select(t => t.Value)
            .Where(t => t.StartsWith("Point ", StringComparison.Ordinal));
        var drawn = page.WithClass("svg", "assembly")
            .Select(d => string.Join("; ", d.WithClass("circle", "key-point").Select(c => c.Value.Trim())))
            .ToArray();

        Assert.Equal(
            [
                "Point 1, without compensation (measured): -0.400 mm", "Point 2, without compensation (measured): +0.100 mm",
                "Point 1, with compensation (measured): +0.050 mm", "Point 2, with compensation (measured): 0.000 mm",
            ],
            plotted);
        Assert.Equal(
            [
                "Point 1: mating error -0.400 mm; Point 2: mating error +0.100 mm",
                "Point 1: mating error +0.050 mm; Point 2: mating error 0.000 mm"],
            drawn);
    }

    [Fact]
    public void A_compensation_that_made_it_worse_is_not_praised()
    {
        var result = HandMadeReport.Verified.Result;
        var worse = HandMadeReport.Verified with
        {
            Result = result with { Points = [.. result.Points.Select(p => p with { Before = p.After, After = p.Before })] }
        };

        var verdict = PageReader.Read(VerifyReportHtml.Write(worse)).ById("summary").Elements("p").First();

        Assert.StartsWith("✗ The largest mating error is larger with compensation. Find out why", verdict.Value, StringComparison.Ordinal);
        Assert.True(verdict.HasClass("fails"));
    }

    // In the paper's experiment, a counterpart as designed would be 0.14 mm off, the one cut without compensation is 0.51 mm off, and the
    // one cut with it 0.35: it is not worse than before, which nobody can tell without measuring.
    [Fact]
    public void Against_a_counterpart_as_designed_nothing_is_said_to_be_better_or_worse()
    {
        var result = HandMadeReport.Verified.Result;
        var designed = HandMadeReport.Verified with
        {
            Result = result with { Points = [.. result.Points.Select(p => p with { Before = p.After, After = p.Before })] },
            IsBeforeMeasured = false,
        };
        foreach (var report in new[] { designed, HandMadeReport.Verified with { IsBeforeMeasured = false } })
        {
            var page = PageReader.Read(VerifyReportHtml.Write(report));

            var verdict = page.ById("summary").Elements("p").First();
            Assert.StartsWith("○ The largest mating error is ", verdict.Value, StringComparison.Ordinal);
            Assert.Contains("how much the compensation helped is not known", verdict.Value, StringComparison.Ordinal);
            Assert.DoesNotContain(" with compensation", verdict.Value, StringComparison.Ordinal);
            Assert.All(
                page.ById("features-table").Descendants("tr").Select(r => r.Elements("td").LastOrDefault()?.Value).OfType<string>(),
                v => Assert.DoesNotMatch("[0-9]|better|worse", v));
        }
    }
}
