using System.Diagnostics;
using System.Text.RegularExpressions;
using ErrorMatching.EndToEnd.Tests;
using ErrorMatching.Testing;

namespace ErrorMatching.Peers.Tests;

/// <summary>The console for Windows does the same as the one for this system: the same files byte for byte, the same answers, the same exit
/// codes.</summary>
public sealed partial class WineTests(WineConsole wine) : IClassFixture<WineConsole>
{
    private const string Complex = "samples/complex-mating", Surface = "samples/surface-one";
    private const string Blocks = "--blocks N130..N160 --normal 0.02";

    // The sample complex-mating is matched in two other languages below.
    [Theory]
    [InlineData("circle-mating")]
    [InlineData("curve-mating", Explicit = true)]
    [InlineData("dovetail")]
    [InlineData("klartext-mating", Explicit = true)]
    [InlineData("slot-mating", Explicit = true)]
    public async Task Samples_of_mating_pieces_have_the_same_program_and_report(string sample) =>
        await AreAlike($"match samples/{sample}/job.json --out OUT");

    [Theory]
    [InlineData($"nc check {Complex}/counterpart.nc --dialect delta-nc300")]
    [InlineData($"nc motion {Complex}/counterpart.nc --dialect delta-nc300 --json")]
    [InlineData(
        $"nc displace {Complex}/counterpart.nc --dialect delta-nc300 {Blocks} --out OUT/d.nc --wish OUT/w.json --certificate OUT/c.json")]
    [InlineData($"nc prove {Complex}/counterpart.nc samples/proof/displaced.nc --wish samples/proof/wish.json --json")]
    [InlineData($"nc diff {Complex}/counterpart.nc samples/proof/displaced.nc --json", Explicit = true)]
    [InlineData($"verify {Complex}/job.json --before {Complex}/counterpart.csv --after {Complex}/counterpart-after.csv --out OUT")]
    [InlineData($"job check {Complex}/job.json")]
    [InlineData($"surface plan {Surface}/job.json --out OUT", Explicit = true)]
    [InlineData($"surface evaluate {Surface}/job.json --measured {Surface}/after.csv --before {Surface}/measured.csv --out OUT")]
    [InlineData("surface fit samples/surface-fit/points.csv --check samples/surface-fit/check.csv --out OUT")]
    [InlineData($"surface probe {Surface}/job.json --out OUT")]
    [InlineData("surface toolpath samples/surface-two/job.json --out OUT", Explicit = true)]
    [InlineData($"surface displace {Surface}/job.json --measured {Surface}/measured.csv --program {Surface}/cam.nc --out OUT")]
    [InlineData($"surface compensate {Surface}/job.json --measured {Surface}/measured.csv --out OUT")]
    [InlineData("surface compensate samples/surface-two/job.json --measured samples/surface-two/measured.csv --out OUT", Explicit = true)]
    [InlineData(
        "surface compensate samples/surface-three/job.json --measured samples/surface-three/measured.csv --out OUT",
        Explicit = true)]
    public async Task A_verb_writes_and_says_the_same(string command) => await AreAlike(command);

