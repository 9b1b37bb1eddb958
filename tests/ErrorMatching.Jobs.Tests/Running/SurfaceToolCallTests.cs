using System.Text;
using System.Text.Json;
using ErrorMatching.Nc;
using ErrorMatching.Testing;

namespace ErrorMatching.Jobs.Tests;

/// <summary>The tool that a finishing program is for: what the job says of it, and what happens where it says nothing.</summary>
public sealed class SurfaceToolCallTests
{
    private static readonly GivenFile Measured = new(Repository.PathTo("samples", "surface-one", "measured.csv"));

    // What no operator can pass by Cycle Start: a macro alarm, a block that the control refuses, an abort, a cycle alarm.
    [Theory]
    [InlineData("fanuc", "#3000=1(NO TOOL CALL)")]
    [InlineData("delta-nc300", "#3000=1(NO TOOL CALL)|T-1 M6")]
    [InlineData("generic", "#3000=1(NO TOOL CALL)|T-1 M6")]
    [InlineData("linuxcnc", "(ABORT,no tool call in this program)|T-1 M6")]
    [InlineData("siemens-840d", "SETAL(65000,\"no tool call in this program\")")]
    public void Without_a_tool_the_program_begins_with_a_stop_and_an_alarm_and_everything_says_so_first(string dialect, string alarm)
    {
        var finished = Finished(dialect, null);
        var text = Encoding.ASCII.GetString(finished.Program.Span);
        var lines = text.Split('\n');
        var stop = Array.IndexOf(lines, "M0");
        Assert.InRange(stop, 1, 12);
        var locks = alarm.Split('|');
        Assert.Equal(locks, lines.Skip(stop + 1).Take(locks.Length));
        Assert.All(lines.Take(stop), l => Assert.Matches(@"^(%|O1000.*|\(.*\)|;.*|MSG\(.*\))$", l));

        // Whoever looks at it sees the whole path.
        var read = NcInterpreter.Run(NcProgram.Read(finished.Program, NcDialects.Named(dialect).Syntax), NcDialects.Named(dialect));
        Assert.Null(read.Refusal);

        // The lock is what the control refuses.
        Assert.All(read.Problems, p => Assert.Equal(NcRefusalCodes.RefusedByControl, p.Code));
        Assert.True(read.Motions.Length > 1000, $"{read.Motions.Length} motions");

        using var json = JsonDocument.Parse(finished.ReportJson());
        Assert.False(json.RootElement.GetProperty("program").GetProperty("toolCall").GetBoolean());
        Assert.Contains("toolpath.tool", json.RootElement.GetProperty("warnings")[0].GetString(), StringComparison.Ordinal);
        var page = Encoding.UTF8.GetString(finished.ReportHtml());
        Assert.InRange(
            page.IndexOf("has no tool call", StringComparison.Ordinal), 1, page.IndexOf("cuts a surface", StringComparison.Ordinal));
    }

    // Height comes before the way across: with the length in, the tool is nowhere lower than over the piece when it goes there.
    [Theory]
    [InlineData("fanuc", "\"number\": 3, \"lengthOffset\": 13", "T3 M6|S10000 M3|G0 G43 Z* H13")]
    [InlineData("delta-nc300", "\"number\": 3, \"lengthOffset\": 13", "T3 M6|S10000 M3|G0 G43 Z* H13")]
    [InlineData("generic", "\"number\": 3, \"lengthOffset\": 13", "T3 M6|S10000 M3|G0 G43 Z* H13")]
    [InlineData("linuxcnc", "\"number\": 3, \"lengthOffset\": 13", "T3 M6|G43 H13|S10000 M3|G0 Z*")]
    [InlineData("siemens-840d", "\"number\": 3, \"lengthOffset\": 1", "T3|M6|D1|S10000 M3|G0 Z*")]
    [InlineData("siemens-840d", "\"name\": \"BALL D6/R3\", \"lengthOffset\": 2", "T=\"BALL D6/R3\"|M6|D2|S10000 M3|G0 Z*")]
    public void With_a_tool_the_program_calls_it_and_takes_its_length_into_account_before_it_moves(
        string dialect, string tool, string expected)
    {
        var finished = Finished(dialect, tool);
        var lines = Encoding.ASCII.GetString(finished.Program.Span).Split('\n').ToList();
        var words = expected.Split('|');
        var at = lines.IndexOf(words[0]);
        Assert.InRange(at, 4, 12);
        Assert.Equal("G54", lines[at - 1]);
        Assert.All(
            words.Zip(lines.Skip(at)),
            p => Assert.Matches(
                "^" + System.Text.RegularExpressions.Regex.Escape(p.First).Replace("\\*", "[0-9.]+", StringComparison.Ordinal) + "$",
                p.Second));
        Assert.StartsWith("X", lines[at + words.Length], StringComparison.Ordinal);
        Assert.DoesNotContain(
            lines, l => l == "M0" || l.Contains("#3000", StringComparison.Ordinal) || l.Contains("SETAL", StringComparison.Ordinal));

        var read = NcInterpreter.Run(NcProgram.Read(finished.Program, NcDialects.Named(dialect).Syntax), NcDialects.Named(dialect));
        Assert.Empty(read.Problems);
        using var json = JsonDocument.Parse(finished.ReportJson());
        Assert.True(json.RootElement.GetProperty("program").GetProperty("toolCall").GetBoolean());
        Assert.Empty(json.RootElement.GetProperty("warnings").EnumerateArray());
    }

    private static FinishedSurface Finished(string dialect, string? tool)
    {
        using var folder = new TemporaryFolder();
        File.Copy(Repository.PathTo("samples", "surface-one", "surface.igs"), folder["surface.igs"]);
        var job = folder.File("job.json", $$"""
            { "kind": "freeform", "name": "Surface one", "surface": "surface.igs", "tool": { "kind": "ball", "diameterMm": 6 }, "spindleRpm": 10000, "feedMmPerMin": 1200,
              "measuring": { "curves": 7, "pointsPerCurve": 10, "stylusDiameterMm": 6, "dialect": "siemens-840d" },
              "toolpath": { "scallopMm": 0.05, "chordMm": 0.01, "dialect": "{{dialect}}"{{(tool is null ? "" : $", \"tool\": {{ {tool} }}")}} } }
            """);
        var outcome = SurfaceRun.Compensate(new(job), new() { Measured = [Measured] }, TestContext.Current.CancellationToken);
        Assert.Empty(outcome.Refusals);
        return outcome.Result!;
    }
}
