using System.Globalization;
using System.Security.Cryptography;
using System.Text;
using ErrorMatching.Refusals;
using ErrorMatching.Testing;
using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Nc.Tests;

/// <summary>Dialects that a shop writes as files: what they change, and how their mistakes are named.</summary>
public sealed class OwnDialectTests
{
    private const string Increments = """, "settings": { "integersAreIncrements": { "value": true, "statement": "X100 is 0.1 mm.", "source": "parameter list of our machine" } }""";

    private static readonly Lazy<byte[]> Siemens = new(() => Encoding.UTF8.GetBytes(
        File.ReadAllText(Repository.PathTo("src", "ErrorMatching.Nc", "Dialects", "siemens-840d.json")).Replace(
            "\"name\": \"siemens-840d\"", "\"name\": \"our-mill\"", StringComparison.Ordinal)));

    [Fact]
    public void A_file_may_say_that_numbers_without_a_point_are_increments()
    {
        var dialect = OwnDialect.Of(Increments);
        Assert.True(dialect.IntegersAreIncrements);
        Assert.False(NcDialects.FanucMill.IntegersAreIncrements);
        var fact = Assert.Single(dialect.Facts, f => f.Subject == "integersAreIncrements");
        Assert.Equal(
            new(DialectTopic.Setting, "integersAreIncrements", "true", "X100 is 0.1 mm.", "parameter list of our machine", "our-mill"),
            fact);
    }

    [Fact]
    public void What_a_file_does_not_state_is_that_of_the_dialect_it_continues()
    {
        var (dialect, fanuc) = (OwnDialect.Of(""), NcDialects.FanucMill);
        Assert.Equal(("our-mill", "Ours."), (dialect.Name, dialect.Description));
        Assert.Equal(fanuc.Facts, dialect.Facts);
        Assert.All(
            Enumerable.Range(0, 10_000),
            t => Assert.Equal(
                (fanuc.MeaningOf(t), fanuc.FamilyOf(t), fanuc.ScalesFeed(t)),
                (dialect.MeaningOf(t), dialect.FamilyOf(t), dialect.ScalesFeed(t))));
        Assert.Equal(
            (fanuc.Syntax, fanuc.MetricDecimals, fanuc.InchDecimals, fanuc.ArcMismatchMm, fanuc.ArcMismatchOfRadius, fanuc.TurnsLetter),
            (
                dialect.Syntax,
                dialect.MetricDecimals,
                dialect.InchDecimals,
                dialect.ArcMismatchMm,
                dialect.ArcMismatchOfRadius,
                dialect.TurnsLetter));
    }

    [Fact]
    public void What_a_file_states_replaces_what_it_continues_code_by_code()
    {
        var dialect = OwnDialect.Of("""
            , "codes": [
                { "codes": "G54..G59 G300", "means": "harmless", "statement": "Ours.", "source": "our tests" },
                { "codes": "G56", "means": "unknown", "statement": "Ours has none.", "source": "our tests" },
                { "codes": "WASH", "means": "harmless", "statement": "Ours.", "source": "our tests" } ],
              "letters": [ { "letters": "E", "role": "harmless", "statement": "Ours.", "source": "our tests" } ],
              "functions": [ { "functions": "M200..M201", "role": "call", "statement": "Ours.", "source": "our tests" } ],
              "flow": [ { "words": "JUMP", "statement": "Ours.", "source": "our tests" } ],
              "machinePrograms": [ { "programs": "O7000..O7009 8000 WASHING", "statement": "Ours.", "source": "our tests" } ],
              "notes": [ { "topic": "block skip", "statement": "Ours.", "source": "our tests" } ]
            """);
        Assert.Equal(
            [NcMeaning.Harmless, NcMeaning.Unknown, NcMeaning.Harmless, NcMeaning.Harmless, NcMeaning.WorkOffset],
            new[] { 540, 560, 590, 3000, 541 }.Select(dialect.MeaningOf));
        Assert.Equal(NcMeaning.Harmless, dialect.MeaningOf("wash"u8));
        Assert.Equal((LetterRole.Harmless, LetterRole.Feed), (dialect.RoleOf((byte)'E'), dialect.RoleOf((byte)'F')));
        Assert.Equal([97, 98, 198, 200, 201], dialect.CallFunctions.Order());
        Assert.True(dialect.IsFlow("jump"u8) && dialect.IsFlow("GOTO"u8));
        Assert.Equal([true, true, false, true, true], new[] { 7000, 7009, 7010, 8000, 9810 }.Select(dialect.IsMachineProgram));
        Assert.True(dialect.IsMachineProgram("washing"u8));
        Assert.Equal("Ours.", Assert.Single(dialect.Facts, f => f.Subject == "block skip").Statement);
        Assert.DoesNotContain(dialect.Facts, f => f.Dialect != "our-mill" && f.Subject == "G54..G59");
        Assert.Equal("G54..G59 G300", dialect.Facts.First(f => f is { Dialect: "our-mill", Topic: DialectTopic.Code }).Subject);
    }

