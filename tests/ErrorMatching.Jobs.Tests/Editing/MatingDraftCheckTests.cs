using ErrorMatching.Mating;
using ErrorMatching.Refusals;
using ErrorMatching.Testing;

namespace ErrorMatching.Jobs.Tests;

/// <summary>Every mistake is found by the reader of the file and told at the field of the draft.</summary>
public sealed class MatingDraftCheckTests
{
    private static readonly string File = Repository.PathTo("samples", "complex-mating", "job.json");

    private static readonly DraftProgram NoProgram = DraftProgram.Of("point,x_mm,y_mm\n1,2,3\n"u8.ToArray());

    private static readonly DraftProgram Own = DraftProgram.Of(
        System.IO.File.ReadAllBytes(Repository.PathTo("samples", "complex-mating", "counterpart.nc")));

    private static readonly Dictionary<string, (Func<MatingDraft, MatingDraft> Mistake, string Field, string Code)> Mistakes = new()
    {
        ["no name"] = (d => d with { Name = " " }, "$.name", "too-short"),
        ["uncertainty missing"] = (d => d.With("$.gauge.uncertaintyMm", ""), "$.gauge.uncertaintyMm", "wrong-type"),
        ["uncertainty negative"] = (d => d.With("$.gauge.uncertaintyMm", "-1"), "$.gauge.uncertaintyMm", "too-small"),
        ["stylus missing"] = (
            d => d.With("$.gauge.reports", "stylus-center"), "$.gauge.stylusDiameterMm", "stylus-diameter-missing"),
        ["format unknown"] = (d => d.With("$.gauge.format", "table"), "$.gauge.format", "bad-format"),
        ["tool zero"] = (
            d => d.With("$.counterpart.toolDiameterMm", "0"), "$.counterpart.toolDiameterMm", "too-small"),
        ["tool text"] = (
            d => d.With("$.counterpart.toolDiameterMm", "6 mm"), "$.counterpart.toolDiameterMm", "wrong-type"),
        ["rotation text"] = (
            d => d.With("$.counterpart.frame.rotateDeg", "1,5"), "$.counterpart.frame.rotateDeg", "wrong-type"),
        ["half a translation"] = (
            d => d.With("$.counterpart.frame.translateMm[0]", ""), "$.counterpart.frame.translateMm[0]", "wrong-type"),
        ["dialect unknown"] = (
            d => d.With("$.counterpart.dialect", "fanuk"), "$.counterpart.dialect", "unknown-dialect"),
        ["program missing"] = (
            d => d.With("$.counterpart.program", "nowhere.nc"), "$.counterpart.program", "file-unreadable"),
        ["frame wrong"] = (d => d.With("$.counterpart.frame.translateMm[0]", "7"), "$.features[0].blocks", "point-off-path"),
        ["gain too large"] = (d => d.With("$.compensation.gain", "3"), "$.compensation.gain", "too-large"),
        ["feedback without a measured counterpart"] = (
            d => d.With("$.compensation.from", "counterpart").With("$.counterpart.measured", ""),
            "$.counterpart.measured",
            "measured-missing"),
        ["datum of one point"] = (d => d.With("$.alignment.kind", "datum")
            .With("$.alignment.origin", "1")
            .With("$.alignment.direction", "1"), "$.alignment.direction", "datum-needs-two-points"),
        ["datum of an unknown point"] = (d => d.With("$.alignment.kind", "datum")
            .With("$.alignment.origin", "1")
            .With("$.alignment.direction", "99"), "$.alignment.direction", "missing-point"),
        ["origin unknown"] = (
            d => d.With("$.originCheck.point", "O").With("$.originCheck.limitMm", "0.01"), "$.originCheck.point", "missing-point"),
        ["origin without a limit"] = (d => d.With("$.originCheck.point", "1"), "$.originCheck.limitMm", "wrong-type"),
        ["no features"] = (d => d with { Features = [] }, "$.features", "too-few-items"),
        ["feature without a name"] = (d => d.WithFeature(0, f => f with { Name = "" }), "$.features[0].name", "pattern-mismatch"),
        ["two features of one name"] = (d => d.WithFeature(2, f => f with { Name = "L1" }), "$.features[2].name", "duplicate-name"),
        ["limits reversed"] = (d => d.WithFeature(1, f => f with { Lower = "0.1" }), "$.features[1].toleranceMm[0]", "reversed-tolerance"),
        ["limit text"] = (d => d.WithFeature(1, f => f with { Lower = "x" }), "$.features[1].toleranceMm[0]", "wrong-type"),
        ["chain missing"] = (d => d.WithFeature(1, f => f with { Tolerance = "chain:rss" }), "$.features[1].toleranceMm", "chain-missing"),
        ["too few points"] = (d => d.WithPoints(0, 0, 1), "$.features[0].points", "too-few-points"),
        ["too few points on a flank"] = (d => d.WithPoints(1, 1, 1), "$.features[1].points[1]", "too-few-points"),
        ["point twice"] = (d => Point(d, 1, 0, 1, p => p with { Label = "1" }), "$.features[1].points[0][1]", "duplicate-point"),
        ["degree too high"] = (d => d.WithFeature(2, f => f.With("degree", "10")), "$.features[2].degree", "degree-too-high"),
        ["degree text"] = (d => d.WithFeature(2, f => f.With("degree", "two")), "$.features[2].degree", "not-one-of"),
        ["no blocks"] = (d => d.WithFeature(0, f => f with { Blocks = "" }), "$.features[0].blocks", "too-few-items"),
        ["block wrong"] = (d => d.WithFeature(0, f => f with { Blocks = "N120, 130" }), "$.features[0].blocks[1]", "pattern-mismatch"),
        ["expression wrong"] = (d => d.WithFeature(0, f => f with { Blocks = "/(/" }), "$.features[0].blocks[0]", "bad-pattern"),
        ["block not there"] = (d => d.WithFeature(0, f => f with { Blocks = "N121" }), "$.features[0].blocks", "block-not-found"),
        ["block of two features"] = (
            d => d.WithFeature(0, f => f with { Blocks = "N120, N130" }), "$.features[1].blocks", "blocks-overlap"),
        ["block not there, beside another mistake"] = (
            d => d.WithFeature(0, f => f with { Blocks = "N121" }) with { Name = "", Program = Own },
            "$.features[0].blocks",
            "block-not-found"),
        ["block of two features, beside another mistake"] = (
            d => d.WithFeature(0, f => f with { Blocks = "N120, N130", Lower = "9" }) with { Program = Own },
            "$.features[1].blocks",
            "blocks-overlap"),
        ["no program, beside another mistake"] = (
            d => d with { Name = "", Program = NoProgram }, "$.counterpart.program", "no-cutting-motion"),
        ["chain link without a name"] = (d => d.With("$.toleranceChain[0].nominalMm", "1")
            .With("$.toleranceChain[0].toleranceMm[0]", "0")
            .With("$.toleranceChain[0].toleranceMm[1]", "0"), "$.toleranceChain[0].name", "too-short"),
        ["chain limits reversed"] = (
            d => d.With("$.toleranceChain[0].name", "a")
                .With("$.toleranceChain[0].nominalMm", "1")
                .With("$.toleranceChain[0].toleranceMm[0]", "1")
                .With("$.toleranceChain[0].toleranceMm[1]", "0"), "$.toleranceChain[0].toleranceMm[0]", "reversed-tolerance"),
        ["comparison of an unknown element"] = (
            d => d.Without("$.verify")
                .With("$.verify[0].name", "a")
                .With("$.verify[0].quantity", "angle")
                .With("$.verify[0].between", "L1, L9"), "$.verify[0].between[1]", "unknown-element"),
        ["comparison of one element"] = (d => d.Without("$.verify")
            .With("$.verify[0].name", "a")
            .With("$.verify[0].quantity", "angle")
            .With("$.verify[0].between", "L1"), "$.verify[0].between", "too-few-items"),
        ["comparison of an unknown point"] = (
            d => d.Without("$.verify")
                .With("$.verify[0].name", "a")
                .With("$.verify[0].quantity", "deviation")
                .With("$.verify[0].points", "77"), "$.verify[0].points[0]", "unknown-point"),
        ["coordinate missing"] = (d => Point(d, 0, 0, 1, p => p with { Y = "" }), "$.features[0].points[1]/y", "empty-cell"),
        ["coordinate text"] = (d => Point(d, 1, 1, 0, p => p with { X = "abc" }), "$.features[1].points[1][0]/x", "text-for-number"),
        ["coordinate with a comma"] = (d => Point(d, 2, 0, 3, p => p with { X = "1,5" }), "$.features[2].points[3]/x", "decimal-comma"),
        ["other point twice"] = (
            d => d with { OtherPoints = [new("3", "0", "0"), new("3", "0", "1")] }, "$.otherPoints[1]", "duplicate-point"),
        ["other point without a label"] = (d => d with { OtherPoints = [new("", "0", "0")] }, "$.otherPoints[0]", "empty-cell"),
    };

