namespace ErrorMatching.Cell.Tests;

/// <summary>What is an alarm, how urgent it is, and that what people did about it holds for this occurrence alone.</summary>
public sealed class AlarmTests() : StoreTest(new SqliteKind())
{
    private static readonly DateTimeOffset At = new(2026, 3, 1, 6, 0, 0, TimeSpan.Zero);

    [Fact]
    public void A_cell_that_stands_is_one_alarm_of_high_priority_with_what_was_changed_meanwhile()
    {
        var status = Status(isRunning: false) with { Tampered = ["somebody wrote to the row of ben"] };
        var alarms = Alarm.Of(status).ToArray();
        Assert.Equal([AlarmKind.NotRunning, AlarmKind.Tampered], alarms.Select(a => a.Kind));
        Assert.All(alarms, a => Assert.Equal((AlarmPriority.High, false), (a.Priority, a.MayBeShelved)));
        Assert.Equal(At, alarms[0].Since);

        // A running cell reports what was changed among its troubles.
        Assert.Empty(Alarm.Of(Status(isRunning: true) with { Tampered = status.Tampered }));
    }

    [Theory]
    [InlineData("machine-away", AlarmPriority.Medium)]
    [InlineData("gauge-away", AlarmPriority.Medium)]
    [InlineData("changed-at-machine", AlarmPriority.High)]
    [InlineData("started-meanwhile", AlarmPriority.High)]
    [InlineData("store-tampered", AlarmPriority.High)]
    public void A_trouble_is_as_urgent_as_the_doubt_about_what_a_machine_cuts(string code, AlarmPriority priority)
    {
        var alarm = Assert.Single(Alarm.Of(Status(isRunning: true, new CellTrouble("machine vmc1", code, "why", At.AddHours(1)))));
        Assert.Equal(
            (AlarmKind.Trouble, $"machine vmc1: {code}", priority, At.AddHours(1)), (alarm.Kind, alarm.Key, alarm.Priority, alarm.Since));
    }

    [Fact]
    public void A_name_with_control_characters_or_of_any_length_makes_a_key()
    {
        var alarm = Assert.Single(Alarm.Of(
            Status(isRunning: true, new CellTrouble($"machine a\n{new string('b', 500)}", "machine-away", "why", At))));
        Assert.Equal(Alarm.MostCharacters, alarm.Key.Length);
        Assert.StartsWith("machine a b", alarm.Key, StringComparison.Ordinal);
    }

    [Fact]
    public void A_failed_correction_is_an_alarm_and_one_to_approve_is_none()
    {
        var store = Open();
        var proposed = Recognize(store, store.Archive(Arrival("one", "1")).Correction, "one");
        var failed = store.Step(proposed, CorrectionState.Failed, "cell", "the machine is away");
        var alarm = Assert.Single(Alarm.Of(Status(isRunning: true) with { Failed = [failed], Proposed = [proposed] }));
        Assert.Equal(
            (AlarmKind.Failed, $"correction {failed.Id}: failed", AlarmPriority.Medium, failed.ChangedAt),
            (alarm.Kind, alarm.Key, alarm.Priority, alarm.Since));
        Assert.Equal((AlarmKind.Outside, AlarmPriority.Low), (Alarm.OfOutside(failed).Kind, Alarm.OfOutside(failed).Priority));
    }

