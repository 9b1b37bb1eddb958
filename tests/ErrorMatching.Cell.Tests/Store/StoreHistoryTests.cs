namespace ErrorMatching.Cell.Tests;

/// <summary>The history, the audit trail, and what is stored of texts and times.</summary>
public abstract class StoreHistoryTests(StoreKind kind) : StoreTest(kind)
{
    [Fact]
    public void Who_had_a_part_in_a_correction_is_known_and_written_as_a_table()
    {
        var store = Open();
        var first = Release(store, "one", "G1");
        var second = store.Archive(Arrival("two", "2")).Correction;
        second = store.Step(second, CorrectionState.Refused, "cell", "no job", c => c with { Code = "unknown-piece", Reason = "+1" });
        var third = store.Archive(Arrival("three", "3")).Correction;
        third = store.Step(
            Recognize(store, third, "=A1"),
            CorrectionState.Computed,
            "cell",
            "computed",
            c => c with { ProgramSha256 = Hash("G3") },
            [Bytes("G3")]);
        third = store.Step(store.Step(third, CorrectionState.Proposed, "cell", "within limits"), CorrectionState.Rejected, "bert", "no");
        var people = store.Corrections.PeopleOf([first.Id, second.Id, third.Id]);
        Assert.Equal([first.Id, third.Id], people.Keys.Order());
        Assert.Equal(["anna"], people[first.Id]);
        Assert.Equal(["bert"], people[third.Id]);
        Assert.Empty(store.Corrections.PeopleOf([]));

        using var csv = new StringWriter();
        HistoryCsv.Write(csv, [store.Find(first.Id)!, store.Find(second.Id)!, store.Find(third.Id)!], people);
        var rows = csv.ToString().Split("\r\n");
        Assert.Equal(5, rows.Length);
        Assert.Contains("\"released\"", rows[1], StringComparison.Ordinal);
        Assert.Contains(",\"anna\",\"\"", rows[1], StringComparison.Ordinal);
        Assert.EndsWith("\"\",\"unknown-piece: +1\"", rows[2], StringComparison.Ordinal);

        // Nothing that a spreadsheet would calculate.
        Assert.Contains("\"'=A1\"", rows[3], StringComparison.Ordinal);
    }

    [Fact]
    public void The_trail_is_found_by_person_piece_word_and_time_latest_first()
    {
        var store = Open();
        var start = Clock.Now;
        var first = Release(store, "one", "G1");
        Clock.Now = start.AddHours(1);
        var second = Approve(store, "two", "G2");
        store.Audit("bert", "secret-set", "", "mill");
        store.Audit("bert_%!", "note", "100 %", "lathe");

        Assert.Equal(store.AuditEntries(0, 100).Reverse().Select(e => e.Seq), Found(new() { Most = 100 }));
        Assert.Equal([.. Found(new() { Most = 100 }).Take(3)], Found(new() { Most = 3 }));
        Assert.Equal(["approved", "released", "approved"], Words(new() { Who = "ANN" }));
        Assert.Equal(["note", "secret-set"], Words(new() { Who = "bert" }));
        Assert.Equal(["note"], Words(new() { Who = "_%!" }));
        Assert.Equal(["approved", "approved"], Words(new() { What = ["approved"] }));
        Assert.Equal(["approved"], Words(new() { What = ["approved"], From = start.AddHours(1) }));
        Assert.Equal(["approved"], Words(new() { What = ["approved"], To = start.AddHours(1) }));
        Assert.Equal(["released", "verified", "uploading", "approved", "proposed", "computed", "recognized", "archived"],
            Words(new() { About = "ONE" }));
        Assert.Equal(8 + 5, Words(new() { About = "WO-1" }).Length);
        Assert.Equal(["secret-set"], Words(new() { About = "mill" }));
        Assert.Equal(["note"], Words(new() { About = "ath", Who = "bert" }));
        Assert.Equal([], Words(new() { About = "' OR 1 = 1 --" }));
        Assert.Equal([], Words(new() { What = ["x') OR (1 = 1"] }));
        Assert.Equal(["note"], Words(new() { After = store.AuditHead().Seq - 1 }));
        Assert.NotEqual(first.Id, second.Id);

        long[] Found(TrailQuery query) => [.. store.SearchTrail(query).Select(e => e.Seq)];
        string[] Words(TrailQuery query) => [.. store.SearchTrail(query).Select(e => e.What)];
    }

