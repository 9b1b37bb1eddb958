using System.Text;
using ErrorMatching.Geometry;
using ErrorMatching.Mating;
using ErrorMatching.Testing;

namespace ErrorMatching.Jobs.Tests;

/// <summary>What the tolerances of a model become in a job: limits that say the same or are as strict, or a question.</summary>
public sealed class StepToleranceTests : IDisposable
{
    // 4 mm inside of a rectangle: the pocket that receives it.
    private const string Pocket =
        "G21 G17 G40 G90\nN10 G0 X4. Y4.\nN20 G1 Z-5. F200.\nN40 X56. F500.\nN50 Y36.\nN60 X4.\nN70 Y4.\nN100 G0 Z50.\nN110 M30\n";

    // A bore of radius 20 by a tool of radius 3.
    private const string Bore =
        "G21 G17 G90 G40\nN10 G0 X0. Y0.\nN20 G1 Z-5. F100.\nN30 X17. F500.\nN40 G3 X17. Y0. I-17. J0.\nN50 G1 X0.\nN60 G0 Z9.\nM30\n";

    // The same size from outside: a boss.
    private const string Boss =
        "G21 G17 G90 G40\nN10 G0 X23. Y-9.\nN20 G1 Z-5. F100.\nN30 Y0. F500.\nN40 G3 X23. Y0. I-23. J0.\nN50 G1 Y9.\nN60 G0 Z9.\nM30\n";

