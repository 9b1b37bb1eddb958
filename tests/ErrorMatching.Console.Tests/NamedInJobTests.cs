using System.Text.Json;
using ErrorMatching.Testing;

namespace ErrorMatching.Console.Tests;

/// <summary>What a job names wrongly is said with the job's file, line, column and path.</summary>
public sealed class NamedInJobTests
{
    [Theory]
    [InlineData("surface probe", "measuring")]
    [InlineData("job check", "measuring")]
    [InlineData("surface toolpath", "toolpath")]
    [InlineData("job check", "toolpath")]
    public void A_dialect_that_there_is_not(string verb, string section)
    {
        using var folder = new TemporaryFolder();
        var job = Job(folder, text => With(text, section, "\"dialect\": \"siemens-840d\"", "\"dialect\": \"heidenhain\""));
        var error = Refused(folder, job, verb, "unknown-dialect", $"$.{section}.dialect", "\"heidenhain\"");
        Assert.Contains(
            "found the dialect \"heidenhain\"; expected \"heidenhain-klartext\", or one of generic, fanuc, ",
            error.Text("message"),
            StringComparison.Ordinal);
    }

    [Fact]
    public void Two_dialects_that_there_are_not_are_both_said()
    {
        using var folder = new TemporaryFolder();
        var job = Job(folder, text => text.Replace("siemens-840d", "heidenhain", StringComparison.Ordinal));
        var errors = Shell.Json(1, "errormatch/error/1", "job", "check", job).GetProperty("errors").EnumerateArray();
        Assert.Equal(["$.measuring.dialect", "$.toolpath.dialect"], errors.Select(e => e.Text("path")));
    }

    [Theory]
    [InlineData("surface probe")]
    [InlineData("job check")]
    public void A_dialect_without_a_probing_template(string verb)
    {
        using var folder = new TemporaryFolder();
        var job = Job(folder, text => With(text, "measuring", "\"siemens-840d\"", "\"delta-nc300\""));
        Refused(folder, job, verb, "unknown-template", "$.measuring.dialect", "\"delta-nc300\"");

        // With a template of the shop's choice it can be probed.
        job = Job(folder, text => With(text, "measuring", "\"siemens-840d\"", "\"delta-nc300\", \"template\": \"fanuc\""));
        Assert.Equal(0, Shell.Run("job", "check", job).Exit);
    }

    [Theory]
    [InlineData("surface plan")]
    [InlineData("surface probe")]
    [InlineData("surface toolpath")]
    public void A_surface_that_is_not_there(string verb)
    {
        using var folder = new TemporaryFolder();
        var job = Job(folder, text => text.Replace("surface.igs", "nope.igs", StringComparison.Ordinal));
        var error = Refused(folder, job, verb, "file-unreadable", "$.surface", "\"nope.igs\"");
        Assert.Contains($"{folder["nope.igs"]} cannot be opened", error.Text("message"), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("surface probe", "\"template\": \"nope.probing\", \"dialect\": \"siemens-840d\"", "template", "\"nope.probing\"")]
    [InlineData("job check", "\"template\": \"nope.probing\", \"dialect\": \"siemens-840d\"", "template", "\"nope.probing\"")]
    [InlineData("surface probe", "\"dialect\": \"nope.json\"", "dialect", "\"nope.json\"")]
    [InlineData("job check", "\"dialect\": \"nope.json\"", "dialect", "\"nope.json\"")]
    public void A_template_or_a_dialect_s_file_that_is_not_there(string verb, string members, string key, string value)
    {
        using var folder = new TemporaryFolder();
        var job = Job(folder, text => With(text, "measuring", "\"dialect\": \"siemens-840d\"", members));
        Refused(folder, job, verb, "file-unreadable", $"$.measuring.{key}", value);
    }

    [Fact]
    public void A_measured_counterpart_that_is_not_there_is_a_warning_with_its_place()
    {
        using var folder = new TemporaryFolder();
        File.Copy(Repository.PathTo("samples", "complex-mating", "counterpart.csv"), folder["counterpart.csv"]);
        var text = File.ReadAllText(Repository.PathTo("samples", "complex-mating", "job.json"));
        var (there, gone) = (
            folder.File("there.json", text),
            folder.File(
                "gone.json", text.Replace("\"measured\": \"counterpart.csv\"", "\"measured\": \"nope.csv\"", StringComparison.Ordinal)));
        Assert.Empty(Shell.Json(0, "errormatch/job-check/1", "job", "check", there).GetProperty("warnings").EnumerateArray());
        Assert.DoesNotContain("Warning", Shell.Run("job", "check", there).Output, StringComparison.Ordinal);

        // The job can be used: exit 0. Its line 20 begins with four blanks and "measured": .
        var warning = Assert.Single(Shell.Json(0, "errormatch/job-check/1", "job", "check", gone).GetProperty("warnings").EnumerateArray());
        Assert.Equal(
            ("measured-not-there", gone, 20, 17, "$.counterpart.measured"),
            (
                warning.Text("code"),
                warning.Text("file"),
                warning.GetProperty("line").GetInt32(),
                warning.GetProperty("column").GetInt32(),
                warning.Text("path")));
        Assert.StartsWith(
            $"{gone}, line 20, column 17, $.counterpart.measured: The measured counterpart \"nope.csv\" is not there; expected the file",
            warning.Text("message"),
            StringComparison.Ordinal);
        Assert.EndsWith($"\nWarning: {warning.Text("message")}\n", Shell.Run("job", "check", gone).Output, StringComparison.Ordinal);
    }

    private static JsonElement Refused(TemporaryFolder folder, string job, string verb, string code, string path, string value)
    {
        string[] arguments = verb == "job check" ? ["job", "check", job] : [.. verb.Split(' '), job, "--out", folder["out"]];
        var error = Shell.Error(1, arguments);
        Assert.Equal((code, job, path), (error.Text("code"), error.Text("file"), error.Text("path")));
        var line = File.ReadAllLines(job)[error.GetProperty("line").GetInt32() - 1];
        Assert.StartsWith(value, line[(error.GetProperty("column").GetInt32() - 1)..], StringComparison.Ordinal);
        Assert.StartsWith(
            $"{job}:{error.GetProperty("line").GetInt32()}:{error.GetProperty("column").GetInt32()}",
            Shell.Run(arguments).Error,
            StringComparison.Ordinal);
        return error;
    }

    private static string Job(TemporaryFolder folder, Func<string, string> change)
    {
        File.Copy(Repository.PathTo("samples", "surface-one", "surface.igs"), folder["surface.igs"], overwrite: true);
        return folder.File("job.json", change(File.ReadAllText(Repository.PathTo("samples", "surface-one", "job.json"))));
    }

    // In one section of the job.
    private static string With(string text, string section, string old, string changed)
    {
        var start = text.IndexOf($"\"{section}\"", StringComparison.Ordinal);
        var at = text.IndexOf(old, start, StringComparison.Ordinal);
        return text[..at] + changed + text[(at + old.Length)..];
    }
}