    [Fact]
    public void History_is_found_by_each_thing_that_is_known_of_a_correction()
    {
        var store = Open();
        var start = Clock.Now;
        var first = Release(store, "one", "G1");
        Clock.Now = start.AddHours(1);
        var second = Approve(store, "two", "G2");
        Clock.Now = start.AddHours(2);
        var third = store.Archive(Arrival("three", "3")).Correction;
        third = store.Step(
            third,
            CorrectionState.Recognized,
            "bert",
            "by hand",
            c => c with { Serial = "A-9", WorkOrder = "WO-9", Machine = "lathe", Program = "O9.nc" });

        Is([first], new HistoryQuery { Serial = "one" });
        Is([third], new HistoryQuery { WorkOrder = "WO-9" });
        Is([second, first], new HistoryQuery { WorkOrder = "WO-1" });
        Is([third, second], new HistoryQuery { From = start.AddHours(1) });
        Is([first], new HistoryQuery { To = start.AddHours(1) });
        Is([second], new HistoryQuery { From = start.AddMinutes(1), To = start.AddHours(2) });
        Is([second, first], new HistoryQuery { Program = "O1.nc" });
        Is([second], new HistoryQuery { Program = Hash("G2") });
        Is([second], new HistoryQuery { Program = Hash("G2")[..8].ToUpperInvariant() });
        Is([], new HistoryQuery { Program = Hash("G2")[..7] });
        Is([second, first], new HistoryQuery { User = "anna" });
        Is([third], new HistoryQuery { User = "bert" });
        Is([first], new HistoryQuery { State = CorrectionState.Released });
        Is([third], new HistoryQuery { Machine = "lathe" });
        Is([first], new HistoryQuery { User = "anna", WorkOrder = "WO-1", To = start.AddMinutes(1), State = CorrectionState.Released });
        Is([], new HistoryQuery { Serial = "one", State = CorrectionState.Approved });
        Is([], new HistoryQuery { Serial = "' OR 1 = 1 --" });
        Is([third, second], new HistoryQuery { Most = 2 });
        foreach (var (count, query) in new (int, HistoryQuery)[]
        {
            (3, new() { Most = 1 }),
            (2, new() { Most = 1, User = "anna" }),
            (2, new() { Most = 1, WorkOrder = "WO-1" }),
            (2, new() { Most = 1, IsLoose = true, Program = "o1" }),
            (2, new() { Most = 1, From = start.AddHours(1) }),
            (0, new() { User = "nobody" }),
        })
        {
            Assert.Equal(count, store.Count(query));
        }

        Is([second, first], new HistoryQuery { IsLoose = true, WorkOrder = "o-1" });
        Is([third, second, first], new HistoryQuery { IsLoose = true, WorkOrder = "WO" });
        Is([], new HistoryQuery { IsLoose = true, WorkOrder = "W_-1" });
        Is([], new HistoryQuery { IsLoose = true, WorkOrder = "%" });
        Is([second, first], new HistoryQuery { IsLoose = true, User = "ANN" });
        Is([second, first], new HistoryQuery { IsLoose = true, Program = "o1" });
        Is([third, second, first], new HistoryQuery());

        // A piece that says no work order is found by that of its job, another only by its own.
        var fourth = store.Archive(Arrival("four", "4")).Correction;
        fourth = store.Step(fourth, CorrectionState.Recognized, "cell", "by name", c => c with { JobWorkOrder = "JOB-1" });
        third = store.Step(third, CorrectionState.Refused, "cell", "no", c => c with { JobWorkOrder = "JOB-1" });
        Is([fourth], new HistoryQuery { WorkOrder = "JOB-1" });
        Is([third], new HistoryQuery { WorkOrder = "WO-9" });

        void Is(Correction[] wanted, HistoryQuery query) => Assert.Equal(wanted, store.Search(query));
    }