    public static TheoryData<string> Names => [.. Mistakes.Keys];

    [Theory]
    [MemberData(nameof(Names))]
    public void A_mistake_is_told_at_its_field(string name)
    {
        var (mistake, field, code) = Mistakes[name];
        var check = MatingDraftCheck.Run(mistake(MatingDraftFiles.Open(File)), File);
        Assert.Contains((field, code), check.Problems.Select(p => (p.Field, p.Code)));
        Assert.All(check.Problems, p => Assert.NotEmpty(p.Message));
    }

    [Theory]
    [InlineData("N160..N130", "blocks-backwards", "N130..N160")]
    [InlineData("N130..N165", "block-not-found", "N165")]
    [InlineData("/X-99999/", "block-not-found", "/X-99999/")]
    public void What_is_wrong_with_blocks_is_named_whether_the_rest_is_right_or_not(string blocks, string code, string found)
    {
        var draft = MatingDraftFiles.Open(File).WithFeature(1, f => f with { Blocks = blocks });
        foreach (var one in new[] { draft, draft with { Name = "", Program = Own } })
        {
            Assert.Contains(
                ("$.features[1].blocks", code, found), MatingDraftCheck.Run(one, File).Problems.Select(p => (p.Field, p.Code, p.Found)));
        }
    }

