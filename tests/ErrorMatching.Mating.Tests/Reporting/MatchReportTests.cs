using System.Globalization;
using System.Text;
using System.Text.Json;
using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating.Tests;

public sealed class MatchReportTests
{
    private static readonly ReportFeature Curve = new()
    {
        Name = "C1",
        Kind = CurveKind.Instance,
        Tolerance = new(new(-0.05, 0.05), ToleranceSource.RootSumOfSquares),
        Quantities = [new(new("lengthMm", 17.5, 17.82, 0.003), 17.6), new(new("directionDeg", 179, -179, 0.1), null)],
        Decision = Decision.Compensated,
        LargestMm = -0.118,
        UncertaintyMm = 0.0054,
        Acceptance = new(-0.041, 0.041),
        SignificantMm = 0.0159,
        ProbabilityBefore = 0.25,
        ResidualsMm = [0.1 + 0.2, -0.0],
        Curve = new(4, 1e-12, null, 0.002),
        TheoreticalOutline = [new(1, 2)],
        ActualOutline = [new(1.1, 2), new(3, 4)],
        StandsOutMm = 0.5,
    };

    private static readonly ReportKeyPoint Point = new()
    {
        Point = "0",
        Feature = "C1",
        Theoretical = new(48.05, 76.008),
        Actual = new(47.932, 76.004),
        Normal = new(1, 0),
        Correction = new(-0.118, 0),
        DecidedMm = -0.118,
        UncompensatedMm = 0.118,
        ExcessMm = -0.068,
        ProbabilityBefore = 0.5,
        PredictedMm = 0.0002,
        Blocks = ["N8960"],
    };

    private static readonly MatchReport Report = new()
    {
        Job = new("Größe <1>", null, "job.json", "aa"),
        Inputs = [new("part", "part.csv", "bb"), new("program", "counterpart.nc", "cc")],
        Alignments = [
            new(
                "part",
                JobAlignmentKind.BestFit,
                new(Mirror.None, Angle.FromDegrees(0.5), new(1, 2)),
                0.01,
                0.02,
                [new("0", new(0.003, -0.004))]),
            new("counterpart", JobAlignmentKind.None, default, 0, 0, [])],
        OriginCheck = new("O", 0.005, 0.01),
        Compensation = new(CompensationSource.Counterpart, 0.5, CompensationAmount.Excess, CompensationDirection.Vector, 0.4),
        Rule = DecisionRule.GuardBand(2.5),
        ProbabilityBefore = 0.125,
        Uncertainty = new([new("probing", 0.003), new("clamping", 0.004)]),
        Chain = ReportChain.Of(new([new("a", 10, new(-0.03, 0.03), 1)])),
        Features = [
            Curve,
            Curve with { Name = "L1", Kind = LineKind.Instance, Decision = Decision.WithinTolerance, Curve = null, StandsOutMm = null },
            Curve with { Name = "T1", Kind = TriangleKind.Instance, Decision = Decision.NotSignificant }],
        KeyPoints = [Point, Point with { Counterpart = new(1, 2) }],
        Program = new("out/counterpart.nc", "dd", 1, 2, [new("N8960", 7, "N8960 X-34.995", "N8960 X-34.965", [new(6, 8)], [new(6, 8)])]),
        Proof = new(true, 12, 3, [new("N8950", 3, NeighborRole.Slides, 0.0151)], null, 0.0004, true),
        Time = new(8, 0.0012),
        RadiusWearMm = 0.02,
        Warnings = [new("sparse-points", "w", "C1", "3")],
        Notes = ["n"],
    };

