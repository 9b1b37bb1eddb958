using System.Diagnostics;
using System.Globalization;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>Ends a cell as a service manager does, and measures how long it takes.</summary>
/// <remarks>
/// The clock is one of naps of 50 ms: each counts as what it was meant to be, however long a busy computer makes it. So it stands still
/// while the computer has no time for the tests, which is when it has none for the cell either; where nothing else runs it is a stopwatch.
/// </remarks>
internal static class FireStop
{
    /// <summary>How long a cell may take to stop.</summary>
    public static readonly TimeSpan Limit = TimeSpan.FromSeconds(10);

    private static readonly TimeSpan Nap = TimeSpan.FromMilliseconds(50);

    /// <summary>Tells a process to end, waits for it, and fails the test if it takes longer than <see cref="Limit"/> or what it is
    /// given.</summary>
    /// <returns>Its exit code.</returns>
    public static async Task<int> Of(Process process, TimeSpan? atMost = null)
    {
        var limit = atMost ?? Limit;
        using (var kill = Process.Start("kill", ["-TERM", process.Id.ToString(CultureInfo.InvariantCulture)]))
        {
            await kill.WaitForExitAsync(TestContext.Current.CancellationToken);
        }

        for (var took = TimeSpan.Zero; !process.WaitForExit(Nap); took += Nap)
        {
            Assert.True(took < limit, $"The cell goes on {limit} after it was told to stop.");
        }

        // Until what it said last is read.
        await process.WaitForExitAsync(TestContext.Current.CancellationToken);
        return process.ExitCode;
    }
}
