using System.Text;
using System.Text.Json.Nodes;
using ErrorMatching.Geometry;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;
using ErrorMatching.Testing;
using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Freeform.Tests;

/// <summary>Reports of surfaces are read as they were written.</summary>
public sealed class StoredSurfaceTests
{
    [Fact]
    public void A_random_compensation_is_read_as_it_was_written() => FsCheck.Check.One(
        Config.QuickThrowOnFailure.WithMaxTest(100),
        Prop.ForAll(
            Gen.Choose(0, int.MaxValue).ToArbitrary(), seed => DocumentCheck.IsReadAndWritten(Random(new(seed)).Write(), Again)));

    [Fact]
    public void A_mutated_compensation_is_read_or_its_problem_is_named()
    {
        var (read, named) = (0, 0);
        foreach (var (path, json) in DocumentCheck.Mutations(Random(new(7)).Write()))
        {
            try
            {
                read += CompensationDocument.Read(ReportReader.Document(json))?.Findings.Predicted is null ? 0 : 1;
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

    [Theory]
    [InlineData("verdict", "\"chaos\"", "not-one-of", "$.structure.verdict")]
    [InlineData("method", "\"magic\"", "not-one-of", "$.compensation.method")]
    [InlineData("stage", "\"roughing\"", "not-one-of", "$.stage")]
    [InlineData("countU", "3", "too-few-items", "$.map.x")]
    [InlineData("countV", "1", "too-many-items", "$.map.x")]
    [InlineData("outside", "[1]", "too-large", "$.map.outside")]
    [InlineData("nominal", "[1, 2]", "too-few-items", "$.points[0].nominal")]
    [InlineData("passes", "1.5", "wrong-type", "$.toolpath.passes")]
    public void A_wrong_member_is_named_by_its_path(string member, string now, string code, string path)
    {
        var json = JsonNode.Parse(Random(new(7)).Write())!;
        json["points"] = new JsonArray(json["points"]![0]!.DeepClone());
        var owner = new[] { json, json["structure"]!, json["compensation"]!, json["map"]!, json["points"]![0]!, json["toolpath"]! }
            .Last(o => o.AsObject().ContainsKey(member));
        owner[member] = JsonNode.Parse(now);
        var e = Assert.Throws<InputException>(
            () => CompensationDocument.Read(ReportReader.Document(Encoding.UTF8.GetBytes(json.ToJsonString()))));
        Assert.Equal((code, path), Assert.Single(e.Refusals) is var problem ? (problem.Code, problem.Place.Path) : default);
    }

    [Fact]
    public void A_report_older_than_the_tool_call_and_the_program_that_cut_the_piece_is_read()
    {
        var json = JsonNode.Parse(Random(new(7)).Write())!;
        json.AsObject().Remove("cutBy");
        json["program"]!.AsObject().Remove("toolCall");
        var document = CompensationDocument.Read(ReportReader.Document(Encoding.UTF8.GetBytes(json.ToJsonString())))!;
        Assert.Equal((null, new MeasuredPieceProgram(null, null)), (document.CallsTool, document.Findings.CutBy));
    }

    [Fact]
    public void A_report_older_than_the_map_is_no_document()
    {
        var json = JsonNode.Parse(Random(new(7)).Write())!;
        json.AsObject().Remove("map");
        Assert.Null(CompensationDocument.Read(ReportReader.Document(Encoding.UTF8.GetBytes(json.ToJsonString()))));
    }

    internal static byte[] Again(byte[] json) => CompensationDocument.Read(ReportReader.Document(json))!.Write();

    private static CompensationDocument Random(Random r) => new()
    {
        Job = new("Fläche", r.Next(2) == 0 ? null : "WO-1", "job.json", "aa"),
        Inputs = [new("measured", "measured.csv", "bb")],
        Findings = Findings(r),
        ToolPath = new(r.Next(9), r.Next(99), Mm(r), Mm(r), Mm(r), Mm(r), r.Next(9), Mm(r)),
        ProgramFile = "out/finishing.nc",
        ProgramSha256 = "cc",
        CallsTool = r.Next(3) switch { 0 => null, var n => n == 1 },
        Warnings = [new("", "w"), new("noise-only", "\"quoted\"", "> 0.05")],
        Notes = [],
        CalculatingS = r.Next(2) == 0 ? null : Mm(r),
    };

    private static SurfaceFindings Findings(Random r)
    {
        ErrorSample[] samples = [
            .. Enumerable.Range(0, 3).Select(i => new ErrorSample(
                i + 1, i, 0, r.NextDouble(), r.NextDouble(), new(Mm(r), Mm(r), Mm(r)), new(Mm(r), Mm(r), Mm(r)), Mm(r)))];
        var verdict = (SpatialVerdict)r.Next(3);
        var pieces = r.Next(3) == 0 ? null : new MeasuredLot(["1", "2", "3"], [Piece(r), Piece(r)], [Mm(r), Mm(r), Mm(r)]);
        return new()
        {
            CutBy = r.Next(2) == 0 ? new(null, null) : new("nominal.nc", "dd") { Previous = r.Next(2) == 0 ? null : "before/report.json" },
            Verdict = r.Next(2) == 0 ? null : Verdict(r),
            Alignment = r.Next(2) == 0 ? null : new(new(Mm(r), Mm(r), Mm(r)), new(Mm(r), Mm(r), Mm(r)), new(Mm(r), Mm(r), Mm(r))),
            Motion = r.Next(2) == 0 ? null : new(new(Mm(r), Mm(r), Mm(r)), new(Mm(r), Mm(r), Mm(r)), Mm(r), r.Next(2) == 0, Mm(r), Mm(r))
            {
                ShiftUncertaintyMm = new(Mm(r), Mm(r), Mm(r)),
                TurnUncertaintyDegrees = new(Mm(r), Mm(r), Mm(r)),
            },
            Stage = r.Next(2) == 0 ? CuttingStage.Finishing : CuttingStage.SemiFinishing,
            Before = Statistics(r),
            Structure = new(Mm(r), Mm(r), double.NaN, Mm(r), Mm(r), verdict),
            IsMirror = r.Next(2) == 0,
            Gain = Mm(r),
            LimitMm = Mm(r),
            OfError = r.Next(2) == 0,
            Fit = "best",
            LargestMoveMm = Mm(r),
            Model = "polynomial",
            FieldFit = r.Next(2) == 0 ? null : new([Mm(r)], [], r.Next(2) == 0 ? null : Mm(r), Mm(r), null),
            Surface = new("s", 3, 2, r.Next(99), r.Next(99), Mm(r)),
            Mirror = Prediction(r, "mirror"),
            ToolRadius = Prediction(r, "tool-radius"),
            Samples = samples,
            Compensated = [.. samples.Select(_ => new Point3(Mm(r), Mm(r), Mm(r)))],
            Map = new(
                new(2, 2, [.. Enumerable.Range(0, 4).Select(_ => new Point3(Mm(r), Mm(r), Mm(r)))], r.Next(2) == 0 ? [] : [0]),
                [Mm(r), Mm(r), Mm(r), Mm(r)],
                [Mm(r), Mm(r), Mm(r), Mm(r)],
                [Mm(r), Mm(r), Mm(r), Mm(r)]),
            Pieces = pieces,
            Lot = pieces is null || r.Next(2) == 0 ? null
                : new([Mm(r), Mm(r), Mm(r)], [Mm(r), Mm(r), Mm(r)], Mm(r), Mm(r), Mm(r), [Found(r), Found(r)]),
        };
    }

    private static RecordedPiece Piece(Random r) => new("ee", Mm(r), new([Mm(r), Mm(r), Mm(r)], [Mm(r), Mm(r), Mm(r)]));

    private static LotFinding Found(Random r) => new(Mm(r), Mm(r), r.NextDouble(), r.NextDouble());

    private static SurfaceVerdict Verdict(Random r) => new(
        new(0.02, r.Next(2) == 0 ? DecisionRule.Simple : DecisionRule.GuardBand(5), r.Next(2) == 0),
        Judgement(r, null),
        Judgement(r, Mm(r)));

    private static ProfileJudgement Judgement(Random r, double? anywhereMm) => new()
    {
        Code = (ProfileCode)r.Next(4),
        ProfileMm = Math.Abs(Mm(r)),
        Points = r.Next(1, 99),
        Outside = [.. Enumerable.Range(1, r.Next(1, 9))],
        NotAccepted = [.. Enumerable.Range(1, r.Next(1, 9))],
        WorstPoint = r.Next(99),
        WorstMm = Mm(r),
        WorstAnywhereMm = anywhereMm,
        UncertaintyMm = Math.Abs(Mm(r)),
        Probability = r.NextDouble(),
    };

    private static SurfacePrediction Prediction(Random r, string method) =>
        new(method, [Mm(r), Mm(r), Mm(r)], Statistics(r), Mm(r), Mm(r));

    private static DeviationStatistics Statistics(Random r) => new(r.Next(99), Mm(r), Mm(r), Mm(r), Mm(r));

    private static double Mm(Random r) => (r.NextDouble() - 0.5) * Math.Pow(10, r.Next(-6, 3));
}
