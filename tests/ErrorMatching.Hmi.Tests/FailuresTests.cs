using ErrorMatching.Cell;
using ErrorMatching.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>What is said of work that failed, and what is no failure from outside.</summary>
public sealed class FailuresTests
{
    // A station is closed while a saved job is still being told: that must not end the program.
    [Fact]
    public async Task Work_on_the_store_of_a_closed_station_fails_in_words()
    {
        using var folder = new TemporaryFolder();
        var store = CellStore.Open(new SqliteSettings(Path.Combine(folder.Path, "cell.db")), TimeProvider.System);
        store.Dispose();
        Assert.Equal(
            Texts.Current.Word(StoreError.Away),
            await Failures.OfAsync(() => store.Corrections.InState(CorrectionState.Proposed), TimeProvider.System));
    }

    [Fact]
    public async Task A_defect_is_none() => await Assert.ThrowsAsync<ObjectDisposedException>(
        () => Failures.OfAsync(() => throw new ObjectDisposedException("System.IO.Stream"), TimeProvider.System));
}
