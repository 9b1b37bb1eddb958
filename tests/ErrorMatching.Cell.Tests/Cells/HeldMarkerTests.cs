namespace ErrorMatching.Cell.Tests;

/// <summary>Finished files that cannot be moved aside: named, kept, and taken once as soon as they can be.</summary>
public sealed class HeldMarkerTests
{
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void A_file_with_a_marker_that_cannot_be_moved_is_named_and_not_lost(bool restart)
    {
        using var incoming = new Incoming(new FinishedByMarker(".done"));
        incoming.Write("a.csv", "one");
        incoming.Write("a.csv.done", "");

        // A folder of its name is in the way.
        Directory.CreateDirectory(incoming.Claimed("a.csv"));
        for (var look = 0; look < 3; look++)
        {
            Assert.Equal(0, incoming.Take());
            Assert.Equal("a.csv", Assert.Single(incoming.Source.Left).Name);
            if (restart)
            {
                incoming.Restart();
            }
        }

        Directory.Delete(incoming.Claimed("a.csv"));
        Assert.Equal(1, incoming.Take());
        Assert.Equal(["a.csv:one"], incoming.Texts);
        Assert.Equal(1, incoming.Handed);
        Assert.Empty(incoming.Files());
        Assert.Equal(0, incoming.Take());
        Assert.Empty(incoming.Source.Left);
    }

    [Fact]
    public void A_file_that_cannot_be_moved_is_named()
    {
        using var incoming = new Incoming();
        incoming.Write("a.csv", "one");
        Directory.CreateDirectory(incoming.Claimed("a.csv"));
        Assert.Equal(0, incoming.Take());
        Assert.Equal("a.csv", Assert.Single(incoming.Source.Left).Name);
        Directory.Delete(incoming.Claimed("a.csv"));
        Assert.Equal(1, incoming.Take());
        Assert.Empty(incoming.Source.Left);
    }

    [Fact]
    public void A_marker_is_no_ones_but_its_own_files()
    {
        using var incoming = new Incoming(new FinishedByMarker(".done"));
        incoming.Write(".errormatch/a.csv", "one", 1);
        incoming.Write("a.csv", "two", 2);
        incoming.Write("a.csv.done", "", 2);

        // What lies aside cannot be archived: the next file of its name waits with its marker.
        Assert.Throws<IOException>(() => incoming.Take(before: _ => throw new IOException("full")));
        Assert.Equal([".errormatch/a.csv", "a.csv", "a.csv.done"], incoming.Files());
        Assert.Equal(2, incoming.Take());
        Assert.Equal(["a.csv:one", "a.csv:two"], incoming.Texts);
        Assert.Empty(incoming.Files());
    }

    [Fact]
    public void A_kill_while_a_file_is_removed_leaves_no_marker_for_the_next_one()
    {
        using var incoming = new Incoming(new FinishedByMarker(".done"));
        incoming.Write("a.csv", "one", 1);
        incoming.Write("a.csv.done", "", 1);
        Assert.Throws<OperationCanceledException>(() => incoming.Take(behind: _ => throw new OperationCanceledException()));

        // The kill came between the two removals, and the gauge has begun the next file.
        File.Delete(incoming.Claimed("a.csv.done"));
        incoming.Write("a.csv", "tw", 2);
        incoming.Restart();
        Assert.Equal(1, incoming.Take());
        Assert.Equal(["a.csv:one"], incoming.Texts);
        Assert.Equal(["a.csv"], incoming.Files());
    }
}
