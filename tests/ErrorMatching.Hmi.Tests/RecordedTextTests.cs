using System.Text.RegularExpressions;
using ErrorMatching.Cell;
using ErrorMatching.Jobs;
using ErrorMatching.Mating;
using ErrorMatching.Reporting;

namespace ErrorMatching.Hmi.Tests;

[Trait("Length", "Long")]
public sealed partial class RecordedTextTests
{
    // Commands, fields of the configuration, units: the same in every language.
    private static readonly string[] Stored = [
        "errormatch cell release CONFIG", "errormatch", "toolpath.tool", "sumLimitMm", "limitMm", "mostMB", "UTC", "mm",
        "\"base\": \"correct\"", "programSha256", "counterpart"];

    private static readonly SentenceForm[] Forms = [.. Recorded.All, .. WarningForms.All, .. RefusalForms.All];

    [Fact]
    public Task Every_form_is_shown_in_Chinese_with_its_values() => InChinese(() => Assert.All(Forms, form =>
    {
        var statement = Read(form.With([.. form.Kinds.Select(Sample)]).Text);
        var shown = RecordedText.Of(statement);
        Assert.DoesNotMatch(English(), Without(shown, Stored));
        Assert.All(
            statement.Values.Zip(form.Kinds).Where(v => v.Second is "" or ['0' or 'y', ..]),
            v => Assert.Contains(
                SentenceForm.Formatted(v.Second, v.First.Words!) ?? v.First.Words!, shown, StringComparison.Ordinal));
    }));

    [Fact]
    public void Every_form_is_shown_in_English_with_its_values() => Assert.All(Forms, form =>
    {
        var statement = Read(form.With([.. form.Kinds.Select(Sample)]).Text);
        Assert.Same(form, statement.Form);
        Assert.Equal(statement.Text, Read(statement.Text).Text);
        Assert.DoesNotContain('{', RecordedText.Of(statement));
        Assert.DoesNotContain('{', statement.Sentence);
        Assert.All(
            statement.Values.Where((_, i) => form.Kinds[i] is ""),
            v => Assert.Contains(v.Sentence, statement.Sentence, StringComparison.Ordinal));
    });

    [Fact]
    public void Forms_have_names_of_their_own() => Assert.Distinct(Forms.Select(f => f.Name));

    [Fact]
    public Task Words_are_shown_as_they_were_written() => InChinese(() => Assert.All(
        [
            "Coolant ran out",
            "slot",
            "[\"slot\",\"A\",\"m1\"]",
            "\u001e[\"slot\",\"A\"",

            // Of earlier versions.
            "displaced by at most 0.3283 mm at block N150. C1 has 3 key points on 40 mm; one per 5 mm is recommended.",
            "policy: automatic within 0.05 mm",
            "slot A of m1",
            ""],
        r => Assert.Equal(r, RecordedText.Of(Read(r)))));

    [Fact]
    public Task Of_several_statements_each_is_shown() => InChinese(() => Assert.Equal(
        "最大位移 0.3283\u00a0mm，在單節 N150。C1 在 40\u00a0mm 上有 3 個關鍵點；建議每 5\u00a0mm 一點。Somebody says more.",
        RecordedText.Of(Read(Statement.InARow(
            Recorded.DisplacedAt.With(0.32829999999999998, Recorded.AtBlock.With("N150")),
            WarningForms.SparsePoints.With("C1", "3", "40", "5"),
            "Somebody says more.").Text))));

    [Fact]
    public Task A_code_that_this_station_does_not_know_is_shown_with_its_values() => InChinese(() => Assert.Equal(
        "newer-code: A; the machine held it after a cut", RecordedText.Of(Read("\u001e[\"newer-code\",\"A\",[\"held-after-cut\"]]"))));

