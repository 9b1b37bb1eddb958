using System.Xml.Linq;
using ErrorMatching.Geometry;

namespace ErrorMatching.Mating.Tests;

public sealed class MatchReportHtmlTests
{
    private static readonly MatchReport Report = HandMadeReport.Report;

    [Fact]
    public void Key_points_show_actual_less_nominal()
    {
        var table = Page(Report).Table("key-points-table");

        // Deviation is actual - theoretical; before compensation the counterpart lacks what the part is too far away: a gap, negative.
        Assert.Equal("1|L1|0.000|0.000|0.002|0.100|+0.002|+0.100|+0.100|0.000|+0.100|-0.100|0.000|N10", table.Row("1"));
        Assert.Equal("2|L1|100.000|0.000|100.002|0.080|+0.002|+0.080|+0.080|0.000|+0.080|-0.080|-0.001|N10", table.Row("2"));
    }

    [Fact]
    public void The_appendix_has_the_signs_of_figure_9()
    {
        var page = Page(Report);

        // Theoretical - actual, ideal - actual.
        Assert.Equal("1|0.000|0.000|0.002|0.100|-0.002|-0.100", page.Table("paper-points-table").Row("1"));
        Assert.Equal("L1|length|mm|100.000|100.020|-0.020|100.019", page.Table("paper-quantities-table").Row("L1"));
        Assert.Equal("paper", (string?)page.Descendants("section").Last().Attribute("id"));
    }

    [Fact]
    public void Measured_counterparts_have_columns_of_their_own()
    {
        var points = Report.KeyPoints.Select((p, i) => p with { Counterpart = i == 0 ? new Point2(-1, 2.5) : null }).ToArray();

        var table = Page(Report with { KeyPoints = points }).Table("key-points-table");

        Assert.StartsWith("1|L1|0.000|0.000|0.002|0.100|-1.000|2.500|+0.002|", table.Row("1"), StringComparison.Ordinal);
        Assert.Contains("|–|–|", table.Row("2"), StringComparison.Ordinal);
    }

    [Fact]
    public void Decisions_tell_limits_largest_deviation_and_reason()
    {
        var table = Page(Report).Table("decisions-table");

        Assert.Equal(
            "L1|line|◆ compensated|-0.020|+0.050|job|+0.100|0.0054|-0.001|2 of its points lie outside, point 1 the furthest: 0.050 mm "
                + "beyond its limit. The counterpart follows the whole deviation.",
            table.Row("L1"));
        Assert.Equal(
            "L2|line|✓ within tolerance|-0.020|+0.050|job|+0.010|0.0054|-0.010|Every point lies between -0.020 and +0.050 mm.",
            table.Row("L2"));
    }

    [Fact]
    public void A_deviation_that_is_not_significant_says_against_what()
    {
        var table = Page(
            Report with { Features = [HandMadeReport.Line with { Decision = Decision.NotSignificant, UncertaintyMm = 0.06 }] })
            .Table("decisions-table");

        Assert.EndsWith(
            "0.050 mm beyond its limit. But no deviation is larger than 0.1200 mm, 2 times its uncertainty: it may be the gauge's.",
            table.Row("L1"),
            StringComparison.Ordinal);
        Assert.Contains("○ not significant", table.Row("L1"), StringComparison.Ordinal);
    }

    [Fact]
    public void A_report_with_a_decision_rule_states_it_and_the_risk()
    {
        var line = HandMadeReport.Line with { Decision = Decision.NotSignificant, SignificantMm = 0.12, ProbabilityBefore = 0.001 };
        var calm = HandMadeReport.Calm with { Acceptance = new(-0.011, 0.041), SignificantMm = 0.12, ProbabilityBefore = 0.995 };
        var report = Report with { Features = [line, calm], Rule = DecisionRule.GuardBand(5), ProbabilityBefore = 0.000995 };
        var table = Page(report).Table("decisions-table");

        Assert.EndsWith(
            "0.050 mm beyond its acceptance limit. But none lies more than 0.1200 mm off, which the gauge may show on a perfect part. "
                + "Risk that one lies outside the limits all the same: 99.9 %.",
            table.Row("L1"),
            StringComparison.Ordinal);
        Assert.EndsWith(
            "Every point lies between -0.011 and +0.041 mm. Risk that one lies outside the limits all the same: 0.5 %.",
            table.Row("L2"),
            StringComparison.Ordinal);
        Assert.Equal(
            [
                "Decision rule guard-band: points are accepted 0.0089 mm inside their limits, for a risk of at most 5 % at each limit.",
                "Probability that every point is within its limits without compensation: less than 0.1 %, if the errors of the points are "
                    + "independent.",
                "Risk of leaving a point outside its limits: L1 99.9 %, L2 0.5 %.",
            ],
            RuleWords.Of(report));
        Assert.Equal(
            ["Decision rule simple: points are accepted up to their limits."],
            RuleWords.Of(Report with { Rule = DecisionRule.Simple, ProbabilityBefore = null }));
        Assert.Empty(RuleWords.Of(Report));
    }

