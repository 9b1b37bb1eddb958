using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using ErrorMatching.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Files and folders are chosen in the station's own window, by finger and by keyboard.</summary>
public sealed class FileChooserTests
{
    private const string Mount = "/mnt";

    [Fact]
    public void Of_what_is_mounted_disks_and_sticks_are_offered_and_nothing_of_the_system_s_own() => Assert.Equal(
        ["/", "/media/anna/STICK", "/media/cdrom", "/run/media/anna/STICK", Mount + "/share"],
        Places.DisksAmong(
            [
                "/", "/proc", "/dev/shm", "/boot/efi", "/home", "/media/anna/STICK", "/media/cdrom", "/run/media/anna/STICK",
                "/run/user/1000/doc", Mount + "/share", Mount + "/tools/v1/python", "/media/anna/STICK/inside/image", Mount + "ing/x"]));

    [Fact]
    public Task A_file_is_chosen_by_tapping_into_folders() => At(async (seat, folder) =>
    {
        var chosen = Open(seat, new(FileChoiceKind.Open, "History.Program", [".nc"]) { Start = folder });
        seat.See("entry-empty");
        Assert.NotNull(seat.Find("entry-programs"));
        Assert.Null(seat.Find("entry-notes.txt"));
        Assert.Equal(
            "Folders: 2, files: 0. Other file types, not shown: 1. Hidden: 1. To open one, type its path.", seat.TextOf("chooser-summary"));
        seat.Tap("entry-programs").See("entry-b.NC");
        seat.Tap("entry-a.nc");
        Assert.Equal(Path.Combine(folder, "programs", "a.nc"), ((TextBox)seat.See("chooser-path")).Text);
        seat.Tap("chooser-confirm");
        Assert.Equal(Path.Combine(folder, "programs", "a.nc"), await chosen);
        Assert.Null(seat.Shell.Choosing);
    });

    [Theory]
    [InlineData("")]
    [InlineData("programs/b.NC")]
    public Task What_is_typed_before_the_folder_is_shown_stays(string proposed) => At((seat, folder) =>
    {
        _ = seat.Shell.ChooseAsync(new(FileChoiceKind.Open, "History.Program", [".nc"]) { Start = Path.Combine(folder, proposed) });
        var typed = Path.Combine(folder, "programs", "a.nc");
        seat.Shell.Choosing!.Typed = typed;
        Assert.Equal(typed, ((TextBox)seat.See("chooser-path")).Text);
        Assert.True(seat.See("chooser-confirm").IsEffectivelyEnabled);
        return Task.CompletedTask;
    });

    [Fact]
    public Task A_path_can_be_confirmed_before_the_folder_is_shown() => At(async (seat, folder) =>
    {
        var chosen = seat.Shell.ChooseAsync(new(FileChoiceKind.Open, "History.Program", [".nc"]) { Start = folder });
        seat.Shell.Choosing!.Typed = Path.Combine(folder, "programs", "a.nc");
        seat.Shell.Choosing.Confirm.Execute(null);
        Assert.Equal(Path.Combine(folder, "programs", "a.nc"), await chosen);
    });

    [Fact]
    public Task A_new_name_goes_along_into_a_folder_that_is_still_being_read() => At((seat, folder) =>
    {
        _ = Open(seat, new(FileChoiceKind.Save, "History.Program", [".nc"]) { Start = Path.Combine(folder, "old.nc") });
        seat.See("entry-programs");
        seat.Shell.Choosing!.Enter(Path.Combine(folder, "programs"));
        seat.Shell.Choosing.Typed = Path.Combine(folder, "new.nc");
        seat.See("entry-a.nc");
        Assert.Equal(Path.Combine(folder, "programs", "new.nc"), seat.Shell.Choosing.Typed);
        return Task.CompletedTask;
    });

