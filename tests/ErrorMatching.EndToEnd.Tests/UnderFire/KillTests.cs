using System.Globalization;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>The process dies at any instant, again and again: no measurement is lost, none is applied twice,
/// no program is ever seen in part.</summary>
/// <remarks>20 times here, 500 times by <c>tests/fire kill 500</c>.</remarks>
public sealed class KillTests
{
    private static readonly int Times = int.Parse(
        Environment.GetEnvironmentVariable("ERRORMATCH_KILLS") ?? "8", CultureInfo.InvariantCulture);

    [Fact]
    public async Task Nothing_is_lost_or_done_twice_however_often_the_process_dies()
    {
        using var cell = new FireCell(slots: 4);
        await FireKills.Run(cell, Times, seed: 7);
    }
}
