namespace ErrorMatching.Cell.Tests;

/// <summary>What is on the disk between two steps of taking a file is all that a kill leaves.</summary>
public sealed class KilledSourceTests
{
    private sealed class KilledException : Exception;

    [Fact]
    public void Killed_before_the_file_is_archived()
    {
        using var incoming = new Incoming();
        incoming.Write("a.csv", "one");
        Assert.Throws<KilledException>(() => incoming.Take(before: _ => throw new KilledException()));
        incoming.Restart();
        Assert.Equal(1, incoming.Take());
        Assert.Equal(["a.csv:one"], incoming.Texts);
        Assert.Empty(incoming.Files());
    }

    [Fact]
    public void Killed_between_archiving_and_removing()
    {
        using var incoming = new Incoming();
        incoming.Write("a.csv", "one");
        Assert.Throws<KilledException>(() => incoming.Take(behind: _ => throw new KilledException()));
        incoming.Restart();
        Assert.Equal(1, incoming.Take());
        Assert.Equal(2, incoming.Handed);
        Assert.Equal(["a.csv:one"], incoming.Texts);
        Assert.Empty(incoming.Files());
    }

    [Fact]
    public void What_the_archive_refuses_stays_for_the_next_look_of_the_same_process()
    {
        using var incoming = new Incoming();
        incoming.Write("a.csv", "one");
        incoming.Write("b.csv", "two", 1);
        Assert.Throws<KilledException>(() => incoming.Take(before: _ => throw new KilledException()));
        Assert.Equal(2, incoming.Take());
        Assert.Equal(["a.csv:one", "b.csv:two"], incoming.Texts);
    }

    [Fact]
    public void Killed_between_taking_the_marker_and_taking_its_file()
    {
        using var incoming = new Incoming(new FinishedByMarker(".done"));
        incoming.Write("a.csv", "one");
        incoming.Write(".errormatch/a.csv.done", "");
        incoming.Restart();
        Assert.Equal(1, incoming.Take());
        Assert.Equal(["a.csv:one"], incoming.Texts);
        Assert.Empty(incoming.Files());
    }

    [Fact]
    public void Killed_between_removing_a_file_and_removing_its_marker()
    {
        using var incoming = new Incoming(new FinishedByMarker(".done"));
        incoming.Write(".errormatch/a.csv.done", "");
        incoming.Write("b.csv", "two");
        incoming.Restart();
        Assert.Equal(0, incoming.Take());
        Assert.Equal(["b.csv"], incoming.Files());
    }

    [Fact]
    public void Killed_between_archiving_and_laying_aside_what_is_too_large()
    {
        using var incoming = new Incoming(mostBytes: 2);
        incoming.Write(".errormatch/a.csv", "one");
        incoming.Take();
        incoming.Write(".errormatch/a.csv", "one");
        incoming.Restart();
        incoming.Take();
        Assert.Equal(2, incoming.Handed);
        Assert.Single(incoming.Unread);
        Assert.Equal([$".errormatch/too-large/{Incoming.Sha256("one")}"], incoming.Files());
    }

    [Fact]
    public void What_a_gauge_writes_under_the_name_of_a_file_that_is_being_taken_is_not_lost()
    {
        using var incoming = new Incoming();
        incoming.Write("a.csv", "one", 1);
        incoming.Take(behind: a =>
        {
            if (incoming.Handed == 1)
            {
                incoming.Write("a.csv", "two", 2);
            }
        });
        incoming.Take();
        Assert.Equal(["a.csv:one", "a.csv:two"], incoming.Texts);
    }

    [Fact]
    public void A_leftover_and_a_new_file_of_its_name_are_two_arrivals_in_order()
    {
        using var incoming = new Incoming();
        incoming.Write(".errormatch/a.csv", "one", 1);
        incoming.Write("a.csv", "two", 2);
        Assert.Equal(2, incoming.Take());
        Assert.Equal(["a.csv:one", "a.csv:two"], incoming.Texts);
    }

    [Fact]
    public void A_folder_of_what_is_moved_aside_that_somebody_removed_is_made_again()
    {
        using var incoming = new Incoming();
        incoming.Write("a.csv", "one", 1);
        Assert.Equal(1, incoming.Take());
        Directory.Delete(incoming.PathOf(ClaimFolder.Name), recursive: true);
        incoming.Write("b.csv", "two", 2);
        Assert.Equal(1, incoming.Take() + incoming.Take());
        Assert.Equal(["a.csv:one", "b.csv:two"], incoming.Texts);
    }

    [Fact]
    public void A_file_that_grows_while_it_is_read_is_read_again()
    {
        using var incoming = new Incoming();
        incoming.Write("a.csv", new string('x', 1000));
        var file = new FileInfo(incoming.PathOf("a.csv"));
        _ = file.Length;
        File.AppendAllText(file.FullName, "more");
        Assert.Null(FileReading.Whole(file));
        file.Refresh();
        Assert.Equal(1004, FileReading.Whole(file)!.Length);
    }

    [Fact]
    public void Another_gauges_leftovers_in_one_folder_are_left_to_it()
    {
        using var incoming = new Incoming(files: "a*.csv");
        incoming.Write(".errormatch/b.csv", "other");
        Assert.Equal(0, incoming.Take());
        Assert.Equal([".errormatch/b.csv"], incoming.Files());
    }
}