    [Theory]
    [InlineData("match samples/none.json", 1)]
    [InlineData($"match {Complex}/part.csv", 1, Explicit = true)]
    [InlineData($"match {Complex}/job.json --measured {Complex}/counterpart.nc", 1)]
    [InlineData($"nc check {Complex}/counterpart.nc --dialect none", 1, Explicit = true)]
    [InlineData($"nc displace {Complex}/counterpart.nc --dialect delta-nc300 {Blocks} --out {Complex}/counterpart.nc", 1)]
    [InlineData($"nc displace {Complex}/counterpart.nc --dialect delta-nc300 --blocks N99999 --normal 0.02 --out OUT/d.nc", 2)]
    [InlineData("cell run samples/none.json", 1)]
    public async Task A_refusal_has_the_same_code_place_and_exit_code(string command, int exit)
    {
        WineConsole.IsNeeded();
        using var folder = new TemporaryFolder();
        var arguments = Arguments(command + " --json", folder.Path);
        var (here, there) = (ConsoleRun.Of(Repository.Root, arguments), ConsoleRun.Of(wine.Start(arguments)));
        Assert.Equal((exit, exit), ((await here).Exit, (await there).Exit));
        var (one, other) = ((await here).Json.GetProperty("errors"), (await there).Json.GetProperty("errors"));
        Assert.NotEqual(0, one.GetArrayLength());
        foreach (var (expected, found) in one.EnumerateArray().Zip(other.EnumerateArray()))
        {
            // The system's own sentence about a missing file differs; all else is ours.
            Assert.Equal(
                expected.EnumerateObject().Where(p => p.Name != "message").Select(p => $"{p.Name}: {p.Value}"),
                found.EnumerateObject().Where(p => p.Name != "message").Select(p => $"{p.Name}: {p.Value}"));
        }

        Assert.Equal(one.GetArrayLength(), other.GetArrayLength());
    }

    [Fact]
    public async Task Paths_may_be_long_and_in_any_script_and_reports_state_them_with_slashes()
    {
        WineConsole.IsNeeded();
        using var folder = new TemporaryFolder();
        var name = Path.Combine([.. Enumerable.Repeat("Gegenstück 配合件 ödön", 15)]);
        var shop = Directory.CreateDirectory(folder[name]).FullName;
        Assert.True(shop.Length > 260, "Windows' limit of old is 260 characters.");
        foreach (var file in Directory.EnumerateFiles(Repository.PathTo("samples", "complex-mating")))
        {
            File.Copy(file, Path.Combine(shop, Path.GetFileName(file)));
        }

        var start = wine.Start("match", $@"{name.Replace('/', '\\')}\job.json", "--out", $@"{name.Replace('/', '\\')}\out");
        start.WorkingDirectory = folder.Path;
        var run = await ConsoleRun.Of(start);
        Assert.True(run.Exit == 0, run.Error);
        var here = await ConsoleRun.Of(folder.Path, "match", $"{name}/job.json", "--out", $"{name}/here");
        Assert.Equal(0, here.Exit);
        Assert.Equal(Text(shop, "here", "counterpart.nc"), Text(shop, "out", "counterpart.nc"));
        Assert.Equal(
            Timeless(Text(shop, "here", "report.json").Replace("/here/", "/out/", StringComparison.Ordinal)),
            Timeless(Text(shop, "out", "report.json")));
    }

    [Theory]
    [InlineData("de_DE", "de-DE", Explicit = true)]
    [InlineData("zh_TW", "zh-TW")]
    public async Task A_computer_of_another_language_writes_the_same(string locale, string culture)
    {
        WineConsole.IsNeeded();
        await wine.MakeLocale(locale);
        var known = wine.In(locale, wine.Windows("reg", "query", @"HKCU\Control Panel\International", "/v", "LocaleName"));
        Assert.Contains(culture, (await ConsoleRun.Of(known)).Output, StringComparison.Ordinal);
        await AreAlike($"match {Complex}/job.json --out OUT", locale);
    }

    [Fact]
    public async Task A_file_that_another_program_keeps_open_is_not_replaced_and_nothing_else_is_either()
    {
        WineConsole.IsNeeded();
        using var folder = new TemporaryFolder();
        var arguments = Arguments($"match {Complex}/job.json --out OUT --json", folder.Path);
        Assert.Equal(0, (await ConsoleRun.Of(wine.Start(arguments))).Exit);
        var before = Directory.EnumerateFiles(folder.Path).ToDictionary(f => f, File.ReadAllBytes);

        // The report, which gets its name last, is open for appending until the input ends.
        var start = wine.Windows("cmd", "/c", "more >> report.json");
        start.WorkingDirectory = folder.Path;
        start.RedirectStandardInput = start.RedirectStandardOutput = start.RedirectStandardError = true;
        using var keeper = Process.Start(start)!;
        var run = await ConsoleRun.Of(wine.Start(arguments));
        keeper.StandardInput.Close();
        await keeper.WaitForExitAsync(TestContext.Current.CancellationToken);
        Assert.Equal("file-unwritable", run.SingleError.GetProperty("code").GetString());
        Assert.Equal(3, run.Exit);
        Assert.Equal(before.Keys.Order(StringComparer.Ordinal), Directory.EnumerateFiles(folder.Path).Order(StringComparer.Ordinal));
        Assert.All(before, f => Assert.Equal(f.Value, File.ReadAllBytes(f.Key)));

        Assert.Equal(0, (await ConsoleRun.Of(wine.Start(arguments))).Exit);
    }