    [Fact]
    public Task Nothing_that_a_cell_records_is_left_in_English_on_a_Chinese_screen() => Seat.AtAsync(async seat =>
    {
        Texts.Current.Language = Language.TraditionalChinese;
        var (cell, store, users) = (seat.Cell, seat.Station.Store, seat.Station.Users);
        var decisions = new CorrectionDecisions(store);
        cell.Run();
        cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        decisions.Approve(1, DemoCell.Setter, null);
        seat.WaitFor(1, CorrectionState.Verified);
        cell.FinishPiece();
        seat.WaitFor(1, CorrectionState.Released);
        cell.Deliver(2, 0.02);
        seat.WaitFor(2, CorrectionState.Proposed);
        decisions.Approve(2, DemoCell.Setter, null);
        seat.WaitFor(2, CorrectionState.Verified);
        await new SlotReversal(
            cell.Settings,
            store,
            m => MachineFolders.Open(m, () => null),
            TimeProvider.System).RevertAsync(2, DemoCell.Setter, "換刀", CancellationToken.None);
        decisions.Release(2, DemoCell.Operator, null);
        cell.Deliver(3, 0.02);
        seat.WaitFor(3, CorrectionState.Proposed);
        cell.Deliver(3, 0.01);
        seat.WaitFor(3, CorrectionState.Superseded);
        seat.WaitFor(4, CorrectionState.Proposed);
        decisions.Reject(4, DemoCell.Operator, "量錯");
        cell.Deliver(3, 0.01);
        seat.WaitFor(() => store.Find(5)?.State is CorrectionState.Refused or CorrectionState.Proposed, "The same file is not taken.");
        cell.Deliver(6, 3);
        seat.WaitFor(6, CorrectionState.Refused);
        await File.WriteAllTextAsync(
            Path.Combine(cell.Settings.Gauges[0].Incoming!, "X1.csv"), "point,x,y\n1,0,0\n", CancellationToken.None);
        seat.WaitFor(7, CorrectionState.Refused);
        cell.DeliverCounterpart(1, 0);
        seat.WaitFor(8, CorrectionState.Recorded);
        cell.DeliverSurface(1, 0);
        seat.WaitFor(9, CorrectionState.Proposed);

        SignedIn Ada() => users.SignIn(DemoCell.Administrator, DemoCell.Password);
        users.SetRole(Ada(), DemoCell.Operator, Role.Setter);
        users.Disable(Ada(), DemoCell.Operator);
        Assert.Throws<PeopleException>(() => users.SignIn(DemoCell.Operator, DemoCell.Password));
        users.Enable(Ada(), DemoCell.Operator);
        Assert.Throws<PeopleException>(() => users.SignIn("X2", DemoCell.Password));
        for (var i = 0; i < 5; i++)
        {
            Assert.Throws<PeopleException>(() => users.SignIn(DemoCell.Operator, "X3"));
        }

        var job = cell.Settings.Jobs[0];
        new JobEdits(cell.Settings, store, users).Save(job, MatingDraftFiles.Open(job.File), JobEdits.Sha256Of(job), Ada());
        seat.SignIn(DemoCell.Setter).Tap("sign-out");
        seat.WaitFor(() => seat.Shell.IsLocked, "Nobody is signed out.");
        seat.SignIn(DemoCell.Setter).Tap("nav-messages");
        var screen = (MessagesViewModel)seat.Shell.Current!;
        seat.WaitFor(() => screen.Entries.Count == store.AuditEntries(0, 1000).Count, "The trail is not shown whole.");
        string[] names =
        [
            // Files first: a word for a field is a part of a file's name.
            "counterpart.nc", .. Stored, "FINISH.MPF", "A.READY", "job.json", "theoretical.csv", "X1.csv", "Sample cell",
            .. cell.Settings.Jobs.Select(j => j.Name), .. cell.Settings.Gauges.Select(g => g.Name),
            .. cell.Settings.Machines.Select(m => m.Name), DemoCell.Setter, DemoCell.Operator, DemoCell.Administrator,
        ];
        Assert.All(
            screen.Entries,
            e => Assert.DoesNotMatch(English(), Without(NameOrHash().Replace($"{e.Who} {e.What} {e.Subject} {e.Basis}", ""), names)));
        foreach (var id in Enumerable.Range(1, 9))
        {
            var detail = new CorrectionDetail(StoredCorrection.Read(store, store.Find(id)!), seat.Clock);
            Assert.All(
                detail.Steps, s => Assert.DoesNotMatch(English(), Without(NameOrHash().Replace($"{s.By} {s.State} {s.Basis}", ""), names)));
        }
    });

    private static object Sample(string kind, int index) => kind switch
    {
        "" => $"X{index + 3}",
        SentenceForm.Word => "setter",
        SentenceForm.State => "proposed",
        ['0', ..] => 7.25,
        ['y', ..] => new DateTimeOffset(2026, 11, 22, 8, 0, 0, TimeSpan.Zero),
        _ when SentenceForm.SeparatorOf(kind) is not null =>
            Statement.InARow(Recorded.AtPoint.With("X1"), Recorded.AtPointOf.With("X1", "X2")),
        _ => throw new ArgumentOutOfRangeException(nameof(kind), kind, "A kind without a sample."),
    };

    private static Statement Read(string text) => Statement.Read(text, Forms.ToDictionary(f => f.Name, StringComparer.Ordinal));

    private static string Without(string text, IEnumerable<string> names) =>
        names.Aggregate(text, (t, n) => t.Replace(n, "", StringComparison.Ordinal));

    [GeneratedRegex("[A-Za-z]{2,}", RegexOptions.None, 1000)]
    private static partial Regex English();

    [GeneratedRegex(
        @"[0-9a-f]{8,64}…?|(part|counterpart|surface)-\d{4}\.csv|\^(part|counterpart|surface)-.*?\$", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex NameOrHash();

    // The language is the process's: whoever needs another one waits for the turn.
    private static Task InChinese(Action test) => Drawing.Needed().RunAsync(() =>
    {
        Texts.Current.Language = Language.TraditionalChinese;
        try
        {
            test();
        }
        finally
        {
            Texts.Current.Language = Language.English;
        }

        return Task.CompletedTask;
    });
}
