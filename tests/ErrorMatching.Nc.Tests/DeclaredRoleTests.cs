using System.Text;
using ErrorMatching.Refusals;
using ErrorMatching.Testing;

namespace ErrorMatching.Nc.Tests;

/// <summary>
/// Whatever role a shop's dialect declares, the interpreter has a way for it: it is executed, refused, makes everything behind it
/// unknown, or cannot be declared. None is passed over.
/// </summary>
public sealed class DeclaredRoleTests
{
    // The meanings that say themselves that they change no place, and those that need more than a word to change one.
    private static readonly NcMeaning[] Still =
    [
        NcMeaning.Harmless, NcMeaning.Smoothing, NcMeaning.Dwell, NcMeaning.InverseTimeFeed, NcMeaning.FeedPerMinute,
        NcMeaning.FeedPerRevolution, NcMeaning.RetractToInitial, NcMeaning.RetractToR,
        NcMeaning.CompensationRoundCorners, NcMeaning.CompensationSharpCorners, NcMeaning.CompensationNormalEntry,
        NcMeaning.CompensationOtherEntry, NcMeaning.CompensationSharpCorner, NcMeaning.CompensationUnfollowed,
        NcMeaning.LengthOffset, NcMeaning.CycleOff, NcMeaning.ModalCycle, NcMeaning.StoreReference, NcMeaning.CycleCall, NcMeaning.Unknown,
    ];

    private static readonly string[] OfLanguages =
    [
        "rapid-in-block", "arc-by-radius", "arc-about-pole", "polar-arc", "polar-line", "polar-tangent-arc", "arc-sense", "set-pole",
        "corner-rounding", "corner-chamfer", "datum-shift", "unknown-origin", "tool-axis-retract", "approach", "departure",
        "computed-contour", "approach-tangent", "approach-normal", "departure-tangent", "departure-normal", "tool-call",
        "tool-definition",
    ];

    // Not every family has a code for these states: G556 and the codes behind it.
    private static readonly string Helpers = string.Concat(
        new[] { "absolute-centers", "inch", "rotation", "scaling", "mirroring", "polar", "opaque-transform", "tool-length", "set-position",
            "compensation-left" }
            .Select((m, i) => ", " + Code(FormattableString.Invariant($"G{556 + i}"), m)));

    // A language has no codes; its words are in LanguageDialectTests.
    public static TheoryData<string> Bases => [.. Letters];

    private static IEnumerable<string> Letters => NcDialects.All.Where(d => LanguageSpelling.Of(d.Syntax) is null).Select(d => d.Name);

    [Theory]
    [MemberData(nameof(Bases))]
    public void A_function_that_steers_is_executed_or_refused(string like)
    {
        foreach (var (name, number) in KebabNames.Of(typeof(FunctionRole)))
        {
            var role = (FunctionRole)number;
            var entry = $$"""{ "functions": "M555", "role": "{{name}}", "statement": "Ours.", "source": "our tests" }""";
            var dialect = OwnDialect.Of($", \"functions\": [ {entry} ]", like);
            foreach (var block in new[] { "M555", "M555 P7", "N5 M555 P7 (WORDS)", "G0 X3 M555 P7", "M[500+55] P7", "M=555" })
            {
                // What is called: a program of this number, and a block of it. Both go to X9.
                var path = Bench.Read($"G90 G17 G40 G0 X0 Y0 Z0\n{block}\nX1\nM30\n{Called(dialect)}", dialect);
                if (path.Problems.Any(p => p.Code == NcRefusalCodes.RefusedByControl))
                {
                    // Where P belongs to certain codes only, the control stops at the block.
                    continue;
                }

                var moves = Moves.Of(path, 1);
                var passed = path.Refusal is null && (moves is "R1,0,0" or "R3,0,0 R1,0,0");
                Assert.True(passed ? IsStill(role) : !IsStill(role) || IsComputed(block),
                    $"{name}, {block}, like {like}: {moves}, {path.Refusal}");
            }
        }
    }

