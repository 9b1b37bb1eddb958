using System.Text;
using ErrorMatching.Refusals;

namespace ErrorMatching.Mating.Tests;

/// <summary>Each way in which a job can be wrong, with its code and JSON path.</summary>
public sealed class JobCheckTests
{
    private const string Tool = "\"toolDiameterMm\": 6";

    private const string Compensation = "\"compensation\": { \"from\": \"part\" }";

    [Fact]
    public void A_free_form_job_is_one_problem_that_says_which_verb_it_belongs_to()
    {
        var error = Assert.Throws<InputException>(() => MatingJob.Parse("""{ "kind": "freeform", "surface": "s.stp" }"""u8, "job.json"));
        Assert.Equal((MatingJob.OtherKind, "$.kind", 1, 11), (error.Code, error.Place.Path, error.Place.Line, error.Place.Column));
        Assert.Contains("errormatch surface", Assert.Single(error.Refusals).Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("\"kind\": \"mating\"", "\"kind\": \"matting\"", "not-one-of", "$.kind")]
    [InlineData("\"name\": \"Complex mating\"", "\"name\": \"\"", "too-short", "$.name")]
    [InlineData("\"workOrder\": \"WO-1\"", "\"workOrder\": 1", "wrong-type", "$.workOrder")]
    [InlineData("\"theoretical\": \"theoretical.csv\", ", "", "missing-key", "$.part")]
    [InlineData("\"measured\": \"part.csv\"", "\"mesured\": \"part.csv\"", "missing-key", "$.part", "unknown-key", "$.part.mesured")]
    [InlineData("0.002", "-0.002", "too-small", "$.gauge.uncertaintyMm")]
    [InlineData("0.002", "[{ \"name\": \"a\" }]", "missing-key", "$.gauge.uncertaintyMm[0]")]
    [InlineData("0.002", "\"2 µm\"", "wrong-type", "$.gauge.uncertaintyMm")]
    [InlineData("0.002", "0.002, \"stylusDiameterMm\": 0", "too-small", "$.gauge.stylusDiameterMm")]
    [InlineData("0.002", "0.002, \"reports\": \"stylus\"", "not-one-of", "$.gauge.reports")]
    [InlineData("0.002", "0.002, \"measuring\": { \"probingSpeedMmPerS\": 0 }", "too-small", "$.gauge.measuring.probingSpeedMmPerS")]
    [InlineData("{ \"kind\": \"none\" }", "{ \"kind\": \"best\" }", "not-one-of", "$.alignment.kind")]
    [InlineData("{ \"kind\": \"none\" }", "{ \"kind\": \"none\", \"origin\": \"1\" }", "unknown-key", "$.alignment.origin")]
    [InlineData("{ \"kind\": \"none\" }", "{ \"kind\": \"datum\", \"origin\": \"1\" }", "missing-key", "$.alignment")]
    [InlineData("{ \"kind\": \"none\" }", "{ \"kind\": \"best-fit\", \"locked\": [\"z\"] }", "not-one-of", "$.alignment.locked[0]")]
    [InlineData(
        "{ \"kind\": \"none\" }",
        "{ \"kind\": \"none\" }, \"originCheck\": { \"point\": \"O\", \"limitMm\": 0 }",
        "too-small",
        "$.originCheck.limitMm")]
    [InlineData("\"kind\": \"curve\"", "\"kind\": \"arc\"", "not-one-of", "$.features[2].kind")]
    [InlineData("\"name\": \"L1\"", "\"name\": \"L/1\"", "pattern-mismatch", "$.features[0].name")]
    [InlineData("\"name\": \"C1\"", "\"name\": \"C1\", \"degree\": 1.5", "not-one-of", "$.features[2].degree")]
    [InlineData("\"name\": \"C1\"", "\"name\": \"C1\", \"ridge\": -1", "too-small", "$.features[2].ridge")]
    [InlineData("\"name\": \"L1\"", "\"name\": \"L1\", \"degree\": 1", "unknown-key", "$.features[0].degree")]
    [InlineData("\"name\": \"L1\"", "\"name\": \"L1\", \"plane\": \"XZ\"", "not-one-of", "$.features[0].plane")]
    [InlineData("\"name\": \"L1\"", "\"name\": \"L1\", \"method\": \"lad\"", "not-one-of", "$.features[0].method")]
    [InlineData(
        "[[\"2a\", \"3a\"], [\"3b\", \"4\"]]",
        "[\"2a\", \"3a\", \"3b\", \"4\"]",
        "too-many-items",
        "$.features[1].points",
        "wrong-type",
        "$.features[1].points[0]",
        "wrong-type",
        "$.features[1].points[1]",
        "wrong-type",
        "$.features[1].points[2]",
        "wrong-type",
        "$.features[1].points[3]")]
    [InlineData("\"N100\"", "\"100\"", "pattern-mismatch", "$.features[0].blocks[0]")]
    [InlineData("\"N110..N130\"", "\"N110-N130\"", "pattern-mismatch", "$.features[1].blocks[0]")]
    [InlineData("[\"N100\"]", "[]", "too-few-items", "$.features[0].blocks")]
    [InlineData("[-0.04, 0.06]", "[-0.04]", "too-few-items", "$.features[1].toleranceMm")]
    [InlineData("[-0.04, 0.06]", "\"chain\"", "not-one-of", "$.features[1].toleranceMm")]
    [InlineData("\"toolDiameterMm\": 6", "\"toolDiameterMm\": -6", "too-small", "$.counterpart.toolDiameterMm")]
    [InlineData("\"toolDiameterMm\": 6", "\"toolDiameterMm\": 6, \"mapMm\": 0", "too-small", "$.counterpart.mapMm")]
    [InlineData("\"mirror\": \"none\"", "\"mirror\": \"z\"", "not-one-of", "$.counterpart.frame.mirror")]
    [InlineData("[-80, 0]", "[-80, 0, 0]", "too-many-items", "$.counterpart.frame.translateMm")]
    [InlineData("\"from\": \"part\"", "\"from\": \"gauge\"", "not-one-of", "$.compensation.from")]
    [InlineData("\"from\": \"part\"", "\"gain\": 0", "too-small", "$.compensation.gain")]
    [InlineData("\"from\": \"part\"", "\"gain\": 2.01", "too-large", "$.compensation.gain")]
    [InlineData("\"from\": \"part\"", "\"amount\": \"half\"", "not-one-of", "$.compensation.amount")]
    [InlineData("\"from\": \"part\"", "\"along\": \"x\"", "not-one-of", "$.compensation.along")]
    [InlineData("\"from\": \"part\"", "\"limitMm\": 0", "too-small", "$.compensation.limitMm")]
    [InlineData(
        Compensation,
        "\"toleranceChain\": [{ \"name\": \"a\", \"nominalMm\": 1, \"toleranceMm\": [0, 1], \"sign\": 0 }]",
        "not-one-of",
        "$.toleranceChain[0].sign")]
    [InlineData(
        Compensation, "\"recognition\": { \"part\": [{ \"in\": \"file-name\", \"pattern\": \"p\" }] }", "missing-key", "$.recognition")]
    [InlineData(
        Compensation,
        "\"recognition\": { \"part\": [{ \"in\": \"name\", \"pattern\": \"p\" }], \"counterpart\": [{ \"in\": \"header\", \"pattern\": "
            + "\"p\" }] }",
        "not-one-of",
        "$.recognition.part[0].in",
        "missing-key",
        "$.recognition.counterpart[0]")]
    [InlineData(
        Compensation,
        "\"verify\": [{ \"name\": \"a\", \"quantity\": \"width\", \"points\": [\"1\"] }]",
        "not-one-of",
        "$.verify[0].quantity")]
    [InlineData(
        Compensation,
        "\"verify\": [{ \"name\": \"a\", \"quantity\": \"angle\", \"between\": [\"L1\"] }]",
        "too-few-items",
        "$.verify[0].between")]
    public void A_job_that_breaks_the_schema_is_refused_by_path(string found, string instead, params string[] codesAndPaths) =>
        Refuses(found, instead, codesAndPaths);

    [Theory]
    [InlineData("\"blocks\": [\"N100\"], ", "")]
    [InlineData("[\"N100\"]", "[]")]
    [InlineData("\"blocks\": [\"N110..N130\"], ", "")]
    [InlineData("\"blocks\": [\"/^N8[0-9]{3}\\\\b/\"], ", "")]
    public void Only_blocks_that_are_still_sought_may_be_missing(string found, string instead)
    {
        Assert.Contains(found, SampleJob.Text, StringComparison.Ordinal);
        var text = Encoding.UTF8.GetBytes(SampleJob.Text.Replace(found, instead, StringComparison.Ordinal));
        Assert.Throws<InputException>(() => MatingJob.Parse(text, "job.json"));
        var job = MatingJob.ParseWithoutBlocks(text, "job.json");
        Assert.Empty(Assert.Single(job.Features, f => f.Blocks.Count == 0).Blocks);
        Assert.Equal(["1", "2"], job.Features[0].Points);

        // What else is wrong is said, with the place where it stands.
        var wrong = Encoding.UTF8.GetBytes(
            SampleJob.Text.Replace(found, instead, StringComparison.Ordinal).Replace("[-0.04, 0.06]", "[0.06]", StringComparison.Ordinal));
        Assert.Equal(
            ("too-few-items", "$.features[1].toleranceMm"),
            Assert.Single(Assert.Throws<InputException>(() => MatingJob.ParseWithoutBlocks(wrong, "job.json")).Refusals) is var p
                ? (p.Code, p.Place.Path)
                : default);
    }

    [Theory]
    [InlineData("\"name\": \"C1\"", "\"name\": \"L1\"", "duplicate-name", "$.features[2].name")]
    [InlineData("[-0.04, 0.06]", "[0.06, -0.04]", "reversed-tolerance", "$.features[1].toleranceMm")]
    [InlineData("[\"1\", \"2\"]", "[\"1\"]", "too-few-points", "$.features[0].points")]
    [InlineData("[\"2a\", \"3a\"]", "[\"2a\"]", "too-few-points", "$.features[1].points[0]")]
    [InlineData("[\"3b\", \"4\"]", "[\"4\"]", "too-few-points", "$.features[1].points[1]")]
    [InlineData("\"5..14\"", "\"5..6\"", "too-few-points", "$.features[2].points")]
    [InlineData("\"5..14\"", "\"4..14\"", "duplicate-point", "$.features[2].points[0]")]
    [InlineData("[\"1\", \"2\"]", "[\"1\", \"1\", \"2\"]", "duplicate-point", "$.features[0].points[1]")]
    [InlineData("\"5..14\"", "\"14..5\"", "bad-range", "$.features[2].points[0]", "too-few-points", "$.features[2].points")]
    [InlineData("\"name\": \"C1\"", "\"name\": \"C1\", \"degree\": 10", "degree-too-high", "$.features[2].degree")]
    [InlineData(Tool, Tool + ", \"assume\": { \"100\": 1 }", "bad-variable", "$.counterpart.assume['100']")]
    [InlineData(Tool, Tool + ", \"assume\": { \"#100\": \"x\" }", "wrong-type", "$.counterpart.assume['#100']")]
    [InlineData("/^N8[0-9]{3}\\\\b/", "/N(/", "bad-pattern", "$.features[2].blocks[0]")]
    [InlineData("/^N8[0-9]{3}\\\\b/", "/N(?=8)/", "bad-pattern", "$.features[2].blocks[0]")]
    [InlineData("[-0.04, 0.06]", "\"chain:rss\"", "chain-missing", "$.features[1].toleranceMm")]
    [InlineData("[-0.04, 0.06]", "\"chain:worst-case\"", "chain-missing", "$.features[1].toleranceMm")]
    [InlineData("\"from\": \"part\"", "\"from\": \"counterpart\"", "measured-missing", "$.counterpart")]
    [InlineData("0.002", "0.002, \"reports\": \"stylus-center\"", "stylus-diameter-missing", "$.gauge")]
    [InlineData("\"points\", \"unc", "\"pionts\", \"unc", "bad-format", "$.gauge.format")]
    [InlineData("\"points\", \"unc", "{ \"delimiter\": \"#\" }, \"unc", "bad-format", "$.gauge.format.delimiter")]
    [InlineData(
        "{ \"kind\": \"none\" }",
        "{ \"kind\": \"datum\", \"origin\": \"1\", \"direction\": \"1\" }",
        "datum-needs-two-points",
        "$.alignment.direction")]
    [InlineData(
        Compensation,
        "\"toleranceChain\": [{ \"name\": \"a\", \"nominalMm\": 1, \"toleranceMm\": [1, 0], \"sign\": 1 }]",
        "reversed-tolerance",
        "$.toleranceChain[0].toleranceMm")]
    [InlineData(
        Compensation,
        "\"recognition\": { \"part\": [{ \"in\": \"file-name\", \"pattern\": \"(\" }], \"counterpart\": [{ \"in\": \"header\", \"name\": "
            + "\"a\", \"pattern\": \"p\" }] }",
        "bad-pattern",
        "$.recognition.part[0].pattern")]
    [InlineData(
        Compensation,
        "\"verify\": [{ \"name\": \"L1\", \"quantity\": \"deviation\", \"points\": [\"1\"] }]",
        "duplicate-name",
        "$.verify[0].name")]
    [InlineData(
        Compensation,
        "\"verify\": [{ \"name\": \"a\", \"quantity\": \"deviation\", \"points\": [\"1\"] }, { \"name\": \"a\", \"quantity\": "
            + "\"deviation-x\", \"points\": [\"1\"] }]",
        "duplicate-name",
        "$.verify[1].name")]
    [InlineData(
        Compensation,
        "\"verify\": [{ \"name\": \"a\", \"quantity\": \"deviation\", \"points\": [\"1\", \"15\"] }]",
        "unknown-point",
        "$.verify[0].points[1]")]
    [InlineData(
        Compensation,
        "\"verify\": [{ \"name\": \"a\", \"quantity\": \"angle\", \"between\": [\"L1/1\", \"L2L3\"] }]",
        "unknown-element",
        "$.verify[0].between[0]",
        "unknown-element",
        "$.verify[0].between[1]")]
    [InlineData(
        Compensation,
        "\"verify\": [{ \"name\": \"a\", \"quantity\": \"angle\", \"between\": [\"L2L3/3\", \"C1\"] }]",
        "unknown-element",
        "$.verify[0].between[0]",
        "unknown-element",
        "$.verify[0].between[1]")]
    [InlineData(
        Compensation,
        "\"verify\": [{ \"name\": \"a\", \"quantity\": \"angle\", \"between\": [\"L9\", \"L2L3/2\"] }]",
        "unknown-element",
        "$.verify[0].between[0]")]
    public void A_job_that_contradicts_itself_is_refused_by_path(string found, string instead, params string[] codesAndPaths) =>
        Refuses(found, instead, codesAndPaths);

    [Fact]
    public void Limits_of_equal_size_and_a_gain_of_two_are_allowed()
    {
        var job = SampleJob.With(("[-0.04, 0.06]", "[0.01, 0.01]"), ("\"from\": \"part\"", "\"gain\": 2"));

        Assert.Equal((0.01, 2.0), (job.Features[1].Tolerance.Band.LowerMm, job.Compensation.Gain));
    }

    [Fact]
    public void A_refusal_names_file_line_column_path_and_what_to_do()
    {
        var e = Assert.Throws<InputException>(() => SampleJob.With(("\"dialect\"", "\"dialekt\"")));

        Assert.Equal("folder/job.json", e.File);
        Assert.Equal(
            "folder/job.json, line 11, column 18, $.counterpart: found no key \"dialect\"; expected the key \"dialect\".\n"
                + "folder/job.json, line 12, column 34, $.counterpart.dialekt: the key \"dialekt\" is not known here; "
                + "did you mean \"dialect\"?",
            e.Message);
    }

    [Fact]
    public void Damaged_jobs_are_never_refused_otherwise()
    {
        var original = System.Text.Encoding.UTF8.GetBytes(JobTemplate.Text);
        var random = new Random(3);
        var read = 0;
        for (var i = 0; i < 3000; i++)
        {
            var bytes = original.ToArray();
            bytes[random.Next(bytes.Length)] = (byte)random.Next(32, 127);
            try
            {
                read += MatingJob.Parse(bytes, "job.json").Features.Count > 0 ? 1 : 0;
            }
            catch (InputException e)
            {
                Assert.NotEmpty(e.Refusals);
            }
        }

        Assert.InRange(read, 1, 2999);
    }

    private static void Refuses(string found, string instead, string[] codesAndPaths)
    {
        var e = Assert.Throws<InputException>(() => SampleJob.With((found, instead)));

        Assert.Equal(codesAndPaths, e.Refusals.SelectMany(p => new[] { p.Code, p.Place.Path }));
        Assert.All(e.Refusals, p => Assert.True(p.Place.Line > 1 && p.Found.Length > 0 && p.Expected.Length > 0));
    }
}
