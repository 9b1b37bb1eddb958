using System.Text.Json;
using ErrorMatching.Testing;

namespace ErrorMatching.Console.Tests;

public class DialectTests
{
    private const string Own = """{ "name": "ours", "like": "fanuc", "description": "Ours.", "codes": [ { "codes": "G187", "means": "harmless", "statement": "Accuracy.", "source": "our tests" } ] }""";

    [Fact]
    public void All_are_listed() => Assert.Equal(
        [
            "generic", "fanuc", "delta-nc300", "haas", "mazak-eia", "mitsubishi-m80", "okuma-osp", "siemens-840d", "linuxcnc", "grbl",
            "heidenhain-klartext",
        ],
        Shell.Json(0, "errormatch/nc-dialects/1", "nc", "dialects").GetProperty("dialects").EnumerateArray().Select(d => d.Text("name")));

    [Fact]
    public void One_is_printed_as_a_manual_page()
    {
        var (exit, page, error) = Shell.Run("nc", "dialects", "siemens-840d");
        Assert.Equal((0, ""), (exit, error));
        var lines = page.Split('\n');
        Assert.Contains(
            lines,
            l => l.StartsWith("TRANS  ", StringComparison.Ordinal)
                && l.Contains("  frame-shift  ", StringComparison.Ordinal)
                && l.Contains("SINUMERIK", StringComparison.Ordinal)
                && l.EndsWith("  siemens-840d", StringComparison.Ordinal));
        Assert.Contains("Programs that are in the machine", lines);
        Assert.Single(Shell.Json(0, "errormatch/nc-dialects/1", "nc", "dialects", "siemens-840d").GetProperty("dialects").EnumerateArray());
    }

    [Fact]
    public void Schema_is_printed_alone()
    {
        var (exit, text, _) = Shell.Run("nc", "dialects", "--schema");
        using var schema = JsonDocument.Parse(text);
        Assert.Equal((0, "an NC dialect"), (exit, schema.RootElement.GetProperty("title").GetString()));
        Assert.Equal("command-line", Shell.Error(1, "nc", "dialects", "fanuc", "--schema").Text("code"));
    }

    [Theory]
    [InlineData("check")]
    [InlineData("motion")]
    [InlineData("locate", "--blocks", "N10")]
    [InlineData("displace", "--blocks", "N20", "--normal", "0.1", "--out", "OUT")]
    [InlineData("diff", "PROGRAM")]
    public void Each_verb_takes_a_file(string verb, params string[] more)
    {
        using var folder = new TemporaryFolder();
        var (program, dialect) = (
            folder.File("p.nc", "G187 P1\nG90 G17 G40 G0 X0 Y0 Z0\nN10 G1 X10. F100\nN20 Y10.\nN30 X20.\n"), folder.File("ours.json", Own));
        var document = Shell.Json(
            0,
            $"errormatch/nc-{verb}/1",
            ["nc", verb, program, .. more.Select(m => m == "OUT" ? folder["o.nc"] : m == "PROGRAM" ? program : m), "--dialect", dialect]);
        Assert.Equal("ours", document.Text("dialect"));
    }

    [Theory]
    [InlineData("check")]
    [InlineData("motion")]
    [InlineData("displace", "--blocks", "N20", "--normal", "0.1", "--out", "OUT")]
    [InlineData("diff", "PROGRAM")]
    public void Each_answer_about_a_program_notes_numbers_without_a_point(string verb, params string[] more)
    {
        using var folder = new TemporaryFolder();
        var program = folder.File("p.nc", "G90 G17 G40 G0 X0 Y0 Z0\nN10 G1 X10 F100\nN20 Y10.\nN30 X20\n");
        string[] arguments = [
            "nc", verb, program, .. more.Select(m => m == "OUT" ? folder["o.nc"] : m == "PROGRAM" ? program : m), "--dialect", "fanuc"];
        var note = Shell.Json(0, $"errormatch/nc-{verb}/1", arguments).GetProperty("notes").EnumerateArray().First();
        Assert.Equal(
            ("number-without-point", 2, 2, "N10"),
            (note.Text("code"), note.GetProperty("count").GetInt32(), note.GetProperty("line").GetInt32(), note.Text("block")));
        if (verb != "motion")
        {
            Assert.Contains(
                "2 coordinates are written without a point, the first in N10.", Shell.Run(arguments).Output, StringComparison.Ordinal);
        }

        arguments[^1] = "linuxcnc";
        Assert.Empty(Shell.Json(0, $"errormatch/nc-{verb}/1", arguments).GetProperty("notes").EnumerateArray());
    }

    [Fact]
    public void A_mistake_in_a_file_is_named_by_its_place()
    {
        using var folder = new TemporaryFolder();
        var (program, dialect) = (
            folder.File("p.nc", "G0 X0\n"),
            folder.File(
                "ours.json",
                Own.Replace(
                    "\"codes\": [", "\n\"codes\": [", StringComparison.Ordinal).Replace("harmless", "harmles", StringComparison.Ordinal)));
        var error = Shell.Error(1, "nc", "check", program, "--dialect", dialect);
        Assert.Equal(
            ("not-one-of", dialect, "$.codes[0].means", 2),
            (error.Text("code"), error.Text("file"), error.Text("path"), error.GetProperty("line").GetInt32()));
        Assert.StartsWith($"{dialect}:2:", Shell.Run("nc", "dialects", dialect).Error, StringComparison.Ordinal);
        Assert.Equal("file-unreadable", Shell.Error(1, "nc", "check", program, "--dialect", folder["none.json"]).Text("code"));
        Assert.Equal("unknown-dialect", Shell.Error(1, "nc", "check", program, "--dialect", "none").Text("code"));
    }