    [Fact]
    public void The_report_has_what_the_contract_promises()
    {
        var json = Parse(Report);

        Assert.Equal("errormatch/match/1", Text(json, "schema"));
        Assert.Equal("mating|Größe <1>|null|job.json|aa", Text(json, "job.kind", "job.name", "job.workOrder", "job.file", "job.sha256"));
        Assert.Equal("part|part.csv|bb|program", Text(json, "inputs.0.role", "inputs.0.file", "inputs.0.sha256", "inputs.1.role"));
        Assert.Equal(
            "part|best-fit|0.5|1|2|none|0.01|0.02|0|0.003|-0.004",
            Text(
                json,
                "alignment.of",
                "alignment.kind",
                "alignment.transform.rotateDeg",
                "alignment.transform.translateMm.0",
                "alignment.transform.translateMm.1",
                "alignment.transform.mirror",
                "alignment.rmsMm",
                "alignment.maxMm",
                "alignment.residuals.0.point",
                "alignment.residuals.0.x",
                "alignment.residuals.0.y"));
        Assert.Equal("counterpart|none", Text(json, "alignment.others.0.of", "alignment.others.0.kind"));
        Assert.Equal(
            "O|0.005|0.01|true", Text(json, "originCheck.point", "originCheck.distanceMm", "originCheck.limitMm", "originCheck.holds"));
        Assert.Equal(
            "counterpart|0.5|excess|vector|0.4",
            Text(json, "compensation.from", "compensation.gain", "compensation.amount", "compensation.along", "compensation.limitMm"));
        Assert.Equal(
            "guard-band|2.5|0.125|-0.041|0.041|0.0159|0.25|0.5",
            Text(
                json,
                "decisionRule.rule",
                "decisionRule.riskPercent",
                "probabilityBefore",
                "features.0.acceptanceMm.0",
                "features.0.acceptanceMm.1",
                "features.0.significantMm",
                "features.0.probabilityBefore",
                "keyPoints.0.probabilityBefore"));
        Assert.Equal(
            "0.005|clamping|0.004",
            Text(json, "uncertainty.combinedMm", "uncertainty.contributions.1.name", "uncertainty.contributions.1.valueMm"));
        Assert.Equal(
            "w|sparse-points|C1|3", Text(json, "warnings.0", "warningCodes.0.code", "warningCodes.0.values.0", "warningCodes.0.values.1"));
        Assert.Equal(
            "10|9.97|10.03|9.97",
            Text(
                json,
                "toleranceChain.nominalMm",
                "toleranceChain.worstCase.smallestMm",
                "toleranceChain.worstCase.largestMm",
                "toleranceChain.rootSumOfSquares.smallestMm"));
        Assert.Equal(
            "out/counterpart.nc|dd|1|2", Text(json, "program.file", "program.sha256", "program.changedBlocks", "program.changedWords"));
        Assert.Equal(
            "N8960|7|N8960 X-34.995|N8960 X-34.965|6|8|8",
            Text(
                json,
                "program.blocks.0.number",
                "program.blocks.0.line",
                "program.blocks.0.original",
                "program.blocks.0.modified",
                "program.blocks.0.originalSpans.0.start",
                "program.blocks.0.originalSpans.0.length",
                "program.blocks.0.modifiedSpans.0.length"));
        Assert.Equal(
            "true|12|3|N8950|null|0.0004|true",
            Text(
                json,
                "proof.holds",
                "proof.motions",
                "proof.movedMotions",
                "proof.neighbors.0",
                "proof.marker",
                "proof.maxDeviationFromWantedMm",
                "proof.untouchedBytesIdentical"));
        Assert.Equal(
            "N8950|3|slides|0.0151",
            Text(
                json,
                "proof.neighborRoles.0.block",
                "proof.neighborRoles.0.line",
                "proof.neighborRoles.0.role",
                "proof.neighborRoles.0.displacementMm"));
        Assert.Equal("8|0.0012|0.02|w|n", Text(json, "time.measuringS", "time.calculatingS", "radiusWearMm", "warnings.0", "notes.0"));
    }

