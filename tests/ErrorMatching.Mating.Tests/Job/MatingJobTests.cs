using System.Text;
using ErrorMatching.Geometry;
using ErrorMatching.Json;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;

namespace ErrorMatching.Mating.Tests;

public sealed class MatingJobTests
{
    [Fact]
    public void A_job_is_read_with_its_defaults()
    {
        var job = SampleJob.With();

        Assert.Equal(("Complex mating", "WO-1", "folder/job.json"), (job.Name, job.WorkOrder, job.File));
        Assert.Equal(new JobPart("theoretical.csv", "part.csv"), job.Part);
        Assert.Equal(
            (0.002, ProbeReport.Contact, (double?)null), (job.Gauge.Uncertainty.CombinedMm, job.Gauge.Reports, job.Gauge.StylusDiameterMm));
        Assert.Same(MeasurementFormat.Points, job.Gauge.Format);
        Assert.Equal(new MeasuringTime(10, 5, 1), job.Gauge.Measuring);
        Assert.Equal(JobAlignment.None, job.Alignment);
        Assert.Equal(
            new JobCompensation(CompensationSource.Part, 1, CompensationAmount.Whole, CompensationDirection.Normal, 1), job.Compensation);
        Assert.Equal(
            ("counterpart.nc", "delta-nc300", 6.0, (string?)null, 0.5),
            (
                job.Counterpart.Program,
                job.Counterpart.Dialect,
                job.Counterpart.ToolDiameterMm,
                job.Counterpart.Measured,
                job.Counterpart.MapMm));
        Assert.Equal(RigidTransform2.Translate(new(-80, 0)), job.Counterpart.Frame);
        Assert.Null(job.OriginCheck);
        Assert.Null(job.Chain);
        Assert.Null(job.Recognition);
        Assert.Empty(job.Verify);
    }

    [Fact]
    public void Features_are_read_in_their_order_with_ranges_expanded()
    {
        var job = SampleJob.With();

        Assert.Equal([LineKind.Instance, TriangleKind.Instance, CurveKind.Instance], job.Features.Select(f => f.Kind));
        Assert.Equal(["1", "2", "2a", "3a", "3b", "4", "5", "6", "7", "8", "9", "10", "11", "12", "13", "14"], job.KeyPoints);
        var triangle = Assert.IsType<TriangleFeature>(job.Features[1]);
        Assert.Equal(["2a", "3a"], triangle.FirstFlank);
        Assert.Equal(["3b", "4"], triangle.SecondFlank);
        Assert.Equal((new ToleranceBand(-0.04, 0.06), ToleranceSource.Stated), (triangle.Tolerance.Band, triangle.Tolerance.Source));
        Assert.Equal(["N110..N130"], triangle.Blocks);
        Assert.Equal(["/^N8[0-9]{3}\\b/"], job.Features[2].Blocks);
        var curve = Assert.IsType<CurveFeature>(job.Features[2]);
        Assert.Equal((null, null, CoordinatePlane.XY), (curve.Degree, curve.Ridge, curve.Plane));
        Assert.Equal(LineMethod.Total, Assert.IsType<LineFeature>(job.Features[0]).Method);
    }

