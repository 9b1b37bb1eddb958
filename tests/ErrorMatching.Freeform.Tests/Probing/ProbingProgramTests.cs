using System.Text;
using ErrorMatching.Geometry;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;
using ErrorMatching.Testing;

namespace ErrorMatching.Freeform.Tests;

public sealed class ProbingProgramTests
{
    // A surface faces up, and Klartext touches in the plane alone.
    public static TheoryData<string> Templates { get; } = [.. ProbingTemplate.Names.Where(n => n != "heidenhain-klartext")];

    public static TheoryData<string> WithMotions { get; } = ["siemens-840d", "fanuc", "linuxcnc"];

    [Theory]
    [MemberData(nameof(Templates))]
    public void The_control_s_dialect_follows_the_program_to_its_end(string template)
    {
        var program = Programs.Of(template);
        var path = Programs.Path(program.Bytes, program.Dialect);
        Assert.Null(path.Refusal);
        Assert.Empty(path.Problems);
    }

    [Theory]
    [MemberData(nameof(WithMotions))]
    public void Each_point_is_touched_along_its_normal_by_the_center_of_the_ball(string template)
    {
        var program = Programs.Of(template);
        var path = Programs.Path(program.Bytes, program.Dialect);
        var half = (0.5 * Math.Pow(10, -program.Dialect.MetricDecimals)) + 1e-12;
        NcMotion[] probes = [.. path.Motions.Where(m => m.Kind == MotionKind.Probe)];
        Assert.Equal(program.Moves.Touches.Count, probes.Length);
        foreach (var (point, probe) in Programs.Plan().Points.Zip(probes))
        {
            // Ball radius 3, stock 0.2, approach and overtravel 2 mm each.
            Near(point.Position + (point.Normal * (3 + 0.2 + 2)), probe.Start, half);
            Near(point.Position + (point.Normal * (3 + 0.2 - 2)), probe.End, half);
            Assert.Equal(100, probe.Feed);
        }
    }

    [Theory]
    [MemberData(nameof(WithMotions))]
    public void Travel_across_is_at_clearance_height_and_nothing_but_measuring_goes_below_the_approach(string template)
    {
        var program = Programs.Of(template);
        var lowest = program.Moves.Touches.Min(p => p.Approach.Z) - 0.001;
        var path = Programs.Path(program.Bytes, program.Dialect);
        foreach (var motion in path.Motions.Where(m => m.Kind != MotionKind.Probe))
        {
            Assert.True(motion.End.Z >= lowest);
            var across = (motion.UnknownStart & (AxisSet.X | AxisSet.Y)) == AxisSet.None
                && (motion.Start.X != motion.End.X || motion.Start.Y != motion.End.Y);
            if (motion.Kind == MotionKind.Rapid && across)
            {
                Assert.True(motion.Start.Z >= program.Moves.ClearanceZ - 1e-9 && motion.End.Z == motion.Start.Z);
            }
        }

        Assert.All(path.Motions.Where(m => m.Kind == MotionKind.Probe), m => Assert.True((m.End - m.Start).Length <= 4.002));
    }

    [Theory]
    [MemberData(nameof(WithMotions))]
    public void Behind_each_touch_the_probe_goes_back_the_way_it_came_and_up(string template)
    {
        var program = Programs.Of(template);
        NcMotion[] motions = [.. Programs.Path(program.Bytes, program.Dialect).Motions];
        for (var i = 0; i < motions.Length; i++)
        {
            if (motions[i].Kind == MotionKind.Probe)
            {
                Assert.Equal(motions[i].Start, motions[i + 1].End);
                Assert.Equal(motions[i].Start with { Z = motions[i + 2].End.Z }, motions[i + 2].End);
                Assert.True(motions[i + 2].End.Z >= program.Moves.ClearanceZ - 1e-9);
            }
        }
    }

    [Theory]
    [InlineData("siemens-840d", "SETAL(65000,\"point 7 was not touched\")")]
    [InlineData("fanuc", "THEN #3000=1(POINT 7 NOT TOUCHED)")]
    [InlineData("linuxcnc", "(MSG, point 7: i ")]
    public void A_missed_touch_stops_with_a_message_that_names_the_point(string template, string message) =>
        Assert.Contains(message, TextOf(Programs.Of(template)), StringComparison.Ordinal);

    [Fact]
    public void The_probe_maker_s_cycle_measures_where_the_move_is_along_an_axis()
    {
        var text = TextOf(Programs.Of("fanuc-p98xx", Programs.Plan(Surfaces.Flat)));

        // The surface with its stock lies at z = 0.2.
        Assert.Equal(20, text.Split("G65 P9811 Z0.2 Q2.0").Length - 1);
        Assert.DoesNotContain("G31", text, StringComparison.Ordinal);
    }

    [Fact]
    public void On_a_slope_the_probe_maker_s_template_measures_by_three_axes_at_once()
    {
        var text = TextOf(Programs.Of("fanuc-p98xx", Programs.Plan(Surfaces.Quadratic((x, _) => x / 4))));
        Assert.DoesNotContain("G65 P9811", text, StringComparison.Ordinal);
        Assert.DoesNotContain("G65 P9821", text, StringComparison.Ordinal);
        Assert.Equal(20, text.Split("G31 X").Length - 1);
    }

    [Theory]
    [InlineData("siemens-cycle978", "CYCLE978(0,,,1,0.2,2.0,2.0,3,2,1,")]
    [InlineData("haas-p98xx", "G65 P9811 Z0.2 Q2.0")]
    public void A_cycle_touches_down_where_the_surface_is_level(string template, string call) =>
        Assert.Equal(20, TextOf(Programs.Of(template, Programs.Plan(Surfaces.Flat))).Split(call).Length - 1);

