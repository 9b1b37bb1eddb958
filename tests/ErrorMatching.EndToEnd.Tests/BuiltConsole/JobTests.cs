namespace ErrorMatching.EndToEnd.Tests;

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
        Assert.All(new[] { "kind", "name", "part", "gauge", "features", "counterpart", "compensation", "toleranceChain", "verify" }, k => Assert.True(schema.GetProperty("properties").TryGetProperty(k, out _), k));
    }
}