    // The law: a search finds what is left if all corrections are looked at one by one, also behind a clock that was set back.
    [Fact]
    public void A_search_finds_what_looking_at_each_correction_finds()
    {
        var (store, random, start) = (Open(), new Random(1), Clock.Now);
        var all = new List<(Correction Correction, string By)>();
        for (var i = 0; i < 25; i++)
        {
            Clock.Now = start.AddHours(i + random.Next(-3, 1));
            var (c, by) = (store.Archive(Arrival($"file {i}", $"file {i}")).Correction, $"user {random.Next(3)}");
            if (random.Next(5) == 0) c = store.Step(c, CorrectionState.Refused, by, "no");
            else c = store.Step(c, CorrectionState.Recognized, by, "by hand", x => x with { Serial = $"S{i % 7}", Machine = $"m{i % 2}" });
            all.Add((c, by));
        }

        for (var i = 0; i < 150; i++)
        {
            var query = new HistoryQuery
            {
                From = random.Next(2) == 0 ? start.AddHours(random.Next(-1, 26)) : null,
                To = random.Next(2) == 0 ? start.AddHours(random.Next(-1, 26)) : null,
                User = random.Next(3) == 0 ? $"user {random.Next(4)}" : null,
                Serial = random.Next(4) == 0 ? $"S{random.Next(8)}" : null,
                State = random.Next(3) == 0 ? CorrectionState.Recognized : null,
                Machine = random.Next(4) == 0 ? $"m{random.Next(3)}" : null,
                Most = random.Next(1, 30),
            };
            Assert.Equal(
                all.Where(c => (query.From is null || c.Correction.ArrivedAt >= query.From)
                        && (query.To is null || c.Correction.ArrivedAt < query.To)
                        && (query.User ?? c.By) == c.By
                        && (query.Serial is null || query.Serial == c.Correction.Serial)
                        && (query.State ?? c.Correction.State) == c.Correction.State
                        && (query.Machine is null || query.Machine == c.Correction.Machine))
                    .Select(c => c.Correction).OrderByDescending(c => c.Id).Take(query.Most),
                store.Search(query));
        }
    }

    [Fact]
    public void Corrections_in_a_state_come_in_order_of_arrival()
    {
        var store = Open();
        var (first, second, third) = (
            Approve(store, "one", "1"), store.Archive(Arrival("two", "2")).Correction, Approve(store, "three", "3"));
        Assert.Equal([first, third], store.Corrections.InState(CorrectionState.Approved));
        Assert.Equal([first, second, third], store.Corrections.InState(CorrectionState.Archived, CorrectionState.Approved));
        Assert.Empty(store.Corrections.InState());
    }

    [Fact]
    public void A_file_that_is_not_kept_is_refused_and_accounted_for()
    {
        var store = Open();
        var arrival = new UnreadArrival("gauge", "huge.csv", "huge", Hash("huge"), 1L << 40, "too-large", "The file has 1 TB.");
        var (correction, isNew) = store.ArchiveUnread(arrival);
        Assert.True(isNew);
        Assert.Equal(
            (CorrectionState.Refused, "too-large", "The file has 1 TB.", 1L << 40),
            (correction.State, correction.Code, correction.Reason, correction.MeasurementBytes));
        Assert.Equal(correction, store.Find(correction.Id));
        Assert.Equal((correction, false), store.ArchiveUnread(arrival));
        Assert.Equal([(null, CorrectionState.Refused)], store.Corrections.StepsOf(correction.Id).Select(s => (s.From, s.To)));
        Assert.Equal(StoreError.Missing, Assert.Throws<StoreException>(() => store.Content(correction.MeasurementSha256)).Error);
    }

