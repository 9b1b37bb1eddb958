using System.Globalization;
using System.Text;
using System.Text.Json;
using System.Text.RegularExpressions;
using ErrorMatching.EndToEnd.Tests;

namespace ErrorMatching.Peers.Tests;

/// <summary>The log of a running cell, provoked to tell what it knows: passwords of machines and people, keys, tokens.</summary>
public sealed partial class LogSecretTests
{
    private const string Machines = "Machine$ecret-4711";
    private const string Annas = "Anna's long password";
    private const string Wrong = "wrong password of Anna";
    private const string Token = "bearer-of-telemetry-0815";
    private static readonly TimeSpan Patience = TimeSpan.FromMinutes(2);

    [Fact]
    public async Task A_running_cells_log_is_JSON_and_has_no_secret_whatever_goes_wrong()
    {
        Daemon.IsNeeded("curl", "curl");
        using var ftp = new TellingFtp();
        using var cell = new FireCell(
            slots: 1,
            transport: string.Create(
                CultureInfo.InvariantCulture,
                $$"""{ "kind": "ftp", "host": "127.0.0.1", "port": {{ftp.Port}}, "user": "cell", "folder": "/", "tls": "none" }"""));
        Assert.Equal(0, (await Type(cell, ["user", "add", cell.Configuration, "anna", "--role", "administrator"], Annas)).Exit);
        Assert.Equal(0, (await Type(cell, ["cell", "secret", cell.Configuration, "vmc", "--user", "anna"], Annas, Machines)).Exit);
        var piece = new FireFiles().Next(cell.Slots[0], 1);
        cell.Start(("OTEL_EXPORTER_OTLP_ENDPOINT", "http://127.0.0.1:9"), ("OTEL_EXPORTER_OTLP_HEADERS", "authorization=" + Token));
        cell.Drop(piece.Name, piece.Bytes);
        await cell.Until(async () => (await cell.Status()).Codes.Contains("machine-login"), Patience, "the login is refused");
        Assert.Contains(Machines, ftp.Tried);

        // People who mistype, one of them a password as a name.
        Assert.Equal(1, (await Type(cell, ["cell", "approve", cell.Configuration, "1", "--user", "anna"], Wrong)).Exit);
        Assert.Equal(1, (await Type(cell, ["cell", "approve", cell.Configuration, "1", "--user", Annas], Wrong)).Exit);
        Assert.Equal(0, (await Type(cell, ["cell", "approve", cell.Configuration, "1", "--user", "anna"], Annas)).Exit);
        await cell.Until(() => Task.FromResult(ftp.Tried.Count > 1), Patience, "the login is tried again");

        // Keys that are broken are named, not shown.
        await cell.Stop();
        var keys = Directory.EnumerateFiles(cell["keys"]).Select(File.ReadAllText).ToArray();
        var key = Directory.EnumerateFiles(cell["keys"], "*.xml").Single();
        await File.WriteAllTextAsync(
            key, (await File.ReadAllTextAsync(key, TestContext.Current.CancellationToken))[..^20], TestContext.Current.CancellationToken);
        var broken = cell.Start();
        await broken.WaitForExitAsync(TestContext.Current.CancellationToken);
        Assert.Equal(3, broken.ExitCode);

        var log = string.Concat(Directory.EnumerateFiles(cell["logs"], "*.jsonl").Select(File.ReadAllText));
        var lines = log.Split('\n', StringSplitOptions.RemoveEmptyEntries);
        Assert.True(lines.Length > 10, log);
        Assert.All(lines, line =>
        {
            using var document = JsonDocument.Parse(line);
            var root = document.RootElement;
            Assert.True(root.GetProperty("Timestamp").TryGetDateTimeOffset(out _), line);
            Assert.Contains(root.GetProperty("Level").GetString(), new[] { "Debug", "Information", "Warning", "Error", "Fatal" });
            Assert.NotEmpty(root.GetProperty("MessageTemplate").GetString()!);
            Assert.Equal(JsonValueKind.Object, root.GetProperty("Properties").ValueKind);
        });
        var all = log + cell.Said;
        Assert.All(new[] { "machine-login", key }, named => Assert.Contains(named, all, StringComparison.Ordinal));
        var secrets = new[]
        {
            Machines,
            Annas,
            Wrong,
            Token
        }.SelectMany(Spelled).Concat(keys.SelectMany(k => Material().Matches(k).Select(m => m.Value))).ToArray();
        Assert.True(secrets.Length > 14, "The keys' files have no key.");
        Assert.All(secrets, secret => Assert.DoesNotContain(secret, all, StringComparison.OrdinalIgnoreCase));
    }

    // As it is, as an URL, as JSON and as Base64 write it.
    private static IEnumerable<string> Spelled(string secret) =>
    [
        secret, Uri.EscapeDataString(secret), JsonEncodedText.Encode(secret).ToString(),
        Convert.ToBase64String(Encoding.UTF8.GetBytes(secret)).TrimEnd('='),
    ];

    private static Task<ConsoleRun> Type(FireCell cell, IReadOnlyList<string> words, params string[] lines) =>
        ConsoleRun.Typed(cell.Folder, [.. words, "--password-stdin"], lines);

    // Long runs of the digits of Base64 and hexadecimal numbers: keys, but no words.
    [GeneratedRegex("(?=[A-Za-z+/]*[0-9])[A-Za-z0-9+/]{40,}", RegexOptions.None, 1000)]
    private static partial Regex Material();
}
