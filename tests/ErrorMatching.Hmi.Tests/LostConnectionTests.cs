using Avalonia.Controls;
using ErrorMatching.Cell;

namespace ErrorMatching.Hmi.Tests;

/// <summary>A store or a machine that goes away is a banner and a message with what still works;
/// when it is back, the banner goes and everything works again.</summary>
[Trait("Length", "Long")]
public sealed class LostConnectionTests
{
    private static readonly string[] Ends = ["", "-wal", "-shm"];

    [Fact]
    public Task A_store_that_goes_away_and_comes_back_ends_nothing() => Seat.AtAsync(seat =>
    {
        Prepare(seat);
        Move(seat, "", ".away");
        seat.WaitFor(
            () => seat.Find("banner") is TextBlock { Text: { } text }
                && text.StartsWith("The store cannot be read: It does not answer.", StringComparison.Ordinal),
            "There is no banner.");

        // What was seen last stays, and every screen can be gone to.
        Assert.NotNull(seat.Find("waiting-1"));
        foreach (var item in seat.Shell.Items)
        {
            seat.Tap(item.Screen.AutomationId);
            seat.WaitFor(() => seat.Shell.Chosen == item, "The screen does not open.");
        }

        seat.Tap("nav-history");
        seat.WaitFor(() => seat.TextOf("history-message") == "It does not answer.", "History does not say why it finds nothing.");
        seat.Tap("theme").Tap("language").Tap("language").Tap("sign-out");
        seat.WaitFor(() => seat.Shell.IsLocked, "The station does not lock.");
        seat.Type("login-name", DemoCell.Setter).Type("login-password", DemoCell.Password).Tap("login-sign-in");
        seat.WaitFor(() => seat.TextOf("login-message") == "It does not answer.", "Nobody says why signing in fails.");
        Assert.True(seat.Shell.IsLocked);

        Move(seat, ".away", "");
        seat.WaitFor(() => seat.Shell.Banner is null, "The banner stays.");
        seat.See("login-user-anna");
        Assert.Null(seat.Find("login-message"));
        seat.Type("login-password", DemoCell.Password).Tap("login-sign-in");
        seat.WaitFor(() => !seat.Shell.IsLocked, "The station stays locked.");
        seat.Tap("nav-compensation").Tap("approve").Type("signing-password", DemoCell.Password).Tap("signing-confirm");
        seat.WaitFor(1, CorrectionState.Verified);
        seat.Cell.Deliver(2, 0.02);
        seat.WaitFor(2, CorrectionState.Proposed);
    });

    [Fact]
    public Task What_is_being_signed_when_the_store_goes_is_told_and_can_be_signed_again() => Seat.AtAsync(seat =>
    {
        Prepare(seat);
        seat.Tap("nav-compensation").Tap("approve").Type("signing-password", DemoCell.Password);
        Move(seat, "", ".away");
        seat.Tap("signing-confirm");
        Assert.Equal("It does not answer.", seat.TextOf("signing-message"));
        Move(seat, ".away", "");
        Assert.Equal(CorrectionState.Proposed, seat.Station.Store.Find(1)!.State);
        seat.Type("signing-password", DemoCell.Password).Tap("signing-confirm");
        seat.WaitFor(1, CorrectionState.Verified);
    });

    [Fact]
    public Task A_machine_that_goes_away_is_named_and_gets_its_program_when_it_is_back() => Seat.AtAsync(seat =>
    {
        Prepare(seat);
        Directory.Move(seat.Cell.MachineFolder, seat.Cell.MachineFolder + "-away");
        seat.Tap("nav-compensation").Tap("approve").Type("signing-password", DemoCell.Password).Tap("signing-confirm");
        seat.WaitFor(() => seat.Shell.Signing is null, "It cannot be approved meanwhile.");
        seat.WaitFor(() => seat.Find("banner") is not null, "There is no banner.");
        Assert.Equal("slot vmc1/A: The machine does not answer.", seat.TextOf("banner"));
        Directory.Move(seat.Cell.MachineFolder + "-away", seat.Cell.MachineFolder);
        var sent = seat.WaitFor(1, CorrectionState.Verified);
        Assert.Equal(
            seat.Station.Store.Content(sent.ProgramSha256!), File.ReadAllBytes(Path.Combine(seat.Cell.MachineFolder, "counterpart.nc")));
        seat.WaitFor(() => seat.Shell.Banner is null, "The banner stays.");
    });

    [Fact]
    public Task A_locked_station_shows_a_part_that_arrives() => Seat.AtAsync(
        seat =>
        {
            seat.Cell.Run();
            seat.SignIn(DemoCell.Setter);
            seat.Clock.Advance(TimeSpan.FromMinutes(11));
            seat.WaitFor(() => seat.Shell.IsLocked, "The station does not lock.");
            seat.Cell.Deliver(1, 0);
            seat.WaitFor(1, CorrectionState.Proposed);
            Assert.IsType<Button>(seat.See("waiting-1"), exactMatch: false);

            // Seen, but nobody can go there.
            seat.Tap("waiting-1");
            Assert.True(seat.Shell.IsLocked);
            Assert.Null(seat.Find("detail-title"));
        },
        idle: TimeSpan.FromMinutes(10));

    private static void Prepare(Seat seat)
    {
        seat.Cell.Run();
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.SignIn(DemoCell.Setter).See("waiting-1");
        seat.WaitFor(() => seat.Shell.Banner is null, "All is not well.");
    }

    // The whole disk: the store and what SQLite has beside it.
    internal static void Move(Seat seat, string from, string to)
    {
        var file = ((SqliteSettings)seat.Cell.Settings.Store).File;
        foreach (var end in Ends.Where(e => File.Exists(file + e + from)))
        {
            File.Move(file + end + from, file + end + to, overwrite: true);
        }
    }
}
