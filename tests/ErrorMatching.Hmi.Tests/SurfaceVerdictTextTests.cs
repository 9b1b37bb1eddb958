using ErrorMatching.Freeform;
using ErrorMatching.Geometry;
using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi.Tests;

/// <summary>The verdict on a surface at the station: the numbers and words of the report and the console, in two languages.</summary>
public sealed class SurfaceVerdictTextTests
{
    private static readonly string Folder = Path.Combine(AppContext.BaseDirectory, "samples", "surface-one");
    private static readonly Lazy<CompensationResult> Sample = new(() => SurfaceRun.Compensate(
        new(Path.Combine(Folder, "job.json")), new() { Measured = [new(Path.Combine(Folder, "measured.csv"))] }, CancellationToken.None)
        .Result!.Report.Result);

    private static readonly ProfileJudgement Good = new()
    {
        Code = ProfileCode.Within,
        ProfileMm = 0.00701,
        Points = 70,
        Outside = [],
        NotAccepted = [],
        WorstPoint = 8,
        WorstMm = 0.0001,
        WorstAnywhereMm = 0.0002,
        UncertaintyMm = 0.001,
        Probability = 0.9876,
    };

    private static readonly ProfileTolerance Tolerance = new(0.02, DecisionRule.GuardBand(5), false);

    private static readonly Dictionary<string, (ProfileJudgement Judgement, Severity Severity)> Cases = new(StringComparer.Ordinal)
    {
        ["within"] = (Good, Severity.Quiet),
        ["sure"] = (Good with { Probability = 0.99999 }, Severity.Quiet),
        ["not accepted"] = (Good with { Code = ProfileCode.NotAccepted, Probability = 0.5 }, Severity.Attention),
        ["between"] = (Good with { Code = ProfileCode.OutsideBetween, WorstAnywhereMm = -0.01234 }, Severity.Attention),
        ["one outside"] = (
            Good with { Code = ProfileCode.Outside, ProfileMm = 0.025, Outside = [8], WorstMm = -0.0125 }, Severity.Alarm),
        ["many outside"] = (
            Good with { Code = ProfileCode.Outside, ProfileMm = 0.025, Outside = [.. Enumerable.Range(1, 9)], WorstMm = 0.0125 },
            Severity.Alarm),
    };

    public static TheoryData<string> Names => [.. Cases.Keys];

    [Theory]
    [MemberData(nameof(Names))]
    public Task In_English_it_is_word_for_word_that_of_the_report(string name) => InAsync(Language.English, () =>
    {
        var (judgement, severity) = Cases[name];
        foreach (var before in new[] { ProfileCode.Within, ProfileCode.NotAccepted, ProfileCode.Outside })
        {
            var verdict = new SurfaceVerdict(Tolerance, Good with { Code = before, ProfileMm = 0.0506 }, judgement);
            Assert.Equal(severity, SurfaceVerdictText.SeverityOf(verdict));
            foreach (var isReady in new[] { true, false })
            {
                Assert.Equal(ProfileLead.Of(Sample.Value, verdict, isReady), Text(verdict, isReady));
            }
        }
    });

    [Theory]
    [InlineData("within", "預期符合公差：輪廓度 7.01 / 20 µm，機率 98.8 %。實測：超出公差，輪廓度 50.60 µm。可以加工。")]
    [InlineData(
        "not accepted",
        "無法確定符合公差：預期輪廓度 7.01 / 20 µm，所有點都符合的機率為 50.0 %，要求 95 %。除非您接受此風險，否則請勿加工。實測：超出公差，輪廓度 50.60 µm。")]
    [InlineData(
        "between", "預期在各點之間超出公差：該處 12.34 µm，公差限 ±10 µm。除非該處可以接受，否則請勿加工。實測：超出公差，輪廓度 50.60 µm。")]
    [InlineData(
        "one outside",
        "預期超出公差：輪廓度 25.00 / 20 µm；70 點中 1 點會超出 ±10 µm：點 8，超出 2.50 µm。除非該處可以接受，否則請勿加工。實測：超出公差，輪廓度 50.60 µm。")]
    public Task In_Chinese_it_has_the_same_numbers(string name, string text) => InAsync(Language.TraditionalChinese, () => Assert.Equal(
        text, Text(new(Tolerance, Good with { Code = ProfileCode.Outside, ProfileMm = 0.0506 }, Cases[name].Judgement), true)));

