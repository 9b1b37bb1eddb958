using System.Diagnostics;

namespace ErrorMatching.Peers.Tests;

/// <summary>Waits for what others still do, such as a server that ends its sessions.</summary>
internal static class Quiet
{
    private static readonly TimeSpan Limit = TimeSpan.FromMinutes(3);

    /// <summary>Waits until it is so, and fails the test if it never is: whatever came then would be looked at too early.</summary>
    public static async Task WhenAsync(Func<bool> isSo, string what)
    {
        var since = Stopwatch.StartNew();
        while (!isSo())
        {
            Assert.True(since.Elapsed < Limit, $"{what}: not after {Limit}.");
            await Task.Delay(2, TestContext.Current.CancellationToken);
        }
    }
}