    // A folder that may not be read, or is read slowly: there is nothing to show all of.
    [Fact]
    public Task All_files_are_asked_for_once_there_are_some() => At((seat, folder) =>
    {
        _ = seat.Shell.ChooseAsync(new(FileChoiceKind.Open, "History.Program", [".nc"]) { Start = folder });
        var chooser = seat.Shell.Choosing!;
        Assert.False(chooser.ShowAll.CanExecute(null));
        chooser.ShowAll.Execute(null);
        seat.See("entry-programs");
        Assert.True(seat.Tap("chooser-filter").See("entry-notes.txt").IsEffectivelyVisible);
        return Task.CompletedTask;
    });

    [Fact]
    public Task Nothing_can_be_opened_before_something_is_chosen() => At((seat, folder) =>
    {
        _ = Open(seat, new(FileChoiceKind.Open, "History.Program", [".nc"]) { Start = Path.Combine(folder, "programs") });
        seat.See("entry-a.nc");
        Assert.False(seat.See("chooser-confirm").IsEffectivelyEnabled);
        seat.Tap("entry-a.nc");
        Assert.True(seat.See("chooser-confirm").IsEffectivelyEnabled);
        seat.Tap("chooser-leave");

        // A folder is chosen as it stands there, and says what it holds though files are not shown.
        _ = Open(seat, new(FileChoiceKind.Folder, "History.Folder", []) { Start = Path.Combine(folder, "programs") });
        seat.WaitFor(() => seat.Shell.Choosing!.Folder.Length > 0, "The folder does not appear.");
        Assert.True(seat.See("chooser-confirm").IsEffectivelyEnabled);
        Assert.Contains("Files, not shown: 3.", seat.TextOf("chooser-summary"), StringComparison.Ordinal);
        return Task.CompletedTask;
    });

    [Fact]
    public Task The_row_of_the_file_in_the_field_looks_chosen_and_no_other() => At((seat, folder) =>
    {
        var file = Path.Combine(folder, "programs", "b.NC");
        _ = Open(seat, new(FileChoiceKind.Open, "History.Program", [".nc"]) { Start = file });
        var rows = (ListBox)seat.See("chooser-entries");
        seat.WaitFor(() => rows.SelectedItem is FolderEntry { Name: "b.NC" }, "The file that is proposed does not look chosen.");

        // It follows what is typed.
        seat.Type("chooser-path", Path.Combine(folder, "programs", "a.nc"));
        Assert.Equal("a.nc", (rows.SelectedItem as FolderEntry)?.Name);
        seat.Type("chooser-path", file);
        Assert.Equal("b.NC", (rows.SelectedItem as FolderEntry)?.Name);

        // What is chosen stays so where more is shown, and the folder that is shown instead holds nothing chosen.
        seat.Tap("chooser-filter").See("entry-c.txt");
        Assert.Equal(
            (file, "b.NC", true),
            (seat.Shell.Choosing!.Typed, (rows.SelectedItem as FolderEntry)?.Name, seat.See("chooser-confirm").IsEffectivelyEnabled));
        seat.Tap("chooser-up").See("entry-empty");
        Assert.Equal((null, false), (rows.SelectedItem, seat.See("chooser-confirm").IsEffectivelyEnabled));
        return Task.CompletedTask;
    });

    [Fact]
    public Task Two_taps_on_a_file_choose_it() => At(async (seat, folder) =>
    {
        var chosen = Open(seat, new(FileChoiceKind.Open, "History.Program", [".nc"]) { Start = Path.Combine(folder, "programs") });
        var row = seat.Tap("entry-b.NC").See("entry-b.NC");
        var place = row.TranslatePoint(new Rect(row.Bounds.Size).Center, seat.Window)!.Value;

        // At the window: the second tap takes the row away under the pointer.
        seat.User.Click(seat.Window, place);
        seat.WaitFor(() => chosen.IsCompleted, "The second tap does not choose.");
        Assert.Equal(Path.Combine(folder, "programs", "b.NC"), await chosen);
    });

    [Fact]
    public Task Folders_come_first_and_each_kind_by_name() => At((seat, folder) =>
    {
        _ = Open(seat, new(FileChoiceKind.Open, "History.Program", []) { Start = folder });
        seat.See("entry-empty");
        Assert.Equal(["empty", "programs", "notes.txt"], seat.Shell.Choosing!.Rows.Select(r => r.Name));
        Assert.Equal(["", "", "5 B"], seat.Shell.Choosing!.Rows.Select(r => r.Size));
        return Task.CompletedTask;
    });

