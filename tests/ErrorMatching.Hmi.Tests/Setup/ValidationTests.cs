using System.Text.RegularExpressions;
using Avalonia.Automation;
using Avalonia.Controls;
using Avalonia.VisualTree;
using ErrorMatching.Cell;
using ErrorMatching.Jobs;
using ErrorMatching.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Every message that the readers have for a field of a draft is caused here, told at its field, in both languages.</summary>
public sealed partial class ValidationTests
{
    private static readonly (string Code, Func<MatingDraft, MatingDraft> Mistake)[] Mistakes =
    [
        // The last row of a long table comes first: it has to be gone to.
        ("duplicate-point", d => d with { OtherPoints = [new("P", "0", "0"), new("P", "0", "1")] }),
        ("too-short", d => d with { Name = " " }),
        ("too-short", d => d.With("$.toleranceChain[0].nominalMm", "1")
            .With("$.toleranceChain[0].toleranceMm[0]", "0")
            .With("$.toleranceChain[0].toleranceMm[1]", "0")),
        ("empty-cell", d => X(d, "")),
        ("wrong-type", d => Tool(d, "6 mm")),
        ("text-for-number", d => X(d, "abc")),
        ("decimal-comma", d => X(d, "1,5")),
        ("thousands-separator", d => X(d, "1,234.5")),
        ("formula", d => X(d, "=A1")),
        ("not-a-number", d => X(d, "NaN")),
        ("number-out-of-range", d => X(d, "1e999")),
        ("implausible-number", d => X(d, "1e12")),
        ("number-out-of-range", d => Tool(d, "1e999")),
        ("too-small", d => Tool(d, "0")),
        ("too-small", d => d.With("$.gauge.uncertaintyMm", "-1")),
        ("too-large", d => d.With("$.compensation.gain", "3")),
        ("not-one-of", d => d.WithFeature(2, f => f.With("degree", "two"))),
        ("not-one-of", d => d.WithFeature(2, f => f.With("ridge", "x"))),
        ("not-one-of", d => d.WithFeature(2, f => f.With("degree", "1.5"))),
        ("pattern-mismatch", d => d.WithFeature(0, f => f with { Blocks = "120" })),
        ("pattern-mismatch", d => d.WithFeature(0, f => f with { Name = "L/1" })),
        ("too-few-items", d => d.WithFeature(0, f => f with { Blocks = "" })),
        ("too-few-items", d => d with { Features = [] }),
        ("too-many-items", d => d.Without("$.verify")
            .With("$.verify[0].name", "a")
            .With("$.verify[0].quantity", "angle")
            .With("$.verify[0].between", "L1, L1, L1")),
        ("stylus-diameter-missing", d => d.With("$.gauge.reports", "stylus-center")),
        ("bad-format", d => d.With("$.gauge.format", "table")),
        ("unknown-dialect", d => d.With("$.counterpart.dialect", "fanuk")),
        ("other-dialect", d => d.With("$.counterpart.dialect", "fanuc")),
        ("from-fixed", d => d.With("$.compensation.from", "counterpart")),
        ("file-unreadable", d => d.With("$.counterpart.program", "nowhere.nc")),
        (
            "measured-missing",
            d => d.With("$.compensation.from", "counterpart").With("$.counterpart.measured", "")),
        ("datum-needs-two-points", d => d.With("$.alignment.kind", "datum")
            .With("$.alignment.origin", "1")
            .With("$.alignment.direction", "1")),
        ("missing-point", d => d.With("$.alignment.kind", "datum").With("$.alignment.origin", "1").With("$.alignment.direction", "99")),
        ("missing-point", d => d.With("$.originCheck.point", "O").With("$.originCheck.limitMm", "0.01")),
        ("duplicate-name", d => d.WithFeature(2, f => f with { Name = "L1" })),
        ("reversed-tolerance", d => d.WithFeature(1, f => f with { Lower = "0.1" })),
        ("limit-implausible", d => d.WithFeature(0, f => f with { Upper = "9" })),
        ("uncertainty-implausible", d => d.With("$.gauge.uncertaintyMm", "5.4")),
        ("gauge-too-coarse", d => d.With("$.gauge.uncertaintyMm", "0.06")),
        ("guard-bands-overlap", d => d.With("$.gauge.uncertaintyMm", "0.04").With("$.decision.rule", "guard-band")),
        ("chain-missing", d => d.WithFeature(1, f => f with { Tolerance = "chain:rss" })),
        ("too-few-points", d => d.WithPoints(0, 0, 1)),
        ("degree-too-high", d => d.WithFeature(2, f => f.With("degree", "10"))),
        ("bad-pattern", d => d.WithFeature(0, f => f with { Blocks = "/(/" })),
        ("bad-range", d => d.Without("$.verify")
            .With("$.verify[0].name", "a")
            .With("$.verify[0].quantity", "deviation")
            .With("$.verify[0].points", "9..2a")),
        ("block-not-found", d => d.WithFeature(0, f => f with { Blocks = "N121" })),
        ("blocks-backwards", d => d.WithFeature(1, f => f with { Blocks = "N160..N130" })),
        ("blocks-overlap", d => d.WithFeature(0, f => f with { Blocks = "N120, N130" })),
        ("point-off-path", d => d.With("$.counterpart.frame.translateMm[0]", "7")),
        ("sides-differ", d => X(d, "-37.94")),
        ("plane-differs", d => d.WithFeature(0, f => f with { Plane = "ZX" })),
        ("alignment-needs-one-plane", d => (d.With("$.alignment.kind", "best-fit")).WithFeature(0, f => f with { Plane = "ZX" })),
        ("no-motion", d => d.WithFeature(0, f => f with { Blocks = "N80" })),
        ("no-cutting-motion", d => d with { Name = "", Program = DraftProgram.Of("N10 G0 X0\n"u8.ToArray()) }),
        ("already-compensated", d => d with { Program = DraftProgram.Of(Compensated()) }),
        ("unknown-element", d => d.Without("$.verify")
            .With("$.verify[0].name", "a")
            .With("$.verify[0].quantity", "angle")
            .With("$.verify[0].between", "L1, L9")),
        ("unknown-point", d => d.Without("$.verify")
            .With("$.verify[0].name", "a")
            .With("$.verify[0].quantity", "deviation")
            .With("$.verify[0].points", "77")),
    ];

