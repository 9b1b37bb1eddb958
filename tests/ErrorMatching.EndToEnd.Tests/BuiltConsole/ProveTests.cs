using System.Text.Json;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>A result is proved again from the files alone; what was changed in any of the three files shows.</summary>
[Trait("Runs", "Console")]
public sealed class ProveTests
{
    private const string Program = "samples/complex-mating/counterpart.nc";

    [Theory]
    [InlineData("samples/complex-mating")]
    [InlineData("samples/curve-mating")]
    public async Task A_match_is_proved_again_with_the_proof_of_its_report(string sample)
    {
        using var shop = new Workshop();
        Assert.Equal(0, (await shop.Run($"match {sample}/job.json --out out --wish out/wish.json")).Exit);
        var run = await shop.Run($"nc prove {sample}/counterpart.nc out/counterpart.nc --wish out/wish.json --json");
        Assert.Equal((0, ""), (run.Exit, run.Error));
        Assert.Equal("errormatch/nc-prove/1", run.Json.GetProperty("schema").GetString());
        using var report = JsonDocument.Parse(
            await File.ReadAllBytesAsync(shop["out", "report.json"], TestContext.Current.CancellationToken));
        var (was, now) = (report.RootElement.GetProperty("proof"), run.Json.GetProperty("proof"));
        Assert.True(now.GetProperty("holds").GetBoolean());
        Assert.Equal(
            was.EnumerateObject().Select(p => (p.Name, JsonSerializer.Serialize(p.Value))),
            now.EnumerateObject().Select(p => (p.Name, JsonSerializer.Serialize(p.Value))));
        Assert.Equal(Workshop.Sha256(shop["out", "counterpart.nc"]), run.Json.GetProperty("afterSha256").GetString());
    }

    [Fact]
    public async Task A_match_that_writes_nothing_else_still_writes_its_wish()
    {
        using var shop = new Workshop();
        var before = shop.State().Count;
        Assert.Equal(0, (await shop.Run("match samples/complex-mating/job.json --wish wish.json")).Exit);
        Assert.True(File.Exists(shop["wish.json"]));
        Assert.Equal(before + 1, shop.State().Count);
    }

    [Theory]
    [InlineData("--blocks N130..N160 --normal 0.02")]
    [InlineData("--blocks N170..N190 --by -0.1,0.05,0.02")]
    [InlineData("--blocks N170..N190 --by 0,0")]
    public async Task A_displaced_program_is_proved_again_and_says_what_moved(string options)
    {
        using var shop = new Workshop();
        Assert.Equal(0, (await shop.Run($"nc displace {Program} --dialect delta-nc300 {options} --out d.nc --wish w.json")).Exit);
        var run = await shop.Run($"nc prove {Program} d.nc --wish w.json --json");
        Assert.Equal((0, ""), (run.Exit, run.Error));
        var moved = (await shop.Run($"nc diff {Program} d.nc --json")).Json.GetProperty("motions").EnumerateArray();
        Assert.Equal(
            moved.Select(m => (m.GetProperty("block").GetString(), m.GetProperty("displacement").ToString())),
            run.Json.GetProperty("motions")
                .EnumerateArray()
                .Select(m => (m.GetProperty("block").GetString(), m.GetProperty("displacement").ToString())));
        Assert.Equal(
            options.EndsWith("0,0", StringComparison.Ordinal) ? 0 : options.Contains("by", StringComparison.Ordinal) ? 3 : 5,
            run.Json.GetProperty("motions").GetArrayLength());
    }

    [Theory]
    [InlineData("N130 X-45.265", "N130 X-45.165", "N140")]
    [InlineData("N130 X-45.265 Y53.958", "N130 X-45.265 Y53.958 M0", "N130")]
    [InlineData("N170", "N171", "N170")]
    [InlineData("G21", "G20", null)]
    public async Task A_tampered_result_is_not_proved(string was, string now, string? block)
    {
        using var shop = new Workshop();
        shop.Edit("samples/proof/displaced.nc", was, now);
        var run = await Prove(shop, Program);
        Assert.Equal(2, run.Exit);
        Assert.All(run.Json.GetProperty("errors").EnumerateArray(), e => Assert.Equal("proof-failed", e.GetProperty("code").GetString()));
        Assert.True(
            block is null
                || run.Json.GetProperty("errors").EnumerateArray().Any(e => e.TryGetProperty("block", out var b) && b.GetString() == block),
            run.Output);
    }