    [Fact]
    public Task It_goes_up_and_shows_all_files() => At((seat, folder) =>
    {
        _ = Open(seat, new(FileChoiceKind.Open, "History.Program", [".nc"]) { Start = Path.Combine(folder, "programs") });
        seat.See("entry-a.nc");
        seat.Tap("chooser-up").See("entry-programs");
        seat.Tap("chooser-filter").See("entry-notes.txt");
        Assert.Equal("Only .nc", seat.Shell.Choosing!.Filter);
        seat.Tap("chooser-filter");
        seat.WaitFor(() => seat.Find("entry-notes.txt") is null, "The filter does not come back.");
        return Task.CompletedTask;
    });

    [Fact]
    public Task A_file_is_chosen_by_keyboard_alone() => At(async (seat, folder) =>
    {
        var chosen = Open(seat, new(FileChoiceKind.Open, "History.Program", [".nc"]) { Start = folder });
        seat.See("entry-programs");
        seat.WaitFor(() => seat.Find("entry-empty") is { IsKeyboardFocusWithin: true }, "The first row has no focus.");
        seat.User.Press(Key.End).Press(Key.Enter);
        seat.WaitFor(() => seat.Find("entry-a.nc") is { IsKeyboardFocusWithin: true }, "The first row of the folder has no focus.");
        seat.User.Press(Key.Back);
        seat.WaitFor(() => seat.Find("entry-empty") is { IsKeyboardFocusWithin: true }, "Backspace does not go up.");
        seat.User.Press(Key.Down).Press(Key.Enter);
        seat.WaitFor(() => seat.Find("entry-a.nc") is { IsKeyboardFocusWithin: true }, "Enter does not go down again.");
        seat.User.Press(Key.Enter).Press(Key.Enter);
        seat.WaitFor(() => chosen.IsCompleted, "Enter does not choose.");
        Assert.Equal(Path.Combine(folder, "programs", "a.nc"), await chosen);
    });

    [Fact]
    public Task A_path_is_typed_whole_or_from_the_folder_that_is_shown() => At(async (seat, folder) =>
    {
        var chosen = Open(seat, new(FileChoiceKind.Open, "History.Program", [".nc"]) { Start = folder });
        seat.See("entry-programs");
        seat.Type("chooser-path", "programs/gone.nc").User.Press(Key.Enter);
        Assert.Equal($"{Path.Combine(folder, "programs", "gone.nc")} does not exist.", seat.TextOf("chooser-message"));
        seat.Type("chooser-path", "programs").User.Press(Key.Enter);
        seat.See("entry-a.nc");
        seat.Type("chooser-path", "../notes.txt").User.Press(Key.Enter);
        seat.WaitFor(() => chosen.IsCompleted, "A typed file is not chosen.");
        Assert.Equal(Path.Combine(folder, "notes.txt"), await chosen);
    });

    [Fact]
    public Task What_is_hidden_is_gone_into_by_typing() => At((seat, folder) =>
    {
        _ = Open(seat, new(FileChoiceKind.Open, "History.Program", []) { Start = folder });
        seat.See("entry-empty");
        Assert.Null(seat.Find("entry-.hidden"));
        seat.Type("chooser-path", ".hidden").User.Press(Key.Enter);
        seat.See("entry-kept.nc");
        return Task.CompletedTask;
    });

    [Fact]
    public Task A_folder_that_vanished_is_told_and_the_one_before_stays() => At((seat, folder) =>
    {
        _ = Open(seat, new(FileChoiceKind.Open, "History.Program", []) { Start = folder });
        seat.See("entry-empty");
        Directory.Delete(Path.Combine(folder, "empty"));
        seat.Tap("entry-empty");
        Assert.Equal($"{Path.Combine(folder, "empty")} does not exist.", seat.TextOf("chooser-message"));
        Assert.Equal(folder, seat.Shell.Choosing!.Folder);
        Assert.NotNull(seat.Find("entry-programs"));
        return Task.CompletedTask;
    });

