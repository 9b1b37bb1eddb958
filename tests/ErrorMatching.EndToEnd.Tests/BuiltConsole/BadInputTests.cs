using System.Diagnostics;
using System.Text;
using System.Text.Json;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>Every class of bad input once through the real process: exit code, code and place, nothing written, no input changed.</summary>
[Trait("Runs", "Console")]
public sealed class BadInputTests
{
    private const string Job = "samples/complex-mating/job.json";
    private const string Part = "samples/complex-mating/part.csv";
    private const string Program = "samples/complex-mating/counterpart.nc";

    [Theory]
    [InlineData("not-a-number", "1,-32.067,76.009", "1,NaN,76.009", 2, 2)]
    [InlineData("infinite-number", "1,-32.067,76.009", "1,-32.067,Infinity", 2, 3)]
    [InlineData("text-for-number", "1,-32.067,76.009", "1,oops,76.009", 2, 2)]
    [InlineData("empty-cell", "1,-32.067,76.009", "1,,76.009", 2, 2)]
    [InlineData("short-row", "1,-32.067,76.009", "1,-32.067", 2, null)]
    [InlineData("long-row", "1,-32.067,76.009", "1,-32.067,76.009,7", 2, 4)]
    [InlineData("duplicate-point", "1,-32.067,76.009", "2,-32.067,76.009", null, null)]
    [InlineData("missing-point", "1,-32.067,76.009", "99,-32.067,76.009", null, null)]
    [InlineData("missing-column", "point,x_mm,y_mm", "point,x_mm,why_mm", 1, null)]
    [InlineData("duplicate-column", "point,x_mm,y_mm", "point,x_mm,x_mm", 1, null)]
    [InlineData("formula", "1,-32.067,76.009", "1,=A1+1,76.009", 2, 2)]
    [InlineData("thousands-separator", "1,-32.067,76.009", "1,\"-32,067.5\",76.009", 2, 2)]
    [InlineData("decimal-comma", "1,-32.067,76.009", "1,\"-32,0671\",76.009", 2, 2)]
    [InlineData("number-out-of-range", "1,-32.067,76.009", "1,1e999,76.009", 2, 2)]
    [InlineData("implausible-number", "1,-32.067,76.009", "1,-32067000,76.009", 2, 2)]
    [InlineData("unclosed-quote", "1,-32.067,76.009", "1,\"-32.067,76.009", 2, 2)]
    [InlineData("bad-quote", "1,-32.067,76.009", "1,-32\".067,76.009", 2, 2)]
    [InlineData("binary-file", "1,-32.067,76.009", "1,-32.067,76.009\0", 2, null)]
    public async Task A_damaged_measurement_is_named_by_its_place(string code, string line, string damaged, int? atLine, int? column)
    {
        using var shop = new Workshop();
        var first = File.ReadAllLines(shop[Part])[line.StartsWith("point", StringComparison.Ordinal) ? 0 : 1];
        shop.Edit(Part, first, damaged);
        var error = await Refused(shop, 1, code, "match", Job, "--out", "out");
        Assert.Equal(Part, error.GetProperty("file").GetString());
        Assert.Equal(atLine, atLine is null ? null : error.GetProperty("line").GetInt32());
        Assert.Equal(column, column is null ? null : error.GetProperty("column").GetInt32());
    }

    [Theory]
    [InlineData("empty-file", "")]
    [InlineData("missing-header", "1,-32.067,76.009\n")]
    [InlineData("no-points", "point,x_mm,y_mm\n")]
    public async Task A_measurement_without_points_is_named(string code, string content)
    {
        using var shop = new Workshop();
        File.WriteAllText(shop[Part], content);
        Assert.Equal(Part, (await Refused(shop, 1, code, "match", Job, "--out", "out")).GetProperty("file").GetString());
    }

    [Fact]
    public async Task A_measurement_in_another_encoding_is_named()
    {
        using var shop = new Workshop();
        File.WriteAllBytes(
            shop[Part], Encoding.Unicode.GetPreamble().Concat(Encoding.Unicode.GetBytes(File.ReadAllText(shop[Part]))).ToArray());
        await Refused(shop, 1, "invalid-encoding", "match", Job, "--out", "out");
    }

