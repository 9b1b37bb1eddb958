using System.Collections.Concurrent;
using System.Globalization;
using ErrorMatching.EndToEnd.Tests;

namespace ErrorMatching.Peers.Tests;

/// <summary>What a cell that has nothing to do asks of its server, by the server's own log.</summary>
[Collection(PostgresTests.Name)]
public sealed class QuietCellTests(PostgresServer server)
{
    private static readonly TimeSpan Watched = TimeSpan.FromSeconds(3);

    [Fact]
    public async Task A_cell_has_four_connections_and_in_rest_one_transaction_a_second_at_most()
    {
        PostgresServer.IsNeeded();
        var token = TestContext.Current.CancellationToken;
        var settings = server.NewDatabase();
        using var cell = new FireCell(slots: 6, server.StoreOf(settings, "quiet"));
        var files = new FireFiles();
        var (transactions, connections) = (new ConcurrentDictionary<string, string>(StringComparer.Ordinal), 0L);
        server.Execute("postgres", "ALTER SYSTEM SET log_line_prefix = '%d|%v|'");
        server.Execute("postgres", "SELECT pg_reload_conf()");
        server.Execute("postgres", $"ALTER DATABASE {settings.Database} SET log_statement = 'all'");
        server.Said += Note;
        try
        {
            cell.Start();
            await cell.HasBegun();
            for (var i = 0; i < 2; i++)
            {
                var (name, bytes) = files.Next(cell.Slots[i], i);
                cell.Drop(name, bytes);
            }

            var changed = cell.Slots.Take(2).Select(s => Path.Combine(cell.Machine, FireCell.ProgramOf(s))).ToArray();
            await cell.Until(
                () =>
                {
                    connections = Math.Max(connections, Connections());
                    return Task.FromResult(changed.All(f => FireFiles.Hash(File.ReadAllBytes(f)) != FireFiles.OriginalSha256));
                },
                TimeSpan.FromMinutes(1),
                "both verified");

            // Two slots wait for their ready files now, and four for programs.
            await Task.Delay(TimeSpan.FromSeconds(1), token);
            Assert.True(transactions.Count > 20, "The server's log is not heard.");
            transactions.Clear();
            await Task.Delay(Watched, token);
            connections = Math.Max(connections, Connections());
        }
        finally
        {
            server.Said -= Note;
            server.Execute("postgres", "ALTER SYSTEM RESET log_line_prefix");
            server.Execute("postgres", "SELECT pg_reload_conf()");
        }

        // Within three seconds those that come every five and every thirty may all fall.
        Assert.True(transactions.Count <= 8, string.Join('\n', transactions.Values));
        Assert.InRange(connections, 3, 4);
        await cell.Kill();

        void Note(string line)
        {
            if (line.Split('|', 3) is [var database, var number, var text] && database == settings.Database && number.Length > 0)
                transactions.TryAdd(number, text);
        }

        long Connections() => server.Value(
            settings.Database,
            string.Create(
                CultureInfo.InvariantCulture,
                $"SELECT count(*) FROM pg_stat_activity WHERE datname = '{settings.Database}' AND application_name = 'errormatch'"));
    }
}
