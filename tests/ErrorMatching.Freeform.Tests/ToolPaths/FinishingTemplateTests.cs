using System.Text;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform.Tests;

/// <summary>What a shop writes around the moves, and what it may not write.</summary>
public sealed class FinishingTemplateTests
{
    private const string Own = """
        @about ours
        @head
        ; {name} {feed}
        G17 G90 G94 G710 G40
        G54
        @if tool
        T{tool.number} D{tool.offset}
        M6
        @else
        M0
        SETAL(65000,"no tool")
        @endif
        S{rpm} M3 M8
        G0 Z{travel}
        @tail
        M9 M5
        M30
        """;

    [Theory]
    [InlineData("@head\nG0 Z{travle}\n", 2, "{travle}")]
    [InlineData("@head\nT{tool.number}\n", 2, "behind @if tool only")]
    [InlineData("@head\n@if tool\n@else\nT{tool.number}\n@endif\n", 4, "behind @if tool only")]
    [InlineData("@head\n@if merged\n", 2, "tool-by-name")]
    [InlineData("@head\n@each point\n", 2, "@about, @head, @tail, @if, @else or @endif")]
    [InlineData("@head\n@body\n", 2, "@head, @tail")]
    [InlineData("G0\n", 1, "@head, @tail before it")]
    [InlineData("@tail\nM30\n", 2, "no section @head")]
    [InlineData("@head\n@if tool\nM6\n", 2, "@endif behind it")]
    public void An_error_is_named_by_its_line(string text, int line, string reason)
    {
        var error = Assert.Throws<InputException>(() => FinishingTemplate.Parse(Encoding.UTF8.GetBytes(text), "own.txt"));
        Assert.Equal(("bad-template", "own.txt", line), (error.Code, error.File, error.Place.Line));
        Assert.Contains(reason, error.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_shop_s_own_template_stands_around_the_moves_of_the_dialect_s()
    {
        var template = FinishingTemplate.Parse(Encoding.UTF8.GetBytes(Own), "own.txt");
        var (own, ours) = (Written(template, new(7, null, 2)), Written(null, new(7, null, 2)));
        Assert.StartsWith(
            "; Surface one 1200\nG17 G90 G94 G710 G40\nG54\nT7 D2\nM6\nS10000 M3 M8\nG0 Z15.000\nX", own, StringComparison.Ordinal);
        Assert.EndsWith("M9 M5\nM30\n", own, StringComparison.Ordinal);
        Assert.Equal(Moves(ours), Moves(own));
        Assert.True(template.CallsTool(Job(new(7, null, 2))));
        Assert.False(template.CallsTool(Job(null)));
        Assert.Contains("\nM0\nSETAL(65000,\"no tool\")\nS10000", Written(template, null), StringComparison.Ordinal);

        // One that does not ask calls a tool of its own, whatever the job says; then the job must say nothing.
        var fix = FinishingTemplate.Parse(Encoding.UTF8.GetBytes("@head\nG90 G94 G710 G17 G54 T1 M6 D1\nG0 Z{travel}\n"), "fix.txt");
        Assert.True(fix.CallsTool(Job(null)));
        Assert.Contains("the job names a tool (toolpath.tool)", Refused(fix, new(7, null, 2)), StringComparison.Ordinal);

        string Moves(string text) =>
            text[
                text.IndexOf("\nX", StringComparison.Ordinal)..text.LastIndexOf(
                    "\nM", text.LastIndexOf("M30", StringComparison.Ordinal) - 2, StringComparison.Ordinal)];
    }

    // Behind what a shop writes the moves must be those of the path: rapid, absolute, in millimeters, from the height of travel.
    [Theory]
    [InlineData("G0 Z{travel}", "G0 Z5", "height of travel")]
    [InlineData("G0 Z{travel}", "G1 Z{travel} F{feed}", "rapid")]
    [InlineData("G0 Z{travel}", "", "height of travel")]
    [InlineData("G90", "G91", "absolute")]
    [InlineData("G710", "G700", "millimeters")]
    [InlineData("M6", "M30", "height of travel")]
    [InlineData("M6", "FOO(1)", "FOO")]
    [InlineData("tool.number", "tool.name", "by its number")]
    public void A_template_behind_which_the_moves_would_be_others_is_refused(string what, string other, string reason)
    {
        Assert.Contains(what, Own, StringComparison.Ordinal);
        var template = FinishingTemplate.Parse(Encoding.UTF8.GetBytes(Own.Replace(what, other, StringComparison.Ordinal)), "own.txt");
        Assert.Contains(reason, Refused(template, new(7, null, 2)), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("\"number\": 0, \"lengthOffset\": 1", "$.toolpath.tool.number")]
    [InlineData("\"number\": 2.5, \"lengthOffset\": 1", "$.toolpath.tool.number")]
    [InlineData("\"number\": 100000000, \"lengthOffset\": 1", "$.toolpath.tool.number")]
    [InlineData("\"number\": \"3\", \"lengthOffset\": 1", "$.toolpath.tool.number")]
    [InlineData("\"number\": 3, \"lengthOffset\": 0", "$.toolpath.tool.lengthOffset")]
    [InlineData("\"number\": 3, \"lengthOffset\": 1000", "$.toolpath.tool.lengthOffset")]
    [InlineData("\"number\": 3", "$.toolpath.tool")]
    [InlineData("\"lengthOffset\": 1", "$.toolpath.tool")]
    [InlineData("\"number\": 3, \"name\": \"BALL6\", \"lengthOffset\": 1", "$.toolpath.tool")]
    [InlineData("\"name\": \"\", \"lengthOffset\": 1", "$.toolpath.tool.name")]
    [InlineData("\"name\": \"BALL\\\"\\nG0 X0\", \"lengthOffset\": 1", "$.toolpath.tool.name")]
    [InlineData("\"name\": \"BALL6\\n\", \"lengthOffset\": 1", "$.toolpath.tool.name")]
    [InlineData("\"name\": \"BALL;6\", \"lengthOffset\": 1", "$.toolpath.tool.name")]
    [InlineData("\"name\": \"K\\u00dcGEL\", \"lengthOffset\": 1", "$.toolpath.tool.name")]
    [InlineData("\"name\": \"B123456789012345678901234567890123\", \"lengthOffset\": 1", "$.toolpath.tool.name")]
    public void A_tool_that_no_control_has_is_refused_with_its_place(string tool, string path)
    {
        var text = $$"""
            { "kind": "freeform", "name": "x", "surface": "s.igs", "tool": { "kind": "ball", "diameterMm": 6 }, "spindleRpm": 1, "feedMmPerMin": 1,
              "measuring": { "curves": 7, "pointsPerCurve": 10, "stylusDiameterMm": 6, "dialect": "siemens-840d" },
              "toolpath": { "dialect": "siemens-840d", "tool": { {{tool}} } } }
            """;
        var error = Assert.Throws<InputException>(() => FreeformJob.Parse(Encoding.UTF8.GetBytes(text), "job.json"));
        Assert.StartsWith(path, Assert.Single(error.Refusals).Place.Path, StringComparison.Ordinal);
    }

    [Fact]
    public void Every_built_in_template_is_one_of_a_dialect_and_says_what_it_is_for()
    {
        Assert.Equal(
            NcDialects.All.Where(d => d.HasCodes).Select(d => d.Name).Order(StringComparer.Ordinal),
            FinishingTemplate.Names.Order(StringComparer.Ordinal));
        Assert.Equal(
            "unknown-template", Assert.Throws<InputException>(() => FinishingTemplate.For(NcDialects.HeidenhainKlartext)).Code);
        Assert.All(FinishingTemplate.Names, n => Assert.NotEmpty(FinishingTemplate.Named(n).About));
        Assert.All(
            FinishingTemplate.Names,
            n => Assert.Equal(
                FinishingTemplate.Named(n).About, FinishingTemplate.Parse(Encoding.UTF8.GetBytes(FinishingTemplate.TextOf(n)), "x").About));
        Assert.Equal("unknown-template", Assert.Throws<InputException>(() => FinishingTemplate.Named("heidenhain")).Code);
        var large = Assert.Throws<InputException>(() => FinishingTemplate.Parse(new byte[ProgramTemplate.MaxBytes + 1], "own.txt"));
        Assert.Equal("bad-template", large.Code);
    }

    private static FreeformJob Job(ToolCall? tool) =>
        Plans.Job(Plans.Passes(), "siemens-840d") is var job
            ? job with { Toolpath = job.Toolpath with { Tool = tool } }
            : throw new InvalidOperationException();

    private static string Written(FinishingTemplate? template, ToolCall? tool)
    {
        var dialect = NcDialects.Siemens840D;
        var path = Plans.Path(Shapes.Plane(10, 1, 2), Plans.Passes(0.05, 0.01), dialect: dialect);
        return Encoding.UTF8.GetString(FinishingProgram.Write(path, Job(tool), dialect, template: template));
    }

    private static string Refused(FinishingTemplate template, ToolCall tool)
    {
        var error = Assert.Throws<InputException>(() => Written(template, tool));
        Assert.Equal(("bad-template", template.File), (error.Code, error.File));
        return error.Problem;
    }
}