    [Fact]
    public void A_single_code_beats_a_range_wherever_it_stands()
    {
        var dialect = OwnDialect.Of("""
            , "codes": [ { "codes": "G202", "means": "call", "statement": "Ours.", "source": "our tests" }, { "codes": "G200..G209", "means": "harmless", "statement": "Ours.", "source": "our tests" } ]
            """);
        Assert.Equal([NcMeaning.Harmless, NcMeaning.Call, NcMeaning.Harmless], new[] { 2010, 2020, 2030 }.Select(dialect.MeaningOf));
    }

    [Fact]
    public void The_interpreter_follows_a_file()
    {
        var dialect = OwnDialect.Of(
            """, "codes": [ { "codes": "G187", "means": "harmless", "statement": "Accuracy.", "source": "our tests" } ]""");
        Assert.Equal("unknown-code", Assert.Single(Bench.Read("G187 P1\n", NcDialects.FanucMill).Problems).Code);
        Assert.Empty(Bench.Read("G187 P1\n", dialect).Problems);
    }

    [Theory]
    [InlineData("{ \"name\": \"m\", \"like\": \"fanuc\", \"description\": \"d\",\n  \"setings\": {} }", "unknown-key $.setings 2:3")]
    [InlineData("{ \"name\": \"m\", \"like\": \"fanuc\", \"description\": 5 }", "wrong-type $.description 1:48")]
    [InlineData("{ \"name\": \"m\", \"like\": \"fanuc\" }", "missing-key $ 1:1")]
    [InlineData("{ \"name\": \"m\", \"description\": \"d\" }", "missing-key $ 1:1")]
    [InlineData("{ \"name\": \"m\", \"like\": \"fanuk\",\n \"description\": \"d\" }", "unknown-like $.like 1:24")]
    [InlineData("{ \"name\": \"m\",\n  \"like\": \"gone.json\", \"description\": \"d\" }", "unknown-like $.like 2:11")]
    [InlineData("{ \"name\": \"m\", \"like\": \"our-mill.json\", \"description\": \"d\" }", "circular-like $.like 1:24")]
    [InlineData("{ \"name\": \"fanuc\", \"like\": \"fanuc\", \"description\": \"d\" }", "name-taken $.name 1:11")]
    [InlineData(
        "{ \"name\": \"m\", \"like\": \"fanuc\", \"description\": \"d\", \"codes\": [\n  { \"codes\": \"G1000\", \"means\": \"line\", "
            + "\"statement\": \"s\", \"source\": \"our tests\" } ] }",
        "bad-subject $.codes[0].codes 2:14")]
    [InlineData(
        "{ \"name\": \"m\", \"like\": \"fanuc\", \"description\": \"d\", \"codes\": [\n  { \"codes\": \"G59..G54\", \"means\": \"line\", "
            + "\"statement\": \"s\", \"source\": \"our tests\" } ] }",
        "bad-subject $.codes[0].codes 2:14")]
    [InlineData(
        "{ \"name\": \"m\", \"like\": \"fanuc\", \"description\": \"d\", \"codes\": [\n  { \"codes\": \"G5 g6\", \"means\": \"line\", "
            + "\"statement\": \"s\", \"source\": \"our tests\" } ] }",
        "bad-subject $.codes[0].codes 2:14")]
    [InlineData(
        "{ \"name\": \"m\", \"like\": \"fanuc\", \"description\": \"d\", \"codes\": [\n  { \"codes\": \"G5\", \"means\": \"lyne\", "
            + "\"statement\": \"s\", \"source\": \"our tests\" } ] }",
        "not-one-of $.codes[0].means 2:29")]
    [InlineData(
        "{ \"name\": \"m\", \"like\": \"fanuc\", \"description\": \"d\", \"codes\": [\n  { \"codes\": \"G5\", \"means\": \"line\", "
            + "\"statement\": \"s\" } ] }",
        "missing-key $.codes[0] 2:3")]
    [InlineData(
        "{ \"name\": \"m\", \"like\": \"fanuc\", \"description\": \"d\", \"codes\": [\n  { \"codes\": \"G5 G5\", \"means\": \"line\", "
            + "\"statement\": \"s\", \"source\": \"our tests\" } ] }",
        "stated-twice $.codes[0].codes 2:14")]
    [InlineData(
        "{ \"name\": \"m\", \"like\": \"fanuc\", \"description\": \"d\", \"letters\": [\n  { \"letters\": \"x\", \"role\": \"axis\", "
            + "\"statement\": \"s\", \"source\": \"our tests\" } ] }",
        "bad-subject $.letters[0].letters 2:16")]
    [InlineData(
        "{ \"name\": \"m\", \"like\": \"fanuc\", \"description\": \"d\", \"functions\": [\n  { \"functions\": \"M10000\", \"role\": "
            + "\"call\", \"statement\": \"s\", \"source\": \"our tests\" } ] }",
        "bad-subject $.functions[0].functions 2:18")]
    [InlineData(
        "{ \"name\": \"m\", \"like\": \"fanuc\", \"description\": \"d\", \"settings\": {\n  \"metricDecimals\": { \"value\": 2.5, "
            + "\"statement\": \"s\", \"source\": \"our tests\" } } }",
        "wrong-type $.settings.metricDecimals.value 2:32")]
    [InlineData(
        "{ \"name\": \"m\", \"like\": \"fanuc\", \"description\": \"d\", \"settings\": {\n  \"metricDecimals\": { \"value\": 12, "
            + "\"statement\": \"s\", \"source\": \"our tests\" } } }",
        "too-large $.settings.metricDecimals.value 2:32")]
    [InlineData("{ \"name\": \"m\", \"like\": \"fanuc\",\n \"description\": \"d\"", "not-json $ 2:20")]
    [InlineData("", "empty-document $ 1:1")]
    public void What_is_wrong_in_a_file_is_named_by_path_line_and_column(string text, string problem) =>
        Assert.Equal(problem, OwnDialect.Problem(text));

