using ErrorMatching.Cell;
using ErrorMatching.Geometry;
using ErrorMatching.Mating;

namespace ErrorMatching.Hmi.Tests;

/// <summary>The verdict on a pair at the station: the numbers and words of the report and the console, in two languages.</summary>
public sealed class MatchVerdictTextTests
{
    private static readonly MatchReport Sample = SampleReport.Of().Leaving([
        .. SampleReport.Of().KeyPoints.Select(p => (p.Point, p.Point == "11" ? 0.0204 : 0.001))]);

    private static readonly Dictionary<string, (MatchReport Report, VerdictCode Code, Severity Severity)> Cases = new(
        StringComparer.Ordinal)
    {
        ["within"] = (Sample, VerdictCode.Within, Severity.Quiet),
        ["unchanged"] = (
            Sample with { Program = Sample.Program with { ChangedBlocks = 0 }, Proof = Sample.Proof with { Marker = null } },
            VerdictCode.Within, Severity.Quiet),
        ["different limits"] = (
            Sample with
            {
                Features = [
                    Sample.Features[0] with { Tolerance = new(new(-0.0205, 0.1), ToleranceSource.Stated), WorstBetween = null },
                    .. Sample.Features.Skip(1)]
            },
            VerdictCode.Within, Severity.Quiet),
        ["earlier version"] = (Sample.Older(), VerdictCode.Within, Severity.Quiet),
        ["one outside"] = (Sample.Leaving(("4", -0.0512)), VerdictCode.Outside, Severity.Alarm),
        ["two outside"] = (Sample.Leaving(("2", 0.06), ("4", -0.0712)), VerdictCode.Outside, Severity.Alarm),
        ["many outside"] = (
            Sample.Leaving([.. Sample.KeyPoints.Take(9).Select((p, i) => (p.Point, 0.06 + (0.001 * i)))]),
            VerdictCode.Outside, Severity.Alarm),
        ["outside between"] = (Between(Sample, -0.0612), VerdictCode.OutsideBetween, Severity.Attention),
        ["outside at points and between"] = (Between(Sample.Leaving(("4", 0.0512)), -0.0612), VerdictCode.Outside, Severity.Alarm),
        ["doubtful between"] = (Between(Sample, 0.0012, 0.0612), VerdictCode.NotKnownBetween, Severity.Attention),
        ["one doubtful, one not known"] = (
            NotKnown(Between(Sample, 0.0012, 0.0612)), VerdictCode.NotKnownBetween, Severity.Attention),
        ["not known between"] = (NotKnown(Sample), VerdictCode.NotKnownBetween, Severity.Attention),
        ["between not accepted"] = (
            Between(Sample, 0.0012, 0.0612) with { Rule = DecisionRule.GuardBand(5) }, VerdictCode.NotAccepted, Severity.Attention),
        ["one and between not accepted"] = (
            Between(Sample.Leaving(("4", 0.0499)), 0.0012, 0.0612) with { Rule = DecisionRule.GuardBand(5) },
            VerdictCode.NotAccepted, Severity.Attention),
        ["two and between not accepted"] = (
            Between(Sample.Leaving(("2", -0.0499), ("4", 0.0499)), 0.0012, 0.0612) with { Rule = DecisionRule.GuardBand(5) },
            VerdictCode.NotAccepted, Severity.Attention),
        ["one not accepted"] = (
            Sample.Leaving(("4", 0.0499)) with { Rule = DecisionRule.GuardBand(5) }, VerdictCode.NotAccepted, Severity.Attention),
        ["two not accepted"] = (
            Sample.Leaving(("2", -0.0499), ("4", 0.0499)) with { Rule = DecisionRule.GuardBand(5) },
            VerdictCode.NotAccepted, Severity.Attention),
        ["no limits"] = (
            Sample with
            {
                Features = [.. Sample.Features.Select(f => f with { Tolerance = new(ToleranceBand.Zero, ToleranceSource.Stated) })]
            },
            VerdictCode.NoLimits, Severity.Attention),
        ["no points"] = (Sample with { KeyPoints = [], ProbabilityAfter = null }, VerdictCode.NoLimits, Severity.Attention),
        ["not proved"] = (Sample with { Proof = Sample.Proof with { Holds = false } }, VerdictCode.ProofFails, Severity.Alarm),
    };

