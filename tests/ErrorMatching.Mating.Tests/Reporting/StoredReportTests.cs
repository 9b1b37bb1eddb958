using System.Text;
using System.Text.Json.Nodes;
using ErrorMatching.Geometry;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;
using ErrorMatching.Testing;
using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Mating.Tests;

/// <summary>Reports are read as they were written.</summary>
public sealed class StoredReportTests
{
    private const string Letters = "aZ0 \"\\\n<ö€點";

    private static readonly string[] Labels = ["a", "b", "c", "d", "e"];

    [Fact]
    public void A_random_match_is_read_as_it_was_written() => Check(r => DocumentCheck.IsReadAndWritten(
        MatchReportJson.Write(Match(r)),
        b => MatchReportJson.Write(MatchReportJson.Read(ReportReader.Document(b))),
        // Its numbers are rounded a second time.
        "$.verdict.sentence"));

    [Fact]
    public void A_random_verification_is_read_as_it_was_written() => Check(r => DocumentCheck.IsReadAndWritten(
        VerifyReportJson.Write(Verified(r)),
        b => VerifyReportJson.Write(VerifyReportJson.Read(ReportReader.Document(b))),
        // Small differences of large numbers.
        [.. Enumerable.Range(0, 9).Select(i => $"$.features[{i}].improvementPercent")]));

    [Fact]
    public void A_mutated_match_is_read_or_its_problem_is_named()
    {
        var (read, named) = (0, 0);
        foreach (var (path, json) in DocumentCheck.Mutations(MatchReportJson.Write(Match(new(3)))))
        {
            try
            {
                var report = MatchReportJson.Read(ReportReader.Document(json));
                _ = (report.Prediction.Outside, report.Outside, report.MissesOf(report.Prediction), report.OnCorners);
                read++;
            }
            catch (InputException e)
            {
                Assert.StartsWith("$", Assert.Single(e.Refusals).Place.Path, StringComparison.Ordinal);
                named++;
            }
            catch (Exception e) when (e is not InputException)
            {
                Assert.Fail($"{path}: {e}");
            }
        }

        Assert.True(read > 100 && named > 500, $"{read} read, {named} named");
    }

    [Fact]
    public void A_mutated_verification_is_read_or_its_problem_is_named()
    {
        var (read, named) = (0, 0);
        foreach (var (path, json) in DocumentCheck.Mutations(VerifyReportJson.Write(Verified(new(5)))))
        {
            try
            {
                var report = VerifyReportJson.Read(ReportReader.Document(json));
                _ = (report.Result.Outside, report.Result.WorstAfter, report.Result.RmsImprovementPercent);
                read++;
            }
            catch (InputException e)
            {
                Assert.StartsWith("$", Assert.Single(e.Refusals).Place.Path, StringComparison.Ordinal);
                named++;
            }
            catch (Exception e) when (e is not InputException)
            {
                Assert.Fail($"{path}: {e}");
            }
        }

        Assert.True(read > 50 && named > 300, $"{read} read, {named} named");
    }

