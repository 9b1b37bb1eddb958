using ErrorMatching.Refusals;

namespace ErrorMatching.Nc.Tests;

/// <summary>What a shop's dialect of a language can declare, and that it is followed.</summary>
public sealed class LanguageDialectTests
{
    private const string Klartext = "heidenhain-klartext";

    // Those that say themselves that they change no place, and that of an arc that the block does not have.
    private static readonly string[] Still = ["harmless", "smoothing", "cycle-call", "arc-sense"];

    [Fact]
    public void Meanings_are_followed_or_cannot_be_declared()
    {
        var refused = new List<string>();
        foreach (var name in KebabNames.Of(typeof(NcMeaning)).Keys)
        {
            NcDialect dialect;
            try
            {
                dialect = Own($"\"codes\": [ {Entry("codes", "SPECIAL", "means", name)} ]");
            }
            catch (InputException e)
            {
                Assert.Equal(("bad-role", "$.codes[0].means"), (e.Refusals[0].Code, e.Refusals[0].Place.Path));
                refused.Add(name);
                continue;
            }

            var without = Own($"\"codes\": [ {Entry("codes", "SPECIAL", "means", "harmless")} ]");
            string[] programs =
            [
                "1 L X+1 Y+2 Z+3 R0 FMAX\n2 {0} X+5 Y+6\n3 L X+7 Y+8\n4 CC X+0 Y+0\n5 C X+8 Y+7 DR+\n",
                "1 L X+1 Y+2 Z+3 R0 FMAX\n2 L X+5 Y+6 {0}\n3 L X+7 Y+8\n",
                "1 L X+1 Y+2 Z+3 RL F100\n2 {0} R1\n3 L X+7 Y+8\n",
                "1 L X+1 Y+2 Z+3 RL F100\n2 PLANE SPATIAL SPA+1\n3 {0}\n4 L X+7 Y+8\n",
                "0 BEGIN PGM A INCH\n1 {0}\n2 L X+1 Y+2 Z+3 RR F100\n3 CR R+2 X+2 Y+3 DR+\n",
                "0 TOOL CALL 5 Y S1000\n1 {0}\n2 L X+1 Y+2 Z+3 RR F100\n3 CR R+2 X+2 Y+3 DR+\n",
                "1 L X+1 Y+2 Z+3 R0 FMAX\n2 L X+9 RL\n3 L X+19 {0}\n4 L Y-20\n",
            ];
            Assert.True(Still.Contains(name) || programs.Any(p => Trace(p, dialect) != Trace(p, without)), name);
        }

        Assert.Equal(
            [
                "arc-sense", "compensation-left", "compensation-off", "compensation-right", "compensation-sharp-corner",
                "compensation-unfollowed", "computed-contour", "cycle-call", "harmless", "inch", "machine-coordinates",
                "measuring-cycle", "metric", "opaque-call", "opaque-transform", "opaque-transform-off",
                "plane-xy", "plane-yz", "plane-zx", "rapid-in-block", "smoothing", "tool-axis-retract", "unknown", "unknown-origin",
            ],
            KebabNames.Of(typeof(NcMeaning)).Keys.Except(refused).Order(StringComparer.Ordinal));
    }

    [Fact]
    public void Codes_and_functions_of_the_control_are_no_subjects()
    {
        Assert.Equal("bad-role", Refused($"\"codes\": [ {Entry("codes", "G1", "means", "line")} ]"));
        Assert.Equal("bad-subject", Refused($"\"functions\": [ {Entry("functions", "M91", "role", "harmless")} ]"));
        Assert.Equal("bad-role", Refused($"\"letters\": [ {Entry("letters", "T", "role", "axis")} ]"));
        var ofLetters = $", \"codes\": [ {Entry("codes", "L", "means", "line")} ]";
        Assert.Equal("bad-subject", Assert.Throws<InputException>(() => OwnDialect.Of(ofLetters)).Refusals[0].Code);
    }

    [Fact]
    public void A_function_of_the_machine_can_be_declared()
    {
        const string Program = "1 L X+1 Y+2 Z+3 R0 FMAX\n2 M55\n3 L IX+1\n";
        var dialect = Own($"\"functions\": [ {Entry("functions", "M55", "role", "unsure")} ]");
        Assert.Equal("R1,2,3 L?,?,?", Moves.Of(Bench.Read(Program, dialect)));
        Assert.Equal("R1,2,3 L2,2,3", Moves.Of(Bench.Read(Program, NcDialects.HeidenhainKlartext)));
    }

    private static string Entry(string key, string subject, string role, string value) =>
        $$"""{ "{{key}}": "{{subject}}", "{{role}}": "{{value}}", "statement": "Ours.", "source": "our tests" }""";

    private static NcDialect Own(string more) => OwnDialect.Of(", " + more, Klartext);

    private static string Refused(string more) => Assert.Throws<InputException>(() => Own(more)).Refusals[0].Code;

    private static string Trace(string text, NcDialect dialect)
    {
        var path = Bench.Read(text.Replace("{0}", "SPECIAL", StringComparison.Ordinal), dialect);
        var motions = path.Motions
            .Select(m => $"{m.Kind} {m.Plane} {m.Flags} {m.Start} {m.End} {m.Center} {m.Turns} {m.UnknownStart} {m.UnknownEnd} {m.Frame}");
        var center = CompensatedPath.Of(path, ToolRadii.Of(2));
        return string.Join('|', motions) + path.Refusal + string.Join('|', center.Motions.Select(m => m.End)) + center.Refusal?.Message
            + string.Join('|', path.Problems.Select(p => p.Code)) + string.Join('|', path.Frames);
    }
}