    public static TheoryData<string> Names => [.. Cases.Keys];

    [Theory]
    [MemberData(nameof(Names))]
    public Task In_English_it_is_word_for_word_that_of_the_report(string name) => InAsync(Language.English, () =>
    {
        var (report, code, severity) = Cases[name];
        var verdict = report.Verdict;
        Assert.Equal((code, severity), (verdict.Code, MatchVerdictText.SeverityOf(verdict.Code)));
        Assert.Equal(VerdictWords.Of(verdict), Plain(MatchVerdictText.Of(verdict)));
        Assert.Equal(VerdictWords.Worst(verdict), Plain(MatchVerdictText.Worst(verdict)));
        Assert.Equal(VerdictWords.Risk(report), Plain(MatchVerdictText.Risk(report)));
    });

    [Theory]
    [InlineData("within", "16 點中 16 點會符合公差限 ±0.05（最大 0.020 ± 0.011）。可以加工。")]
    [InlineData("earlier version", "16 點中 16 點會符合公差限 ±0.05（最大 0.020）。可以加工。")]
    [InlineData("one outside", "16 點中 1 點會超出公差限 ±0.05：點 4，超出 0.001 ± 0.011。除非該處可以接受，否則請勿加工。")]
    [InlineData(
        "two outside", "16 點中 2 點會超出公差限 ±0.05：點 2 與 4，其中點 4 超出最多，達 0.021 ± 0.011。除非該處可以接受，否則請勿加工。")]
    [InlineData(
        "one not accepted", "16 點中 16 點會符合公差限 ±0.05（最大 0.050 ± 0.011），但決定規則不接受點 4：太接近公差限。除非您接受此風險，否則請勿加工。")]
    [InlineData(
        "doubtful between", "16 點中 16 點會符合公差限 ±0.05（最大 0.020 ± 0.011）。但各點之間 C1 的誤差可能達 0.063。若該處形狀足夠好，可以加工。")]
    [InlineData(
        "one and between not accepted",
        "16 點中 16 點會符合公差限 ±0.05（最大 0.050 ± 0.011），但決定規則不接受點 4，也不接受各點之間的 C1：太接近公差限。"
            + "除非您接受此風險，否則請勿加工。")]
    [InlineData("not proved", "程式檢核未通過。請勿使用此程式。")]
    public Task In_Chinese_it_has_the_same_numbers(string name, string text) => InAsync(Language.TraditionalChinese, () =>
        Assert.Equal(text, MatchVerdictText.Of(Rounded(Cases[name].Report).Verdict).Replace('\u00a0', ' ')));

    [Theory]
    [InlineData(CorrectionState.Proposed, true)]
    [InlineData(CorrectionState.Approved, true)]
    [InlineData(CorrectionState.Uploading, true)]
    [InlineData(CorrectionState.Verified, true)]
    [InlineData(CorrectionState.Released, false)]
    [InlineData(CorrectionState.Superseded, false)]
    [InlineData(CorrectionState.Rejected, false)]
    [InlineData(CorrectionState.Failed, false)]
    [InlineData(CorrectionState.Reverted, false)]
    public Task Whether_to_cut_is_answered_while_it_is_a_question(CorrectionState state, bool isAnswered) => InAsync(Language.English, () =>
    {
        var detail = Detail(Sample, state);
        Assert.Equal(isAnswered, detail.Verdict!.EndsWith(" Cut it.", StringComparison.Ordinal));
        Assert.StartsWith("16 of 16 points will be within ±0.05 (worst 0.020", detail.Verdict, StringComparison.Ordinal);
    });

