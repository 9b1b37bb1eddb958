namespace ErrorMatching.Cell.Tests;

public abstract partial class StoreTests
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
        Assert.Equal([failed.Id, known.Id, approved.Id], store.Line("mill", "1").Select(c => c.Id));
        Assert.Empty(store.Line("mill", "2"));
        Assert.Equal(cut.Id, store.LastSent("job", null)!.Id);
        Assert.Equal(cut.Id, store.LastSent("job", cut.Serial)!.Id);
        Assert.Null(store.LastSent("job", "A-5"));
        Assert.Null(store.LastSent("other", null));
        Assert.Equal(known.Id, store.LastPart("job", null, null)!.Id);
        Assert.Equal(known.Id, store.LastPart("job", "A-3", "WO-1")!.Id);
        Assert.Null(store.LastPart("job", "A-3", "WO-2"));
        Assert.Equal([known.Id], store.OfMeasurement(known.MeasurementSha256).Select(c => c.Id));
    }
}
