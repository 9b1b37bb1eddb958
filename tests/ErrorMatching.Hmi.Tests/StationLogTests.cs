using ErrorMatching.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>What a station without an error stream says.</summary>
public sealed class StationLogTests
{
    [Fact]
    public void Why_it_does_not_start_is_in_a_window_that_names_the_file_and_in_the_file()
    {
        using var folder = new TemporaryFolder();
        var file = Path.Combine(folder.Path, "errormatch", "station.log");
        var shown = new List<string>();
        using var error = new StringWriter();
        var log = new StationLog(file, error, shown.Add, TimeProvider.System);
        log.Tell("A finger acts as a mouse.");
        log.Fail("nowhere.json cannot be opened.");
        Assert.Equal([$"nowhere.json cannot be opened.\n\n{file}"], shown);
        Assert.Equal(
            ["A finger acts as a mouse.", "nowhere.json cannot be opened."], File.ReadAllLines(file).Select(l => l[20..]));
        Assert.Equal(2, error.ToString().Split(Environment.NewLine, StringSplitOptions.RemoveEmptyEntries).Length);
    }

    [Fact]
    public void A_long_reason_is_in_the_file_and_its_beginning_in_a_window()
    {
        using var folder = new TemporaryFolder();
        var file = Path.Combine(folder.Path, "station.log");
        var shown = new List<string>();
        var log = new StationLog(file, TextWriter.Null, shown.Add, TimeProvider.System);
        log.Fail("cell.json is wrong.\nLine 3.\nLine 5.");
        log.Fail(new string('x', 1000));
        Assert.Equal([$"cell.json is wrong.\n\n{file}", $"{new string('x', StationLog.MostShown)}…\n\n{file}"], shown);
        Assert.Contains("Line 5.", File.ReadAllText(file), StringComparison.Ordinal);
    }

    [Fact]
    public void A_warning_has_the_time_once()
    {
        using var folder = new TemporaryFolder();
        var file = Path.Combine(folder.Path, "station.log");
        using var error = new StringWriter();
        new StationLog(file, error, null, TimeProvider.System).Warn("The screen was busy for 312 ms");
        Assert.Matches("^[0-9:]{8} wrn The screen was busy for 312 ms$", error.ToString().TrimEnd());
        Assert.Matches("^[0-9-]{10} [0-9:]{8} wrn The screen was busy for 312 ms$", File.ReadAllText(file).TrimEnd());
    }

    [Fact]
    public void A_file_that_cannot_be_written_is_said_and_the_sentence_is_shown_all_the_same()
    {
        using var folder = new TemporaryFolder();
        var shown = new List<string>();
        using var error = new StringWriter();
        var log = new StationLog(Path.Combine(folder.File("file", ""), "station.log"), error, shown.Add, TimeProvider.System);
        log.Fail("No store.");
        Assert.Equal(["No store."], shown);
        Assert.Equal(2, error.ToString().Split(Environment.NewLine, StringSplitOptions.RemoveEmptyEntries).Length);
    }

    [Fact]
    public void A_long_log_is_begun_again_and_the_last_one_kept()
    {
        using var folder = new TemporaryFolder();
        var file = folder.File("station.log", new string('x', StationLog.MostBytes + 1));
        new StationLog(file, TextWriter.Null, null, TimeProvider.System).Tell("Second start");
        Assert.Equal(StationLog.MostBytes + 1, new FileInfo(file + ".old").Length);
        Assert.EndsWith(" Second start\n", File.ReadAllText(file), StringComparison.Ordinal);
    }
}