    [Fact]
    public Task What_is_left_carries_its_interval_wherever_it_is_shown_and_alone_if_that_is_not_known() => InAsync(Language.English, () =>
    {
        var detail = Detail(Sample, CorrectionState.Proposed);
        Assert.All(
            Sample.KeyPoints.Zip(detail.Points),
            p => Assert.Equal($"{Shown.SignedMm(p.First.PredictedMm)} ± {Shown.Mm(p.First.Interval95Mm)}", Spaced(p.Second.LeftOver)));
        var half = Shown.Mm(Sample.KeyPoints.Single(p => p.Point == "11").Interval95Mm);
        Assert.Equal($"With compensation, as predicted: at most 0.0204 ± {half} mm", Spaced(detail.AfterCaption));
        var piece = StoredPiece.Predicted(detail.Stored.Correction, Sample);
        var verified = new PieceDetail(piece, [piece]);
        Assert.Equal(detail.Points.Select(p => p.LeftOver), verified.Points.Select(p => p.After));
        Assert.Contains($"→ 0.0204 ± {half} mm.", Spaced(verified.Summary), StringComparison.Ordinal);
        Assert.All(verified.Features, f => Assert.Contains("±", f.After, StringComparison.Ordinal));
        Assert.All(verified.Features, f => Assert.DoesNotContain("±", f.Before, StringComparison.Ordinal));
        Assert.All(verified.Errors.Values, v => Assert.Contains("±", v, StringComparison.Ordinal));

        // A measured counterpart has errors, not predictions; an earlier version knew no intervals.
        var measured = piece with { Counterpart = piece.Correction with { Id = 2 } };
        Assert.All(new PieceDetail(measured, [measured]).Points, p => Assert.DoesNotContain("±", p.After, StringComparison.Ordinal));
        var older = Detail(Sample.Older(), CorrectionState.Proposed);
        Assert.Equal(Sample.KeyPoints.Select(p => Shown.SignedMm(p.PredictedMm)), older.Points.Select(p => p.LeftOver));
        Assert.Equal("Worst at the points: +0.0204 mm at point 11 of C1.", Spaced(older.LeftOver!));
        Assert.Equal("With compensation, as predicted: at most 0.0204 mm", Spaced(older.AfterCaption));
    });

    [Fact]
    public Task Who_signs_sees_the_verdict_first_and_what_compensation_drives_out_of_its_limits() => InAsync(Language.English, () =>
    {
        var detail = Detail(Sample.Leaving(("2", 0.06), ("4", -0.0712)), CorrectionState.Proposed);
        Assert.Equal(new Fact(detail.Verdict!, Severity.Alarm), detail.Facts[0]);
        Assert.Equal((false, Severity.Alarm), (detail.IsWithin, detail.VerdictSeverity));
        Assert.Contains(new(detail.LeftOver!, Severity.Quiet), detail.Facts);
        Assert.EndsWith(" Within limits without compensation: 2, 4.", detail.LeftOver, StringComparison.Ordinal);
        Assert.Equal(["2", "4"], detail.Points.Where(p => p.IsOutside).Select(p => p.Point));
    });

    private static CorrectionDetail Detail(MatchReport report, CorrectionState state) => new(
        new(
            new(1, state, 1, "cmm", "part-0001.csv", DateTimeOffset.UnixEpoch, new string('0', 64), 1) { Piece = "part" },
            [], report, null),
        TimeProvider.System);

    private static MatchReport Between(MatchReport report, double mm, double interval = 1.96 * 0.0052) => report with
    {
        Features = [
            .. report.Features.SkipLast(1),
            report.Features[^1] with
            {
                WorstBetween = new(new(-40.9334, 52.975), new(0, 1), -0.1, mm, interval / 1.96) { Interval95Mm = interval },
            }]
    };

    private static MatchReport NotKnown(MatchReport report) => report with
    {
        Features = [
            report.Features[0] with { WorstBetween = new(new(1, 2), new(0, 1), -0.1, 0.001, 0) { IsKnown = false } },
            .. report.Features.Skip(1)]
    };