    [Fact]
    public void Every_key_of_a_job_is_read()
    {
        var job = SampleJob.With(
            ("\"uncertaintyMm\": 0.002", """
                "uncertaintyMm": [{ "name": "probing", "valueMm": 0.003 }, { "name": "clamping", "valueMm": 0.004 }],
                "acceptCoarse": true, "reports": "stylus-center", "stylusDiameterMm": 2, "measuring": { "probingSpeedMmPerS": 4, "probingDistanceMm": 2, "calculatingS": 0.5 }
                """),
            ("\"format\": \"points\"", "\"format\": { \"delimiter\": \";\", /* German */ \"decimalComma\": true, }"),
            (
                "{ \"kind\": \"none\" }",
                """{ "kind": "best-fit", "locked": ["x", "rotation"] }, "originCheck": { "point": "O", "limitMm": 0.01 }"""),
            ("\"points\": [\"1\", \"2\"]", "\"points\": [\"1\", \"2\"], \"method\": \"ols\", \"plane\": \"ZX\""),
            ("\"points\": [\"5..14\"]", "\"points\": [\"5..14\"], \"degree\": 4, \"ridge\": 0.5, \"plane\": \"YZ\""),
            ("\"toleranceMm\": [-0.04, 0.06]", "\"toleranceMm\": \"chain:rss\""),
            ("\"frame\": { \"mirror\": \"none\", \"rotateDeg\": 0, \"translateMm\": [-80, 0] }", """
                "measured": "counterpart.csv", "mapMm": 0.2, "frame": { "mirror": "x", "rotateDeg": 90, "translateMm": [1, 2] }
                """),
            ("{ \"from\": \"part\" }", """
                { "from": "counterpart", "gain": 0.5, "amount": "excess", "along": "vector", "limitMm": 0.4 },
                "decision": { "rule": "guard-band", "riskPercent": 2.5 },
                "toleranceChain": [{ "name": "a", "nominalMm": 10, "toleranceMm": [-0.03, 0.03], "sign": 1 }, { "name": "b", "nominalMm": 4, "toleranceMm": [-0.04, 0.04], "sign": -1 }],
                "recognition": { "part": [{ "in": "file-name", "pattern": "^part" }], "counterpart": [{ "in": "header", "name": "Piece", "pattern": "c" }, { "in": "column", "name": "side", "pattern": "c" }] },
                "verify": [
                  { "name": "L1-L2", "quantity": "angle", "between": ["L1", "L2L3/1"] },
                  { "name": "inner", "quantity": "deviation-x", "points": ["6..7", "14"] },
                  { "name": "all", "quantity": "deviation", "points": ["1"] }
                ]
                """));

        Assert.Equal(0.005, job.Gauge.Uncertainty.CombinedMm, 12);
        Assert.Equal(
            (ProbeReport.StylusCenter, 2.0, new MeasuringTime(4, 2, 0.5)),
            (job.Gauge.Reports, job.Gauge.StylusDiameterMm, job.Gauge.Measuring));
        Assert.Equal((';', true), (job.Gauge.Format.Delimiter, job.Gauge.Format.DecimalComma));
        Assert.Equal(new JobAlignment(JobAlignmentKind.BestFit, null, null, true, false, true), job.Alignment);
        Assert.Equal(new JobOriginCheck("O", 0.01), job.OriginCheck);
        Assert.Equal(
            (LineMethod.Ordinary, CoordinatePlane.ZX), (Assert.IsType<LineFeature>(job.Features[0]).Method, job.Features[0].Plane));
        var curve = Assert.IsType<CurveFeature>(job.Features[2]);
        Assert.Equal((4, 0.5, CoordinatePlane.YZ), (curve.Degree, curve.Ridge, curve.Plane));
        Assert.Equal(ToleranceSource.RootSumOfSquares, job.Features[1].Tolerance.Source);
        Assert.Equal(0.05, job.Features[1].Tolerance.Band.UpperMm, 12);
        Assert.Equal(6, job.Chain!.NominalMm);
        Assert.Equal(
            ("counterpart.csv", 0.2, new RigidTransform2(Mirror.X, Angle.FromDegrees(90), new(1, 2))),
            (job.Counterpart.Measured, job.Counterpart.MapMm, job.Counterpart.Frame));
        Assert.Equal(
            new JobCompensation(CompensationSource.Counterpart, 0.5, CompensationAmount.Excess, CompensationDirection.Vector, 0.4),
            job.Compensation);
        Assert.Equal((DecisionRule.GuardBand(2.5), true), (job.Rule, job.Gauge.AcceptsCoarse));
        Assert.NotNull(job.Recognition);
        Assert.Equal(new AngleComparison("L1-L2", new("L1", null), new("L2L3", 1)), job.Verify[0]);
        var inner = Assert.IsType<DeviationComparison>(job.Verify[1]);
        Assert.Equal((true, "6 7 14"), (inner.AlongX, string.Join(' ', inner.Points)));
        Assert.False(Assert.IsType<DeviationComparison>(job.Verify[2]).AlongX);
        Assert.Equal("O", job.NeededPoints[^1]);
    }