    [Theory]
    [InlineData("0.0098", "0.0198", 2, "proof-failed")]
    [InlineData("\"marker\": null", "\"marker\": \"(M)\"", 2, "proof-failed")]
    [InlineData("    {\"block\":\"N160\"", "    {\"block\":\"N161\"", 1, "no-such-motion")]
    [InlineData("\"elements\"", "\"element\"", 1, "unknown-key")]
    [InlineData("\"leastIncrementMm\": 0.001", "\"leastIncrementMm\": 1", 1, "increment-too-coarse")]
    [InlineData("delta-nc300", "delta-nc301", 1, "unknown-dialect")]
    [InlineData("\"beforeSha256\": \"d", "\"beforeSha256\": \"e", 1, "wish-of-other-program")]
    [InlineData("\"schema\"", "schema", 1, "not-json")]
    public async Task A_tampered_wish_is_refused_or_not_met(string was, string now, int exit, string code)
    {
        using var shop = new Workshop();
        shop.Edit("samples/proof/wish.json", was, now);
        var run = await Prove(shop, Program);
        Assert.Equal(exit, run.Exit);
        Assert.Contains(run.Json.GetProperty("errors").EnumerateArray(), e => e.GetProperty("code").GetString() == code);
    }

    [Fact]
    public async Task A_wish_in_a_shop_s_own_dialect_is_proved_with_its_file()
    {
        using var shop = new Workshop();
        await shop.Run(
            "nc displace samples/own-dialect/pocket.nc --dialect samples/own-dialect/our-mill.json --blocks /X/ --by 0.1,0 --out "
                + "after.nc --wish wish.json");
        var prove = "nc prove samples/own-dialect/pocket.nc after.nc --wish wish.json --json";
        Assert.Equal(0, (await shop.Run($"{prove} --dialect samples/own-dialect/our-mill.json")).Exit);
        Assert.Equal("unknown-dialect", (await shop.Run(prove)).SingleError.GetProperty("code").GetString());
        Assert.Equal("wish-of-other-dialect", (await shop.Run($"{prove} --dialect fanuc")).SingleError.GetProperty("code").GetString());
    }

    [Fact]
    public async Task Another_original_is_a_wrong_input()
    {
        using var shop = new Workshop();
        var run = await Prove(shop, "samples/curve-mating/counterpart.nc");
        Assert.Equal((1, "wish-of-other-program"), (run.Exit, run.SingleError.GetProperty("code").GetString()));
        Assert.Equal(1, (await shop.Run($"nc prove {Program} samples/proof/displaced.nc --wish missing.json")).Exit);
        Assert.Equal(1, (await shop.Run($"nc prove {Program} samples/proof/displaced.nc")).Exit);
    }

    [Fact]
    public async Task A_wish_appears_with_its_program_or_not_at_all()
    {
        using var shop = new Workshop();
        var before = shop.State();
        Assert.Equal(2, (await shop.Run($"nc displace {Program} --blocks N7 --normal 0.02 --out d.nc --wish w.json")).Exit);
        Assert.Equal(1, (await shop.Run($"nc displace {Program} --blocks N130 --normal 0.02 --out d.nc --wish {Program}")).Exit);
        Assert.Equal(1, (await shop.Run($"nc displace {Program} --blocks N130 --normal 0.02 --out d.nc --wish d.nc")).Exit);
        Assert.Equal(1, (await shop.Run("match samples/complex-mating/job.json --out out --wish samples/complex-mating/part.csv")).Exit);
        Assert.Equal(before, shop.State());
    }

    private static Task<ConsoleRun> Prove(Workshop shop, string before) =>
        shop.Run($"nc prove {before} samples/proof/displaced.nc --wish samples/proof/wish.json --json");
}