    [Theory]
    [MemberData(nameof(Bases))]
    public void A_meaning_that_calls_is_executed_or_refused_as_a_code_and_as_a_word(string like)
    {
        foreach (var meaning in new[] { "call", "modal-call", "modal-call-off", "opaque-call" })
        {
            foreach (var code in new[] { "G555", "SPECIAL" })
            {
                var dialect = OwnDialect.Of($", \"codes\": [ {Code(code, meaning)} ]", like);
                foreach (var block in new[] { code, code + " P7", "N5 " + code + " P7 A1", "X3 " + code })
                {
                    var path = Bench.Read($"G90 G17 G40 G0 X0 Y0 Z0\n{block}\nX1\nM30\n{Called(dialect)}", dialect);
                    var moves = Moves.Of(path, 1);
                    var ends = meaning == "modal-call-off" && dialect.Syntax == NcSyntax.Iso && code[0] == 'G';
                    Assert.True(path.Refusal is not null || moves.Contains("R9", StringComparison.Ordinal) || ends,
                        $"{meaning}, {block}, like {like}: {moves}");
                }
            }
        }
    }

    [Theory]
    [MemberData(nameof(Bases))]
    public void A_meaning_is_followed_as_a_code_and_as_a_word_or_cannot_be_declared(string like)
    {
        var refused = new List<string>();
        foreach (var (name, number) in KebabNames.Of(typeof(NcMeaning)))
        {
            foreach (var code in new[] { "G555", "SPECIAL" })
            {
                var codes = Code(code, name) + Helpers;
                var text = $$"""{ "name": "our-mill", "like": "{{like}}", "description": "Ours.", "codes": [ {{codes}} ] }""";
                NcDialect dialect;
                try
                {
                    dialect = OwnDialect.Parse(text);
                }
                catch (InputException e)
                {
                    Assert.Equal(("bad-role", "$.codes[0].means"), (e.Refusals[0].Code, e.Refusals[0].Place.Path));
                    refused.Add($"{code} {name}");
                    continue;
                }

                // Each dialect gets a third of the meanings and each meaning a third of the dialects.
                if ((Letters.Count(d => string.CompareOrdinal(d, like) < 0) + (int)number) % Depth.Of(3, 1) != 0)
                {
                    continue;
                }

                // From three states, one of which the code leaves: else it has done nothing.
                Assert.True(Still.Contains((NcMeaning)number) || IsFollowed(dialect, like, code), $"{name}, {code}, like {like}");
            }
        }

        // What only languages have.
        Assert.Equal(2 * OfLanguages.Length, refused.RemoveAll(r => OfLanguages.Contains(r.Split(' ')[1])));
        Assert.Equal(
            [
                "G555 cycle-call", "G555 measuring-cycle", "G555 modal-cycle", "SPECIAL reference-return", "SPECIAL store-reference",
                "SPECIAL work-offset",
            ],
            refused.Order(StringComparer.Ordinal));
    }

    [Fact]
    public void A_letter_has_no_role_that_is_another_letters()
    {
        // Each dialect gets a third of the roles and each role a third of the dialects, but for the one that differs: it gets all.
        foreach (var (dialect, like) in Letters.Index())
        {
            foreach (var (role, name) in KebabNames.Of(typeof(LetterRole)).Keys.Index())
            {
                if (like != "siemens-840d" && (dialect + role) % Depth.Of(3, 1) != 0)
                {
                    continue;
                }

                var refused = new StringBuilder();
                for (var letter = 'A'; letter <= 'Z'; letter++)
                {
                    var entry = $$"""{ "letters": "{{letter}}", "role": "{{name}}", "statement": "Ours.", "source": "our tests" }""";
                    var text = $$"""{ "name": "our-mill", "like": "{{like}}", "description": "Ours.", "letters": [ {{entry}} ] }""";
                    try
                    {
                        OwnDialect.Parse(text);
                    }
                    catch (InputException e)
                    {
                        Assert.Equal(("bad-role", "$.letters[0].role"), (e.Refusals[0].Code, e.Refusals[0].Place.Path));
                        refused.Append(letter);
                    }
                }

                var fixedLetters = like == "siemens-840d" ? "FGIJKLMNORXYZ" : "FGIJKMNORXYZ";
                var allowed = name switch
                {
                    "unknown" => "ABCDEFGHIJKLMNOPQRSTUVWXYZ",
                    "axis" => "XYZ",
                    "center" => "IJK",
                    "radius" => "R",
                    "feed" => "F",
                    "g" => "G",
                    "m" => "M",
                    "number" => "N",
                    "program" => like == "siemens-840d" ? "LO" : "O",
                    "harmless" or "other-axis" => string.Concat("ABCDEFGHIJKLMNOPQRSTUVWXYZ".Except(fixedLetters)),
                    "variable" => string.Concat("ABCDEFGHIJKLMNOPQRSTUVWXYZ".Except(fixedLetters.Where(l => l != 'R'))),
                    "length" or "length-number" => "DHT",
                    _ => "",
                };
                Assert.Equal(string.Concat("ABCDEFGHIJKLMNOPQRSTUVWXYZ".Except(allowed)), refused.ToString());
            }
        }
    }