    [Fact]
    public void Each_change_is_an_entry_of_the_audit_trail()
    {
        var store = Open(AuditKey);
        var released = Release(store, "one", "G1");
        store.Audit("anna", "signed-in", "password");
        store.FreeSlot("mill", "1", released.Id, "anna", "is free already");
        var program = $"correction {released.Id} program {Hash("G1")}";
        Assert.Equal(
            [
                ("cell", "created", null),
                ("cell", "archived", $"correction {released.Id} file {Hash("one")}"),
                ("cell", "recognized", $"correction {released.Id}"),
                ("cell", "computed", program),
                ("cell", "proposed", program),
                ("anna", "approved", program),
                ("cell", "uploading", program),
                ("cell", "verified", program),
                ("anna", "released", program),
                ("anna", "signed-in", null),
            ],
            store.AuditEntries(0, 100).Select(e => (e.Who, e.What, e.Subject?.Sentence)));
        Assert.Equal("looks right", store.AuditEntries(5, 1).Single().Basis);
        Assert.Equal(10, store.ChangeCount());
        Assert.Null(store.VerifyAudit());
    }

    [Fact]
    public void What_did_not_happen_is_no_entry()
    {
        var store = Open();
        var correction = store.Archive(Arrival("one", "1")).Correction;
        var before = store.AuditHead();
        Assert.Throws<StoreException>(() => store.Step(
            correction, CorrectionState.Recognized, "cell", "by name", c => c with { BaseSha256 = Hash("not kept") }));
        Assert.Throws<DivideByZeroException>(() => store.Write<int>(t =>
        {
            t.Audit("anna", "tried", null, "and failed");
            throw new DivideByZeroException();
        }));
        Assert.Equal(before, store.AuditHead());
        Assert.Equal(correction, store.Find(correction.Id));
        Assert.Null(store.VerifyAudit());
    }

    [Fact]
    public void A_correction_names_only_contents_that_are_kept()
    {
        var store = Open();
        var correction = store.Archive(Arrival("one", "1")).Correction;
        Assert.Equal(
            StoreError.Missing,
            Assert.Throws<StoreException>(() => store.Step(
                correction, CorrectionState.Recognized, "cell", "by name", c => c with { BaseSha256 = Hash("O1") })).Error);
        store.Step(correction, CorrectionState.Recognized, "cell", "by name", c => c with { BaseSha256 = Hash("O1") }, [Bytes("O1")]);
    }

    [Fact]
    public void A_store_without_its_key_does_not_pass_for_a_sealed_one()
    {
        using (var sealing = CellStore.Open(Settings, Clock, AuditKey)) sealing.Audit("anna", "signed-in", "password");
        using (var without = CellStore.Open(Settings, Clock))
        {
            Assert.Null(without.VerifyAudit());
            without.Audit("eve", "signed-in", "without the key");
        }

        var store = Open(AuditKey);
        Assert.Equal(AuditFaultKind.Unsealed, store.VerifyAudit()?.Kind);
        store.Audit("anna", "signed-in", "password");
        Assert.Equal(AuditFaultKind.Unsealed, store.VerifyAudit()?.Kind);
    }

    [Theory]
    [InlineData("UPDATE audit SET who = 'eve' WHERE seq = 1")]
    [InlineData("DELETE FROM audit WHERE seq = 2")]
    [InlineData("DELETE FROM audit")]
    public void The_database_refuses_to_change_the_audit_trail(string sql)
    {
        var store = Open();
        store.Audit("anna", "signed-in", "password");
        var refused = Assert.Throws<StoreException>(() => store.Write(t => t.Execute(sql)));
        Assert.Contains("append-only", refused.Message, StringComparison.Ordinal);
        Assert.Null(store.VerifyAudit());
        Assert.Equal(2, store.AuditEntries(0, 10).Count);
    }

