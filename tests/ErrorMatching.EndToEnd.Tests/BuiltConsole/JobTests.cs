namespace ErrorMatching.EndToEnd.Tests;

[Trait("Runs", "Console")]
public sealed class JobTests
{
    [Fact]
    public async Task A_new_job_passes_the_check_and_runs_beside_the_files_it_names()
    {
        using var shop = new Workshop();
        Assert.Equal(0, (await shop.Run("job new mating mine/job.json")).Exit);
        foreach (var file in new[] { "theoretical.csv", "part.csv", "counterpart.nc" })
        {
            File.Copy(shop["samples", "complex-mating", file], shop["mine", file]);
        }

        var check = (await shop.Run("job check mine/job.json --json")).Json;
        Assert.Equal(("errormatch/job-check/1", true), (check.GetProperty("schema").GetString(), check.GetProperty("valid").GetBoolean()));
        var run = await shop.Run("match mine/job.json --out out --json");
        Assert.Equal((0, true), (run.Exit, run.Json.GetProperty("proof").GetProperty("holds").GetBoolean()));
    }

    [Theory]
    [InlineData("complex-mating", "N120", "N130..N160", "N170..N1190")]
    [InlineData("curve-mating", "N120..N1970")]
    public async Task A_sample_s_blocks_are_found_by_its_key_points_and_make_the_same_program(string sample, params string[] blocks)
    {
        using var shop = new Workshop();
        var job = $"samples/{sample}/job.json";
        foreach (var block in blocks)
        {
            shop.Edit(job, $"[\"{block}\"]", "[]");
        }

        var before = shop.State();
        Assert.Equal(1, (await shop.Run($"job check {job}")).Exit);
        var dry = await shop.Run($"job blocks {job} --json");
        Assert.Equal(before, shop.State());
        Assert.Equal((0, ""), (dry.Exit, dry.Error));
        Assert.Equal(
            blocks,
            dry.Json.GetProperty("features")
                .EnumerateArray()
                .Select(f => Assert.Single(f.GetProperty("blocks").EnumerateArray()).GetString()));

        // Written elsewhere, the job still finds its files; the sample itself, with the blocks that it came with, makes the same program.
        var written = await shop.Run($"job blocks {job} --out out/found/job.json");
        Assert.Equal((0, ""), (written.Exit, written.Error));
        Assert.Equal(before, shop.State().Where(f => !f.StartsWith("out", StringComparison.Ordinal)));
        Assert.Equal(["job.json"], Directory.EnumerateFileSystemEntries(shop["out", "found"]).Select(Path.GetFileName));
        Assert.Equal(0, (await shop.Run("match out/found/job.json --out out/one")).Exit);
        Assert.Equal(
            0,
            (await shop.Run(["match", ErrorMatching.Testing.Repository.PathTo("samples", sample, "job.json"), "--out", "out/two"])).Exit);
        Assert.Equal(File.ReadAllBytes(shop["out", "two", "counterpart.nc"]), File.ReadAllBytes(shop["out", "one", "counterpart.nc"]));
    }

    [Fact]
    public async Task Blocks_that_are_not_found_are_refused_and_nothing_is_written()
    {
        using var shop = new Workshop();
        shop.Edit("samples/curve-mating/job.json", "\"toolDiameterMm\": 6", "\"toolDiameterMm\": 10");
        var before = shop.State();
        var run = await shop.Run("job blocks samples/curve-mating/job.json --out out/job.json --json");
        Assert.Equal((2, ""), (run.Exit, run.Error));
        Assert.Equal(
            ("errormatch/job-blocks/1", 2, "boundary-not-found"),
            (
                run.Json.GetProperty("schema").GetString(),
                run.Json.GetProperty("exit").GetInt32(),
                run.SingleError.GetProperty("code").GetString()));
        Assert.Equal(before, shop.State());
    }

    [Fact]
    public async Task A_job_that_is_there_is_not_overwritten()
    {
        using var shop = new Workshop();
        var before = shop.State();
        var run = await shop.Run("job new mating samples/complex-mating/job.json --json");
        Assert.Equal((1, "output-exists"), (run.Exit, run.SingleError.GetProperty("code").GetString()));
        Assert.Equal(before, shop.State());
    }

    [Fact]
    public async Task A_free_form_job_to_start_from_passes_the_check()
    {
        using var shop = new Workshop();
        Assert.Equal(0, (await shop.Run("job new freeform job.json")).Exit);
        var run = await shop.Run("job check job.json --json");
        Assert.Equal((0, "freeform"), (run.Exit, run.Json.GetProperty("summary").GetProperty("kind").GetString()));
    }

    [Fact]
    public async Task The_schema_of_free_form_jobs_is_printed()
    {
        using var shop = new Workshop();
        var run = await shop.Run("job schema freeform");
        Assert.Equal(0, run.Exit);
        Assert.Contains("\"scallopMm\"", run.Output, StringComparison.Ordinal);
    }

    [Fact]
    public async Task The_schema_describes_every_key_of_the_template()
    {
        using var shop = new Workshop();
        var schema = (await shop.Run("job schema mating --json")).Json;
        Assert.Equal("errormatch/job-schema/1", schema.GetProperty("schema").GetString());
        Assert.All(
            new[] { "kind", "name", "part", "gauge", "features", "counterpart", "compensation", "toleranceChain", "verify" },
            k => Assert.True(schema.GetProperty("properties").TryGetProperty(k, out _), k));
    }
}