    [Fact]
    public void Features_are_reported_as_decided()
    {
        var json = Parse(Report);

        Assert.Equal(
            "C1|curve|compensated|L1|line|within-tolerance|T1|triangle|not-significant",
            Text(
                json,
                "features.0.name",
                "features.0.kind",
                "features.0.decision",
                "features.1.name",
                "features.1.kind",
                "features.1.decision",
                "features.2.name",
                "features.2.kind",
                "features.2.decision"));
        Assert.Equal(
            "17.5|17.82|-0.32|17.6|0.003",
            Text(
                json,
                "features.0.theoretical.lengthMm",
                "features.0.actual.lengthMm",
                "features.0.deviation.lengthMm",
                "features.0.corrected.lengthMm",
                "features.0.uncertainty.lengthMm"));
        Assert.Equal("-2|null", Text(json, "features.0.deviation.directionDeg", "features.0.corrected.directionDeg"));
        Assert.Equal(
            "-0.05|0.05|chain:rss|-0.118|0.0054",
            Text(
                json,
                "features.0.toleranceMm.0",
                "features.0.toleranceMm.1",
                "features.0.toleranceFrom",
                "features.0.largestMm",
                "features.0.uncertaintyMm"));
        Assert.Equal(
            "4|1E-12|null|0.002|null",
            Text(
                json,
                "features.0.fit.degree",
                "features.0.fit.ridge",
                "features.0.fit.leaveOneOutMm",
                "features.0.fit.residualStandardDeviationMm",
                "features.1.fit"));
        Assert.Equal(
            "0.5|null|1|2|3",
            Text(
                json,
                "features.0.standsOutMm",
                "features.1.standsOutMm",
                "features.0.outline.theoretical.0.x",
                "features.0.outline.theoretical.0.y",
                "features.0.outline.actual.1.x"));
    }

    [Fact]
    public void Key_points_carry_the_signs_of_the_paper()
    {
        var json = Parse(Report);

        // Figure 9: 48.050 - 47.932 = 0.118, theoretical - actual. Along +x the part is 0.118 short.
        Assert.Equal(
            "0|C1|48.05|76.008|47.932|76.004|0.118|0.004|-0.118|0",
            Text(
                json,
                "keyPoints.0.point",
                "keyPoints.0.feature",
                "keyPoints.0.theoretical.x",
                "keyPoints.0.theoretical.y",
                "keyPoints.0.actual.x",
                "keyPoints.0.actual.y",
                "keyPoints.0.deviation.x",
                "keyPoints.0.deviation.y",
                "keyPoints.0.normalMm",
                "keyPoints.0.correction.y"));
        Assert.Equal(
            "-0.118|1|0|-0.118|-0.068|0.0002|N8960",
            Text(
                json,
                "keyPoints.0.correction.x",
                "keyPoints.0.normal.x",
                "keyPoints.0.normal.y",
                "keyPoints.0.decidedMm",
                "keyPoints.0.excessMm",
                "keyPoints.0.predictedMm",
                "keyPoints.0.blocks.0"));
        Assert.False(json.GetProperty("keyPoints")[0].TryGetProperty("counterpart", out _));
        Assert.Equal("1|2", Text(json, "keyPoints.1.counterpart.x", "keyPoints.1.counterpart.y"));
    }

    [Fact]
    public void Points_outside_their_limits_are_listed_by_whether_the_compensation_is_why()
    {
        // Limits of the part -0.05 to 0.05, deviation 0.04: only what the compensation makes of it is outside.
        var json = Parse(
            Report with
            {
                KeyPoints = [
                    Point with { Point = "1", PredictedMm = 0.051 },
                    Point with { Point = "2", DecidedMm = 0.04, UncompensatedMm = -0.04, PredictedMm = 0.051 },
                    Point]
            });

        Assert.Equal("1|2", Text(json, "outsideLimits.staying.0", "outsideLimits.drivenOut.0"));
        Assert.Equal(
            (1, 1),
            (
                json.GetProperty("outsideLimits").GetProperty("staying").GetArrayLength(),
                json.GetProperty("outsideLimits").GetProperty("drivenOut").GetArrayLength()));
    }

    [Fact]
    public void Numbers_carry_no_noise_of_binary_fractions_and_no_negative_zero() =>
        Assert.Equal("0.3|0", Text(Parse(Report), "features.0.residualsMm.0", "features.0.residualsMm.1"));

    [Fact]
    public void Text_is_utf8_without_mark_and_with_line_feeds_only()
    {
        var bytes = MatchReportJson.Write(Report);

        Assert.Equal((byte)'{', bytes[0]);
        Assert.Equal((byte)'\n', bytes[^1]);
        Assert.DoesNotContain((byte)'\r', bytes);
    }

