namespace ErrorMatching.EndToEnd.Tests;

/// <summary>Cutter compensation at the built console: the path of the tool's center, and what its control would refuse.</summary>
[Trait("Runs", "Console")]
public sealed class CompensationTests
{
    private const string Program = "samples/programs/compensated.ngc --dialect linuxcnc";

    [Fact]
    public async Task The_path_of_the_center_has_two_more_columns_in_both_forms()
    {
        using var shop = new Workshop();
        var csv = (await shop.Run($"nc motion {Program} --tool-radius 3 --compensated")).Output.Split(
            '\n', StringSplitOptions.RemoveEmptyEntries);
        Assert.Equal("index,line,block,kind,x,y,z,cx,cy,cz,plane,turns,feed,programmed,inserted", csv[0]);
        Assert.Contains("5,8,N70,arc-cw,-6.1,12,-1,-3.1,12,-1,XY,0,300,5,1", csv);
        var json = (await shop.Run($"nc motion {Program} --tool-radius 3 --compensated --json")).Json;
        Assert.Equal((true, csv.Length - 1), (json.GetProperty("compensated").GetBoolean(), json.GetProperty("motions").GetArrayLength()));
        var arc = json.GetProperty("motions")[5];
        Assert.Equal((5, true), (arc.GetProperty("programmed").GetInt32(), arc.GetProperty("inserted").GetBoolean()));
    }

    [Theory]
    [InlineData("nc motion", "--compensated", 2, "tool-radius-unknown")]
    [InlineData("nc motion", "--tool-radii D2=3 --compensated", 2, "tool-radius-unknown")]
    [InlineData("nc motion", "--tool-radii D1=3 --compensated", 0, "")]
    [InlineData("nc motion", "--tool-radius 3.2 --compensated", 2, "compensation-gouge")]
    [InlineData("nc motion", "--tool-radius 3.2", 0, "")]
    [InlineData("nc motion", "--tool-radius three", 1, "command-line")]
    [InlineData("nc motion", "--tool-radii D1", 1, "command-line")]
    [InlineData("nc check", "--tool-radius 3", 0, "")]
    [InlineData("nc check", "--tool-radius 3.2", 2, "compensation-gouge")]
    [InlineData("nc check", "", 0, "")]
    public async Task A_tool_that_does_not_fit_or_is_not_stated_is_refused(string verb, string options, int exit, string code)
    {
        using var shop = new Workshop();
        var run = await shop.Run($"{verb} {Program} {options} --json");
        Assert.Equal(exit, run.Exit);
        if (exit != 0)
        {
            Assert.Equal(code, run.SingleError.GetProperty("code").GetString());
        }
    }

    [Fact]
    public async Task A_proof_reads_the_radius_from_the_wish()
    {
        using var shop = new Workshop();
        var displaced = await shop.Run(
            $"nc displace {Program} --tool-radius 3 --blocks N50 --normal 0.05 --out out.ngc --wish wish.json");
        Assert.Equal(0, displaced.Exit);
        Assert.Equal(0, (await shop.Run("nc prove samples/programs/compensated.ngc out.ngc --wish wish.json")).Exit);
        shop.Edit("wish.json", "\"toolRadiusMm\": 3", "\"toolRadiusMm\": 3.08");
        var proof = await shop.Run("nc prove samples/programs/compensated.ngc out.ngc --wish wish.json --json");
        Assert.Equal((2, "compensation-gouge"), (proof.Exit, proof.SingleError.GetProperty("code").GetString()));
    }
}