    [Fact]
    public void The_rule_is_simple_unless_a_job_has_guard_bands()
    {
        Assert.Equal((DecisionRule.Simple, false), (SampleJob.With().Rule, SampleJob.With().Gauge.AcceptsCoarse));
        Assert.Equal(DecisionRule.Simple, With("""{ "rule": "simple" }"""));
        Assert.Equal(DecisionRule.GuardBand(5), With("""{ "rule": "guard-band" }"""));

        static DecisionRule With(string decision) =>
            SampleJob.With(("\"compensation\"", $"\"decision\": {decision}, \"compensation\"")).Rule;
    }

    [Fact]
    public void A_datum_adds_its_points_to_the_needed_ones()
    {
        var job = SampleJob.With(("{ \"kind\": \"none\" }", """{ "kind": "datum", "origin": "O", "direction": "1" }"""));

        Assert.Equal(new JobAlignment(JobAlignmentKind.Datum, "O", "1", false, false, false), job.Alignment);
        Assert.Equal(["O"], job.NeededPoints.Except(job.KeyPoints));
    }

    [Fact]
    public void Paths_start_from_the_folder_of_the_job()
    {
        var job = SampleJob.With();

        Assert.Equal(Path.Combine("folder", "part.csv"), job.PathOf("part.csv"));
        Assert.Equal(Path.GetFullPath("/part.csv"), job.PathOf(Path.GetFullPath("/part.csv")));
        Assert.Equal("part.csv", MatingJob.Parse(Encoding.UTF8.GetBytes(SampleJob.Text), "job.json").PathOf("part.csv"));
    }

    [Fact]
    public void A_job_is_identified_by_its_bytes()
    {
        Assert.Equal(64, SampleJob.With().Sha256.Length);
        Assert.NotEqual(SampleJob.With().Sha256, SampleJob.With(("WO-1", "WO-2")).Sha256);
    }

    [Fact]
    public void A_job_that_is_no_json_is_refused_by_place()
    {
        var e = Assert.Throws<InputException>(() => MatingJob.Parse("{ \"kind\": mating }"u8, "x"));

        Assert.Equal(("not-json", 1, 11), (e.Refusals[0].Code, e.Refusals[0].Place.Line, e.Refusals[0].Place.Column));
    }

    [Fact]
    public void A_job_is_read_from_a_file()
    {
        var path = Path.GetTempFileName();
        try
        {
            File.WriteAllText(path, SampleJob.Text);
            Assert.Equal(SampleJob.With().Sha256, MatingJob.Read(path).Sha256);
        }
        finally
        {
            File.Delete(path);
        }
    }

    [Fact]
    public void The_template_passes_its_own_check()
    {
        var job = MatingJob.Parse(Encoding.UTF8.GetBytes(JobTemplate.Text), "job.json");

        Assert.Equal(3, job.Features.Count);
        Assert.Equal(new(-0.05, 0.05), job.Features[2].Tolerance.Band);
    }

    [Fact]
    public void Every_example_of_the_schema_passes_the_rule_beside_it()
    {
        var schema = JsonInput.Read(Encoding.UTF8.GetBytes(JobTemplate.Schema), "mating.schema.json");
        var definitions = schema["$defs"].ToJson();
        var examples = 0;
        Visit(schema);
        Assert.True(examples > 20);

        void Visit(JsonItem rule)
        {
            foreach (var example in rule.Find("examples")?.Items ?? [])
            {
                var json = rule.ToJson();
                var own = JsonSchema.Parse(Encoding.UTF8.GetBytes(json[..^1] + ",\"$defs\":" + definitions + "}"), "rule");
                Assert.Empty(own.Check(example));
                examples++;
            }

            foreach (var member in rule.Members.Where(m => m.Name is not ("examples" or "default")))
            {
                Visit(member.Value);
            }

            foreach (var item in rule.Items)
            {
                Visit(item);
            }
        }
    }
}