    [Fact]
    public void What_keeps_a_folder_from_being_shown_is_said() => Assert.Equal(
        [
            "You have no permission to open /x. Ask the administrator of this computer, or choose another folder.",
            "/x does not exist.",
            "/x cannot be read: loop"],
        new Exception[]
        {
            new UnauthorizedAccessException(),
            new DirectoryNotFoundException(),
            new IOException("loop")
        }.Select(e => FileChooserViewModel.Why(e, "/x")));

    [Fact]
    public Task A_folder_that_leads_to_itself_is_told() => At((seat, folder) =>
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "Links take rights there.");
        Directory.CreateSymbolicLink(Path.Combine(folder, "loop"), Path.Combine(folder, "loop"));
        _ = Open(seat, new(FileChoiceKind.Open, "History.Program", []) { Start = folder });
        seat.See("entry-loop");
        seat.Shell.Choosing!.Enter(Path.Combine(folder, "loop"));
        Assert.StartsWith(Path.Combine(folder, "loop"), seat.TextOf("chooser-message"), StringComparison.Ordinal);
        return Task.CompletedTask;
    });

    [Fact]
    public Task A_file_is_replaced_only_after_a_second_tap() => At(async (seat, folder) =>
    {
        var chosen = Open(seat, new(FileChoiceKind.Save, "History.Export", [".nc"]) { Start = Path.Combine(folder, "programs", "a") });
        seat.See("entry-a.nc");
        seat.Tap("chooser-confirm").See("chooser-message");
        Assert.False(chosen.IsCompleted);
        Assert.Equal("Replace", seat.Shell.Choosing!.ConfirmLabel);
        seat.Type("chooser-path", "new");
        Assert.Equal("Save", seat.Shell.Choosing!.ConfirmLabel);
        seat.Type("chooser-path", "a.nc").Tap("chooser-confirm").See("chooser-message");
        seat.Tap("chooser-confirm");
        seat.WaitFor(() => chosen.IsCompleted, "The second tap does not choose.");
        Assert.Equal(Path.Combine(folder, "programs", "a.nc"), await chosen);
    });

    [Fact]
    public Task A_new_name_goes_along_into_another_folder_and_gets_its_ending() => At(async (seat, folder) =>
    {
        var chosen = Open(seat, new(FileChoiceKind.Save, "History.Export", [".json"]) { Start = Path.Combine(folder, "job") });
        seat.See("entry-empty");
        seat.Tap("entry-empty");
        seat.WaitFor(() => seat.Shell.Choosing!.Typed == Path.Combine(folder, "empty", "job"), "The name stays behind.");
        seat.Tap("chooser-confirm");
        Assert.Equal(Path.Combine(folder, "empty", "job.json"), await chosen);
    });

    [Fact]
    public Task Escape_and_a_lock_choose_nothing_and_the_focus_returns() => At(async (seat, folder) =>
    {
        seat.Tap("nav-history");
        var serial = seat.See("history-serial");
        var left = Open(seat, new(FileChoiceKind.Folder, "History.Folder", []) { Start = folder });
        seat.See("entry-programs");
        seat.User.Press(Key.Escape);
        Assert.Null(await left);
        seat.WaitFor(() => serial.IsKeyboardFocusWithin, "The focus is lost.");
        var locked = Open(seat, new(FileChoiceKind.Folder, "History.Folder", []) { Start = folder });
        seat.See("entry-programs");
        seat.Clock.Advance(Station.DefaultIdle * 2);
        seat.WaitFor(() => locked.IsCompleted, "The lock leaves the chooser open.");
        Assert.Null(await locked);
        Assert.Null(await seat.Shell.ChooseAsync(new(FileChoiceKind.Folder, "History.Folder", [])));
    });

    [Fact]
    public Task A_folder_that_was_chosen_is_one_tap_away_the_next_time() => At(async (seat, folder) =>
    {
        var first = Open(seat, new(FileChoiceKind.Folder, "History.Folder", []) { Start = Path.Combine(folder, "programs") });
        seat.WaitFor(() => seat.Shell.Choosing!.Folder.Length > 0, "Nothing is shown.");
        Assert.Equal("Folders: 0. Files, not shown: 3.", seat.TextOf("chooser-summary"));
        seat.Tap("chooser-confirm");
        Assert.Equal(Path.Combine(folder, "programs"), await first);
        _ = Open(seat, new(FileChoiceKind.Open, "History.Program", []) { Start = folder });
        seat.See("place-0");
        var place = seat.Shell.Choosing!.Places.Single(p => p.Path == Path.Combine(folder, "programs"));
        Assert.Equal("programs", place.Name);
        seat.Tap(place.AutomationId).See("entry-a.nc");
    });

    [Fact]
    public Task An_export_goes_to_the_folder_that_was_chosen() => At(async (seat, folder) =>
    {
        seat.Cell.Run();
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, Cell.CorrectionState.Proposed);
        seat.Tap("nav-history").Tap("found-1").Tap("history-choose-folder");
        seat.Type("chooser-path", Path.Combine(folder, "empty")).Tap("chooser-confirm").Tap("history-export").See("history-exported");
        await ((HistoryViewModel)seat.Shell.Current!).Export.Running;
        var correction = seat.Station.Store.Find(1)!;
        Assert.Equal(
            seat.Station.Store.Content(correction.ReportSha256!),
            await File.ReadAllBytesAsync(Path.Combine(folder, "empty", "1-report.json"), CancellationToken.None));
    });

    [Fact]
    public Task A_time_follows_the_language_and_what_is_typed_stays() => At((seat, folder) =>
    {
        File.SetLastWriteTimeUtc(Path.Combine(folder, "programs", "a.nc"), new(2026, 3, 1, 7, 5, 9, DateTimeKind.Utc));
        _ = Open(seat, new(FileChoiceKind.Open, "History.Program", [".nc"]) { Start = Path.Combine(folder, "programs") });
        seat.Tap("entry-a.nc");
        Assert.Equal("2026-03-01 07:05:09", seat.Shell.Choosing!.Rows[0].Changed);
        Texts.Current.Language = Language.TraditionalChinese;
        seat.User.Settle();
        Assert.Equal("2026/03/01 07:05:09", seat.Shell.Choosing!.Rows[0].Changed);
        Assert.Equal(Path.Combine(folder, "programs", "a.nc"), seat.Shell.Choosing!.Typed);
        Texts.Current.Language = Language.English;
        return Task.CompletedTask;
    });

    [Fact]
    public Task Nothing_of_it_is_cut_off() => At((seat, folder) =>
    {
        File.WriteAllText(Path.Combine(folder, "bell\u0007\u202Egnp.nc"), "");
        var pictures = new Pictures(seat);
        _ = Open(seat, new(FileChoiceKind.Open, "History.Program", [".nc"]) { Start = folder });
        seat.See("entry-bell□□gnp.nc");
        pictures.Take("file-chooser");
        pictures.MustBeClean();
        return Task.CompletedTask;
    });

    private static Task<string?> Open(Seat seat, FileChoice choice)
    {
        var chosen = seat.Shell.ChooseAsync(choice);
        seat.User.Settle();
        return chosen;
    }

    private static Task At(Func<Seat, string, Task> test) => Seat.AtAsync(async seat =>
    {
        using var made = new TemporaryFolder();
        Directory.CreateDirectory(Path.Combine(made.Path, "programs"));
        Directory.CreateDirectory(Path.Combine(made.Path, "empty"));
        Directory.CreateDirectory(Path.Combine(made.Path, ".hidden"));
        foreach (var name in new[] { "programs/a.nc", "programs/b.NC", "programs/c.txt", ".hidden/kept.nc", "notes.txt" })
        {
            await File.WriteAllTextAsync(Path.Combine(made.Path, name), "words", CancellationToken.None);
        }

        seat.SignIn(DemoCell.Setter);
        await test(seat, made.Path);
    });
}