    [Fact]
    public void What_a_report_does_not_have_is_null()
    {
        var json = Parse(Report with { OriginCheck = null, Chain = null, RadiusWearMm = null });

        Assert.Equal("null|null|null", Text(json, "originCheck", "toleranceChain", "radiusWearMm"));
    }

    [Fact]
    public void A_report_knows_its_fit()
    {
        var fit = CurveFit.Fit([new(0, 0), new(1, 1), new(2, 1.5), new(3, 1), new(4, 0)], new() { Degree = 2 });

        Assert.Equal(new(2, 0, fit.Polynomial.LeaveOneOutRms, fit.ResidualStandardDeviation), ReportCurve.Of(fit));
    }

    [Fact]
    public void A_verification_has_what_the_contract_promises()
    {
        var point = new VerifiedPoint("6", new(1, 1), new(1.3, 1.4), new(1, 1.05), new(0.6, 0.8));
        var result = new VerificationResult(
            [point],
            [
                new("L1", VerifiedQuantity.Length, 17.649, 17.308, 17.562),
                new("C1", VerifiedQuantity.DeviationX, 0, 0, 0),
                new("A", VerifiedQuantity.Angle, 1, 2, 1),
                VerifiedFeature.DeviationOf("B", [point])]);
        var verified = result with
        {
            Boundaries = [new("C1", new(-0.05, 0.02), [("6", new(1, 1.5))], [new(0, 0), new(2, 1)])]
        };
        var json = JsonDocument.Parse(VerifyReportJson.Write(new(Report.Job, Report.Inputs, verified, ["w"]))).RootElement;

        Assert.Equal("errormatch/verify/1|job.json|part", Text(json, "schema", "job.file", "inputs.0.role"));
        Assert.Equal(
            "6|0.3|0.4|0.5|0|0.05|0.04",
            Text(
                json,
                "points.0.point",
                "points.0.before.dx",
                "points.0.before.dy",
                "points.0.before.normalMm",
                "points.0.after.dx",
                "points.0.after.dy",
                "points.0.after.normalMm"));
        Assert.Equal(
            "L1|length|17.649|17.308|17.562|74.486803519",
            Text(
                json,
                "features.0.name",
                "features.0.quantity",
                "features.0.wanted",
                "features.0.before",
                "features.0.after",
                "features.0.improvementPercent"));
        Assert.Equal(
            "deviation-x|null|angle|deviation",
            Text(json, "features.1.quantity", "features.1.improvementPercent", "features.2.quantity", "features.3.quantity"));
        Assert.Equal(["6"], json.GetProperty("features")[3].GetProperty("points").EnumerateArray().Select(p => p.GetString()));
        Assert.Equal(0, json.GetProperty("features")[0].GetProperty("points").GetArrayLength());
        Assert.Equal("0.5|0.04|0.5|0.04|w", Text(json, "maxBeforeMm", "maxAfterMm", "rmsBeforeMm", "rmsAfterMm", "warnings.0"));
        Assert.Equal("1|0.8", Text(json, "points.0.part.x", "points.0.normal.y"));
        Assert.Equal(
            "C1|-0.05|0.02|6|1.5|2",
            Text(
                json,
                "boundaries.0.name",
                "boundaries.0.toleranceMm.0",
                "boundaries.0.toleranceMm.1",
                "boundaries.0.points.0.point",
                "boundaries.0.points.0.theoretical.y",
                "boundaries.0.outline.1.x"));
    }

    private static JsonElement Parse(MatchReport report) => JsonDocument.Parse(MatchReportJson.Write(report)).RootElement;

    /// <summary>The values at some dotted paths, as they are written.</summary>
    private static string Text(JsonElement root, params string[] paths)
    {
        var values = new StringBuilder();
        foreach (var path in paths)
        {
            var at = root;
            foreach (var step in path.Split('.'))
            {
                at = at.ValueKind == JsonValueKind.Array ? at[int.Parse(step, CultureInfo.InvariantCulture)] : at.GetProperty(step);
            }

            values.Append(values.Length > 0 ? "|" : "").Append(at.ValueKind == JsonValueKind.String ? at.GetString() : at.GetRawText());
        }

        return values.ToString();
    }
}
