using System.Diagnostics;

namespace ErrorMatching.Cell.Tests;

public sealed class FileSourceTests
{
    [Fact]
    public void A_file_under_its_name_is_taken_archived_and_removed()
    {
        using var incoming = new Incoming();
        incoming.Write("WO-1_A.csv", "one");
        Assert.Equal(1, incoming.Take());
        var arrival = Assert.Single(incoming.Archived.Values);
        Assert.Equal(("cmm", "WO-1_A.csv", 64), (arrival.Gauge, arrival.FileName, arrival.Key.Length));
        Assert.Equal(["WO-1_A.csv:one"], incoming.Texts);
        Assert.Empty(incoming.Files());
        Assert.Equal(0, incoming.Take());
    }

    [Fact]
    public void Files_are_taken_in_order_of_their_time_of_change_then_of_their_name()
    {
        using var incoming = new Incoming();
        incoming.Write("c.csv", "", 1);
        incoming.Write("b.csv", "", 1);
        incoming.Write("a.csv", "", 2);
        incoming.Take();
        Assert.Equal(["b.csv", "c.csv", "a.csv"], incoming.Archived.Values.Select(a => a.FileName));
    }

    [Fact]
    public void Other_names_and_hidden_names_are_left_alone()
    {
        using var incoming = new Incoming();
        incoming.Write("notes.txt", "");
        incoming.Write(".WO-1.csv", "");
        incoming.Write("WO-1.csv.part", "");
        incoming.Write("deeper/WO-2.csv", "");
        Assert.Equal(0, incoming.Take());
        Assert.Empty(incoming.Source.Left);
        Assert.Equal(4, incoming.Files().Count());
    }

    [Fact]
    public void The_same_content_written_again_later_is_another_arrival()
    {
        using var incoming = new Incoming();
        incoming.Write("a.csv", "same", 1);
        incoming.Take();
        incoming.Write("a.csv", "same", 2);
        incoming.Take();
        Assert.Equal(2, incoming.Archived.Count);
    }

    [Fact]
    public void A_marker_says_that_its_file_is_finished_and_goes_with_it()
    {
        using var incoming = new Incoming(new FinishedByMarker(".done"), "*");
        incoming.Write("a.csv", "one");
        incoming.Write("b.csv", "two");
        Assert.Equal(0, incoming.Take());
        incoming.Write("b.csv.done", "");
        Assert.Equal(1, incoming.Take());
        Assert.Equal(["b.csv:two"], incoming.Texts);
        Assert.Equal(["a.csv"], incoming.Files());
    }

    [Fact]
    public void Values_wait_for_their_description_and_both_are_one_arrival()
    {
        using var incoming = new Incoming(files: "*.dfx");
        incoming.Write("part-1.dfx", "1.5\n", 2);
        Assert.Equal(0, incoming.Take());
        var left = Assert.Single(incoming.Source.Left);
        Assert.Equal("part-1.dfx", left.Name);
        Assert.Contains("part-1.dfd is not there yet", left.Reason, StringComparison.Ordinal);
        incoming.Write("part-1.dfd", "K0100 1", 1);
        Assert.Equal(1, incoming.Take());
        Assert.Equal(["part-1.dfx:K0100 1\n1.5\n"], incoming.Texts);
        Assert.Empty(incoming.Files());
        Assert.Empty(incoming.Source.Left);
    }

    [Fact]
    public void A_description_alone_is_left_and_one_that_is_still_written_is_waited_for()
    {
        using var incoming = new Incoming(new FinishedAtRest(TimeSpan.FromSeconds(2)), "*");
        incoming.Write("a.DFX", "1.5\n", 1);
        incoming.Write("b.dfd", "K0100 1\n", 1);
        Assert.Equal(0, incoming.Take());
        incoming.Clock.Advance(TimeSpan.FromSeconds(1));
        incoming.Write("a.DFD", "K0100 ", 2);
        Assert.Equal(0, incoming.Take());
        incoming.Clock.Advance(TimeSpan.FromSeconds(1.5));
        Assert.Equal(0, incoming.Take());
        incoming.Clock.Advance(TimeSpan.FromSeconds(0.5));
        Assert.Equal(1, incoming.Take());
        Assert.Equal(["a.DFX:K0100 \n1.5\n"], incoming.Texts);
        Assert.Equal(["b.dfd"], incoming.Files());
    }

    [Fact]
    public void Values_and_description_survive_a_kill_at_any_step()
    {
        // Moved aside: the values only.
        using var incoming = new Incoming(files: "*.dfx");
        Directory.CreateDirectory(Path.GetDirectoryName(incoming.Claimed("a.dfx"))!);
        File.WriteAllText(incoming.Claimed("a.dfx"), "1.5\n");
        incoming.Write("a.dfd", "K0100 1\n", 1);
        Assert.Equal(1, incoming.Take());
        Assert.Equal(["a.dfx:K0100 1\n1.5\n"], incoming.Texts);

        // Archived, and nothing removed yet: the same arrival once more.
        incoming.Write("b.dfx", "2.5\n", 2);
        incoming.Write("b.dfd", "K0100 1\n", 1);
        Assert.Throws<InvalidOperationException>(() => incoming.Take(behind: _ => throw new InvalidOperationException("killed")));
        incoming.Restart();
        Assert.Equal(1, incoming.Take());
        Assert.Equal((2, 3), (incoming.Archived.Count, incoming.Handed));

        // The values are removed, their description is not.
        File.WriteAllText(incoming.Claimed("c.dfd"), "K0100 1\n");
        incoming.Restart();
        Assert.Equal(0, incoming.Take());
        Assert.Empty(incoming.Files());
    }