    [Fact(Explicit = true)]
    public async Task A_cell_that_dies_again_and_again_sends_each_program_once()
    {
        WineConsole.IsNeeded();
        using var cell = new FireCell(slots: 2) { Launch = wine.Start, EndsInOrder = false };
        await FireKills.Run(cell, kills: 3, seed: 11);
    }

    [Fact]
    public async Task A_store_has_one_cell()
    {
        WineConsole.IsNeeded();
        using var cell = new FireCell(slots: 1) { Launch = wine.Start, EndsInOrder = false };
        cell.Start();
        await cell.HasBegun();
        var second = await ConsoleRun.Of(wine.Start("cell", "run", cell.Configuration, "--json"));
        Assert.Equal(3, second.Exit);
        Assert.Equal("cell-runs-already", second.SingleError.GetProperty("code").GetString());
        var status = await ConsoleRun.Of(wine.Start("cell", "status", cell.Configuration, "--json"));
        Assert.True(status.Json.GetProperty("running").GetBoolean());
    }

    private static string[] Arguments(string command, string output) =>
        [
            .. command.Split(' ')
                .Select(a => a.StartsWith("samples/", StringComparison.Ordinal) ? Repository.PathTo(a) : a)
                .Select(a => a.Replace("OUT", output, StringComparison.Ordinal))];

    private static string Text(params string[] path) => File.ReadAllText(Path.Combine(path));

    // How long it took is all that a run measures of itself.
    private static string Timeless(string text) => Duration().Replace(text, "${what}?");

    private async Task AreAlike(string command, string? locale = null)
    {
        WineConsole.IsNeeded();
        using var folder = new TemporaryFolder();
        var arguments = Arguments(command, "out");
        async Task<(int Exit, string Said, Dictionary<string, string> Files)> Made(string name, ProcessStartInfo start)
        {
            start.WorkingDirectory = Directory.CreateDirectory(folder[name]).FullName;
            var run = await ConsoleRun.Of(start);
            var output = Path.Combine(start.WorkingDirectory, "out");
            var files = Directory.Exists(output)
                ? Directory.EnumerateFiles(output).ToDictionary(f => Path.GetFileName(f), f => Timeless(File.ReadAllText(f)))
                : [];
            return (run.Exit, Timeless(run.Output + run.Error), files);
        }

        var start = wine.Start(arguments);
        var working = Made("there", locale is null ? start : wine.In(locale, start));
        var (here, there) = (await Made("here", new(ConsoleRun.Executable, arguments)), await working);
        Assert.Equal(0, here.Exit);
        Assert.Equal((here.Exit, here.Said), (there.Exit, there.Said));
        Assert.Equal(here.Files.Keys.Order(StringComparer.Ordinal), there.Files.Keys.Order(StringComparer.Ordinal));
        Assert.Equal(command.Contains("OUT", StringComparison.Ordinal), here.Files.Count > 0);
        Assert.All(here.Files, f => Assert.True(f.Value == there.Files[f.Key], $"{f.Key} differs."));
    }

    [GeneratedRegex(
        "(?<what>\"calculatingS\": |this calculation took |Calculating: |Calculated in</dt>\\s*<dd>)[0-9.]+",
        RegexOptions.ExplicitCapture,
        Timeout.Infinite)]
    private static partial Regex Duration();
}