    [Fact]
    public void A_file_over_one_mebibyte_is_refused() =>
        Assert.Equal("too-big $ 1:1", OwnDialect.Problem(new string(' ', 1024 * 1024) + "{}"));

    [Fact]
    public void Files_may_continue_files_from_their_own_folder()
    {
        var folder = Directory.CreateTempSubdirectory("errormatch-").FullName;
        try
        {
            Directory.CreateDirectory(Path.Combine(folder, "base"));
            var (own, shared) = (Path.Combine(folder, "own.json"), Path.Combine(folder, "base", "shared.json"));
            File.WriteAllText(own, """{ "name": "own", "like": "base/shared.json", "description": "d" }""");
            File.WriteAllText(shared, """{ "name": "shared", "like": "linuxcnc", "description": "d" """ + Increments + "}");
            var dialect = NcDialects.Read(own);
            Assert.True(dialect.IntegersAreIncrements);
            Assert.Equal(NcMeaning.AbsoluteCenters, dialect.MeaningOf(901));
            Assert.Equal([own, shared], dialect.Files.Select(f => f.File));
            Assert.All(dialect.Files, f => Assert.Equal(Convert.ToHexStringLower(SHA256.HashData(File.ReadAllBytes(f.File))), f.Sha256));

            File.WriteAllText(shared, """{ "name": "shared", "like": "../own.json", "description": "d" }""");
            var circle = Assert.Throws<InputException>(() => NcDialects.Read(own));
            Assert.Equal((shared, "circular-like", "$.like"), (circle.File, circle.Refusals[0].Code, circle.Refusals[0].Place.Path));

            File.WriteAllText(shared, "{");
            Assert.Equal(shared, Assert.Throws<InputException>(() => NcDialects.Read(own)).File);
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }

    [Fact]
    public void A_damaged_file_reads_or_is_refused_in_the_one_way()
    {
        var alphabet = "{}[]\",:\\ \n\0ujGM..01234599999eE+-truefalsnl/*\u00ff"u8.ToArray();
        var edits = Gen.Choose(0, Siemens.Value.Length - 1)
            .Zip(Gen.Elements(alphabet))
            .ArrayOf(3)
            .Zip(Gen.Choose(0, 4 * Siemens.Value.Length));
        var (read, refused) = (0, 0);
        Check.One(Config.QuickThrowOnFailure.WithMaxTest(400), Prop.ForAll(edits.ToArbitrary(), e =>
        {
            var bytes = Siemens.Value.ToArray();
            foreach (var (at, value) in e.Item1)
            {
                bytes[at] = value;
            }

            try
            {
                _ = NcDialects.Parse(bytes.AsSpan(0, Math.Min(e.Item2, bytes.Length)), "our-mill.json").Facts;
                read++;
            }
            catch (InputException problem)
            {
                Assert.NotEmpty(problem.Refusals);
                refused++;
            }

            return true;
        }));
        Assert.True(read > 20 && refused > 100, string.Create(CultureInfo.InvariantCulture, $"{read} read, {refused} refused"));
    }
}
