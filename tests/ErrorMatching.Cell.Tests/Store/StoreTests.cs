using System.Globalization;
using System.Text;

namespace ErrorMatching.Cell.Tests;

/// <summary>Arrivals and steps of corrections.</summary>
public abstract class StoreTests(StoreKind kind) : StoreTest(kind)
{
    [Fact]
    public void A_file_that_arrives_is_kept_by_its_content()
    {
        var store = Open();
        var (correction, isNew) = store.Archive(Arrival("one", "1;2;3"));
        Assert.True(isNew);
        Assert.Equal(
            new Correction(correction.Id, CorrectionState.Archived, 1, "gauge", "one.csv", Clock.Now, Hash("1;2;3"), 5)
            {
                ChangedAt = Clock.Now,
                Trace = "trace"
            },
            correction);
        Assert.Equal(correction, store.Find(correction.Id));
        Assert.Equal("1;2;3"u8.ToArray(), store.Content(correction.MeasurementSha256));
        Assert.Equal(
            [
                new CorrectionStep(
                    correction.Id, null, CorrectionState.Archived, Clock.Now, "cell", Recorded.Arrived.With("gauge", "one.csv"))],
            store.Corrections.StepsOf(correction.Id));
    }

    [Fact]
    public void The_same_arrival_again_is_the_correction_that_is_there()
    {
        var store = Open();
        var first = store.Archive(Arrival("one", "1")).Correction;
        Assert.Equal((first, false), store.Archive(Arrival("one", "1")));
        var second = store.Archive(Arrival("two", "1"));
        Assert.True(second.IsNew);
        Assert.True(second.Correction.Id > first.Id);
        Assert.Equal(2, store.Corrections.InState(CorrectionState.Archived).Count);
    }

    [Fact]
    public void A_step_is_seen_by_whoever_opens_the_store_next()
    {
        long id;
        using (var store = CellStore.Open(Settings, Clock))
        {
            var correction = Recognize(store, store.Archive(Arrival("one", "1")).Correction, "A-1");
            Clock.Now = Clock.Now.AddSeconds(1);
            correction = store.Step(
                correction,
                CorrectionState.Computed,
                "cell",
                "computed",
                c => c with { ProgramSha256 = Hash("G1"), LargestMm = 0.1, SumMm = double.BitIncrement(0.2) },
                [Bytes("G1")]);
            Assert.Equal(correction, store.Find(correction.Id));
            Assert.Equal((CorrectionState.Computed, 3, Clock.Now), (correction.State, correction.Version, correction.ChangedAt));
            id = correction.Id;
        }

        var again = Open();
        var found = again.Find(id)!;
        Assert.Equal(("A-1", "WO-1", 0.1, double.BitIncrement(0.2)), (found.Serial, found.WorkOrder, found.LargestMm, found.SumMm));
        Assert.Equal(("one.csv", "gauge", "trace", Hash("1")), (found.FileName, found.Gauge, found.Trace, found.MeasurementSha256));
        Assert.Equal("G1"u8.ToArray(), again.Content(found.ProgramSha256!));
        Assert.Equal(
            [CorrectionState.Archived, CorrectionState.Recognized, CorrectionState.Computed],
            again.Corrections.StepsOf(id).Select(s => s.To));
    }

    [Fact]
    public void What_is_not_in_the_table_of_steps_does_not_happen()
    {
        var store = Open();
        var correction = store.Archive(Arrival("one", "1")).Correction;
        Assert.Equal(
            StoreError.Conflict,
            Assert.Throws<StoreException>(() => store.Step(correction, CorrectionState.Approved, "eve", "wish")).Error);
        Assert.Equal(correction, store.Find(correction.Id));
    }

    [Fact]
    public void A_step_from_what_is_no_longer_so_is_a_conflict()
    {
        var store = Open();
        var correction = store.Archive(Arrival("one", "1")).Correction;
        Recognize(store, correction, "A-1");
        Assert.Equal(
            StoreError.Conflict,
            Assert.Throws<StoreException>(() => store.Step(correction, CorrectionState.Refused, "cell", "late")).Error);
        Assert.Equal(2, store.Corrections.StepsOf(correction.Id).Count);
    }

    [Fact]
    public void A_step_changes_nothing_of_the_arrival()
    {
        var store = Open();
        var correction = store.Archive(Arrival("one", "1")).Correction;
        var after = store.Step(
            correction,
            CorrectionState.Refused,
            "cell",
            "nobody's",
            c => new Correction(c.Id + 1, CorrectionState.Verified, 9, "other", "other", c.ArrivedAt.AddDays(1), Hash("2"), 2)
            {
                Code = "unknown",
                Reason = "No job has such files."
            });
        Assert.Equal(
            correction with
            {
                State = CorrectionState.Refused,
                Version = 2,
                Code = "unknown",
                Reason = "No job has such files.",
                Trace = null
            },
            after);
        Assert.Equal(after, store.Find(correction.Id));
        Assert.Null(store.Find(correction.Id + 1));
    }

    [Fact]
    public void One_identity_is_recognized_once()
    {
        var store = Open();
        var first = store.Archive(Arrival("one", "1")).Correction;
        var second = store.Archive(Arrival("two", "1")).Correction;
        Recognize(store, first, "A-1", "identity");
        Assert.Equal(first.Id, Assert.Throws<DuplicateCorrectionException>(() => Recognize(store, second, "A-1", "identity")).Existing);
        Assert.Equal(second, store.Find(second.Id));
    }

    [Fact]
    public void Writers_in_four_threads_make_one_chain()
    {
        const int EachDoes = 150;
        var first = Open();
        CellStore[] stores = [first, Kind.IsShared ? Open() : first];
        var failures = new List<Exception>();
        var threads = Enumerable.Range(0, 4).Select(t => new Thread(() =>
        {
            try
            {
                for (var i = 0; i < EachDoes; i++)
                {
                    var name = string.Create(CultureInfo.InvariantCulture, $"{t}-{i}");
                    var correction = stores[t % 2].Archive(new Arrival("gauge", name, name, Encoding.UTF8.GetBytes(name))).Correction;
                    correction = stores[t % 2].Step(
                        correction, CorrectionState.Recognized, "cell", "by name", c => c with { Identity = name });
                    correction = stores[t % 2].Step(correction, CorrectionState.Computed, "cell", "computed");
                    stores[t % 2].Step(correction, CorrectionState.Proposed, "cell", "within limits");
                }
            }
            catch (Exception failure)
            {
                lock (failures) failures.Add(failure);
            }
        })).ToArray();
        foreach (var thread in threads) thread.Start();
        foreach (var thread in threads) thread.Join();

        Assert.Empty(failures);
        Assert.Equal(1 + 4 * 4 * EachDoes, stores[0].ChangeCount());
        Assert.Null(stores[1].VerifyAudit());
        Assert.Equal(4 * EachDoes, stores[0].Corrections.InState(CorrectionState.Proposed).Count);
    }
}