    [Theory]
    [InlineData(Part)]
    [InlineData(Program)]
    [InlineData(Job)]
    [InlineData("samples/complex-mating/theoretical.csv")]
    public async Task A_missing_file_is_named(string file)
    {
        using var shop = new Workshop();
        File.Delete(shop[file]);
        Assert.Equal(file, (await Refused(shop, 1, "file-unreadable", "match", Job, "--out", "out")).GetProperty("file").GetString());
    }

    [Fact]
    public async Task A_measurement_of_the_other_piece_is_named()
    {
        using var shop = new Workshop();
        shop.Edit(Job, "\"alignment\"", """
            "recognition": {
              "part": [{ "in": "file-name", "pattern": "^part" }],
              "counterpart": [{ "in": "file-name", "pattern": "^counterpart" }],
            },
            "alignment"
            """);
        Assert.Equal(0, (await shop.Run(["match", Job])).Exit);
        await Refused(shop, 1, "wrong-piece", "match", Job, "--part", "samples/complex-mating/counterpart.csv", "--out", "out");
        await Refused(shop, 1, "wrong-piece", "verify", Job, "--before", Part, "--after", "samples/complex-mating/counterpart-after.csv");
        await Refused(shop, 1, "undecided-source", "match", Job, "--part", "samples/complex-mating/theoretical.csv", "--out", "out");
    }

    [Fact]
    public async Task Common_mistakes_are_named()
    {
        using var shop = new Workshop();
        const string before = "samples/complex-mating/counterpart.csv", surface = "samples/surface-one/job.json";
        const string measured = "samples/surface-one/measured.csv";
        await Refused(shop, 1, "wrong-piece", "match", Job, "--part", before, "--out", "out");
        await Refused(shop, 1, "wrong-piece", "verify", Job, "--before", Part, "--after", before);
        await Refused(shop, 1, "same-measurement", "verify", Job, "--before", before, "--after", before);
        await Refused(shop, 1, "not-a-measurement", "match", Job, "--part", Program, "--out", "out");
        await Refused(shop, 1, "other-kind", "match", surface, "--out", "out");
        await Refused(shop, 1, "other-kind", "surface", "evaluate", Job, "--measured", measured);
        await Refused(shop, 1, "not-a-measurement", "surface", "evaluate", surface, "--measured", "samples/surface-one/surface.igs");
        File.WriteAllText(shop["commas.csv"], File.ReadAllText(shop[measured]).Replace(',', ';').Replace('.', ','));
        var comma = await Refused(shop, 1, "decimal-comma", "surface", "evaluate", surface, "--measured", "commas.csv");
        Assert.Contains(
            "set \"decimalComma\": true in the \"format\" of \"gauge\"",
            comma.GetProperty("message").GetString(),
            StringComparison.Ordinal);
        shop.Edit(surface, "\"measuring\": {", "\"gauge\": { \"format\": { \"decimalComma\": true } }, \"measuring\": {");
        Assert.Equal(0, (await shop.Run(["surface", "evaluate", surface, "--measured", "commas.csv"])).Exit);
        shop.Edit(surface, "\"surface.igs\"", "\"measured.csv\"");
        await Refused(shop, 1, "cloud-as-surface", "surface", "evaluate", surface, "--measured", "commas.csv");
        File.WriteAllText(shop["samples/surface-one/measured.csv"], "solid s\nfacet normal 0 0 1\n");
        await Refused(shop, 1, "mesh-as-surface", "surface", "evaluate", surface, "--measured", "commas.csv");
    }