    [Theory]
    [InlineData("\"holds\": true,", "", "missing-key", "$.proof")]
    [InlineData("\"decision\": \"compensated\"", "\"decision\": \"postponed\"", "not-one-of", "$.features[0].decision")]
    [InlineData("\"kind\": \"line\"", "\"kind\": \"spiral\"", "not-one-of", "$.features[0].kind")]
    [InlineData("\"feature\": \"L1\"", "\"feature\": \"L9\"", "not-one-of", "$.keyPoints[0].feature")]
    [InlineData("\"point\": \"2\"", "\"point\": \"1\"", "duplicate-name", "$.keyPoints[1].point")]
    [InlineData("\"changedBlocks\": 1", "\"changedBlocks\": -4", "wrong-type", "$.program.changedBlocks")]
    [InlineData("\"changedBlocks\": 1", "\"changedBlocks\": \"4\"", "wrong-type", "$.program.changedBlocks")]
    [InlineData("        -0.02,\n", "        0.5,\n", "reversed-tolerance", "$.features[0].toleranceMm")]
    [InlineData("        -0.02,\n", "", "too-few-items", "$.features[0].toleranceMm")]
    public void A_wrong_member_is_named_by_path_line_and_column(string was, string now, string code, string path)
    {
        var text = Encoding.UTF8.GetString(MatchReportJson.Write(HandMadeReport.Report)).Replace("\r", "", StringComparison.Ordinal);
        var at = text.IndexOf(was, StringComparison.Ordinal);
        Assert.True(at >= 0, text);
        var e = Assert.Throws<InputException>(() => MatchReportJson.Read(
            ReportReader.Document(Encoding.UTF8.GetBytes(text[..at] + now + text[(at + was.Length)..]))));
        var problem = Assert.Single(e.Refusals);
        Assert.Equal((code, path, "report.json"), (problem.Code, problem.Place.Path, e.File));
        var member = text[..at].Count(c => c == '\n') + 1;
        var before = code is "missing-key" or "too-few-items" or "reversed-tolerance" ? 1 : 0;
        Assert.InRange(problem.Place.Line!.Value, member - before, member);
        Assert.True(problem.Place.Column > 1);
    }

    [Fact]
    public void A_report_older_than_codes_and_roles_is_read()
    {
        var json = JsonNode.Parse(MatchReportJson.Write(HandMadeReport.Report))!.AsObject();
        json.Remove("warningCodes");
        json.Remove("outsideLimits");
        json["job"]!.AsObject().Remove("workOrder");
        json["proof"]!.AsObject().Remove("neighborRoles");
        json["proof"]!.AsObject().Remove("marker");
        var report = MatchReportJson.Read(ReportReader.Document(Encoding.UTF8.GetBytes(json.ToJsonString())));
        Assert.Equal(HandMadeReport.Report.Warnings.Select(w => w.Message), report.Warnings.Select(w => w.Message));
        Assert.All(report.Warnings, w => Assert.Equal("", w.Code));
        Assert.Equal(HandMadeReport.Report.Outside.Points, report.Outside.Points);
        Assert.Null(report.Job.WorkOrder);
        Assert.Empty(report.Proof.Neighbors);
    }

    [Fact]
    public void A_verification_older_than_the_points_of_features_is_read()
    {
        var json = JsonNode.Parse(VerifyReportJson.Write(HandMadeReport.Verified))!.AsObject();
        foreach (var feature in json["features"]!.AsArray())
        {
            feature!.AsObject().Remove("points");
        }

        var report = VerifyReportJson.Read(ReportReader.Document(Encoding.UTF8.GetBytes(json.ToJsonString())));
        Assert.All(report.Result.Features, f => Assert.Empty(f.Points));
    }

    [Fact]
    public void A_prediction_is_a_verification_that_is_not_measured_yet()
    {
        var (report, prediction) = (HandMadeReport.Report, HandMadeReport.Report.Prediction);
        Assert.Equal(report.KeyPoints.Select(p => p.Point), prediction.Points.Select(p => p.Label));
        Assert.All(
            report.KeyPoints.Zip(prediction.Points),
            p => Assert.Equal(p.First.UncompensatedMm, p.Second.BeforeError.NormalMm, 9));
        Assert.All(report.KeyPoints.Zip(prediction.Points), p => Assert.Equal(p.First.PredictedMm, p.Second.AfterError.NormalMm, 9));
        Assert.Equal(report.Outside.Points, prediction.Outside.Points);
        Assert.Equal(report.Outside.DrivenOut, prediction.Outside.DrivenOut);
        Assert.All(report.MissesOf(prediction), m => Assert.Equal(0, m.Mm, 9));
    }

    private static void Check(Action<Random> law) =>
        FsCheck.Check.One(
            Config.QuickThrowOnFailure.WithMaxTest(100), Prop.ForAll(Gen.Choose(0, int.MaxValue).ToArbitrary(), seed => law(new(seed))));

