namespace ErrorMatching.Cell.Tests;

/// <summary>Corrections in line, and the first and the latest of them.</summary>
public abstract class StoreLineTests(StoreKind kind) : StoreTest(kind)
{
    [Fact]
    public void In_line_for_a_slot_stands_what_may_still_be_sent_in_order_of_arrival()
    {
        var store = Open();
        store.Archive(Arrival("nobody", "0"));
        var cut = Release(store, "one", "G1");
        var failed = store.Step(Up(store, Approve(store, "two", "G2")), CorrectionState.Failed, "cell", "the disk is full");
        var known = Recognize(store, store.Archive(Arrival("three", "3")).Correction, "A-3");
        var approved = Approve(store, "four", "G4");
        store.Step(Recognize(store, store.Archive(Arrival("five", "5")).Correction, "A-5"), CorrectionState.Failed, "cell", "no file");
        Assert.Equal([failed.Id, known.Id, approved.Id], store.Corrections.Line("mill", "1").Select(c => c.Id));
        Assert.Empty(store.Corrections.Line("mill", "2"));
        Assert.Equal(cut.Id, store.Corrections.LastSent("job", null)!.Id);
        Assert.Equal(cut.Id, store.Corrections.LastSent("job", cut.Serial)!.Id);
        Assert.Null(store.Corrections.LastSent("job", "A-5"));
        Assert.Null(store.Corrections.LastSent("other", null));
        Assert.Equal(known.Id, store.Corrections.LastPart("job", null, null)!.Id);
        Assert.Equal(known.Id, store.Corrections.LastPart("job", "A-3", "WO-1")!.Id);
        Assert.Null(store.Corrections.LastPart("job", "A-3", "WO-2"));
        Assert.Equal([known.Id], store.Corrections.OfMeasurement(known.MeasurementSha256).Select(c => c.Id));
    }

    [Fact]
    public void The_first_in_line_is_found_without_the_others_whatever_was_given_again()
    {
        var store = Open();
        Assert.Null(FirstInLine());
        Approve(store, "elsewhere", "G0");
        var ids = Enumerable.Range(1, 5).Select(i => Approve(store, $"file {i}", $"H{i}").Id).ToArray();
        Assert.Equal(FirstInLine()!.Id, store.Corrections.Line("mill", "1")[0].Id);

        // The third, then the first is recalculated: each keeps its place.
        store.Recalculate(store.Find(ids[2])!, "anna", null);
        FirstInLine();
        var again = store.Recalculate(store.Corrections.Line("mill", "1")[0], "anna", null);
        Assert.Equal(again.Id, FirstInLine()!.Id);
        var failed = store.Step(Recognize(store, again, "A-9"), CorrectionState.Failed, "cell", "no file");
        Assert.NotEqual(failed.Id, FirstInLine()!.Id);
        while (FirstInLine() is { } first) store.Step(first, EndOf(first.State), "cell", "for the test");

        Correction? FirstInLine()
        {
            var first = store.Corrections.FirstInLine("mill", "1");
            Assert.Equal(store.Corrections.Line("mill", "1") is [var expected, ..] ? expected.Id : null, first?.Id);
            return first;
        }

        static CorrectionState EndOf(CorrectionState state) =>
            state is CorrectionState.Archived or CorrectionState.Recognized ? CorrectionState.Refused : CorrectionState.Rejected;
    }

    [Fact]
    public void The_first_in_a_state_are_those_of_the_gauges_and_jobs_that_are_asked_for()
    {
        var store = Open();
        var (one, two) = (store.Archive(Arrival("one", "1")).Correction, store.Archive(Arrival("two", "2")).Correction);
        Assert.Equal([one.Id, two.Id], store.Corrections.First(CorrectionState.Archived, 10).Select(c => c.Id));
        Assert.Equal([one.Id], store.Corrections.First(CorrectionState.Archived, 1, ["other", "gauge"]).Select(c => c.Id));
        Assert.Empty(store.Corrections.First(CorrectionState.Archived, 10, ["other"]));
        Assert.Empty(store.Corrections.First(CorrectionState.Archived, 10, []));
        Recognize(store, two, "A-2");
        Assert.Equal([two.Id], store.Corrections.First(CorrectionState.Recognized, 10, jobs: ["job", "other"]).Select(c => c.Id));
        Assert.Empty(store.Corrections.First(CorrectionState.Recognized, 10, ["gauge"], ["other"]));
    }

    [Fact]
    public void Reported_are_the_latest_of_some_jobs_that_have_a_report()
    {
        var store = Open();
        var ids = new List<long>();
        foreach (var name in new[] { "one", "two", "three" })
        {
            var known = Recognize(store, store.Archive(Arrival(name, name)).Correction, name);
            ids.Add(
                store.Step(
                    known,
                    CorrectionState.Computed,
                    "cell",
                    "computed",
                    c => c with { ReportSha256 = Hash("report " + name) },
                    [Bytes("report " + name)]).Id);
        }

        Recognize(store, store.Archive(Arrival("four", "4")).Correction, "A-4");
        Assert.Equal(ids.AsEnumerable().Reverse(), store.Corrections.Reported(["job", "other"], 10).Select(c => c.Id));
        Assert.Equal([ids[2], ids[1]], store.Corrections.Reported(["job"], 2).Select(c => c.Id));
        Assert.Empty(store.Corrections.Reported(["other"], 10));
        Assert.Empty(store.Corrections.Reported([], 10));
    }
}