    [Theory]
    [InlineData("\"kind\": \"mating\"", "\"kind\": \"matting\"", "not-one-of|wrong-type|no-alternative", "$.kind")]
    [InlineData("\"gain\": 1.0", "\"gian\": 1.0", "unknown-key", "$.compensation.gian")]
    [InlineData("\"name\": \"Complex mating\",", "", "missing-key", "$")]
    [InlineData("\"5..14\"", "\"14..5\"", "bad-range", "$.features[2].points[0]")]
    [InlineData("\"L2L3\", \"kind\"", "\"L1\", \"kind\"", "duplicate-name", "$.features[1].name")]
    [InlineData("\"N120\"", "\"/(/\"", "bad-pattern", "$.features[0].blocks[0]")]
    [InlineData(
        "[\"N120\"], \"toleranceMm\": [-0.05, 0.05]",
        "[\"N120\"], \"toleranceMm\": [-30, 30]",
        "limit-implausible",
        "$.features[0].toleranceMm[0]")]
    [InlineData("\"uncertaintyMm\": 0.0054", "\"uncertaintyMm\": 5.4", "uncertainty-implausible", "$.gauge.uncertaintyMm")]
    [InlineData("\"kind\": \"mating\",", "\"kind\": ,", "not-json", null)]
    public async Task A_damaged_job_is_named_by_its_path(string old, string replacement, string codes, string? path)
    {
        using var shop = new Workshop();
        shop.Edit(Job, old, replacement);

        // The document itself begins behind its comment; all else stands where it was damaged.
        var text = File.ReadAllText(shop[Job]);
        var line = 1
            + text[
                ..(
                    path == "$"
                        ? text.IndexOf("\n{", StringComparison.Ordinal) + 1
                        : text.LastIndexOf(replacement, StringComparison.Ordinal))].Count(c => c == '\n');
        foreach (var verb in new[] { "job check", "match" })
        {
            var run = await shop.Run($"{verb} {Job} --json");
            Assert.Equal(1, run.Exit);
            var error = run.Json.GetProperty("errors")
                .EnumerateArray()
                .First(e => codes.Split('|').Contains(e.GetProperty("code").GetString()));
            Assert.Equal((Job, line), (error.GetProperty("file").GetString(), error.GetProperty("line").GetInt32()));
            Assert.True(path is null || path == error.GetProperty("path").GetString(), error.ToString());
        }
    }

    [Fact]
    public async Task All_that_is_wrong_in_a_job_is_said_at_once()
    {
        using var shop = new Workshop();
        shop.Edit(Job, "\"gain\": 1.0", "\"gian\": 1.0");
        shop.Edit(Job, "\"mapMm\": 0.5", "\"mapMm\": -1");
        var run = await shop.Run(["job", "check", Job]);
        Assert.Equal((1, "", 2), (run.Exit, run.Output, run.Error.Split('\n', StringSplitOptions.RemoveEmptyEntries).Length));
        Assert.All(
            run.Error.Split('\n', StringSplitOptions.RemoveEmptyEntries), l => Assert.StartsWith(Job + ":", l, StringComparison.Ordinal));
    }

    [Theory]
    [InlineData("\"delta-nc300\"", "\"delta\"", 1, "unknown-dialect")]
    [InlineData("\"N120\"", "\"N9999\"", 2, "block-not-found")]
    [InlineData("\"N120\"", "\"N10\"", 2, "no-motion|point-off-path")]
    [InlineData("\"translateMm\": [0, 0]", "\"translateMm\": [5, 0]", 2, "point-off-path")]
    [InlineData("\"limitMm\": 1.0", "\"limitMm\": 0.1", 2, "implausible-deviation")]
    [InlineData("\"toolDiameterMm\": 6", "\"toolDiameterMm\": 10", 2, "point-off-path|sides-differ")]
    public async Task What_does_not_fit_together_makes_no_program(string old, string replacement, int exit, string codes)
    {
        using var shop = new Workshop();
        shop.Edit(Job, old, replacement);
        await Refused(shop, exit, codes, "match", Job, "--out", "out");
    }

    [Theory]
    [InlineData("N130 X-45.275", "N130 X#100", "expression|point-off-path")]
    [InlineData("N130 X-45.275", "N130 W5. X-45.275", "other-axis")]
    [InlineData("N120 X-34.995", "N115 G68 X0. Y0. R10.\nN120 X-34.995", "active-transform|unknown-state|point-off-path")]
    [InlineData(
        "N120 X-34.995",
        "N115 IF [#500 EQ 1] GOTO 130\nN120 X-34.995",
        "endless-loop|unknown-condition|unknown-state|point-off-path|expression|frame-change")]
    [InlineData("N140 G3", "N130 G3", "block-ambiguous")]
    [InlineData("I6. J0.", "I5. J0.", "bad-arc|point-off-path")]
    public async Task A_program_that_cannot_be_trusted_is_refused_with_its_block(string old, string replacement, string codes)
    {
        using var shop = new Workshop();
        shop.Edit(Program, old, replacement);
        var error = await Refused(shop, 2, codes, "match", Job, "--out", "out");
        Assert.StartsWith("N1", error.GetProperty("block").GetString(), StringComparison.Ordinal);
        Assert.True(error.GetProperty("line").GetInt32() > 10);
    }