    [Fact]
    public void A_file_at_rest_is_finished_when_size_and_time_have_stayed_the_same_for_long_enough()
    {
        using var incoming = new Incoming(new FinishedAtRest(TimeSpan.FromSeconds(2)));
        incoming.Write("a.csv", "on", 1);
        Assert.Equal(0, incoming.Take());
        incoming.Clock.Advance(TimeSpan.FromSeconds(1.9));
        Assert.Equal(0, incoming.Take());
        incoming.Write("a.csv", "one", 3);
        Assert.Equal(0, incoming.Take());
        incoming.Clock.Advance(TimeSpan.FromSeconds(1.9));
        Assert.Equal(0, incoming.Take());
        incoming.Clock.Advance(TimeSpan.FromSeconds(0.1));
        Assert.Equal(1, incoming.Take());
        Assert.Equal(["a.csv:one"], incoming.Texts);
    }

    [Fact]
    public void Rest_is_counted_by_a_clock_that_nobody_sets()
    {
        using var incoming = new Incoming(new FinishedAtRest(TimeSpan.FromSeconds(2)));
        incoming.Write("a.csv", "one");
        incoming.Take();
        incoming.Clock.Set(incoming.Clock.GetUtcNow().AddDays(-1));
        Assert.Equal(0, incoming.Take());
        incoming.Clock.Advance(TimeSpan.FromSeconds(2));
        Assert.Equal(1, incoming.Take());
    }

    [Theory]
    [InlineData("point,x\nEND\n", true)]
    [InlineData("point,x\r\n  END \r\n\r\n", true)]
    [InlineData("END", true)]
    [InlineData("point,x\nEND\n%\n", true)]
    [InlineData("point,x\n%\n", false)]
    [InlineData("END\npoint,x\n", false)]
    [InlineData("point,x\nTHE END\n", false)]
    [InlineData("", false)]
    public void A_file_with_an_end_mark_is_finished_when_its_last_line_says_so(string text, bool isFinished)
    {
        using var incoming = new Incoming(new FinishedByEndMark("END"));
        incoming.Write("a.csv", text);
        Assert.Equal(isFinished ? 1 : 0, incoming.Take());
    }

    [Fact]
    public void What_is_too_large_is_hashed_handed_over_unread_and_laid_aside()
    {
        using var incoming = new Incoming(mostBytes: 4);
        incoming.Write("a.csv", "12345");
        incoming.Write("b.csv", "1234");
        Assert.Equal(2, incoming.Take());
        var unread = Assert.Single(incoming.Unread);
        Assert.Equal(
            ("cmm", "a.csv", Incoming.Sha256("12345"), 5, "file-too-large"),
            (unread.Gauge, unread.FileName, unread.Sha256, unread.Length, unread.Code));
        Assert.Equal(["b.csv:1234"], incoming.Texts);
        Assert.Equal([$".errormatch/too-large/{Incoming.Sha256("12345")}"], incoming.Files());
        incoming.Restart();
        Assert.Equal(0, incoming.Take());
    }

    [Fact]
    public void A_folder_that_is_away_is_named_and_taken_up_again()
    {
        using var incoming = new Incoming();
        Directory.Delete(incoming.Folder);
        var error = Assert.Throws<SourceException>(() => incoming.Take());
        Assert.Contains(incoming.Folder, error.Message, StringComparison.Ordinal);
        Assert.Contains("\"cmm\"", error.Message, StringComparison.Ordinal);
        incoming.Write("a.csv", "one");
        Assert.Equal(1, incoming.Take());
    }

    [Fact]
    public void A_file_that_changes_between_looks_of_an_idle_folder_is_seen()
    {
        using var incoming = new Incoming();
        for (var i = 0; i < 20; i++)
        {
            incoming.Write($"a{i}.csv", "one");
            Assert.Equal(1, incoming.Take());
        }
    }

    [Fact]
    public async Task A_new_file_ends_the_wait()
    {
        var settings = new Incoming().Gauge with { Every = TimeSpan.FromMinutes(10) };
        using var source = new FileSource(settings, TimeProvider.System);
        var began = Stopwatch.GetTimestamp();
        var wait = source.WaitAsync(TestContext.Current.CancellationToken);
        await File.WriteAllTextAsync(Path.Combine(settings.Incoming!, "a.csv"), "one", TestContext.Current.CancellationToken);
        await wait;
        Assert.True(Stopwatch.GetElapsedTime(began) < settings.Every);
        Directory.Delete(settings.Incoming!, recursive: true);
    }

    [Fact]
    public async Task A_wait_ends_when_its_time_is_over_and_when_it_is_cancelled()
    {
        using var incoming = new Incoming();
        var wait = incoming.Source.WaitAsync(TestContext.Current.CancellationToken);
        incoming.Clock.Advance(incoming.Gauge.Every);
        await wait;
        using var cancelled = new CancellationTokenSource();
        var other = incoming.Source.WaitAsync(cancelled.Token);
        await cancelled.CancelAsync();
        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => other);
    }

    [Fact]
    public void Ten_thousand_files_are_taken_in_one_look_each_once()
    {
        using var incoming = new Incoming();
        for (var i = 0; i < 10_000; i++)
        {
            File.WriteAllText(incoming.PathOf($"{i}.csv"), "");
        }

        Assert.Equal(10_000, incoming.Take());
        Assert.Equal((10_000, 10_000), (incoming.Archived.Count, incoming.Handed));
        Assert.Empty(incoming.Files());
    }
}
