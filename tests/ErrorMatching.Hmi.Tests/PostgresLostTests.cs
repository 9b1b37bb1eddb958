using System.Globalization;
using System.Text.RegularExpressions;
using Avalonia.Input;
using ErrorMatching.Cell;
using ErrorMatching.Peers.Tests;

namespace ErrorMatching.Hmi.Tests;

/// <summary>A station whose store is a PostgreSQL server, which is killed under it and started again.</summary>
[Trait("Length", "Long")]
public sealed partial class PostgresLostTests
{
    [Fact]
    public async Task A_server_that_goes_away_is_a_banner_and_everything_works_again_when_it_is_back()
    {
        PostgresServer.IsNeeded();
        using var server = new PostgresServer();
        await Seat.AtAsync(
            seat =>
            {
                seat.Cell.Run();
                seat.Cell.Deliver(1, 0);
                seat.WaitFor(1, CorrectionState.Proposed);
                seat.SignIn(DemoCell.Setter).Tap("nav-compensation").Tap("approve").Type("signing-password", DemoCell.Password);
                server.Kill();
                try
                {
                    seat.WaitFor(
                        () => seat.Shell.Banner?.StartsWith("The store cannot be read: It does not answer.", StringComparison.Ordinal)
                            ?? false,
                        "There is no banner.");
                    seat.User.Press(Key.Enter);
                    Assert.Equal("It does not answer.", seat.TextOf("signing-message"));
                    seat.User.Press(Key.Escape);

                    // What still works: what was seen stays, and the screens open.
                    Assert.Equal("#1 · 0001", seat.TextOf("detail-title"));
                    foreach (var item in seat.Shell.Items)
                    {
                        seat.Tap(item.Screen.AutomationId).WaitFor(() => seat.Shell.Chosen == item, "The screen does not open.");
                    }

                    seat.Tap("nav-history").WaitFor(
                        () => seat.TextOf("history-message") == "It does not answer.", "History does not say why it finds nothing.");
                }
                finally
                {
                    server.Start();
                }

                seat.WaitFor(() => seat.Shell.Banner is null, "The banner stays.");
                Again(seat, () => seat.Tap("nav-history").Tap("history-search"), () => seat.Find("found-1") is not null, "history-message");
                seat.Tap("nav-compensation").Tap("approve");
                Again(
                    seat,
                    () => seat.Type("signing-password", DemoCell.Password).Tap("signing-confirm"),
                    () => seat.Shell.Signing is null,
                    "signing-message");
                seat.WaitFor(
                    () => seat.Find("detail-state") is not null && seat.TextOf("detail-state") == "At the machine",
                    "It is not approved and sent.");
                Assert.Null(seat.Station.Store.VerifyAudit());
            },
            prepare: folder => Move(folder, server.NewDatabase()));
    }

    // Each connection that was open may find out by itself that it is none any more: then it is told once more, and tried again.
    private static void Again(Seat seat, Action act, Func<bool> isDone, string message)
    {
        for (var i = 0; i < 10 && !isDone(); i++)
        {
            act();
            seat.WaitFor(() => isDone() || seat.Find(message) is not null, "Nothing comes of it.");
        }

        Assert.True(isDone(), $"{message} stays.");
    }

    // The cell of the demonstration with its store on the server: nothing of its own store and keys stays.
    private static void Move(string folder, PostgresSettings to)
    {
        var file = Path.Combine(folder, "cell", "cell.json");
        var store = string.Create(
            CultureInfo.InvariantCulture,
            $$"""{ "kind": "postgresql", "host": "{{to.Host}}", "port": {{to.Port}}, "database": "{{to.Database}}", "user": "{{to.User}}", "passwordFile": "{{to.PasswordFile}}" }""");
        File.WriteAllText(file, Store().Replace(File.ReadAllText(file), $"\"store\": {store},"));
        Directory.Delete(Path.Combine(folder, "cell", "run"), recursive: true);
        var settings = CellSettingsReader.Read(file);
        using var opened = CellStore.Open(settings.Store, TimeProvider.System, AuditKey.Open(settings.KeysFolder));
        var users = new UserBook(opened, TimeProvider.System);
        users.AddFirst(DemoCell.Administrator, DemoCell.Password);
        users.Add(users.SignIn(DemoCell.Administrator, DemoCell.Password), DemoCell.Setter, Role.Setter, DemoCell.Password);
    }

    [GeneratedRegex("\"store\": \\{[^}]*\\},", RegexOptions.CultureInvariant, 1000)]
    private static partial Regex Store();
}