    // What surface evaluate says of a finished piece. With its stock on it, a piece is no finished one.
    [Theory]
    [InlineData("within", "符合公差：70 點的輪廓度 7.01 / 20 µm，機率 98.8 %。")]
    [InlineData("one near", "不予接受：輪廓度 18.00 / 20 µm，但兩側公差限的保護帶 1.645 µm 不接受點 8：太接近公差限。")]
    [InlineData("many near", "不予接受：輪廓度 18.00 / 20 µm，但兩側公差限的保護帶 1.645 µm 不接受點 8 與 9：太接近公差限。")]
    [InlineData("one outside", "超出公差：輪廓度 25.00 / 20 µm；70 點中 1 點超出 ±10 µm：點 8，超出 2.50 µm。")]
    public async Task A_finished_piece_is_judged_as_measured(string name, string chinese)
    {
        var judged = name switch
        {
            "one near" => Good with { Code = ProfileCode.NotAccepted, ProfileMm = 0.018, NotAccepted = [8] },
            "many near" => Good with { Code = ProfileCode.NotAccepted, ProfileMm = 0.018, NotAccepted = [8, 9] },
            _ => Cases[name].Judgement,
        };
        var verdict = new SurfaceVerdict(Tolerance, judged, Good);
        await InAsync(Language.English, () =>
        {
            Assert.Equal(ProfileWords.Of(Tolerance, [("piece.csv", judged)]), Plain(SurfaceVerdictText.OfPiece(verdict)));
            Assert.Equal(
                Cases.TryGetValue(name, out var known) ? known.Severity : Severity.Attention, SurfaceVerdictText.SeverityOfPiece(verdict));
            Assert.Equal(("piece", null), (Piece(CuttingStage.Finishing) is null ? "" : "piece", Piece(CuttingStage.SemiFinishing)));
            Assert.Null(SurfaceVerdictText.OfPiece(null));
        });
        await InAsync(Language.TraditionalChinese, () => Assert.Equal(chinese, Plain(SurfaceVerdictText.OfPiece(verdict))));

        string? Piece(CuttingStage stage)
        {
            var findings = SurfaceFindings.Of(Sample.Value, new(null, null)) with { Verdict = verdict, Stage = stage };
            return new SurfaceFigures(new("", findings, null, null, true, []), true).Piece;
        }
    }

    [Theory]
    [InlineData(true, true)]
    [InlineData(false, false)]
    public Task The_tolerance_is_said_as_in_the_report(bool isGuarded, bool isAligned) => InAsync(Language.English, () =>
    {
        var tolerance = new ProfileTolerance(0.02, isGuarded ? DecisionRule.GuardBand(5) : DecisionRule.Simple, isAligned);
        Assert.Equal(
            ProfileWords.Of(tolerance, Good.UncertaintyMm), Plain(SurfaceVerdictText.OfTolerance(new(tolerance, Good, Good))));
        Assert.Null(SurfaceVerdictText.OfTolerance(null));
    });

    [Fact]
    public Task Without_a_tolerance_nothing_is_judged_and_nothing_asks_for_attention() => InAsync(Language.English, () =>
    {
        Assert.Equal(ProfileLead.Of(Sample.Value, null), Text(null, true));
        Assert.StartsWith("Not judged: ", Text(null, true), StringComparison.Ordinal);
        Assert.Equal(Severity.Quiet, SurfaceVerdictText.SeverityOf(null));
    });

    private static string? Plain(string? text) => text?.Replace('\u00a0', ' ');

    private static string Text(SurfaceVerdict? verdict, bool isToBeCut) => SurfaceVerdictText
        .Of(SurfaceFindings.Of(Sample.Value, new(null, null)) with { Verdict = verdict }, isToBeCut).Replace('\u00a0', ' ');

    private static Task InAsync(Language language, Action act) => Drawing.Needed().RunAsync(() =>
    {
        Texts.Current.Language = language;
        try
        {
            act();
        }
        finally
        {
            Texts.Current.Language = Language.English;
        }
    });
}
