using System.Diagnostics;

namespace ErrorMatching.Peers.Tests;

/// <summary>Waits for a server to end its sessions.</summary>
internal static class Quiet
{
    private static readonly TimeSpan Limit = TimeSpan.FromMinutes(3);

    /// <summary>Waits until it is so, and fails the test if it never is: whatever came then would be looked at too early.</summary>
    public static async Task WhenAsync(Func<bool> isSo)
    {
        var since = Stopwatch.StartNew();
        while (!isSo())
        {
            Assert.True(since.Elapsed < Limit, $"The server goes on with its sessions for more than {Limit}.");
            await Task.Delay(2, TestContext.Current.CancellationToken);
        }
    }
}