    [Fact]
    public void Assumed_values_of_a_job_hold_while_it_is_edited()
    {
        var text = System.IO.File.ReadAllText(File).Replace(
            "\"mapMm\"", "\"assume\": { \"#100\": 1, \"#<_depth>\": -2.5 }, \"mapMm\"", StringComparison.Ordinal);
        var theoretical = System.IO.File.ReadAllBytes(Repository.PathTo("samples", "complex-mating", "theoretical.csv"));
        var draft = MatingDraftFiles.Read(System.Text.Encoding.UTF8.GetBytes(text), File, theoretical);
        var read = MatingJob.Parse(MatingDraftFiles.Job(draft), File).Counterpart.Assumed;
        Assert.Equal([("#100", 1), ("#<_DEPTH>", -2.5)], read.Values.Select(v => (v.Key, v.Value)));
        Assert.Equal(read.Values, MatingDraftCheck.DialectOf(draft, File).Assumed.Values);
    }

    [Fact]
    public void A_point_off_its_blocks_says_how_far()
    {
        var draft = MatingDraftFiles.Open(File)
            .WithFeature(0, f => f with { Blocks = "N130" })
            .WithFeature(1, f => f with { Blocks = "N120" });
        var problem = Assert.Single(MatingDraftCheck.Run(draft, File).Problems);
        Assert.Equal(("point-off-path", "1"), (problem.Code, problem.Found));

        // From (-31.950, 76.008) to the beginning of N130 at (-34.995, 59.757).
        Assert.Equal("16.534 mm", problem.Amount);
    }