    [Fact]
    public void What_stays_outside_the_tolerance_is_marked_on_the_right_side()
    {
        // The part may lie from -0.02 to +0.05, so a counterpart may overlap by 0.02 and leave a gap of 0.05.
        Assert.Equal("-0.049", LeftAt(-0.049));
        Assert.Equal("⚠ -0.051", LeftAt(-0.051));
        Assert.Equal("+0.019", LeftAt(0.019));
        Assert.Equal("⚠ +0.021", LeftAt(0.021));

        static string LeftAt(double predicted) =>
            Page(Report with { KeyPoints = [Report.KeyPoints[0] with { PredictedMm = predicted }] }).Table("decisions-table")
                .Row("L1")
                .Split('|')[8];
    }

    [Fact]
    public void A_point_that_the_compensation_drives_out_is_told_from_one_that_stays_outside()
    {
        // Part - design: 0.1 at point 1, 0.01 at point 3, limits -0.02 to +0.05. So point 1 is outside without compensation, and point 3 is
        // not, whatever was decided about its feature.
        var summary = Summary(0.03, 0.03);
        Assert.EndsWith(
            " mating error left, as predicted: +0.030 mm. ⚠ Point 1 stays outside its limits, with the compensation as without it.",
            summary.Features[0],
            StringComparison.Ordinal);
        Assert.EndsWith(
            " mating error left, as predicted: +0.030 mm. ⚠ The compensation drives point 3 out of its limits; uncompensated it is "
                + "within them.",
            summary.Features[1],
            StringComparison.Ordinal);
        Assert.StartsWith(
            "Points 1 and 3 will be out of tolerance. Is that acceptable? If not, do not cut. ",
            summary.Steps[0],
            StringComparison.Ordinal);
        Assert.Equal(("⚠ +0.030", "⚠ +0.030", "-0.001"), (summary.Left("1"), summary.Left("3"), summary.Left("2")));

        var calm = Summary(-0.0004, -0.01);
        Assert.All(calm.Features, f => Assert.DoesNotContain("⚠", f, StringComparison.Ordinal));
        Assert.StartsWith("Make sure that the part is the one of work order WO-7", calm.Steps[0], StringComparison.Ordinal);
        Assert.Equal("0.000", calm.Left("1"));

        static (string[] Features, string[] Steps, Func<string, string> Left) Summary(double at1, double at3)
        {
            var page = Page(
                Report with
                {
                    KeyPoints = [
                        .. Report.KeyPoints.Select(
                            p => p.Point switch { "1" => p with { PredictedMm = at1 }, "3" => p with { PredictedMm = at3 }, _ => p })]
                });
            var summary = page.ById("summary");
            return (
                [.. summary.Element("ul")!.Elements("li").Select(l => l.Value)],
                [.. summary.Element("ol")!.Elements("li").Select(l => l.Value)],
                label => page.Table("key-points-table").Row(label).Split('|')[12]);
        }
    }

    [Fact]
    public void Several_points_are_named_together()
    {
        var points = Report.KeyPoints.Select(p => p with { PredictedMm = p.Feature == "L1" ? -0.06 : 0.06 }).ToArray();
        Assert.Equal(
            [
                "The compensation drives points 3 and 4 out of their limits; uncompensated they are within them.",
                "Points 1 and 2 stay outside their limits, with the compensation as without it."],
            OutsideWords.Of((Report with { KeyPoints = points }).Outside));
    }

    [Fact]
    public void Excess_says_that_only_the_excess_is_followed() =>
        Assert.EndsWith(
            "The counterpart follows what lies beyond the limit.",
            Page(
                Report with { Compensation = Report.Compensation with { Amount = CompensationAmount.Excess } })
                .Table("decisions-table").Row("L1"),
            StringComparison.Ordinal);