    private static MatchReport Match(Random r) => new()
    {
        Job = new(Text(r), Maybe(r, () => Text(r)), "job.json", Text(r)),
        Inputs = Some(r, () => new ReportInput("part", Text(r), Text(r))),
        Alignments = Some(r, () => new ReportAlignment(
            "part",
            One<JobAlignmentKind>(r),
            new(One<Mirror>(r), Angle.FromDegrees(Mm(r)), new(Mm(r), Mm(r))),
            Mm(r),
            Mm(r),
            Some(r, () => new ReportResidual(Text(r), new(Mm(r), Mm(r)))))),
        OriginCheck = Maybe(r, () => new OriginCheck(Text(r), Mm(r), Mm(r))),
        Compensation = new(
            One<CompensationSource>(r), Mm(r), One<CompensationAmount>(r), One<CompensationDirection>(r), Mm(r)),
        Rule = r.Next(3) switch { 0 => null, 1 => DecisionRule.Simple, _ => DecisionRule.GuardBand(1 + r.Next(49)) },
        ProbabilityBefore = r.Next(2) == 0 ? null : r.Next(1001) / 1000.0,
        ProbabilityAfter = r.Next(2) == 0 ? null : r.Next(1001) / 1000.0,
        Uncertainty = new(Some(r, () => new UncertaintyContribution(Text(r), Mm(r)))),
        Chain = Maybe(r, () => new ReportChain(new(12, Band(r)), new(12, Band(r)))),
        Features = [.. Labels[..2].Select(name => Feature(r, name))],
        KeyPoints = [.. Labels.Select((l, i) => KeyPoint(r, l, Labels[i % 2]))],
        Pair = Maybe(r, () => new PairAssembly
        {
            Assembles = r.Next(2) == 0,
            Probability = r.Next(1001) / 1000.0,
            TightestMm = r.Next(2) == 0 ? null : Mm(r),
            Interval95Mm = Range(r),
            Contacts = Some(r, () => new PairContact(Place(r), Text(r), Text(r))),
            Play = Maybe(r, () => new PairPlay(Range(r), Range(r), Range(r))),
            Gaps = Some(r, () => new PairGap(Text(r), Place(r), new(Mm(r), Mm(r)), Mm(r))),
        }),
        Program = new(
            "out/a.nc",
            Text(r),
            r.Next(100),
            r.Next(100),
            Some(r, () => Block(r, Text(r), Text(r)))),
        Proof = new(
            r.Next(2) == 0,
            r.Next(100),
            r.Next(100),
            Some(r, () => new ProofNeighbor(Text(r), r.Next(100), One<NeighborRole>(r), Mm(r))),
            Maybe(r, () => Text(r)),
            Mm(r),
            r.Next(2) == 0),
        Time = new(Mm(r), r.Next(2) == 0 ? null : Mm(r)),
        RadiusWearMm = r.Next(2) == 0 ? null : Mm(r),
        Warnings = Some(r, () => new ReportWarning(Text(r), Text(r), Some(r, () => Text(r)))),
        Notes = Some(r, () => Text(r)),
    };

    private static PlayRange? Range(Random r) => r.Next(2) == 0 ? null : new(Mm(r), Mm(r));

    private static ReportFeature Feature(Random r, string name) => new()
    {
        Name = name,
        Kind = FeatureKinds.All[r.Next(FeatureKinds.All.Count)],
        Tolerance = new(Band(r), One<ToleranceSource>(r)),
        Acceptance = r.Next(2) == 0 ? null : Band(r),
        SignificantMm = r.Next(2) == 0 ? null : Mm(r),
        ProbabilityBefore = r.Next(2) == 0 ? null : r.Next(1001) / 1000.0,
        ProbabilityAfter = r.Next(2) == 0 ? null : r.Next(1001) / 1000.0,
        Quantities = [
            new(new("lengthMm", Mm(r), Mm(r), Mm(r)), r.Next(2) == 0 ? null : Mm(r)), new(new("directionDeg", Mm(r), Mm(r), Mm(r)), null)],
        Decision = One<Decision>(r),
        LargestMm = Mm(r),
        UncertaintyMm = Mm(r),
        ResidualsMm = Some(r, () => Mm(r)),
        Curve = Maybe(r, () => new ReportCurve(r.Next(9), r.NextDouble() * 1e-12, r.Next(2) == 0 ? null : Mm(r), Mm(r))),
        TheoreticalOutline = Some(r, () => Place(r)),
        ActualOutline = Some(r, () => Place(r)),
        StandsOutMm = r.Next(2) == 0 ? null : Mm(r),
    };

