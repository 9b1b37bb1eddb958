using System.Text;

namespace ErrorMatching.Console.Tests;

public sealed class RehearsalTests
{
    [Fact]
    public void A_rehearsal_plays_the_whole_piece()
    {
        var (page, points) = Rehearsal.Run();

        Assert.Equal(25, points);
        Assert.Contains("cuts a surface that is moved by at most", Encoding.UTF8.GetString(page), StringComparison.Ordinal);
    }
}