    [Fact]
    public void Summary_says_what_was_measured_decided_and_changed()
    {
        var facts = Page(Report).ById("summary")
            .Element("dl")!
            .Elements("div")
            .Select(d => $"{d.Element("dt")!.Value}: {d.Element("dd")!.Value}");

        Assert.Equal(
            [
                "Measured: 4 key points of the part, part.csv (SHA-256 cccccccccccc…).",
                "Decided: 2 features: 1 compensated, 1 within tolerance. The largest deviation is +0.100 mm, at point 1 of L1.",
                "Changed: 1 block and 2 words of them, written to out/counterpart.nc (SHA-256 eeeeeeeeeeee…). The original is untouched.",
            ],
            facts);
    }

    [Fact]
    public void A_program_that_is_not_changed_is_said_to_be_the_original()
    {
        var page = Page(Report with { Program = new("counterpart.nc", "", 0, 0, []), Proof = new(true, 12, 0, [], null, 0, true) });

        Assert.Contains(
            "Nothing: counterpart.nc is the original program, byte for byte.", page.ById("summary").Value, StringComparison.Ordinal);
        Assert.Contains("No block differs", page.ById("program").Value, StringComparison.Ordinal);
    }

    [Fact]
    public void A_proof_that_fails_comes_first_and_leaves_nothing_to_do_with_the_program()
    {
        var page = Page(Report with { Proof = Report.Proof with { Holds = false, UntouchedBytesIdentical = false } });
        var summary = page.ById("summary");

        Assert.Equal("✗ The proof does not hold. Do not use this program.", summary.Elements("p").First().Element("strong")!.Value);
        Assert.Equal(
            ["Do not send the program to a machine. Read under Proof what differs, and report it."],
            summary.Element("ol")!.Elements("li").Select(l => l.Value));
        Assert.DoesNotContain("wear value", summary.Value, StringComparison.Ordinal);
        Assert.EndsWith(
            "|✗ NO", page.Table("proof-table").Row("Every byte outside the changed words is the original one"), StringComparison.Ordinal);
    }

    [Fact]
    public void The_proof_tells_what_was_compared_and_which_neighbors_followed()
    {
        var table = Page(Report).Table("proof-table");

        Assert.Equal("Motions compared|12", table.Row("Motions compared"));
        Assert.Equal("Motions that differ|3", table.Row("Motions that differ"));
        Assert.EndsWith("|0.0004 mm", table.Row("Largest distance of a motion from where it was wanted"), StringComparison.Ordinal);
        Assert.EndsWith(
            "|N5 slid along itself by 0.0303 mm; N15 followed by 0.0200 mm",
            table.Row("Neighbors that followed because they touch what moved"),
            StringComparison.Ordinal);
        Assert.EndsWith("|✓ yes", table.Row("Every byte outside the changed words is the original one"), StringComparison.Ordinal);
        Assert.Equal("Marker comment|(ERRORMATCH)", table.Row("Marker comment"));
    }

    [Fact]
    public void Blocks_stand_side_by_side_with_the_changed_words_marked()
    {
        var cells = Page(Report).Table("blocks-table").Element("tbody")!.Element("tr")!.Elements().ToArray();

        Assert.Equal(["3", "N10", "N10 X-1.5 Y2.", "N10 X-1.5 Y2.1 F9"], cells.Select(c => c.Value));
        Assert.Equal(["2."], cells[2].Descendants("del").Select(d => d.Value));
        Assert.Equal(["2.1", " F9"], cells[3].Descendants("ins").Select(i => i.Value));
    }

    [Fact]
    public void Blocks_that_were_inserted_say_so()
    {
        var program = Report.Program with { Blocks = [new("", 9, "", "(MARK)", [], [new(0, 6)])] };

        Assert.Equal(
            ["9", "–", "inserted", "(MARK)"],
            Page(Report with { Program = program }).Table("blocks-table").Element("tbody")!.Element("tr")!.Elements().Select(c => c.Value));
    }

    [Fact]
    public void Lengths_and_angles_stand_as_ideal_actual_and_corrected()
    {
        var rows = Page(Report).Table("quantities-table")
            .Element("tbody")!
            .Elements("tr")
            .Select(r => string.Join('|', r.Elements().Select(c => c.Value)));

        Assert.Equal(["L1|length|mm|100.000|100.020|+0.020|0.0030|100.019", "L1|direction|°|0.000|-0.012|-0.012|0.0024|–"], rows);
    }