    private static ReportKeyPoint KeyPoint(Random r, string label, string feature)
    {
        var theoretical = Place(r);
        return new()
        {
            Point = label,
            Feature = feature,
            Theoretical = theoretical,
            Actual = Near(r, theoretical),
            Counterpart = r.Next(2) == 0 ? null : Place(r),
            Normal = Vector2.FromDirection(Angle.FromDegrees(Mm(r))),
            Correction = new(Mm(r), Mm(r)),
            DecidedMm = Mm(r),
            UncompensatedMm = Mm(r),
            ExcessMm = Mm(r),
            ProbabilityBefore = r.Next(2) == 0 ? null : r.Next(1001) / 1000.0,
            ProbabilityAfter = r.Next(2) == 0 ? null : r.Next(1001) / 1000.0,
            PredictedMm = Mm(r),
            Interval95Mm = Mm(r),
            Blocks = Some(r, () => Text(r)),
        };
    }

    private static VerifyReport Verified(Random r)
    {
        VerifiedPoint[] points = [
            .. Labels.Select(l => (Label: l, Part: Place(r))).Select(p => new VerifiedPoint(
                p.Label, p.Part, Near(r, p.Part), Near(r, p.Part), Vector2.FromDirection(Angle.FromDegrees(Mm(r)))))];
        return new(
            new(Text(r), Maybe(r, () => Text(r)), "job.json", Text(r)),
            Some(r, () => new ReportInput("part", Text(r), Text(r))),
            new(
                points,
                Some(r, () => new VerifiedFeature(
                    Text(r), VerifiedQuantity.All[r.Next(VerifiedQuantity.All.Count)], Mm(r), Mm(r), Mm(r))
                {
                    Points = Some(r, () => Text(r)),
                    ChangeUncertainty = r.Next(2) == 0 ? null : Mm(r),
                }))
            {
                Boundaries = [
                    .. Labels.Take(r.Next(Labels.Length)).Chunk(2).Select(
                        l => new VerifiedBoundary(Text(r), Band(r), [.. l.Select(p => (p, Place(r)))], Some(r, () => Place(r))))],
            },
            Some(r, () => Text(r)))
        {
            IsBeforeMeasured = r.Next(2) == 0,
        };
    }

    private static T[] Some<T>(Random r, Func<T> one) => [.. Enumerable.Range(0, r.Next(4)).Select(_ => one())];

    private static T? Maybe<T>(Random r, Func<T> one)
        where T : class => r.Next(2) == 0 ? null : one();

    private static T One<T>(Random r)
        where T : struct, Enum => Enum.GetValues<T>() is var all ? all[r.Next(all.Length)] : default;

    private static string Text(Random r) => string.Concat(Enumerable.Range(0, r.Next(1, 6)).Select(_ => Letters[r.Next(Letters.Length)]));

    private static ReportBlock Block(Random r, string original, string modified) =>
        new(Text(r), r.Next(100), original, modified, Spans(r, original), Spans(r, modified));

    private static TextSpan[] Spans(Random r, string text) => Some(r, () => r.Next(text.Length + 1) is var start
        ? new TextSpan(start, r.Next(text.Length - start + 1))
        : default);

    private static Point2 Place(Random r) => new(100 * Mm(r), 100 * Mm(r));

    private static Point2 Near(Random r, Point2 place) => place + new Vector2(r.NextDouble() - 0.5, r.NextDouble() - 0.5);

    private static ToleranceBand Band(Random r) => new(-r.NextDouble(), r.NextDouble());

    private static double Mm(Random r) => (r.NextDouble() - 0.5) * Math.Pow(10, r.Next(-6, 2));
}