    private readonly string _folder = Directory.CreateTempSubdirectory("tolerances").FullName;

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Fact]
    public void A_profile_becomes_limits_of_half_its_zone_with_its_name()
    {
        var sample = Plate();
        Profile(sample, "Profile.1", 0.2, Of(sample, 0, 1), "A");
        var made = Made(sample);
        Assert.Equal((-0.1, 0.1), (made.Limits["L1"].Lower, made.Limits["L1"].Upper));
        Assert.Equal(["L1", "L2"], made.Limits.Keys.Order(StringComparer.Ordinal));
        var tolerance = Assert.Single(made.Tolerances);
        Assert.Equal((OutlineTolerance.Limits, "Profile.1", "surface-profile", 0.2), (
            tolerance.Became, tolerance.Name, tolerance.Kind, tolerance.ValueMm));
        Assert.Equal(["L1", "L2"], tolerance.Features);
        Assert.Equal([sample.Faces[0], sample.Faces[1]], tolerance.Faces);
        Assert.Contains("frame of its datums A", tolerance.Reason, StringComparison.Ordinal);
        Assert.StartsWith("Profile.1 (#", made.Limits["L1"].From, StringComparison.Ordinal);

        // The job has it, and the placeholder where nothing is said.
        var job = MatingJob.Parse(made.Job.Span, "job.json");
        Assert.Equal([0.1, 0.1, 0.05, 0.05, 0.05, 0.05], job.Features.Select(f => f.Tolerance.Band.UpperMm));
        var text = Encoding.UTF8.GetString(made.Job.Span);
        Assert.Contains("\"toleranceMm\": [-0.1, 0.1], \"toleranceFrom\": \"Profile.1 (#", text, StringComparison.Ordinal);
        Assert.Contains("not from the model (toleranceFrom)", text, StringComparison.Ordinal);
    }

    [Fact]
    public void Without_datums_limits_are_stricter_and_the_answer_says_so()
    {
        var sample = Plate();
        Profile(sample, "", 0.1, Of(sample, 0));
        var tolerance = Assert.Single(Made(sample).Tolerances);
        Assert.Equal(OutlineTolerance.StricterLimits, tolerance.Became);
        Assert.Contains("no datums", tolerance.Reason, StringComparison.Ordinal);
    }

    // Each section by itself: the surface as a whole may lie worse.
    [Fact]
    public void Limits_of_a_line_profile_are_stricter_even_with_datums()
    {
        var sample = Plate();
        var datums = $"GEOMETRIC_TOLERANCE_WITH_DATUM_REFERENCE(({Datums(sample, ["A"])}))";
        sample.Add($"(GEOMETRIC_TOLERANCE('P','',{Mm(sample, 0.1)},{Of(sample, 0)}){datums}LINE_PROFILE_TOLERANCE())");
        var tolerance = Assert.Single(Made(sample).Tolerances);
        Assert.Equal(("line-profile", OutlineTolerance.StricterLimits), (tolerance.Kind, tolerance.Became));
    }

    [Fact]
    public void Of_two_profiles_the_narrower_one_limits_and_both_are_named()
    {
        var sample = Plate();
        Profile(sample, "Wide", 0.2, Of(sample, 0, 1), "A");
        Profile(sample, "Narrow", 0.06, Of(sample, 1), "A");
        var made = Made(sample);
        Assert.Equal((0.1, 0.03), (made.Limits["L1"].Upper, made.Limits["L2"].Upper));
        Assert.Matches(@"^Wide \(#.*\); Narrow \(#.*\)$", made.Limits["L2"].From);
    }

    [Fact]
    public void A_composite_aspect_is_its_parts_and_all_over_is_the_rest()
    {
        var sample = Plate();
        var shape = sample.Add($"PRODUCT_DEFINITION_SHAPE('','',$)");
        var whole = sample.Add($"COMPOSITE_SHAPE_ASPECT('','',{shape},.T.)");
        foreach (var part in new[] { Of(sample, 2), Of(sample, 3) })
        {
            sample.Add($"SHAPE_ASPECT_RELATIONSHIP('','',{whole},{part})");
        }

        Profile(sample, "Parts", 0.02, whole, "A");
        Profile(sample, "Rest", 0.4, shape, "A");
        var made = Made(sample);
        Assert.Equal([0.2, 0.2, 0.01, 0.01, 0.2, 0.2], Enumerable.Range(1, 6).Select(n => made.Limits[$"L{n}"].Upper));
    }

    [Fact]
    public void A_feature_with_a_wider_tolerance_of_its_own_keeps_it_whatever_the_rest_has()
    {
        var sample = Plate();
        Profile(sample, "Own", 0.4, Of(sample, 2), "A");
        Profile(sample, "Rest", 0.02, sample.Add($"PRODUCT_DEFINITION_SHAPE('','',$)"), "A");
        var made = Made(sample);
        Assert.Equal([0.01, 0.01, 0.2, 0.01, 0.01, 0.01], Enumerable.Range(1, 6).Select(n => made.Limits[$"L{n}"].Upper));
    }

    [Fact]
    public void Inches_are_converted_and_that_is_said()
    {
        var sample = Plate();
        var inch = sample.Add($"(CONVERSION_BASED_UNIT('INCH',{Mm(sample, 25.4)})LENGTH_UNIT()NAMED_UNIT(*))");
        var magnitude = sample.Add($"LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(0.01),{inch})");
        sample.Add($"SURFACE_PROFILE_TOLERANCE('P','',{magnitude},{Of(sample, 0)})");
        var made = Made(sample);
        Assert.Equal(0.127, made.Limits["L1"].Upper, 1e-9);
        Assert.Equal(25.4, made.Tolerances[0].UnitMm!.Value, 1e-9);
        Assert.Contains(made.Notes, n => n.StartsWith("Converted to millimeters: 1 dimension or tolerance", StringComparison.Ordinal));
    }

    // Who says that the unit of the model is inch, means its tolerances as well.
    [Fact]
    public void A_unit_that_somebody_names_is_that_of_tolerances_in_the_models_own()
    {
        var sample = new StepSample().Plate([Polygon(OutlineJobTests.Outline)], -10, 0, 25.4);
        Profile(sample, "P", 0.01, Of(sample, 0), "A");
        Assert.Equal(0.127, Made(sample, unitMm: 25.4).Limits["L1"].Upper, 1e-9);
    }

    [Theory]
    [InlineData("ASME Y14.5", -0.05, 0.15)]
    [InlineData("ISO 1101", -0.15, 0.05)]
    public void An_unequal_zone_is_read_by_the_standard_that_the_file_names(string standard, double lower, double upper)
    {
        var sample = Solid();
        Unequal(sample, 0.2, 0.05);
        sample.Add($"PRODUCT('{standard}','','',())");
        var made = Made(sample, Pocket, tool: 8);
        Assert.Equal((lower, upper), (made.Limits["L1"].Lower, made.Limits["L1"].Upper));
        Assert.Equal(OutlineTolerance.Limits, made.Tolerances[0].Became);
    }

    [Fact]
    public void An_unequal_zone_is_asked_without_standard_or_side()
    {
        var unknown = Solid();
        Unequal(unknown, 0.2, 0.05);
        AssertAsked(
            Made(unknown, Pocket, tool: 8),
            "by ASME Y14.5 it reaches 0.05 mm out of the material and 0.15 mm into it, by ISO 1101 0.15 and 0.05 mm");

        var open = new StepSample().Plate([Polygon([new(0, 0), new(60, 0), new(60, 40), new(0, 40)])], -10, 0);
        Unequal(open, 0.2, 0.05);
        open.Add($"PRODUCT('ASME Y14.5','','',())");
        AssertAsked(Made(open, Pocket, tool: 8), "does not say on which side of L1");
    }

    // The tool runs around the model's own material: it cuts the model, not what receives it.
    [Fact]
    public void A_model_of_the_counterpart_gives_no_limits_of_the_part()
    {
        var sample = Solid(isPocket: false);
        Profile(sample, "P", 0.2, Of(sample, 0), "A");
        AssertAsked(Made(sample), "the model is not the part but its counterpart");
    }

    [Theory]
    [InlineData(Bore, 6, -0.05, 0.01)]
    [InlineData(Boss, 6, -0.01, 0.05)]
    public void The_size_of_a_circle_becomes_limits_that_are_as_strict(string program, double tool, double lower, double upper)
    {
        var sample = Disc();
        Size(sample, "diameter", 40, -0.02, 0.1, Of(sample, 0));
        var made = Made(sample, program, tool);
        Assert.Equal((lower, upper), (made.Limits["B1"].Lower, made.Limits["B1"].Upper));
        Assert.Equal(OutlineTolerance.StricterLimits, made.Tolerances[0].Became);
        Assert.Equal((-0.02, 0.1, 40.0), (made.Tolerances[0].Lower, made.Tolerances[0].Upper, made.Tolerances[0].ValueMm));
    }

    [Fact]
    public void A_radius_is_read_as_such_and_the_nominal_of_the_file_counts()
    {
        var sample = Disc();
        Size(sample, "radius", 20.01, -0.02, 0.02, Of(sample, 0));
        var made = Made(sample, Boss, 6);
        Assert.Equal((-0.01, 0.03), (made.Limits["B1"].Lower, made.Limits["B1"].Upper));
    }

    [Theory]
    [InlineData(41)]
    [InlineData(39)]
    public void A_size_that_the_drawn_circle_does_not_have_is_asked(double nominal)
    {
        var sample = Disc();
        Size(sample, "diameter", nominal, -0.02, 0.02, Of(sample, 0));
        AssertAsked(Made(sample, Boss, 6), "drawn with a radius of 20 mm, which is not within its limits");
    }

    // Two circles 0.05 mm apart: whatever the form, the center is within 0.05 mm, in a zone of diameter 0.1 mm.
    [Fact]
    public void A_position_with_a_size_narrows_the_limits_until_they_fulfil_it()
    {
        var sample = Disc();
        Size(sample, "diameter", 40, -0.1, 0.1, Of(sample, 0));
        sample.Add($"POSITION_TOLERANCE('Position.1','',{Mm(sample, 0.1)},{Of(sample, 0)})");
        var made = Made(sample, Bore, 6);
        Assert.Equal((-0.025, 0.025), (made.Limits["B1"].Lower, made.Limits["B1"].Upper));
        Assert.All(made.Tolerances, t => Assert.Equal(OutlineTolerance.StricterLimits, t.Became));
        Assert.Contains("Position.1", made.Limits["B1"].From, StringComparison.Ordinal);
    }

    [Fact]
    public void A_position_alone_or_without_width_is_asked()
    {
        var alone = Disc();
        alone.Add($"POSITION_TOLERANCE('Position.1','',{Mm(alone, 0.1)},{Of(alone, 0)})");
        AssertAsked(Made(alone, Bore, 6), "it says nothing of the size of B1");

        var zero = Disc();
        Size(zero, "diameter", 40, -0.1, 0.1, Of(zero, 0));
        zero.Add($"POSITION_TOLERANCE('Position.1','',{Mm(zero, 0)},{Of(zero, 0)})");
        var made = Made(zero, Bore, 6);
        Assert.Equal((-0.05, 0.05), (made.Limits["B1"].Lower, made.Limits["B1"].Upper));
        Assert.Contains("no width", made.Tolerances.Single(t => t.Kind == "position").Reason, StringComparison.Ordinal);
    }

    [Fact]
    public void What_a_job_cannot_state_is_asked_with_its_reason()
    {
        var cases = new (string Reason, Action<StepSample> Write)[]
        {
            ("of the form alone", s => s.Add($"FLATNESS_TOLERANCE('F','',{Mm(s, 0.1)},{Of(s, 0)})")),
            ("of the direction alone", s => s.Add($"PERPENDICULARITY_TOLERANCE('F','',{Mm(s, 0.1)},{Of(s, 0)},())")),
            ("a tolerance of total-runout", s => s.Add($"TOTAL_RUNOUT_TOLERANCE('F','',{Mm(s, 0.1)},{Of(s, 0)},())")),
            ("of the center of L1, a line", s => s.Add($"POSITION_TOLERANCE('F','',{Mm(s, 0.1)},{Of(s, 0)})")),
            ("the thickness of L1, a line", s => Size(s, "thickness", 40, -0.1, 0.1, Of(s, 0))),
            ("has no limits of its own", s => Size(s, "diameter", 40, null, null, Of(s, 0))),
            ("the fit H7", s => s.Add(
                $"PLUS_MINUS_TOLERANCE({s.Add($"LIMITS_AND_FITS('H','hole','7','')")},{Size(s, "diameter", 40, null, null, Of(s, 0))})")),
            ("a distance between two features", s => Nominal(
                s, s.Add($"DIMENSIONAL_LOCATION('linear distance','',{Of(s, 0)},{Of(s, 2)})"), Mm(s, 40, "nominal value"))),
            ("it is an angle", s => Nominal(
                s, s.Add($"ANGULAR_LOCATION('','',{Of(s, 0)},{Of(s, 1)},.SMALL.)"),
                s.Add($"MEASURE_REPRESENTATION_ITEM('nominal value',PLANE_ANGLE_MEASURE(1.5),{Radian(s)})"))),
            ("the drawn face itself", s => Profile(s, "P", 0.1, Of(s, 6))),
            ("no face of it meets the outline", s => Profile(s, "P", 0.1, Of(s, 7))),
            ("lower segment of a composite", s => s.Add(
                $"GEOMETRIC_TOLERANCE_RELATIONSHIP('composite','',$,{Profile(s, "P", 0.1, Of(s, 0))})")),
            ("not understood: STATISTICAL_TOLERANCE", s => Complex(
                s, "P", 0.1, Of(s, 0), $"GEOMETRIC_TOLERANCE_WITH_MODIFIERS((.STATISTICAL_TOLERANCE.))")),
            ("CARTESIAN_POINT, and of no face", s => Profile(s, "P", 0.1, Aspect(s, s.Point(new(0, 0, 0))))),
            ("leads to no geometry", s => Profile(s, "P", 0.1, s.Add($"SHAPE_ASPECT('','',$,.T.)"))),
            ("ends within faces", s => Profile(s, "P", 0.1, Aspect(s, "BETWEEN_SHAPE_ASPECT", s.Faces[0]))),
            ("a magnitude of -0.1 mm", s => Profile(s, "P", -0.1, Of(s, 0))),
            ("without a magnitude", s => s.Add($"SURFACE_PROFILE_TOLERANCE('P','',$,{Of(s, 0)})")),
            ("beyond the 1 mm at which a job stops", s => Profile(s, "P", 2.5, Of(s, 0), "A")),
            ("its zone has no width", s => Profile(s, "P", 0, Of(s, 0))),
            ("leave nothing between them", s =>
            {
                s.Add($"PRODUCT('ISO 1101','','',())");
                Unequal(s, 0.02, 0.02);
                Unequal(s, 0.02, -0.02);
            }),
        };
        foreach (var (reason, write) in cases)
        {
            var isSolid = reason.Contains("between them", StringComparison.Ordinal);
            var sample = isSolid ? Solid() : Plate();
            write(sample);
            AssertAsked(Made(sample, isSolid ? Pocket : OutlineJobTests.Program, 8), reason);
        }
    }

    [Fact]
    public void A_tolerance_of_a_part_of_a_feature_or_of_a_slope_is_asked()
    {
        // Two edges on one line are one feature.
        Point2[] cut = [new(0, 0), new(20, 0), new(40, 0), new(40, 10), new(26, 10), new(26, 30), new(0, 30)];
        var part = new StepSample().Plate([Polygon(cut)], -10, 0);
        Profile(part, "P", 0.2, Of(part, 0));
        AssertAsked(Made(part), "of a part of L1 only");

        // What the file does not have of a feature, no tolerance can cover.
        var open = new StepSample().Plate([Polygon(cut)], -10, 0);
        open.Lose(open.Faces[1]);
        Profile(open, "P", 0.2, Of(open, 0));
        AssertAsked(Made(open), "not all faces there are known");

        // A draft of one degree: the plane of the first side is another one.
        var slope = new StepSample { Slope = 0.0175 }.Plate([Polygon(OutlineJobTests.Outline)], -10, 0);
        Profile(slope, "P", 0.2, Of(slope, 0));
        AssertAsked(Made(slope), "not perpendicular to the drawing");
    }

    [Fact]
    public void A_draft_keeps_the_limits_of_the_model()
    {
        var sample = Plate();
        Profile(sample, "P", 0.2, Of(sample, 0), "A");
        var made = Made(sample);
        var draft = made.Into(MatingDraftFiles.Read(made.Job.Span, "job.json", made.Theoretical));
        Assert.Equal(["0.1", "", ""], draft.Features.Take(3).Select(f => f.Upper));
        Assert.StartsWith("P (#", draft.Features[0]["toleranceFrom"], StringComparison.Ordinal);
    }

    [Fact]
    public void A_hundred_thousand_annotations_take_time_in_proportion()
    {
        var (small, large) = (ManyOf(25_000), ManyOf(100_000));
        var few = ReadingCost.Seconds(() => Made(small));
        OutlineJob? made = null;
        var many = ReadingCost.Seconds(() => made = Made(large));
        Assert.Equal(100_000, made!.Tolerances.Count);
        Assert.Equal(0.05, made.Limits["L1"].Upper);
        Assert.InRange(many, 0, (6 * few) + 2);

        static StepSample ManyOf(int count)
        {
            var sample = Plate();
            var (mm, aspect) = (Mm(sample, 0.1), Of(sample, 0));
            for (var i = 0; i < count; i++)
            {
                sample.Add($"SURFACE_PROFILE_TOLERANCE('P','',{mm},{aspect})");
            }

            return sample;
        }
    }

    private static void AssertAsked(OutlineJob made, string reason)
    {
        Assert.NotEmpty(made.Tolerances);
        Assert.All(made.Tolerances, t => Assert.Equal((OutlineTolerance.Asked, 0), (t.Became, t.Features.Count)));
        Assert.All(made.Tolerances, t => Assert.Contains(reason, t.Reason, StringComparison.Ordinal));
        Assert.Empty(made.Limits);
    }

    private static StepSample Plate() => new StepSample().Plate([Polygon(OutlineJobTests.Outline)], -10, 0);

    private static StepSample Solid(bool isPocket = true) => new StepSample { IsSolid = true }.Plate(
        [Polygon(isPocket ? [new(0, 0), new(60, 0), new(60, 40), new(0, 40)] : OutlineJobTests.Outline)], -10, 0);

    private static StepSample Disc() => new StepSample().Plate([[new DrawnArc("", "", Point2.Origin, 20, 0, Math.Tau)]], -10, 0);

    private static List<DrawnCurve> Polygon(Point2[] corners) =>
        [.. corners.Select((p, i) => new DrawnLine("", "", p, corners[(i + 1) % corners.Length]))];

    private static string Mm(StepSample sample, double value) =>
        sample.Add($"LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE({StepSample.Real(value)}),#3)");

    private static string Mm(StepSample sample, double value, string name) =>
        sample.Add($"MEASURE_REPRESENTATION_ITEM('{name}',LENGTH_MEASURE({StepSample.Real(value)}),#3)");

    private static string Radian(StepSample sample) => sample.Add($"(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");

    // A shape aspect of side faces by their positions; 6 is the top, 7 the bottom.
    private static string Of(StepSample sample, params int[] faces) =>
        Aspect(sample, "SHAPE_ASPECT", [.. faces.Select(f => sample.Faces[f])]);

    private static string Aspect(StepSample sample, string item) => Aspect(sample, "SHAPE_ASPECT", item);

    private static string Aspect(StepSample sample, string kind, params string[] items)
    {
        var aspect = sample.Add($"{kind}('','',$,.T.)");
        foreach (var item in items)
        {
            sample.Add($"GEOMETRIC_ITEM_SPECIFIC_USAGE('','',{aspect},#4,{item})");
        }

        return aspect;
    }

    private static string Datums(StepSample sample, string[] letters)
    {
        string[] compartments = [
            .. letters.Select(l => sample.Add($"DATUM_REFERENCE_COMPARTMENT('','',$,.F.,{sample.Add($"DATUM('','',$,.F.,'{l}')")},$)"))];
        return sample.Add($"DATUM_SYSTEM('','',$,.F.,({string.Join(',', compartments)}))");
    }

    private static string Profile(StepSample sample, string name, double mm, string aspect, params string[] datums) => datums.Length == 0
        ? sample.Add($"SURFACE_PROFILE_TOLERANCE('{name}','',{Mm(sample, mm)},{aspect})")
        : Complex(sample, name, mm, aspect, $"GEOMETRIC_TOLERANCE_WITH_DATUM_REFERENCE(({Datums(sample, datums)}))");

    private static string Unequal(StepSample sample, double mm, double by) => Complex(
        sample,
        "P",
        mm,
        Of(sample, 0),
        $"GEOMETRIC_TOLERANCE_WITH_DATUM_REFERENCE(({Datums(sample, ["A"])}))",
        $"UNEQUALLY_DISPOSED_GEOMETRIC_TOLERANCE({Mm(sample, by)})");

    // A profile of several types.
    private static string Complex(StepSample sample, string name, double mm, string aspect, params string[] types)
    {
        var own = $"GEOMETRIC_TOLERANCE('{name}','',{Mm(sample, mm)},{aspect})";
        return sample.Add($"({own}{string.Concat(types)}SURFACE_PROFILE_TOLERANCE())");
    }

    private static string Nominal(StepSample sample, string dimension, params string[] items)
    {
        var representation = sample.Add($"SHAPE_DIMENSION_REPRESENTATION('',({string.Join(',', items)}),#1)");
        sample.Add($"DIMENSIONAL_CHARACTERISTIC_REPRESENTATION({dimension},{representation})");
        return dimension;
    }

    private static string Size(StepSample sample, string what, double nominal, double? lower, double? upper, string aspect)
    {
        var size = Nominal(sample, sample.Add($"DIMENSIONAL_SIZE({aspect},'{what}')"), Mm(sample, nominal, "nominal value"));
        if (lower is { } least && upper is { } most)
        {
            sample.Add($"PLUS_MINUS_TOLERANCE({sample.Add($"TOLERANCE_VALUE({Mm(sample, least)},{Mm(sample, most)})")},{size})");
        }

        return size;
    }

    private OutlineJob Made(StepSample sample, string program = OutlineJobTests.Program, double? tool = null, double? unitMm = null)
    {
        var (model, nc) = (Path.Combine(_folder, "part.stp"), Path.Combine(_folder, "program.nc"));
        File.WriteAllBytes(model, sample.Bytes());
        File.WriteAllText(nc, program);
        var outcome = OutlineJob.Make(
            new(Path.Combine(_folder, "job.json"), model, nc, "fanuc") { ToolDiameterMm = tool, UnitMm = unitMm },
            TestContext.Current.CancellationToken);
        Assert.True(outcome.Refusals.Count == 0, string.Join('\n', outcome.Refusals.Select(r => r.Message)));
        return Assert.IsType<OutlineJob>(outcome.Result);
    }
}
