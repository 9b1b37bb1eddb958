using System.IO.Compression;
using ErrorMatching.Testing;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>A cell that version 0.1.0 left, opened by this version.</summary>
/// <remarks>
/// <c>cell-0.1.0.zip</c> is what the console of commit f292c46f1dc8add91f6e3e00edba69b6771755cb left of the sample's cell: a store of form
/// 4, whose rows have no codes yet, its keys, the machine's program, and in <c>trail.csv</c> what its <c>audit export</c> printed. Three
/// parts came in, with key point 14 at X -32.310, -32.309 and -32.308. The first was cut, the second is at the machine, the third is
/// approved and waits.
/// </remarks>
public sealed class OlderStoreTests
{
    private const string Config = "samples/cell/cell.json";
    private const string Program = "samples/cell/machine/counterpart.nc";
    private const string Ready = "samples/cell/machine/A.READY";

    // From trail.csv: the programs that the older version computed.
    private const string First = "d89ece46eafb9d449f3fbcaca9ca58ff31f7da9c28dd4f4eb3aeb402d631a876";
    private const string Second = "20acf47ba761ccbadad0a6da3ebd5e0adc8abde1b9eda1652c0d7f7d0728bcc0";
    private const string Third = "05a93ffd48594cd02a776d6514b23e40412a67fcea57cf47d50672929f9f9307";

    [Fact]
    public async Task Its_cell_goes_on_and_nothing_is_lost_or_sent_again()
    {
        using var shop = new Workshop();
        Unpack(shop);
        var sent = new DateTime(2026, 11, 20, 0, 0, 0, DateTimeKind.Utc);
        File.SetLastWriteTimeUtc(shop[Program], sent);
        using (var cell = new RunningConsole(shop, Config))
        {
            // A new part arrives while the second one's program is still to be cut: that program stays as it is.
            var part = File.ReadAllText(shop["samples/complex-mating/part.csv"]);
            File.WriteAllText(shop["samples/cell/new"], part.Replace("14,-32.311,", "14,-32.307,", StringComparison.Ordinal));
            File.Move(shop["samples/cell/new"], shop["samples/cell/incoming/part-0004.csv"]);
            await SampleCellTests.Until(() => History(shop, "approved").Contains("part-0004.csv", StringComparison.Ordinal));
            Assert.Equal((Second, sent), (Workshop.Sha256(shop[Program]), File.GetLastWriteTimeUtc(shop[Program])));

            // What the older version approved is delivered as that version computed it, and then the new part's program.
            await Cut(shop, "part-0003.csv");
            Assert.Equal(Third, Workshop.Sha256(shop[Program]));
            await Cut(shop, "part-0004.csv");
            Assert.Equal(0, await cell.EndAsync());
        }

        Assert.Equal(0, (await shop.Run("audit verify " + Config)).Exit);
        var entries = (await shop.Run("audit export " + Config)).Output.Split("\r\n");
        string[] older = File.ReadAllText(shop["samples/cell/trail.csv"]).TrimEnd().Split("\r\n");
        Assert.Equal(25, older.Length);
        Assert.All(older.Zip(entries), e => Assert.StartsWith(e.First + ",", e.Second, StringComparison.Ordinal));
        foreach (var program in new[] { First, Second, Third, Workshop.Sha256(shop[Program]) })
        {
            Assert.Single(
                entries,
                e => e.Contains("\"uploading\",\"correction ", StringComparison.Ordinal)
                    && e.Contains(" program " + program + "\"", StringComparison.Ordinal));
        }

        Assert.Contains("\nanna  administrator  ", (await shop.Run("user list " + Config)).Output, StringComparison.Ordinal);
        Assert.Equal(0, (await shop.Run($"cell show {Config} 1 --out first")).Exit);
        Assert.Equal(First, Workshop.Sha256(shop["first/1-counterpart.nc"]));
    }

    private static void Unpack(Workshop shop)
    {
        // Keys that others could have read are refused.
        if (!OperatingSystem.IsWindows())
        {
            Directory.CreateDirectory(
                shop["samples/cell/run/keys"], UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.UserExecute);
        }

        ZipFile.ExtractToDirectory(
            Repository.PathTo("tests", "ErrorMatching.EndToEnd.Tests", "Cell", "cell-0.1.0.zip"), shop["samples/cell"]);
    }

    private static async Task Cut(Workshop shop, string next)
    {
        File.WriteAllText(shop[Ready], "");
        await SampleCellTests.Until(() => History(shop, "verified").Contains(next, StringComparison.Ordinal));
    }

    private static string History(Workshop shop, string state) =>
        shop.Run($"cell history {Config} --state {state} --json").GetAwaiter().GetResult().Output;
}
