using System.Globalization;
using System.Security.Cryptography;
using System.Text;
using ErrorMatching.Geometry;
using ErrorMatching.Mating;
using ErrorMatching.Measurement;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;
using ErrorMatching.Testing;

namespace ErrorMatching.Jobs.Tests;

/// <summary>Jobs that are made from a drawing and a program: what is found is what was hidden, and what cannot be found is said.</summary>
public sealed class OutlineJobTests : IDisposable
{
    // An outline without symmetry, and its program at 4 mm from it: the corners are where the offset lines meet, by hand.
    internal const string Program =
        "%\nO1\nN10 G21 G17 G40 G90 G54\nN20 G0 X-20. Y-4.\nN30 G1 Z-5. F200.\nN40 X44. F500.\nN50 Y14.\nN60 X30.\nN70 Y34.\nN80 X-4.\n"
            + "N90 Y-20.\nN100 G0 Z50.\nN110 M30\n%\n";

    internal static readonly Point2[] Outline = [new(0, 0), new(40, 0), new(40, 10), new(26, 10), new(26, 30), new(0, 30)];

    private readonly string _folder = Directory.CreateTempSubdirectory("outline").FullName;

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Theory]
    [InlineData(Mirror.None, 0, 0, 0)]
    [InlineData(Mirror.None, 90, 12.5, -7)]
    [InlineData(Mirror.None, -137.3, 1000, 42)]
    [InlineData(Mirror.None, 0.008, 5, 3)]
    [InlineData(Mirror.X, 0, 0, 0)]
    [InlineData(Mirror.X, 61.25, -300, 420)]
    public void The_frame_that_was_hidden_is_found_with_the_tool(Mirror mirror, double degrees, double x, double y)
    {
        var hidden = new RigidTransform2(mirror, Angle.FromDegrees(degrees), new(x, y));
        var made = Made(Polygon([.. Outline.Select(hidden.Inverse().Apply)]));
        Assert.Equal(8, made.ToolDiameterMm, 1e-9);
        Assert.All(Outline, p => Assert.Equal(0, made.Frame.Apply(hidden.Inverse().Apply(p)).DistanceTo(p), 2e-4));
        Assert.Equal(mirror, made.Frame.Mirror);
        Assert.InRange(made.LargestMm, 0, 2e-4);
        Assert.Equal(["N40", "N50", "N60", "N70", "N80", "N90"], made.Features.SelectMany(f => f.Blocks));
        Assert.All(made.Features, f => Assert.Equal("line", f.Kind.Word));

        // Every key point, in the program, is on the outline.
        var job = MatingJob.Parse(made.Job.Span, "job.json");
        var points = MeasurementReader.Read(made.Theoretical, "theoretical.csv", MeasurementFormat.Points);
        Assert.All(job.KeyPoints, k =>
        {
            var at = job.Counterpart.PlaceOf(points[k], CoordinatePlane.XY, "theoretical.csv");
            Assert.Equal(0, Enumerable.Range(0, 6).Min(s => new Segment2(Outline[s], Outline[(s + 1) % 6]).DistanceTo(at)), 2e-4);
        });
    }

    // The path is 0.02 mm farther from the outline than the tool's radius: nothing but the tool that somebody names can tell.
    [Fact]
    public void An_allowance_in_the_program_is_not_taken_for_tool_in_silence()
    {
        var program = Program.Replace("-4.", "-4.02", StringComparison.Ordinal).Replace("X44.", "X44.02", StringComparison.Ordinal)
            .Replace("Y14.", "Y14.02", StringComparison.Ordinal).Replace("X30.", "X30.02", StringComparison.Ordinal)
            .Replace("Y34.", "Y34.02", StringComparison.Ordinal);
        var found = Made(Polygon(Outline), program);
        Assert.Equal(8.04, found.ToolDiameterMm, 1e-9);
        Assert.Contains(found.Notes, n => n.StartsWith("Nobody named the tool: 8.04 mm", StringComparison.Ordinal));

        var named = Made(Polygon(Outline), program, tool: 8);
        Assert.Equal(8, named.ToolDiameterMm);
        Assert.DoesNotContain(named.Notes, n => n.Contains("named the tool", StringComparison.Ordinal));

        // The outline moves a little, because the path does not close it.
        Assert.InRange(named.LargestMm, 0.015, 0.025);
    }

    // The sample's key as a plate 100 mm deep, its cam a straight line: a third of its edges is what the program cuts.
    [Fact]
    public void A_part_with_more_edges_than_the_program_cuts_is_laid_by_those_that_it_cuts()
    {
        var flank = 30 / Math.Sqrt(3);
        Point2[] plate =
        [
            new(-100, -30), new(-40, -30), new(-40 - flank, 0), new(-34, 0), new(-22, -12), new(-10, 0), new(10, 0), new(36, 0),
            new(40 + flank, 0), new(40, -30), new(100, -30), new(100, -130), new(-100, -130),
        ];
        var program = File.ReadAllText(Repository.PathTo("samples", "dovetail", "counterpart.nc"));
        var moved = new RigidTransform2(Mirror.None, Angle.FromDegrees(90), new(300, 20));
        var made = Made(Polygon([.. plate.Select(moved.Inverse().Apply)]), program, tool: 8);
        Assert.InRange(made.CoveredShare, 0.25, 0.45);
        Assert.All(plate, p => Assert.Equal(0, made.Frame.Apply(moved.Inverse().Apply(p)).DistanceTo(p), 0.002));

        // The top from X-10 to the right is one line here, of which the longest stretch that is cut is N200.
        Assert.Equal(
            ["N100", "N120", "N140", "N160", "N180", "N200", "N950", "N970"],
            made.Features.SelectMany(f => f.Blocks).Where(b => !b.Contains("..", StringComparison.Ordinal)));
    }

    [Fact]
    public void A_drawing_that_says_no_unit_is_told_to_be_in_millimeters() => Assert.Contains(
        Made(Polygon(Outline)).Notes, n => n.StartsWith("The drawing does not say its unit.", StringComparison.Ordinal));

    [Fact]
    public void A_bore_is_a_circle_and_a_key_is_a_slot()
    {
        var bore = Made(
            Dxf(("CIRCLE", [10, 100, 20, 50, 40, 20])),
            "G21 G17 G90 G40\nN10 G0 X0. Y0.\nN20 G1 Z-5. F100.\nN30 X17. F500.\nN40 G3 X17. Y0. I-17. J0.\nN50 G1 X0.\nN60 G0 Z9.\nM30\n",
            tool: 6);
        var circle = Assert.Single(bore.Features);
        Assert.Equal(("circle", 8), (circle.Kind.Word, circle.Points));
        Assert.Equal(["N40"], circle.Blocks);
        Assert.Equal((-100.0, -50.0), (bore.Frame.Translation.X, bore.Frame.Translation.Y));

        var key = Made(
            Dxf(
                ("LINE", [10, -20, 20, -10, 11, 20, 21, -10]),
                ("ARC", [10, 20, 20, 0, 40, 10, 50, 270, 51, 90]),
                ("LINE", [10, 20, 20, 10, 11, -20, 21, 10]),
                ("ARC", [10, -20, 20, 0, 40, 10, 50, 90, 51, 270])),
            "G21 G17 G90 G40\nN10 G0 X0. Y-25.\nN20 G1 Z-8. F200.\nN30 Y-13. F500.\nN40 X-20.\nN50 G2 X-20. Y13. J13.\nN60 G1 X20.\n"
                + "N70 G2 X20. Y-13. J-13.\nN80 G1 X0.\nN90 Y-25.\nN100 G0 Z50.\nM30\n");
        var slot = Assert.Single(key.Features);
        Assert.Equal(("slot", 8), (slot.Kind.Word, slot.Points));
        Assert.Equal(6, key.ToolDiameterMm, 1e-9);

        // A slot turned by half a turn, and its mirror images, are the same, and nobody can tell which way the drawing lies.
        Assert.Contains(key.Notes, n => n.Contains("in 4 ways or more", StringComparison.Ordinal));
    }

    [Fact]
    public void A_drawing_in_another_unit_is_asked_about_and_not_guessed()
    {
        var inches = Polygon([.. Outline.Select(p => new Point2(p.X / 25.4, p.Y / 25.4))]);
        var refusal = Assert.Single(Make(inches).Refusals);
        Assert.Equal("drawing-unit", refusal.Code);
        Assert.Contains("--unit inch", refusal.Message, StringComparison.Ordinal);
        Assert.Equal(6, Made(inches, unit: 25.4).Features.Count);
    }

    [Fact]
    public void A_drawing_of_something_else_is_refused()
    {
        var refusal = Assert.Single(Make(Polygon([new(0, 0), new(300, 10), new(280, 200), new(-20, 90)])).Refusals);
        Assert.Equal("outline-not-laid", refusal.Code);
    }

    [Fact]
    public void The_layer_has_to_be_named_where_there_are_several()
    {
        var two = Polygon(Outline).Replace(
            "0\nENDSEC\n0\nEOF", "0\nLINE\n8\nFRAME\n10\n0\n20\n0\n11\n9\n21\n9\n0\nENDSEC\n0\nEOF", StringComparison.Ordinal);
        var missing = Assert.Throws<InputException>(() => Make(two));
        Assert.Equal("layer-missing", missing.Code);
        Assert.Contains("OUTLINE (6 curves), FRAME (1 curve)", missing.Problem, StringComparison.Ordinal);
        Assert.Equal("layer-unknown", Assert.Throws<InputException>(() => Make(two, layer: "outline")).Code);
        Assert.Equal(6, Made(two, layer: "OUTLINE").Features.Count);

        // The same for somebody who chooses on a screen: the line of the frame is too short to lie anywhere.
        var layers = OutlineJob.LayersOf(Request(null, null, null), TestContext.Current.CancellationToken).Result!;
        Assert.Equal([("OUTLINE", 6, true), ("FRAME", 1, false)], layers.Select(l => (l.Name, l.Curves, l.CoveredShare is not null)));
    }

    // Lines are counted in this program only: in an edited one, others would be meant.
    [Fact]
    public void Blocks_by_line_come_with_the_hash_of_their_program()
    {
        var once = string.Join('\n', Program.Split('\n').Select(
            l => l.StartsWith('N') ? l[(l.IndexOf(' ', StringComparison.Ordinal) + 1)..] : l));
        var pass = once[once.IndexOf("X44.", StringComparison.Ordinal)..once.IndexOf("G0 Z50.", StringComparison.Ordinal)];
        var plain = once.Replace("G0 Z50.", "G0 Z5.\nX-20. Y-4.\nG1 Z-10.\n" + pass + "G0 Z50.", StringComparison.Ordinal);
        var made = Made(Polygon(Outline), plain);
        Assert.All(made.Features, f => Assert.StartsWith("L", f.Blocks[0], StringComparison.Ordinal));
        var counterpart = MatingJob.Parse(made.Job.Span, "job.json").Counterpart;
        Assert.Equal(Convert.ToHexStringLower(SHA256.HashData(Encoding.UTF8.GetBytes(plain))), counterpart.ProgramSha256);
        Assert.Null(MatingJob.Parse(Made(Polygon(Outline)).Job.Span, "job.json").Counterpart.ProgramSha256);
    }

    // On the station's screen the outline lies over the path: one tool radius beside each cut.
    [Fact]
    public void The_outline_is_told_in_the_frame_of_the_program()
    {
        var hidden = new RigidTransform2(Mirror.X, Angle.FromDegrees(61.25), new(-300, 420));
        var made = Made(Polygon([.. Outline.Select(hidden.Inverse().Apply)]));
        Assert.All(Outline, p => Assert.Contains(made.Outline.SelectMany(l => l), o => o.DistanceTo(p) < 2e-4));
    }

    [Fact]
    public void A_draft_takes_what_the_drawing_says_and_keeps_the_rest()
    {
        var made = Made(Polygon(Outline));
        var draft = new MatingDraft { OtherPoints = [new("A", "1", "2", "")] }.With("$.workOrder", "W1")
            .With("$.gauge.uncertaintyMm", "0.003")
            .With("$.counterpart.dialect", "fanuc")
            .With("$.counterpart.mapMm", "0.2")
            .With("$.alignment.kind", "datum")
            .With("$.alignment.origin", "A")
            .With("$.alignment.direction", "B");
        var taken = made.Into(draft);
        Assert.Equal(("outline", "W1", "0.003"), (taken.Name, taken["$.workOrder"], taken["$.gauge.uncertaintyMm"]));
        Assert.Equal(("fanuc", "0.2", "8", "program.nc"), (
            taken["$.counterpart.dialect"],
            taken["$.counterpart.mapMm"],
            taken["$.counterpart.toolDiameterMm"],
            taken["$.counterpart.program"]));
        Assert.Equal(["N40", "N50", "N60", "N70", "N80", "N90"], taken.Features.Select(f => f.Blocks));
        Assert.All(taken.Features, f => Assert.Equal(("", ""), (f.Lower, f.Upper)));
        Assert.Equal(Encoding.UTF8.GetBytes(Program), taken.Program!.Bytes.ToArray());

        // What named points that are gone goes with them.
        Assert.Empty(taken.OtherPoints);
        Assert.Equal("none", taken.Word("$.alignment.kind"));
        Assert.Equal("named", made.Into(draft with { Name = "named" }).Name);
    }

    // A tool that was found, or is another job's, must not be taken for one that somebody named.
    [Fact]
    public void The_request_of_a_draft_names_its_control_and_the_tool_of_an_empty_job()
    {
        var draft = new MatingDraft { IsBegunAnew = true }.With("$.counterpart.dialect", "fanuc")
            .With("$.counterpart.toolDiameterMm", "6")
            .With("$.counterpart.blockSkip", "on")
            .With("$.counterpart.libraries", "subs, more");
        var request = OutlineRequest.For(draft, Path.Combine(_folder, "job.json"), "o.dxf", "p.nc");
        Assert.Equal((6, BlockSkip.On, "fanuc"), (request.ToolDiameterMm, request.Control!.BlockSkip, request.Dialect));
        Assert.Equal([Path.Combine(_folder, "subs"), Path.Combine(_folder, "more")], request.Libraries);
        Assert.Null(OutlineRequest.For(draft with { IsBegunAnew = false }, request.Job, "o.dxf", "p.nc").ToolDiameterMm);
        Assert.Null(OutlineRequest.For(Made(Polygon(Outline)).Into(draft), request.Job, "o.dxf", "p.nc").ToolDiameterMm);
    }

    [Fact]
    public void Blocks_behind_a_slash_are_those_of_the_switch_that_the_request_states()
    {
        var slashed = Program.Replace("N50 ", "/N45 X99.\nN50 ", StringComparison.Ordinal);
        Assert.NotEqual(6, Make(Polygon(Outline), slashed).Result?.Features.Count);
        var skipping = NcDialects.Named("fanuc").With(BlockSkip.On);
        var made = OutlineJob.Make(Request(null, null, null) with { Control = skipping }, TestContext.Current.CancellationToken);
        Assert.Equal(6, made.Result!.Features.Count);
    }

    // Under compensation the path is the boundary, and only a person knows the tool.
    [Fact]
    public void A_program_with_compensation_does_not_tell_the_tool()
    {
        const string Compensated =
            "G21 G17 G90 G40\nN10 G0 X-40. Y-20.\nN20 G1 G42 D1 X-20. Y0. F500.\nN30 X40.\nN40 Y10.\nN50 X26.\nN60 Y30.\nN70 X0.\n"
                + "N80 Y-20.\nN90 G40 Y-40.\nM30\n";
        Assert.Equal("tool-diameter-missing", Assert.Throws<InputException>(() => Make(Polygon(Outline), Compensated)).Code);
        Assert.Equal(6, Made(Polygon(Outline), Compensated, tool: 8).Features.Count);
    }

    [Fact]
    public void What_the_program_does_not_cut_gets_no_feature_and_is_named()
    {
        var made = Made(Polygon(Outline), Program.Replace("N80 X-4.\nN90 Y-20.\n", "", StringComparison.Ordinal), tool: 8);
        Assert.Equal(4, made.Features.Count);
        Assert.Equal(2, made.Notes.Count(n => n.Contains("is left out", StringComparison.Ordinal)));
    }

    private OutlineJob Made(
        string drawing, string program = Program, double? tool = null, double? unit = null, string? layer = null) =>
        Assert.IsType<OutlineJob>(Make(drawing, program, tool, unit, layer).Result);

    private Outcome<OutlineJob> Make(
        string drawing, string program = Program, double? tool = null, double? unit = null, string? layer = null)
    {
        var (dxf, nc) = (Path.Combine(_folder, "outline.dxf"), Path.Combine(_folder, "program.nc"));
        File.WriteAllText(dxf, drawing);
        File.WriteAllText(nc, program);
        return OutlineJob.Make(Request(tool, unit, layer), TestContext.Current.CancellationToken);
    }

    private OutlineRequest Request(double? tool, double? unit, string? layer) =>
        new(Path.Combine(_folder, "job.json"), Path.Combine(_folder, "outline.dxf"), Path.Combine(_folder, "program.nc"), "fanuc")
        {
            ToolDiameterMm = tool,
            UnitMm = unit,
            Layer = layer,
        };

    private static string Polygon(Point2[] corners) => Dxf([
        .. corners.Select((p, i) => (
            "LINE",
            new[] { 10, p.X, 20, p.Y, 11, corners[(i + 1) % corners.Length].X, 21, corners[(i + 1) % corners.Length].Y }))]);

    // Entities with pairs of group code and value.
    private static string Dxf(params (string Entity, double[] Pairs)[] entities)
    {
        var text = new StringBuilder("0\nSECTION\n2\nENTITIES\n");
        foreach (var (entity, pairs) in entities)
        {
            text.Append("0\n").Append(entity).Append("\n8\nOUTLINE\n");
            foreach (var pair in pairs.Chunk(2))
            {
                text.Append(CultureInfo.InvariantCulture, $"{pair[0]:0}\n{pair[1]:R}\n");
            }
        }

        return text.Append("0\nENDSEC\n0\nEOF\n").ToString();
    }
}
