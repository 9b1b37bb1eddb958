using ErrorMatching.Jobs;
using ErrorMatching.Refusals;
using ErrorMatching.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Everybody finds the station as they left it, whatever became of the file meanwhile.</summary>
public sealed class PreferenceTests
{
    private static readonly Preferences Dark = new(
        Language.TraditionalChinese, IsDark: true, TouchSize.Large, KeyboardUse.Always, ["/somewhere"]);

    [Fact]
    public void What_is_kept_is_read_again_for_each_user()
    {
        using var folder = new TemporaryFolder();
        var files = new PreferenceFiles(folder["new"]);
        Assert.Null(files.Read("../anna"));
        files.Keep("../anna", Dark);
        files.Keep("王小明", Dark with { Language = Language.English });
        Assert.Equal(
            (Dark.Language, Dark.IsDark, Dark.TouchSize, Dark.Keyboard),
            files.Read("../anna") is { } read ? (read.Language, read.IsDark, read.TouchSize, read.Keyboard) : default);
        Assert.Equal(Dark.Folders, files.Read("../anna")!.Folders);
        Assert.Equal(Language.English, files.Read("王小明")!.Language);
        Assert.Equal(2, Directory.GetFiles(folder["new"]).Length);
    }

    [Theory]
    [InlineData("")]
    [InlineData("{")]
    [InlineData("null")]
    [InlineData("[[[[")]
    [InlineData("{\"user\":\"a\"}")]
    [InlineData("{\"user\":\"a\",\"language\":\"Klingon\",\"theme\":\"dark\",\"targets\":\"Large\",\"folders\":[]}")]
    [InlineData("{\"user\":\"a\",\"language\":\"English\",\"theme\":\"dark\",\"targets\":\"Large\",\"folders\":[1]}")]
    [InlineData("{\"user\":\"a\",\"language\":\"English\",\"theme\":\"dark\",\"targets\":\"7\",\"folders\":[]}")]
    public void What_is_no_preference_is_refused_with_its_place(string text)
    {
        using var folder = new TemporaryFolder();
        var files = new PreferenceFiles(folder.Path);
        File.WriteAllText(files.Of("a"), text);
        Assert.NotEmpty(Assert.Throws<InputException>(() => files.Read("a")).Refusals);
    }

    [Fact]
    public void A_file_that_is_no_file_or_too_large_is_refused()
    {
        using var folder = new TemporaryFolder();
        var files = new PreferenceFiles(folder.Path);
        File.WriteAllText(files.Of("a"), new string(' ', 1_000_000));
        Assert.Equal("too-big", Assert.Throws<InputException>(() => files.Read("a")).Refusals[0].Code);
        File.WriteAllText(folder["file"], "");
        Assert.Throws<OutputException>(() => new PreferenceFiles(folder["file"]).Keep("a", Dark));
    }

    [Fact]
    public void Paths_that_no_system_takes_are_left_out()
    {
        using var folder = new TemporaryFolder();
        var files = new PreferenceFiles(folder.Path);
        File.WriteAllText(
            files.Of("a"),
            "{\"user\":\"a\",\"language\":\"English\",\"theme\":\"light\",\"targets\":\"Large\",\"folders\":[\"../..\",\"/a\\u0000b\",\""
                + folder.Path.Replace("\\", "\\\\", StringComparison.Ordinal) + "\"]}");
        Assert.Equal([folder.Path], files.Read("a")!.Folders);
    }

    [Fact]
    public Task Everybody_finds_the_station_as_they_left_it() => Seat.AtAsync(seat =>
    {
        seat.SignIn(DemoCell.Setter).Tap("theme").Tap("language");
        seat.Shell.Preferences.TouchSize = TouchSize.Large;
        Leave(seat);
        seat.SignIn(DemoCell.Operator).Tap("theme").Tap("language");
        Leave(seat);
        Assert.False(seat.Shell.IsDark);
        seat.SignIn(DemoCell.Setter);
        seat.WaitFor(
            () => seat.Shell.IsDark && Texts.Current.Language == Language.TraditionalChinese && seat.Shell.TouchSize == TouchSize.Large,
            "The setter's preferences do not come back.");
        Assert.Null(seat.Shell.Notice);
    });

    [Fact]
    public Task A_spoiled_file_is_told_and_the_next_change_mends_it() => Seat.AtAsync(seat =>
    {
        var files = seat.Station.Preferences!;
        files.Keep(DemoCell.Setter, Dark);
        File.WriteAllText(files.Of(DemoCell.Setter), "{ \"theme\": 7 }");

        // What the cell cannot do is said first, in the same place.
        seat.SignIn(DemoCell.Setter).See("banner");
        Assert.Null(seat.Find("notice"));
        seat.RunCell().See("notice");
        Assert.StartsWith("Your preferences cannot be read, so nothing was changed:", seat.TextOf("notice"), StringComparison.Ordinal);
        Assert.False(seat.Shell.IsDark);
        seat.Tap("notice-close");
        Assert.Null(seat.Find("notice"));
        seat.Tap("theme");
        seat.WaitFor(() => seat.Shell.Preferences.Running.IsCompleted, "It is not kept.");
        Assert.True(files.Read(DemoCell.Setter)!.IsDark);
    });

    private static void Leave(Seat seat)
    {
        seat.WaitFor(() => seat.Shell.Preferences.Running.IsCompleted, "It is not kept.");
        seat.Tap("sign-out");
        seat.WaitFor(() => seat.Shell.IsLocked, "The station does not lock.");
    }
}