    [Fact]
    public async Task An_origin_that_is_off_stops_the_job()
    {
        using var shop = new Workshop();
        shop.Edit(Job, "\"alignment\"", "\"originCheck\": { \"point\": \"1\", \"limitMm\": 0.05 },\n  \"alignment\"");
        await Refused(shop, 2, "origin-off", "match", Job, "--out", "out");
    }

    // As a user types it: the shell gives the console a pipe of its own.
    [Fact]
    public async Task A_program_from_a_pipe_of_the_shell_is_read_like_a_file()
    {
        Assert.SkipUnless(ConsoleRun.HasSignals, "Only these shells have it.");
        using var shop = new Workshop();
        var run = await InShell(shop, $"match {Job} --program <(cat {Program}) --out piped");
        Assert.Equal((0, ""), (run.Exit, run.Error));
        Assert.Equal(0, (await shop.Run("match", Job, "--program", Program, "--out", "named")).Exit);
        Assert.Equal(
            Workshop.Sha256(shop["named", "counterpart.nc"]), Workshop.Sha256(shop["piped", "counterpart.nc"]));

        // A pipe cannot be read twice, nor looked at for its length.
        Assert.Equal(0, (await InShell(shop, $"nc check <(cat {Program}) --dialect delta-nc300")).Exit);
        var empty = await InShell(shop, $"match {Job} --program <(true) --json");
        Assert.Equal("empty-program", empty.SingleError.GetProperty("code").GetString());
        var part = await InShell(shop, $"match {Job} --part <(cat {Part}) --out part");
        Assert.Equal((0, ""), (part.Exit, part.Error));
    }

    [Fact]
    public async Task A_job_from_a_pipe_of_the_shell_has_no_folder_and_says_so()
    {
        Assert.SkipUnless(ConsoleRun.HasSignals, "Only these shells have it.");
        using var shop = new Workshop();
        foreach (var line in (string[])["job check", "match"])
        {
            var run = await InShell(shop, $"{line} <(cat {Job}) --json");
            Assert.Equal(1, run.Exit);
            Assert.Equal("job-without-folder", run.SingleError.GetProperty("code").GetString());
            Assert.Contains("/dev/fd/", run.SingleError.GetProperty("file").GetString(), StringComparison.Ordinal);
            Assert.Contains("Name a file.", run.SingleError.GetProperty("message").GetString(), StringComparison.Ordinal);
        }
    }

    private static Task<ConsoleRun> InShell(Workshop shop, string line) => ConsoleRun.Of(
        new ProcessStartInfo("bash", ["-c", $"'{ConsoleRun.Executable}' {line}"]) { WorkingDirectory = shop.Folder });

    /// <summary>Runs a command line that must fail with one of some codes, change nothing and write nothing.</summary>
    private static async Task<JsonElement> Refused(Workshop shop, int exit, string codes, params string[] arguments)
    {
        var before = shop.State();
        var run = await shop.Run([.. arguments, "--json"]);
        Assert.Equal((exit, ""), (run.Exit, run.Error));
        Assert.Equal(("errormatch/error/1", exit), (run.Json.GetProperty("schema").GetString(), run.Json.GetProperty("exit").GetInt32()));
        var error = run.Json.GetProperty("errors")[0];
        Assert.Contains(error.GetProperty("code").GetString(), codes.Split('|'));
        Assert.Equal(before, shop.State());
        Assert.False(Directory.Exists(shop["out"]));

        var text = await shop.Run(arguments);
        Assert.Equal((exit, ""), (text.Exit, text.Output));
        Assert.NotEqual("", text.Error);
        return error;
    }
}