    [Fact]
    public Task A_mistake_on_any_side_of_the_set_up_is_gone_to_and_told() => SetupSeat.AtAsync(ScreenKeys.System, seat =>
    {
        // One of a list and one of no list on each side, one side behind the other: to show one takes longest.
        var (draft, job) = (seat.Draft, seat.Shell.Editing.Job!);
        var edits = new JobEdits(seat.Seat.Station.Settings, seat.Seat.Station.Store, seat.Seat.Station.Users);
        var mistakes = Mistakes.GroupBy(
            m => edits.Check(job, m.Mistake(draft)).Problems.First(p => p.Code == m.Code).Field is var field
                ? $"{ProblemPlace.Of(draft, field)} {field.Contains('[', StringComparison.Ordinal)}"
                : "").OrderBy(g => g.Key, StringComparer.Ordinal);
        foreach (var (code, mistake) in mistakes.Select(g => g.First()))
        {
            seat.Shell.Editing.Change("", _ => mistake(draft));
            seat.Settle();
            var told = seat.Shell.Editing.Problems.FirstOrDefault(p => p.Code == code);
            Assert.True(told is not null, $"{code} is not caused but {string.Join(", ", seat.Shell.Editing.Problems)}.");
            var text = ProblemText.Of(told);
            seat.Shell.Editing.Report();
            seat.Seat.WaitFor(
                () => Shown(seat).Any(t => t.Contains(text, StringComparison.Ordinal)), $"{code} at {told.Field} is not told: {text}.");
        }

        seat.Shell.Editing.DiscardChanges.Execute(null);
        seat.Settle();
        Assert.Empty(seat.Shell.Editing.Problems);
    });

    // The demonstration's job has no circle and no slot; the samples do.
    private static readonly (string Sample, Func<MatingDraft, MatingDraft> Mistake)[] OfOtherKinds = [
        ("circle-mating", d => d.WithFeature(0, f => f with { Blocks = "N110..N130" })),
        ("circle-mating", d => d.WithPoints(0, 0, 3)),
        ("slot-mating", d => d.WithFeature(0, f => f with { Blocks = "N110..N160" }))];

    private static DraftCheck CheckSample(string sample, Func<MatingDraft, MatingDraft> mistake)
    {
        var file = Repository.PathTo("samples", sample, "job.json");
        return MatingDraftCheck.Run(mistake(MatingDraftFiles.Open(file)), file);
    }