    [Fact]
    public void A_job_may_name_a_file_beside_it_and_the_report_lists_it()
    {
        using var folder = new TemporaryFolder();
        foreach (var file in new[] { "theoretical.csv", "part.csv", "counterpart.nc" })
        {
            folder.File(file, File.ReadAllText(Repository.PathTo("samples", "complex-mating", file)));
        }

        var job = folder.File(
            "job.json",
            File.ReadAllText(Repository.PathTo("samples", "complex-mating", "job.json")).Replace(
                "\"delta-nc300\"", "\"ours.json\"", StringComparison.Ordinal));
        Assert.Equal("file-unreadable", Shell.Error(1, "job", "check", job).Text("code"));
        var dialect = folder.File("ours.json", Own.Replace("fanuc", "delta-nc300", StringComparison.Ordinal));
        Assert.Equal(0, Shell.Run("job", "check", job).Exit);
        var inputs = Shell.Json(0, "errormatch/match/1", "match", job, "--out", folder["out"])
            .GetProperty("inputs")
            .EnumerateArray()
            .ToArray();
        Assert.Equal(dialect, Assert.Single(inputs, i => i.Text("role") == "dialect").Text("file"));
        Assert.Equal(
            Shell.Json(0, "errormatch/match/1", "match", Repository.PathTo("samples", "complex-mating", "job.json"))
                .GetProperty("program")
                .Text("sha256"),
            Shell.Json(0, "errormatch/match/1", "match", job).GetProperty("program").Text("sha256"));
    }

    [Theory]
    [InlineData("off", "/N20 X20.|N30 X21. Y11.|N40 X0. Y10.")]
    [InlineData("on", "/N20 X20.|N30 X11. Y11.|N40 X0. Y10.")]
    public void The_switch_for_block_skip_is_stated_at_the_console_and_kept_in_the_wish(string position, string expected)
    {
        using var folder = new TemporaryFolder();
        var program = folder.File("p.nc", "G21 G90 G54\nG0 X0. Y0. Z0.\nN10 G1 X10. F100\n/N20 X20.\nN30 Y10.\nN40 X0.\nM30\n");
        string[] files = [program, "--out", folder["o.nc"], "--wish", folder["w.json"]];
        string[] displace = ["nc", "displace", .. files, "--blocks", "N30", "--by", "1,1", "--dialect", "fanuc"];
        var error = Shell.Error(2, displace);
        Assert.Equal(("unknown-condition", "N30", 5), (error.Text("code"), error.Text("block"), error.GetProperty("line").GetInt32()));
        Assert.False(File.Exists(folder["o.nc"]));

        var (exit, check, _) = Shell.Run("nc", "check", program, "--dialect", "fanuc");
        Assert.Equal((0, false), (exit, check.Contains("Everything is understood", StringComparison.Ordinal)));

        var answer = Shell.Json(0, "errormatch/nc-displace/1", [.. displace, "--block-skip", position]);
        Assert.Contains("block-skip", answer.GetProperty("notes").EnumerateArray().Select(n => n.Text("code")));
        var lines = File.ReadAllLines(folder["o.nc"]);
        Assert.All(expected.Split('|'), l => Assert.Contains(l, lines));
        Assert.Equal(0, Shell.Run("nc", "prove", program, folder["o.nc"], "--wish", folder["w.json"]).Exit);
        Assert.Equal("command-line", Shell.Error(1, [.. displace, "--block-skip", "sometimes"]).Text("code"));
    }

    [Fact]
    public void A_job_states_the_switch_for_block_skip()
    {
        using var folder = new TemporaryFolder();
        foreach (var file in new[] { "theoretical.csv", "part.csv", "counterpart.nc" })
        {
            folder.File(file, File.ReadAllText(Repository.PathTo("samples", "complex-mating", file)));
        }

        // A last block behind a slash: the way to another place.
        var program = File.ReadAllText(folder["counterpart.nc"]).Replace("M30", "/G0 X0. Y0.\nM30", StringComparison.Ordinal);
        folder.File("counterpart.nc", program);
        var text = File.ReadAllText(Repository.PathTo("samples", "complex-mating", "job.json"));
        var job = folder.File("job.json", text);
        // Both positions end in the same place and state, so neither has to be stated.
        Shell.Json(0, "errormatch/match/1", "match", job);
        Assert.Equal(0, Shell.Run("job", "blocks", job).Exit);
        foreach (var position in new[] { "off", "on" })
        {
            var stated = $"\"delta-nc300\", \"blockSkip\": \"{position}\"";
            folder.File("job.json", text.Replace("\"delta-nc300\"", stated, StringComparison.Ordinal));
            Shell.Json(0, "errormatch/match/1", "match", job);
            Assert.Equal(0, Shell.Run("job", "blocks", job).Exit);
        }
    }

    [Fact]
    public void Each_code_of_a_dialect_file_is_in_the_reference()
    {
        var reference = File.ReadAllText(Repository.PathTo("docs", "reference-console.md"));
        string[] codes = ["bad-subject", "stated-twice", "bad-role", "name-taken", "unknown-like", "circular-like"];
        Assert.All(codes, c => Assert.Contains($"| `{c}` |", reference, StringComparison.Ordinal));
    }
}