    [Fact]
    public void A_point_that_a_template_cannot_touch_is_named()
    {
        var error = Assert.Throws<InputException>(() => Programs.Of("heidenhain-klartext", Programs.Plan(Surfaces.Flat)));
        Assert.Equal(("untouchable-point", "heidenhain-klartext"), (error.Code, error.File));
        Assert.Contains("point 1 faces (0, 0, 1): this template touches in the plane XY only", error.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_template_names_what_it_takes_for_granted_and_the_file_beside_its_program()
    {
        var template = ProbingTemplate.Parse(
            "@assumes our probe\n@body\n@if assumed\n; {assumed}\n@endif\nM30\n@beside MASK.A\n; {plan}\n"u8, "own.txt");
        var program = ProbingProgram.Of(Programs.Plan(), "", NcDialects.Siemens840D, template);
        Assert.Equal("; our probe\nM30\n", TextOf(program));
        Assert.Equal("MASK.A", program.Beside!.Value.Name);
        Assert.Equal($"; {program.Moves.Plan}\n", Encoding.UTF8.GetString(program.Beside.Value.Bytes.Span));
        Assert.Throws<InputException>(() => ProbingProgram.Of(
            Programs.Plan(), "", NcDialects.Siemens840D, ProbingTemplate.Parse("@assumes our probe\n@body\nM30\n"u8, "own.txt")));
    }

    [Fact]
    public void Names_cannot_end_a_comment()
    {
        var text = TextOf(ProbingProgram.Of(Programs.Plan(), "bad)\nG0 Z-100(", NcDialects.FanucMill, ProbingTemplate.Named("fanuc")));
        Assert.Contains("(PROBE BAD--G0 Z-100-)", text, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("feed.measuring", "feedMmPerMin")]
    [InlineData("feed.approach", "feedMmPerMin")]
    [InlineData("stylus.diameter", "stylusDiameterMm")]
    [InlineData("overtravel.mm", "overtravelMm")]
    [InlineData("approach.mm", "approachMm")]
    public void A_value_that_would_round_to_zero_is_not_written(string place, string key)
    {
        var plan = Programs.Plan() with
        {
            Measuring = Surfaces.Measuring(4, 5) with
            {
                FeedMmPerMin = 0.00004,
                StylusDiameterMm = 0.0004,
                OvertravelMm = 0.0004,
                ApproachMm = 0.0004
            }
        };
        var template = ProbingTemplate.Parse(Encoding.UTF8.GetBytes($"@body\nG0 Z{{{place}}}\nM30\n"), "own.txt");
        var error = Assert.Throws<InputException>(() => ProbingProgram.Of(plan, "", NcDialects.FanucMill, template));
        Assert.Equal(("rounds-to-zero", "own.txt"), (error.Code, error.File));
        Assert.Contains($"measuring.{key} ", error.Problem, StringComparison.Ordinal);
    }

    [Fact]
    public void A_template_whose_program_cannot_be_followed_is_refused()
    {
        var template = ProbingTemplate.Parse("@body\nG0 Z{clearance.z}\nWHILE[#5061LT1]DO1\nEND1\nM30\n"u8, "own.txt");
        var error = Assert.Throws<InputException>(() => ProbingProgram.Of(Programs.Plan(), "", NcDialects.FanucMill, template));
        Assert.Equal(("bad-template", "own.txt"), (error.Code, error.File));
    }

    [Fact]
    public void A_template_with_words_that_the_dialect_does_not_know_is_refused_with_the_block()
    {
        var template = ProbingTemplate.Parse("@body\n@each point\nTOUCH({center.x})\n@next\nM30\n"u8, "own.txt");
        var error = Assert.Throws<InputException>(() => ProbingProgram.Of(Programs.Plan(), "", NcDialects.Siemens840D, template));
        Assert.Contains("TOUCH(", error.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void The_template_that_the_documentation_shows_measures_each_point_and_writes_a_log()
    {
        var page = File.ReadAllLines(Repository.PathTo("docs", "probe-a-surface.md"));
        var example = page.SkipWhile(l => l != "### A template of your own")
            .SkipWhile(l => !l.StartsWith("    @", StringComparison.Ordinal))
            .TakeWhile(l => l.StartsWith("    ", StringComparison.Ordinal))
            .Select(l => l[4..]);
        var program = ProbingProgram.Of(
            Programs.Plan(),
            "Surface one",
            NcDialects.FanucMill,
            ProbingTemplate.Parse(Encoding.UTF8.GetBytes(string.Join('\n', example) + "\n"), "probe.txt"));
        var lines = TextOf(program).Split('\n');
        Assert.Equal(20, lines.Count(l => l.StartsWith("G31 X", StringComparison.Ordinal)));
        Assert.Equal(20, lines.Count(l => l.StartsWith("DPRNT[P", StringComparison.Ordinal)));
        Assert.Contains($"DPRNT[ERRORMATCH*PROBE*PLAN*{program.Moves.Plan}*MM]", lines);
    }

    private static string TextOf(ProbingProgram program) => Encoding.UTF8.GetString(program.Bytes.Span);

    private static void Near(Point3 expected, Point3 actual, double tolerance)
    {
        Assert.Equal(expected.X, actual.X, tolerance);
        Assert.Equal(expected.Y, actual.Y, tolerance);
        Assert.Equal(expected.Z, actual.Z, tolerance);
    }
}