    [Fact]
    public Task Every_message_has_its_words_in_both_languages_and_every_word_its_cause() => SetupSeat.AtAsync(ScreenKeys.System, seat =>
    {
        var caused = new HashSet<string>(StringComparer.Ordinal);
        Func<MatingDraft, MatingDraft>[] doubtful = [
            d => d.WithFeature(0, f => f with { Blocks = "N120, N110" }),
            d => d.With("$.counterpart.measured", "9.csv"),
            d => d.With("$.gauge.uncertaintyMm", "0.02")];
        var edits = new JobEdits(seat.Seat.Station.Settings, seat.Seat.Station.Store, seat.Seat.Station.Users);
        foreach (var problem in Mistakes.Select(m => m.Mistake)
            .Concat(doubtful)
            .Select(m => edits.Check(seat.Shell.Editing.Job!, m(seat.Draft)))
            .Concat(OfOtherKinds.Select(m => CheckSample(m.Sample, m.Mistake)))
            .SelectMany(c => c.Problems.Concat(c.Doubts)))
        {
            caused.Add("Problem." + problem.Code);
            Assert.DoesNotContain("expected", ProblemText.Of(problem), StringComparison.Ordinal);
            Texts.Current.Language = Language.TraditionalChinese;
            var words = ProblemText.Of(problem);
            Texts.Current.Language = Language.English;
            Assert.True(!Word().IsMatch(words), $"{problem.Code} is said in English: {words}");
        }

        // A count that is none never gets into the draft: its field says so by itself (PointSetupTests).
        var texts = Texts.Of(Language.English).Keys.Where(
            k => k.StartsWith("Problem.", StringComparison.Ordinal) && k.Split('.').Length == 2 && k != "Problem.not-a-count");
        Assert.Equal(texts.Order(StringComparer.Ordinal), caused.Order(StringComparer.Ordinal));
    });

    // What the reader of programs says has its names and numbers in its own words: they stand behind what it means.
    [Theory]
    [InlineData(
        "missing-label",
        "N121 GOTO 9999",
        "跳轉沒有目標，或迴圈、分支沒有結束。（原文：N121: the jump goes to block N9999, which does not exist in this program.）")]
    [InlineData("missing-program", "N121 M98 P9999", "所呼叫的程式不存在。（原文：N121: ")]
    [InlineData("expression", "N121 G1 X#500", "要修改的座標由控制器計算（變數或運算式）。（原文：L1, N121: ")]
    public Task A_refusal_of_the_program_is_said_in_the_language_of_the_screen(string code, string line, string chinese) =>
        SetupSeat.AtAsync(ScreenKeys.System, seat =>
    {
        var edits = new JobEdits(seat.Seat.Station.Settings, seat.Seat.Station.Store, seat.Seat.Station.Users);
        var program = File.ReadAllText(Repository.PathTo("samples", "complex-mating", "counterpart.nc"));
        var at = program.IndexOf("N130", StringComparison.Ordinal);
        var changed = DraftProgram.Of(System.Text.Encoding.ASCII.GetBytes(program[..at] + line + "\n" + program[at..]));
        var draft = (seat.Draft with { Program = changed }).WithFeature(0, f => f with { Blocks = "N120, N121" });
        var problems = edits.Check(seat.Shell.Editing.Job!, draft).Problems;
        var problem = problems.FirstOrDefault(p => p.Code == code);
        Assert.True(problem is not null, string.Join(", ", problems));
        Assert.Equal(problem.Message, ProblemText.Of(problem));
        Texts.Current.Language = Language.TraditionalChinese;
        Assert.StartsWith(chinese, ProblemText.Of(problem), StringComparison.Ordinal);
        Assert.Contains(problem.Message, ProblemText.Of(problem), StringComparison.Ordinal);
    });

    private static IEnumerable<string> Shown(SetupSeat seat) => seat.Seat.Window.GetVisualDescendants().OfType<TextBlock>()
        .Where(
            t => t.IsEffectivelyVisible
                && AutomationProperties.GetAutomationId(t) is { } id
                && id.StartsWith("problem-", StringComparison.Ordinal)).Select(t => t.Text ?? "");

    private static byte[] Compensated()
    {
        var sample = Repository.PathTo("samples", "complex-mating");
        return MatingRun.Run(new(Path.Combine(sample, "job.json")), new(), CancellationToken.None).Result!.Program.ToArray();
    }

    private static MatingDraft X(MatingDraft draft, string x) =>
        draft.WithFeature(0, f => f with { Flanks = f.Flanks.Replaced(0, f.Flanks[0].Replaced(0, f.Flanks[0][0] with { X = x })) });

    private static MatingDraft Tool(MatingDraft draft, string diameter) =>
        draft.With("$.counterpart.toolDiameterMm", diameter);

    [GeneratedRegex("[A-Za-z]{4,}", RegexOptions.CultureInvariant, 1000)]
    private static partial Regex Word();
}