    // The gauge's uncertainty alone, so that the numbers do not depend on the estimate.
    private static MatchReport Rounded(MatchReport report) => report with
    {
        KeyPoints = [.. report.KeyPoints.Select(p => p with { Interval95Mm = p.Interval95Mm is null ? null : 1.96 * 0.0054 })]
    };

    // A bore and a boss, by hand; in English as the report and the console say it.
    [Theory]
    [InlineData(0.02, 1, true, 1)]
    [InlineData(0.02, 0.75, true, 2, 1)]
    [InlineData(-0.02, 0.1, false, 1, 2)]
    [InlineData(-0.2, 0, false, 2, 2)]
    [InlineData(0, 0.4, false, 1)]
    [InlineData(0.02, 0.75, true, 2, 1, 2)]
    [InlineData(-0.02, 0.1, false, 1, 0, 1)]
    [InlineData(-0.2, 0, false, 2, 0, 1)]
    public Task Whether_the_pair_goes_together_is_said_as_in_the_report(
        double tightest, double probability, bool assembles, int places, int corners = 0, int forms = 0) =>
        InAsync(Language.English, () =>
        {
            var pair = new PairAssembly
            {
                Assembles = assembles,
                Probability = probability,
                TightestMm = tightest,
                Interval95Mm = new(tightest - 0.003, tightest + 0.003),
                Contacts = [.. Enumerable.Range(0, places).Select(i => new PairContact(new(i, 0), "B1", $"N{120 + i}"))],
                RoundCorners = [
                    .. Enumerable.Range(0, corners).Select(i => new PairCorner($"N{200 + i}", $"N{210 + i}", 0.04 + (i / 1e3)))],
                UnknownForms = [.. Enumerable.Range(1, forms).Select(i => $"B{i}")],
            };
            ToleranceBand[] limits = [new(-0.05, 0.05)];
            var english = PairText.Of(pair, limits);
            Assert.Equal(PairWords.Of(pair, limits), Plain(english));
            Texts.Current.Language = Language.TraditionalChinese;
            var chinese = PairText.Of(pair, limits);
            Assert.Contains("N120", chinese, StringComparison.Ordinal);
            Assert.DoesNotContain("together", chinese, StringComparison.Ordinal);
        });

    // A flat on a flat: it can always be lifted off, and rests where it is pressed home.
    [Theory]
    [InlineData(0, 0)]
    [InlineData(2, 0)]
    [InlineData(1, 1)]
    public Task A_part_that_can_be_lifted_off_is_said_to_go_together_as_in_the_report(int gaps, int corners) =>
        InAsync(Language.English, () =>
        {
            var pair = new PairAssembly
            {
                Assembles = true,
                Probability = 1,
                Contacts = [new PairContact(new(0, 0), "L1", "N130"), new PairContact(new(9, 0), "L1", "N150")],
                Gaps = [.. Enumerable.Range(0, gaps).Select(i => new PairGap("L1", new(i, 0), new(0, 1), 0.012 + (i / 1e3)))],
                RoundCorners = [.. Enumerable.Range(0, corners).Select(i => new PairCorner($"N{200 + i}", $"N{210 + i}", 0.04))],
            };
            ToleranceBand[] limits = [new(-0.05, 0.05)];
            Assert.Equal(PairWords.Of(pair, limits), Plain(PairText.Of(pair, limits)));
            Assert.Equal(corners > 0, PairText.Head(pair, limits).Length > 0);
            Texts.Current.Language = Language.TraditionalChinese;
            var chinese = PairText.Of(pair, limits);
            Assert.Contains("N150", chinese, StringComparison.Ordinal);
            Assert.DoesNotContain("together", chinese, StringComparison.Ordinal);
        });

    // The console has hyphens for minus signs, and no spaces that keep a line together.
    private static string? Plain(string? text) => text is null ? null : Spaced(text).Replace('−', '-');

    private static string Spaced(string text) => text.Replace('\u00a0', ' ');

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
