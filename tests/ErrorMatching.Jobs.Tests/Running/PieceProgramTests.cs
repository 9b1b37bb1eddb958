using System.Globalization;
using System.Text;
using System.Text.Json;
using ErrorMatching.Freeform;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;
using ErrorMatching.Testing;

namespace ErrorMatching.Jobs.Tests;

/// <summary>A piece that a compensated program cut is not compensated once more from the nominal surface:
/// the correction that it has would be given up.</summary>
public sealed class PieceProgramTests : IDisposable
{
    private const string Code = "piece-compensated";
    private static readonly string After = Repository.PathTo("samples", "surface-one", "after.csv");
    private static readonly string Measured = Repository.PathTo("samples", "surface-one", "measured.csv");
    private static readonly Lazy<byte[]> CompensatedProgram = new(() =>
    {
        using var tests = new PieceProgramTests();
        var finished = SurfaceRun.Compensate(
            new(tests.Job("", "semi-finishing")), new() { Measured = [new(Measured)] }, CancellationToken.None).Result!;
        return finished.Program.ToArray();
    });

    private readonly TemporaryFolder _folder = new();

    public PieceProgramTests() => File.Copy(Repository.PathTo("samples", "surface-one", "surface.igs"), _folder["surface.igs"]);

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void The_program_that_is_named_tells_by_its_marker(bool inJob)
    {
        var compensated = Compensated();
        var outcome = Run(inJob ? ", \"cutBy\": \"compensated.nc\"" : "", After, inJob ? null : compensated);
        var refusal = Assert.Single(outcome.Refusals);
        Assert.Equal((Code, compensated, 1), (refusal.Code, refusal.Place.File, refusal.Place.Line));
        Assert.Contains("errormatch surface toolpath", refusal.Message, StringComparison.Ordinal);
        Assert.Contains("by --previous", refusal.Message, StringComparison.Ordinal);

        // A damaged marker is one.
        File.WriteAllText(_folder["compensated.nc"], File.ReadAllText(compensated).Replace("BASE=", "BASE", StringComparison.Ordinal));
        Assert.Equal(
            Code, Assert.Single(Run(inJob ? ", \"cutBy\": \"compensated.nc\"" : "", After, inJob ? null : compensated).Refusals).Code);
    }

    [Fact]
    public void A_nominal_program_that_is_named_is_said_to_have_cut_it()
    {
        var nominal = _folder.File("nominal.nc", "G0 Z30\nM30\n");
        using var named = JsonDocument.Parse(Run("", After, nominal).Result!.ReportJson());
        Assert.Equal(("named", nominal), Known(named));
        var nobody = Run("", After, null).Result!;
        using var assumed = JsonDocument.Parse(nobody.ReportJson());
        Assert.Equal(("assumed", null), Known(assumed));
        Assert.Contains(
            "A nominal program is taken to have cut it", Encoding.UTF8.GetString(nobody.ReportHtml()), StringComparison.Ordinal);

        static (string?, string?) Known(JsonDocument json)
        {
            var cutBy = json.RootElement.GetProperty("cutBy");
            return (cutBy.GetProperty("known").GetString(), cutBy.GetProperty("file").GetString());
        }
    }

    // The finishing program of an earlier run, where this one will write.
    [Fact]
    public void The_program_that_lies_where_the_new_one_goes_tells_as_well()
    {
        Directory.CreateDirectory(_folder["out"]);
        File.Copy(Compensated(), _folder["out/finishing.nc"]);
        var refusal = Assert.Single(Run("", After, null, "out").Refusals);
        Assert.Equal((Code, _folder["out/finishing.nc"], 1), (refusal.Code, refusal.Place.File, refusal.Place.Line));
        Assert.Contains("--cut-by", refusal.Message, StringComparison.Ordinal);

        // Where somebody says that another one did, a piece that still has its stock, or the same measurement again, it is none.
        Assert.Empty(Run("", After, _folder.File("nominal.nc", "G0 Z30\nM30\n"), "out").Refusals);
        Assert.Empty(Run("", Measured, null, "out", "semi-finishing").Refusals);
        var again = SurfaceRun.Compensate(
            new(Job("", "finishing")), new() { Measured = [new(After)], Folder = _folder["again"] }, Cancellation).Result!;
        Directory.CreateDirectory(_folder["again"]);
        File.WriteAllBytes(_folder["again/finishing.nc"], again.Program.ToArray());
        Assert.Empty(Run("", After, null, "again").Refusals);

        // Nor is a program of another surface.
        File.WriteAllText(
            _folder["out/finishing.nc"], "; " + new Marker(new('a', 64), new('b', 64)).TextIn(NcSyntax.Iso)[1..^1] + "\nG0 Z30\nM30\n");
        Assert.Empty(Run("", After, null, "out").Refusals);
    }