    [Fact]
    public void Beginning_anew_leaves_the_measured_counterpart_of_the_piece_before_behind()
    {
        var draft = MatingDraftFiles.Open(File);
        Assert.Equal("counterpart.csv", draft["$.counterpart.measured"]);
        Assert.Equal("", draft.Emptied()["$.counterpart.measured"]);
    }

    [Fact]
    public void What_is_only_missing_is_told_from_what_is_wrong()
    {
        var draft = MatingDraftFiles.Open(File).Emptied() with { Name = "a" };
        draft = draft with { Features = [FeatureDraft.New(LineKind.Instance, "L1", draft) with { Blocks = "abc", Lower = "x" }] };
        var problems = MatingDraftCheck.Run(draft, File).Problems;
        Assert.Equal(
            ["$.features[0].blocks[0]", "$.features[0].toleranceMm[0]"],
            problems.Where(p => !p.IsMissing).Select(p => p.Field).Order(StringComparer.Ordinal));
        Assert.Contains("$.gauge.uncertaintyMm", problems.Where(p => p.IsMissing).Select(p => p.Field));
        Assert.Contains("$.features[0].points[1]/y", problems.Where(p => p.IsMissing).Select(p => p.Field));
        Assert.Contains(DraftPaths.Program, problems.Where(p => p.IsMissing).Select(p => p.Field));
    }

    [Theory]
    [InlineData("-0.05", "90.05", "1", "$.features[1].toleranceMm[1]")]
    [InlineData("-1e3", "0.05", "", "$.features[1].toleranceMm[0]")]
    [InlineData("-0.05", "0.3", "0.2", "$.features[1].toleranceMm[1]")]
    [InlineData("-0.05", "1", "", null)]
    [InlineData("-9", "9", "10", null)] // what is measured as it is designed says nothing about wide limits
    public void A_limit_that_no_deviation_reaches_is_refused_in_the_words_of_a_match(string lower, string upper, string stop, string? field)
    {
        var draft = MatingDraftFiles.Open(File).WithFeature(1, f => f with { Lower = lower, Upper = upper });
        draft = draft.With("$.compensation.limitMm", stop);
        var problem = MatingDraftCheck.Run(draft, File).Problems.SingleOrDefault();
        Assert.Equal((field, field is null ? null : "limit-implausible"), (problem?.Field, problem?.Code));
        if (problem is not null)
        {
            var said = Assert.Throws<InputException>(() => MatingJob.Parse(MatingDraftFiles.Job(draft), File));
            Assert.Equal(said.Refusals.Single().Message, problem.Message);
        }
    }

    [Theory]
    [InlineData(0, "N120", null)]
    [InlineData(0, "N120, N110", "N110")]
    [InlineData(2, "N170..N1190", null)]
    [InlineData(2, "N170..N1210", "N1210")]
    public void Blocks_that_lead_in_or_out_are_asked_about(int feature, string blocks, string? asked)
    {
        var check = MatingDraftCheck.Run(MatingDraftFiles.Open(File).WithFeature(feature, f => f with { Blocks = blocks }), File);
        Assert.Empty(check.Problems);
        Assert.Equal(
            asked is null ? [] : [(DraftPaths.Feature(feature, "blocks"), asked)],
            check.Doubts.Where(d => d.Code == "blocks-lead").Select(d => (d.Field, d.Found)));
    }

    [Theory]
    [InlineData("complex-mating", "2, 4")]
    [InlineData("curve-mating", "")]
    public void Nothing_is_asked_about_a_job_that_is_meant_so_but_its_points_on_corners(string sample, string corners)
    {
        var job = Repository.PathTo("samples", sample, "job.json");
        var check = MatingDraftCheck.Run(MatingDraftFiles.Open(job), job);
        Assert.Equal((0, corners), (check.Problems.Count, string.Join(", ", check.Doubts.Select(d => d.Found))));
        Assert.All(check.Doubts, d => Assert.Equal("point-on-corner", d.Code));
    }