    // A program that goes on behind the block as if nothing had been there: roles that say so, and modes that are the same when they are
    // restored.
    private static bool IsStill(FunctionRole role) =>
        role is FunctionRole.Harmless or FunctionRole.SaveModes or FunctionRole.SaveModesOfCall or FunctionRole.DropModes;

    // A computed function is never taken to change nothing.
    private static bool IsComputed(string block) => block[1] is '[' or '=';

    private static bool IsFollowed(NcDialect dialect, string like, string code)
    {
        var states = new[]
        {
            "G90 G17 G40\nG1 X1 Y2 Z3 F100\n{0} X5 Y5 Z5 I1 J1 K1\nX7 Y8\n",
            "G91 G18 G41\nG1 X1 Y2 Z3 F100\n{0} X5 Y5 Z5 I1 J1 K1 R3 P2\nX7 Y8\n",
            "G90 G17 G40\nG2 X1 Y2 I1 J1\n{0}\nX7 Y8\n", "G90 G19 G42\nG0 X1 Y2\n{0}\nG1 X7 Y8 Z1\n",
            "G557\n{0}\nG1 X7 Y8 Z1\n", "G90 G17\nG0 X0 Y0\nG556\n{0}\nG2 X7 Y8 I1 J1\n",
            "{0}\nG2 X7 Y8 I1 J1\n", "G558 X0 Y0 R30\n{0}\nG1 X7 Y8\n", "G559 X0 Y0 P2\n{0}\nG1 X7 Y8\n",
            "G560 X0\n{0} X0\nG1 X7 Y8\n", "G561\n{0}\nG1 X7 Y8\n", "G562\n{0}\nG1 X7 Y8\n",
            "G0 Z0\nG563 Z5\n{0}\nG1 X7 Y8\n", "G0 X0\nG564 X5\n{0} X1\nG1 X7 Y8\n",
            "G565\nG1 X1 Y2\n{0}\nX7 Y8\n",
        };
        var without = OwnDialect.Of($", \"codes\": [ {Code(code, "harmless")}{Helpers} ]", like);
        return states.Any(s => Run(s, dialect, code).Refusal is not null || Trace(s, dialect, code) != Trace(s, without, code));
    }

    private static string Code(string code, string meaning) =>
        $$"""{ "codes": "{{code}}", "means": "{{meaning}}", "statement": "Ours.", "source": "our tests" }""";

    // What a call may find: a program of the number 7, and a block.
    private static string Called(NcDialect dialect) => dialect.Syntax == NcSyntax.Siemens ? "" : "O7\nN7 G0 X9\nM99\n";

    private static NcPath Run(string text, NcDialect dialect, string code) =>
        Bench.Read(string.Format(System.Globalization.CultureInfo.InvariantCulture, text, code), dialect);

    private static string Trace(string text, NcDialect dialect, string code)
    {
        var path = Run(text, dialect, code);
        var motions = path.Motions
            .Select(m => $"{m.Kind} {m.Plane} {m.Flags} {m.Start} {m.End} {m.Center} {m.Turns} {m.UnknownStart} {m.UnknownEnd} {m.Frame}");
        return string.Join('|', motions) + path.Refusal
            + string.Join('|', path.Problems.Select(p => p.Code)) + string.Join('|', path.Frames);
    }
}