    [Fact]
    public void A_program_that_was_displaced_where_the_new_one_goes_tells_as_well()
    {
        var cam = new GivenFile(Repository.PathTo("samples", "surface-one", "cam.nc"));
        var displaced = SurfaceRun.Displace(
            new(Job("", "semi-finishing")), new() { Measured = [new(Measured)] }, cam, Cancellation).Result!;
        Directory.CreateDirectory(_folder["out"]);
        File.WriteAllBytes(_folder["out/cam.nc"], displaced.Program.ToArray());
        var refused = SurfaceRun.Displace(
            new(Job("", "finishing")), new() { Measured = [new(After)], Folder = _folder["out"] }, cam, Cancellation);
        Assert.Equal((Code, _folder["out/cam.nc"]), (Assert.Single(refused.Refusals).Code, refused.Refusals[0].Place.File));
        Assert.NotNull(
            SurfaceRun.Displace(
                new(Job("", "finishing")), new() { Measured = [new(After)], Folder = _folder["other"] }, cam, Cancellation).Result);
    }

    // Probed in one run of the control, right behind the program that cut.
    [Theory]
    [InlineData("siemens-840d")]
    [InlineData("fanuc")]
    [InlineData("linuxcnc")]
    public void The_log_of_a_probing_program_behind_a_compensated_one_tells_as_well(string dialect)
    {
        var files = new FreeformFiles(Job("", "finishing", dialect));
        var plan = files.Plan(files.Surface());
        var probing = ProbingProgram.Of(plan, "x", files.MeasuringDialect(), files.Template(files.MeasuringDialect()));
        var compensated = SurfaceRun.Compensate(
            new(Job("", "semi-finishing", dialect)), new() { Measured = [new(Measured)] }, Cancellation).Result!.Program;
        var merged = Encoding.UTF8.GetString(probing.MergeAfter(compensated, "finishing.nc").Span);
        var measurement = Marker.Find(NcProgram.Read(
            compensated, NcDialects.Named(dialect).Syntax))[0].Marker!.MeasurementSha256.ToUpperInvariant();
        Assert.Matches($"CUTBY.{measurement}", merged);

        // What the control writes: the head, that line, and the points that the table has.
        var log = new StringBuilder($"ERRORMATCH PROBE PLAN {ProbingProgram.PlanId(plan)} MM\nCUTBY {measurement}\n");
        foreach (var point in files.Measured("measured", new(After), plan).Points)
        {
            log.Append(
                CultureInfo.InvariantCulture,
                $"P{point.Planned.Number} S X{point.Contact.X:F6} Y{point.Contact.Y:F6} Z{point.Contact.Z:F6}\n");
        }

        var probed = _folder.File("probe.log", log.Append("END\n").ToString());
        var refusal = Assert.Single(SurfaceRun.Compensate(files, new() { Measured = [new(probed)] }, Cancellation).Refusals);
        Assert.Equal((Code, probed), (refusal.Code, refusal.Place.File));

        // Behind a nominal one the log has no such line.
        var nominal = Encoding.ASCII.GetString(compensated.Span)
            .Split('\n')
            .Where(l => !l.Contains("MEASUREMENT=", StringComparison.Ordinal));
        Assert.DoesNotContain(
            "CUTBY",
            Encoding.UTF8.GetString(probing.MergeAfter(Encoding.ASCII.GetBytes(string.Join('\n', nominal)), "finishing.nc").Span),
            StringComparison.Ordinal);
    }

    private static CancellationToken Cancellation => TestContext.Current.CancellationToken;

    private string Compensated()
    {
        File.WriteAllBytes(_folder["compensated.nc"], CompensatedProgram.Value);
        return _folder["compensated.nc"];
    }

    private Outcome<FinishedSurface> Run(
        string measuring, string measured, string? cutBy, string? folder = null, string after = "finishing") =>
        SurfaceRun.Compensate(
        new(Job(measuring, after)),
        new() { Measured = [new(measured)], CutBy = GivenFile.At(cutBy), Folder = folder is null ? null : _folder[folder] },
        Cancellation);

    private string Job(string measuring, string after, string dialect = "siemens-840d") => _folder.File($"job-{after}.json", $$"""
        { "kind": "freeform", "name": "Surface one", "surface": "surface.igs", "tool": { "kind": "ball", "diameterMm": 6 }, "spindleRpm": 10000, "feedMmPerMin": 1200,
          "measuring": { "curves": 7, "pointsPerCurve": 10, "stylusDiameterMm": 6, "dialect": "{{dialect}}", "measuredAfter": "{{after}}"{{measuring}} },
          "toolpath": { "scallopMm": 0.05, "chordMm": 0.01, "dialect": "{{dialect}}", "tool": { "number": 3, "lengthOffset": 1 } } }
        """);
}