    [Fact]
    public void Before_a_job_is_saved_it_is_asked_about_the_same_points_on_corners_that_its_match_warns_of()
    {
        var check = MatingDraftCheck.Run(MatingDraftFiles.Open(File), File);
        var warned = MatingRun.Run(new(File), new(), CancellationToken.None).Result!.Report.Warnings
            .Where(w => w.Code == "point-on-corner")
            .Select(w => w.Values[0]);
        Assert.Equal(warned, check.Doubts.Select(d => d.Found));

        // Point 2 is 1.404 mm behind the end of N120 at (-34.995, 59.757), along it;
        // point 4 is 1.379 mm behind that of N160 at (-34.918, 36.365).
        Assert.Equal(
            [("$.features[0].points[1]", "1.5 mm"), ("$.features[1].points[1][1]", "1.4 mm")],
            check.Doubts.Select(d => (d.Field, d.Amount)));
    }

    [Theory]
    [InlineData("59.446", "0.4 mm")]
    [InlineData("59.846", null)]
    public void A_point_as_far_from_the_corner_as_is_advised_is_asked_about_no_more(string y, string? asked)
    {
        // Point 2, moved along L1 away from the corner: by 1.1 mm, and by the 1.5 mm.
        var check = MatingDraftCheck.Run(
            MatingDraftFiles.Open(File).WithFeature(0, f => f with { Flanks = [[f.Flanks[0][0], f.Flanks[0][1] with { Y = y }]] }), File);
        Assert.Empty(check.Problems);
        Assert.Equal(asked, check.Doubts.SingleOrDefault(d => d.Found == "2")?.Amount);
    }

    [Fact]
    public void A_measured_counterpart_that_is_not_there_is_asked_about_and_saved()
    {
        var draft = MatingDraftFiles.Open(File);
        var check = MatingDraftCheck.Run(draft.With("$.counterpart.measured", "nope.csv"), File);
        Assert.Empty(check.Problems);
        Assert.Equal([("$.counterpart.measured", "nope.csv")], Told(check));

        // Without the key nothing is looked for; in feedback the gauge gives it.
        Assert.Empty(Told(MatingDraftCheck.Run(draft.With("$.counterpart.measured", ""), File)));
        Assert.Empty(Told(MatingDraftCheck.Run(
            draft.With("$.counterpart.measured", "nope.csv").With("$.compensation.from", "counterpart"),
            File)));

        // The sample's points on corners are another matter.
        static IEnumerable<(string, string?)> Told(DraftCheck check) =>
            check.Doubts.Where(d => d.Code == "measured-not-there").Select(d => (d.Field, (string?)d.Found));
    }

    [Fact]
    public void Every_empty_coordinate_is_told_by_itself()
    {
        var draft = new MatingDraft();
        draft = draft with { Features = [FeatureDraft.New(TriangleKind.Instance, "T", draft)] };
        var told = MatingDraftCheck.Run(draft, File).Problems
            .Select(p => p.Field)
            .Where(f => f.Contains('/', StringComparison.Ordinal))
            .ToArray();
        Assert.Equal(8, told.Length);
        Assert.Equal(["1", "2", "3", "4"], draft.Points.Select(p => p.Label));
        Assert.Contains("$.features[0].points[1][1]/y", told);
    }

    [Fact]
    public void A_decimal_sign_at_an_end_and_a_plus_sign_are_numbers()
    {
        var draft = MatingDraftFiles.Open(File).WithFeature(0, f => f with { Lower = "-.05", Upper = "+0.05" });
        var check = MatingDraftCheck.Run(draft.With("$.counterpart.toolDiameterMm", "06."), File);
        Assert.Empty(check.Problems);
        Assert.Equal(
            (-0.05, 0.05, 6.0),
            (
                check.Job!.Features[0].Tolerance.Band.LowerMm,
                check.Job.Features[0].Tolerance.Band.UpperMm,
                check.Job.Counterpart.ToolDiameterMm));
    }

    private static MatingDraft Point(MatingDraft draft, int feature, int flank, int point, Func<PointDraft, PointDraft> change) =>
        draft.WithFeature(
            feature, f => f with { Flanks = f.Flanks.Replaced(flank, f.Flanks[flank].Replaced(point, change(f.Flanks[flank][point]))) });
}