    [Fact]
    public void Who_acknowledged_an_alarm_first_is_known_until_it_returns()
    {
        var store = Open();
        var (book, alarm) = (new AlarmBook(store, Clock), Trouble(At));
        Assert.False(MarkOf(book, alarm).IsAcknowledged(alarm));
        book.Acknowledge(alarm, "anna");
        Clock.Now = Clock.Now.AddMinutes(1);
        book.Acknowledge(alarm, "ben");
        var mark = MarkOf(book, alarm);
        Assert.Equal((true, "anna", At), (mark.IsAcknowledged(alarm), mark.AcknowledgedBy, mark.AcknowledgedAt));

        // The same trouble later is another occurrence, to the last tick.
        var again = Trouble(At.AddTicks(1));
        Assert.False(MarkOf(book, again).IsAcknowledged(again));
        book.Acknowledge(again, "ben");
        Assert.Equal((true, "ben"), (MarkOf(book, again).IsAcknowledged(again), MarkOf(book, again).AcknowledgedBy));

        // Another process reads the same from the trail, and so does one that nobody can say the beginning of.
        var unknown = new Alarm(AlarmKind.NotRunning, "cell", AlarmPriority.High, null);
        book.Acknowledge(unknown, "carl");
        var other = new AlarmBook(store, Clock);
        Assert.True(MarkOf(other, again).IsAcknowledged(again));
        Assert.True(MarkOf(other, unknown).IsAcknowledged(unknown));
        Assert.Equal(
            ["alarm \"machine vmc1: machine-away\"", "it had lasted since 2026-03-01 06:00:00 UTC"],
            store.SearchTrail(new() { What = [AlarmBook.Acknowledged] }).Where(e => e.Who == "anna")
                .SelectMany(e => new[] { e.Subject!.Sentence, e.Basis.Sentence }));
    }

    [Fact]
    public void A_shelved_alarm_returns_by_itself_or_when_somebody_brings_it_back()
    {
        var store = Open();
        var (book, alarm) = (new AlarmBook(store, Clock), Trouble(At));
        var now = Clock.Now;
        book.Shelve(alarm, TimeSpan.FromHours(2), "anna");
        var mark = MarkOf(book, alarm);
        Assert.Equal(("anna", now.AddHours(2)), (mark.ShelvedBy, mark.ShelvedUntil));
        Assert.True(mark.IsShelved(alarm, now.AddHours(2).AddTicks(-1)));
        Assert.False(mark.IsShelved(alarm, now.AddHours(2)));
        Assert.False(mark.IsAcknowledged(alarm));

        // It is shelved whenever it returns until then, but never while it matters more.
        Assert.True(mark.IsShelved(Trouble(At.AddMinutes(5)), now.AddHours(1)));
        Assert.False(mark.IsShelved(alarm with { Priority = AlarmPriority.High }, now));
        book.Unshelve(alarm, "ben");
        Assert.False(MarkOf(book, alarm).IsShelved(alarm, now));
    }

    [Fact]
    public void An_alarm_of_high_priority_is_not_shelved_and_none_for_longer_than_a_day()
    {
        var store = Open();
        var book = new AlarmBook(store, Clock);
        var high = new Alarm(AlarmKind.NotRunning, "cell", AlarmPriority.High, null);
        Assert.Equal(
            DecisionException.StaysInSight,
            Assert.Throws<DecisionException>(() => book.Shelve(high, TimeSpan.FromHours(1), "anna")).Code);
        Assert.Throws<ArgumentOutOfRangeException>(() => book.Shelve(Trouble(At), AlarmBook.MostShelved + TimeSpan.FromTicks(1), "anna"));
        Assert.Throws<ArgumentOutOfRangeException>(() => book.Shelve(Trouble(At), TimeSpan.Zero, "anna"));
        Assert.Empty(book.Read());
        book.Shelve(Trouble(At), AlarmBook.MostShelved, "anna");
        Assert.Single(book.Read());
    }

    private static AlarmMark MarkOf(AlarmBook book, Alarm alarm) => book.Read().GetValueOrDefault(alarm.Key, AlarmMark.None);

    private static Alarm Trouble(DateTimeOffset since) =>
        Alarm.Of(Status(isRunning: true, new CellTrouble("machine vmc1", "machine-away", "why", since))).Single();

    private static CellStatus Status(bool isRunning, params CellTrouble[] troubles) =>
        new(new(1, At, At, troubles), isRunning, [], [], [], [], new Dictionary<CorrectionState, long>());
}