    [Fact]
    public void Whoever_takes_the_triggers_away_and_forges_an_entry_is_found()
    {
        var store = Open();
        var correction = store.Archive(Arrival("one", "1")).Correction;
        Recognize(store, correction, "A-1");
        store.Write(t => t.Execute(Kind.RemoveTriggersSql));
        store.Write(t => t.Execute("UPDATE audit SET who = 'eve' WHERE seq = 2"));
        Assert.Equal((AuditFaultKind.Changed, 2L), (store.VerifyAudit()!.Kind, store.VerifyAudit()!.Seq));
        store.Write(t => t.Execute("UPDATE audit SET who = 'cell' WHERE seq = 2"));
        Assert.Null(store.VerifyAudit());
        store.Write(t => t.Execute("DELETE FROM audit WHERE seq = 3"));
        Assert.Equal((AuditFaultKind.Removed, 3L), (store.VerifyAudit()!.Kind, store.VerifyAudit()!.Seq));
    }

    [Fact]
    public void A_clock_that_jumps_back_is_recorded_and_changes_no_order()
    {
        var store = Open();
        var first = store.Archive(Arrival("one", "1")).Correction;
        Clock.Now = Clock.Now.AddHours(-1);
        var second = store.Archive(Arrival("two", "2")).Correction;
        second = Recognize(store, second, "A-2");
        Assert.Equal(Clock.Now, second.ChangedAt);
        Assert.Equal([first], store.Corrections.InState(CorrectionState.Archived));
        Assert.Equal([second, first], store.Search(new HistoryQuery()));
        Assert.Equal(["created", "archived", "clock", "archived", "recognized"], store.AuditEntries(0, 10).Select(e => e.What));
        Assert.Equal(
            "The clock says 2026-03-01 05:00:00.000000 UTC and said 2026-03-01 06:00:00.000000 before; entries are in order of their "
                + "numbers.",
            store.AuditEntries(2, 1).Single().Basis);
        Assert.Null(store.VerifyAudit());
    }

    [Fact]
    public void A_time_finer_than_a_microsecond_is_what_comes_back()
    {
        Clock.Now = Clock.Now.AddTicks(7);
        var store = Open();
        var correction = store.Archive(Arrival("one", "1")).Correction;
        Assert.Equal(correction, store.Find(correction.Id));
        Assert.Null(store.VerifyAudit());
    }

    [Fact]
    public void Texts_that_no_database_takes_are_kept_as_near_as_may_be()
    {
        var store = Open();
        var correction = store.Archive(new Arrival("gauge", "a\0b.csv", "key", Bytes("1"), new string('t', 5000))).Correction;
        Assert.Equal("a\uFFFDb.csv", correction.FileName);
        var after = store.Step(
            correction,
            CorrectionState.Recognized,
            "an\0na",
            "half a \uD83D character",
            c => c with { Serial = new string('\u20AC', 5000), Reason = "\uDE00" });
        Assert.Equal(after, store.Find(correction.Id));
        Assert.Equal((800, "\uFFFD"), (after.Serial!.Length, after.Reason));
        Assert.Equal("half a \uFFFD character", store.Corrections.StepsOf(correction.Id)[1].Basis);
        Assert.Equal([after], store.Search(new HistoryQuery { Serial = new string('\u20AC', 5000) }));
        Assert.Equal([after], store.Search(new HistoryQuery { User = "an\0na" }));
        Assert.Null(store.VerifyAudit());
    }

    [Fact]
    public void A_content_that_is_not_what_was_kept_is_never_given_out()
    {
        var store = Open();
        var correction = store.Archive(Arrival("one", "1;2;3")).Correction;
        store.Write(t => t.Execute("UPDATE content SET bytes = @Bytes", [("Bytes", "1;2;4"u8.ToArray())]));
        var damaged = Assert.Throws<StoreException>(() => store.Content(correction.MeasurementSha256));
        Assert.Equal(StoreError.Damaged, damaged.Error);
        Assert.Contains(correction.MeasurementSha256, damaged.Message, StringComparison.Ordinal);
    }
}
