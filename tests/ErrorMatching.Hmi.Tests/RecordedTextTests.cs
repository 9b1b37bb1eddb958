using System.Text.RegularExpressions;
using ErrorMatching.Cell;
using ErrorMatching.Jobs;
using ErrorMatching.Mating;

namespace ErrorMatching.Hmi.Tests;

[Trait("Length", "Long")]
public sealed partial class RecordedTextTests
{
    // Commands, fields of the configuration, units: the same in every language.
    private static readonly string[] Kept = [
        "errormatch cell release CONFIG", "errormatch", "sumLimitMm", "limitMm", "mostMB", "UTC", "mm"];

    [Fact]
    public Task Every_form_is_read_back_and_said_in_Chinese_with_its_values() =>
        InChinese(() => Assert.All(Recorded.All.Concat(WarningForms.All).Concat(RefusalForms.All), form =>
    {
        var sentence = form.With([.. form.Kinds.Select(Sample)]);
        var read = form.Read(sentence)!;
        Assert.Equal(sentence, form.With([.. read]));
        var shown = RecordedText.Of(sentence);
        Assert.DoesNotMatch(English(), Without(shown, Kept));
        Assert.All(read.Where((_, i) => form.Kinds[i] is "" or ['0', ..]), v => Assert.Contains(v, shown, StringComparison.Ordinal));
    }));

    [Fact]
    public void Forms_have_names_of_their_own() => Assert.Distinct(Recorded.All.Select(f => f.Name));

    [Fact]
    public Task What_no_form_fits_is_shown_as_it_is_recorded() => InChinese(() => Assert.All(
        [
            "Coolant ran out",
            "because of chips",
            "slot",
            "displaced by at most a lot at block N5.",
            "displaced by at most 0.1 mm at the door.",
            ""],
        r => Assert.Equal(r, RecordedText.Of(r))));

    [Fact]
    public Task Of_several_sentences_those_that_are_known_are_said() => InChinese(() => Assert.Equal(
        "最大位移 0.3283\u00a0mm，在單節 N150。C1 在 40\u00a0mm 上有 3 個關鍵點；建議每 5\u00a0mm 一點。Somebody says more.",
        RecordedText.Of("displaced by at most 0.3283 mm at block N150. C1 has 3 key points on 40 mm; one per 5 mm is recommended. "
                + "Somebody says more.")));

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
            .. Kept, "counterpart.nc", "FINISH.MPF", "A.READY", "job.json", "theoretical.csv", "X1.csv", "Sample cell",
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
        "any" => "the piece is cut",
        "word" => "setter",
        "amount" => "the job's",
        "state" => "proposed",
        "named" => "serial number X1",
        "at" => "point X1 of X2",
        "asked" => "\"X1\" wants a file name like X2; \"X2\" wants a column X1 like X3",
        "like" => "a field X1 like X2",
        "says" => "the serial numbers \"X1\" and \"X2\"",
        "who" => "who was operator then, and this takes setter",
        "form" => "it lacks the X1 X2",
        "wrong" => "wrong password, 3 in a row",
        "policies" =>
            "policy a person, limit the job's, sum 0.3 mm, gain the job's; X1: automatic, limit 0.2 mm, sum none of its own, gain 0.8",
        ['0', ..] => 7,
        ['y', ..] => "2026-11-22 08:00:00",
        _ => throw new ArgumentOutOfRangeException(nameof(kind), kind, "A kind without a sample."),
    };

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
