using ErrorMatching.Testing;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>The certificates that the console writes, and what tools/judge.py says of the results.</summary>
[Trait("Runs", "Console")]
public sealed class CertificateTests
{
    private const string Program = "samples/complex-mating/counterpart.nc";

    [Theory]
    [InlineData("samples/circle-mating")]
    [InlineData("samples/complex-mating")]
    [InlineData("samples/curve-mating")]
    [InlineData("samples/dovetail")]
    [InlineData("samples/slot-mating")]
    public async Task A_second_judge_accepts_what_a_match_writes(string sample)
    {
        Python.IsNeeded();
        using var shop = new Workshop();
        Assert.Equal(0, (await shop.Run($"match {sample}/job.json --out out --certificate out/certificate.json")).Exit);
        var (exit, said) = Judge(shop, $"{sample}/counterpart.nc", "out/counterpart.nc", "out/certificate.json");
        Assert.Equal((0, "yes\n"), (exit, said));
    }

    [Theory]
    [InlineData("--blocks N130..N160 --normal 0.02")]
    [InlineData("--blocks N170..N190 --by -0.1,0.05,0.02")]
    [InlineData("--blocks N170..N190 --by 0,0")]
    public async Task A_second_judge_accepts_what_was_displaced_and_proved_again(string options)
    {
        Python.IsNeeded();
        using var shop = new Workshop();
        var displace = $"nc displace {Program} --dialect delta-nc300 {options} --out d.nc --wish w.json --certificate c.json";
        Assert.Equal(0, (await shop.Run(displace)).Exit);
        Assert.Equal((0, "yes\n"), Judge(shop, Program, "d.nc", "c.json"));
        Assert.Equal(0, (await shop.Run($"nc prove {Program} d.nc --wish w.json --certificate again.json")).Exit);
        var stop = TestContext.Current.CancellationToken;
        Assert.Equal(await File.ReadAllBytesAsync(shop["c.json"], stop), await File.ReadAllBytesAsync(shop["again.json"], stop));
    }

    [Fact]
    public async Task A_second_judge_names_block_and_reason()
    {
        Python.IsNeeded();
        using var shop = new Workshop();
        await shop.Run($"nc prove {Program} samples/proof/displaced.nc --wish samples/proof/wish.json --certificate c.json");
        Assert.Equal((0, "yes\n"), Judge(shop, Program, "samples/proof/displaced.nc", "c.json"));
        shop.Edit("samples/proof/displaced.nc", "N170", "N171");
        Assert.Equal((1, "no: the result is another file\n"), Judge(shop, Program, "samples/proof/displaced.nc", "c.json"));
        Assert.Equal(2, Python.Run(shop[""], "tools/judge.py", Program).Exit);
    }

    [Fact]
    public async Task A_certificate_appears_with_its_program_or_not_at_all()
    {
        using var shop = new Workshop();
        var before = shop.State();
        Assert.Equal(2, (await shop.Run($"nc displace {Program} --blocks N7 --normal 0.02 --out d.nc --certificate c.json")).Exit);
        Assert.Equal(1, (await shop.Run($"nc displace {Program} --blocks N130 --normal 0.02 --out d.nc --certificate {Program}")).Exit);
        Assert.Equal(1, (await shop.Run($"nc displace {Program} --blocks N130 --normal 0.02 --out d.nc --certificate d.nc")).Exit);
        var prove = $"nc prove {Program} {Program} --wish samples/proof/wish.json --certificate";
        Assert.Equal(2, (await shop.Run($"{prove} c.json")).Exit);
        prove = $"nc prove {Program} samples/proof/displaced.nc --wish samples/proof/wish.json --certificate";
        Assert.Equal(1, (await shop.Run($"{prove} samples/proof/wish.json")).Exit);
        Assert.Equal(before, shop.State());
    }

    private static (int Exit, string Output) Judge(Workshop shop, string before, string after, string certificate) =>
        Python.Run(shop[""], "tools/judge.py", before, after, certificate);
}