    [Fact]
    public void Measuring_shows_alignment_origin_uncertainty_chain_and_time()
    {
        var page = Page(Report);

        Assert.Equal("part|best-fit|none|+0.500|+1.000|-2.000|0.011|0.022", page.Table("alignment-table").Row("part"));
        Assert.Equal("combined (root sum of squares)|0.0050", page.Table("uncertainty-table").Row("combined (root sum of squares)"));
        Assert.Equal("spacer|-|5.000|-0.010|+0.010", page.Table("chain-table").Row("spacer"));

        // 12.5 - 0.02 - 0.01 and 12.5 + 0.03 + 0.01; middle 12.505, half widths 0.025 and 0.01 by root sum of squares 0.0269.
        Assert.Equal("worst case|12.500|12.470|12.540", page.Table("chain-sum-table").Row("worst case"));
        Assert.Equal("root sum of squares|12.500|12.478|12.532", page.Table("chain-sum-table").Row("root sum of squares"));
        Assert.Contains(
            "✓ The origin O was measured 0.004 mm off; 0.010 mm are allowed.", page.ById("measuring").Value, StringComparison.Ordinal);
        Assert.Contains(
            "Measuring: 3.000 s by equation (7) of Wang 2021, an estimate. Calculating: 0.012 s, as measured.",
            page.ById("measuring").Value,
            StringComparison.Ordinal);
        Assert.Contains(
            "a tool-radius wear value of +0.020 mm (+0.040 mm where the control keeps a diameter)",
            page.ById("summary").Value,
            StringComparison.Ordinal);
    }

    [Fact]
    public void The_files_and_the_command_that_make_the_report_again_are_named()
    {
        var page = Page(Report);

        Assert.Equal($"program|counterpart.nc|{new string('d', 64)}", page.Table("inputs-table").Row("program"));
        Assert.Equal(
            "errormatch match \"jobs/two lines.json\" --part part.csv --program counterpart.nc",
            page.WithClass("p", "command").Single().Value);
    }

    [Fact]
    public void The_plot_shows_mating_errors_and_the_band_seen_as_one()
    {
        var plot = Page(Report).WithClass("svg", "plot").Single();

        // The part may lie 0.05 too far away, which is a gap, and 0.02 too near, which overlaps.
        Assert.Equal(["limit +0.020", "limit -0.050"], plot.WithClass("text", "limit-label").Select(t => t.Value));
        Assert.Equal(
            ["Point 1, without compensation: -0.100 mm", "Point 1, as compensated (predicted): 0.000 mm"],
            plot.Descendants("title").Select(t => t.Value).Where(t => t.StartsWith("Point 1,", StringComparison.Ordinal)));
    }

    [Fact]
    public void The_exaggeration_is_stated_in_both_drawings_and_in_the_caption()
    {
        var page = Page(Report with { Features = [HandMadeReport.Line], KeyPoints = [.. Report.KeyPoints.Take(2)] });
        var drawings = page.WithClass("svg", "assembly").ToArray();

        // A twentieth of 100 mm is 50 times the largest deviation of 0.1 mm.
        Assert.Equal(
            ["Deviations exaggerated 50 times", "Deviations exaggerated 50 times"],
            drawings.SelectMany(d => d.WithClass("text", "factor")).Select(t => t.Value));
        Assert.Contains(
            "deviations exaggerated 50 times",
            drawings[0].Ancestors("figure").Single().Element("figcaption")!.Value,
            StringComparison.Ordinal);
    }

    [Fact]
    public void Drawings_show_the_mating_errors_of_the_key_points_also_against_a_measured_counterpart()
    {
        // Against the design the part lies at 0.1; the counterpart was cut at -0.2, so it leaves a gap of 0.3 before,
        // and after it is to overlap by 0.01.
        var points = Report.KeyPoints.Select(
            (p, i) => i == 0 ? p with { DecidedMm = 0.3, UncompensatedMm = -0.3, PredictedMm = 0.01 } : p).ToArray();

        var drawings = Page(Report with { KeyPoints = points }).WithClass("svg", "assembly")
            .Select(d => d.WithClass("circle", "key-point").Select(c => c.Value.Trim()).ToArray())
            .ToArray();

        Assert.Equal(
            [
                "Point 1: mating error -0.300 mm",
                "Point 2: mating error -0.080 mm",
                "Point 3: mating error -0.010 mm",
                "Point 4: mating error 0.000 mm"],
            drawings[0]);
        Assert.Equal(
            [
                "Point 1: mating error +0.010 mm",
                "Point 2: mating error -0.001 mm",
                "Point 3: mating error -0.010 mm",
                "Point 4: mating error 0.000 mm"],
            drawings[1]);
    }

    private static XElement Page(MatchReport report) => PageReader.Read(MatchReportHtml.Write(report));
}
