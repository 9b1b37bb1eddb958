using System.Text;
using System.Text.Json.Nodes;
using ErrorMatching.Json;
using ErrorMatching.Mating;
using ErrorMatching.Testing;
using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Jobs.Tests;

/// <summary>A draft that is written and read again is the same draft, and a job that goes through one gives the same answer.</summary>
public sealed class MatingDraftFilesTests
{
    [Fact]
    public void A_draft_comes_back_from_its_files_as_it_was() => Prop.ForAll<int>(seed =>
    {
        var draft = RandomDraft.Of(seed);
        var (job, theoretical) = (MatingDraftFiles.Job(draft), MatingDraftFiles.Theoretical(draft));
        Assert.Equal(
            "", string.Join('\n', MatingDraftCheck.Run(draft, "job.json").Problems.Where(p => p.Field != DraftPaths.Program)));
        var read = MatingDraftFiles.Read(job, "job.json", theoretical);
        Assert.Equal(Encoding.UTF8.GetString(job), Encoding.UTF8.GetString(MatingDraftFiles.Job(read)));
        Assert.Equal(theoretical, MatingDraftFiles.Theoretical(read));
        Assert.All(
            draft.Features.Zip(read.Features),
            f => Assert.Equal((f.First.Name, f.First.Blocks, f.First.Kind), (f.Second.Name, f.Second.Blocks, f.Second.Kind)));
    }).QuickCheckThrowOnFailure();

    [Theory]
    [InlineData("complex-mating")]
    [InlineData("curve-mating")]
    [InlineData("circle-mating")]
    [InlineData("slot-mating")]
    public void A_job_that_went_through_a_draft_gives_the_same_report(string sample)
    {
        using var folder = new TemporaryFolder();
        foreach (var file in Directory.EnumerateFiles(Repository.PathTo("samples", sample)))
        {
            File.Copy(file, folder[Path.GetFileName(file)]);
        }

        var job = folder["job.json"];
        var before = Report(job);
        var draft = MatingDraftFiles.Open(job);
        Assert.Empty(MatingDraftCheck.Run(draft, job).Problems);
        File.WriteAllBytes(job, MatingDraftFiles.Job(draft));
        File.WriteAllBytes(folder["theoretical.csv"], MatingDraftFiles.Theoretical(draft));
        Assert.Equal(before, Report(job));
        Assert.True(draft.IsSame(MatingDraftFiles.Open(job)));
    }

    // Two jobs with all keys that there are: some exclude each other.
    public static TheoryData<string> Every => [
        """
        {
          "$schema": "mating.schema.json",
          "kind": "mating",
          "name": "42",
          "workOrder": "7",
          "part": { "theoretical": "theoretical.csv", "measured": "part.csv" },
          "gauge": {
            "format": { "delimiter": "\t", "decimalComma": true, "point": " P ", "none": null, "some": [null, ""] },
            "labels": ["5..8", "1..4"],
            "uncertaintyMm": [{ "name": "probing", "valueMm": 0.00060 }, { "name": "temperature", "valueMm": 2e-3, "shared": true }],
            "reports": "stylus-center",
            "stylusDiameterMm": 2.0,
            "measuring": { "probingSpeedMmPerS": 10, "probingDistanceMm": 5.0, "calculatingS": 1, "touches": 14 },
            "acceptCoarse": true
          },
          "alignment": { "kind": "datum", "origin": "1", "direction": "2" },
          "originCheck": { "point": "O", "limitMm": 0.010 },
          "without": ["9"],
          "commonMotionMm": 0.1,
          "features": [
            { "name": "L1", "kind": "line", "points": ["1", "2"], "method": "ols", "blocks": ["N120"], "toleranceMm": "chain:rss",
              "toleranceFrom": "Profile.1; #27", "gapMm": 0.02, "base": "correct", "formMm": 0.004, "plane": "ZX" },
            { "name": "C1", "kind": "curve", "points": ["3..8"], "degree": "auto", "ridge": 0.50, "blocks": ["/N12, 3/", "N140"], "toleranceMm": [-0.050, 0.05] }
          ],
          "counterpart": {
            "program": "counterpart.nc", "dialect": "fanuc", "toolDiameterMm": 6, "measured": "counterpart.csv",
            "frame": { "mirror": "x", "rotateDeg": -12.50, "translateMm": [-80, 0.0] },
            "blockSkip": "off", "assume": { "#100": 1, "R5": -2.5 }, "programSha256": "DC8F8E7B5A36B9CECEFFD0B105719187765D9B06B4E45CB20FDC2A1F2048F967",
            "libraries": ["../macros; more", "probing"], "mapMm": 0.5
          },
          "compensation": { "from": "part", "gain": 1.0, "amount": "excess", "along": "vector", "limitMm": 1.0 },
          "correction": { "allow": ["tool-wear", "blocks"], "otherCuts": "may-move", "withinMm": 0.002, "firstVariable": 501, "programNumber": 9001, "tool": 1, "radiusOffset": 2, "stepMm": 0.05, "totalMm": 0.2, "stepDegrees": 0.02, "totalDegrees": 0.08 },
          "decision": { "rule": "guard-band", "riskPercent": 2.50 },
          "toleranceChain": [{ "name": "housing", "nominalMm": 17.50, "toleranceMm": [-0.02, 0.03], "sign": -1 }],
          "recognition": { "part": [{ "in": "header", "name": "h", "pattern": "^part " }], "counterpart": [{ "in": "column", "name": " x ", "pattern": "c" }] },
          "verify": [{ "name": "C1", "quantity": "deviation-x", "points": ["a,b", "3..5"] }, { "name": "L1-C1", "quantity": "angle", "between": ["L1", "L2L3/1"] }]
        }
        """,
        """
        {
          "verify": [{ "points": ["1"], "quantity": "deviation", "name": "a" }],
          "kind": "mating", "name": "other order", "part": { "measured": "part.csv", "theoretical": "theoretical.csv" },
          "gauge": { "uncertaintyMm": 0.0020, "format": "points", "labels": "PNT{n}" },
          "alignment": { "locked": ["rotation", "x"], "kind": "best-fit" },
          "features": [
            { "kind": "circle", "method": "inscribed", "name": "C", "points": ["1..4"], "blocks": ["N1"], "toleranceMm": "chain:worst-case" },
            { "kind": "slot", "name": "S", "points": [["5", "6"], ["7"], ["8"], []], "blocks": ["N2"], "toleranceMm": [0, 0] },
            { "kind": "triangle", "name": "T", "points": [["O"], ["9"]], "blocks": ["N3"], "toleranceMm": [0, 0] }
          ],
          "counterpart": { "program": "p.nc", "dialect": "fanuc", "toolDiameterMm": 6, "frame": {} },
          "compensation": {}, "decision": { "rule": "simple" }
        }
        """];

    // What a station cannot edit has effects nevertheless: a gap that is lost is a piece that does not fit.
    [Theory]
    [MemberData(nameof(Every))]
    public void Every_key_of_a_job_comes_back_with_its_spelling(string job)
    {
        var draft = MatingDraftFiles.Read(Encoding.UTF8.GetBytes(job), "job.json", Encoding.UTF8.GetBytes(Points));
        Assert.Equal(Plain(job), Plain(Encoding.UTF8.GetString(MatingDraftFiles.Job(draft))));

        // So it does when something else is typed, and typed back.
        var typed = draft.With("$.name", "other ").With("$.name", draft.Name).WithFeature(0, f => f with { Blocks = "N7, " });
        typed = typed.WithFeature(0, f => f with { Blocks = draft.Features[0].Blocks });
        Assert.True(draft.IsSame(typed));
    }

    [Fact]
    public void The_jobs_with_every_key_have_every_key() =>
        Assert.Equal(
            KeysOf(MatingJob.Schema.Root, "$").Order(StringComparer.Ordinal),
            Every.SelectMany(row => KeysOf(JsonNode.Parse(row.Data)!, "$"))
                .Where(k => !k.StartsWith("$.gauge.format.", StringComparison.Ordinal)
                    && !k.StartsWith("$.counterpart.assume.", StringComparison.Ordinal))
                .Distinct()
                .Order(StringComparer.Ordinal));

    [Theory]
    [InlineData("$.name", "Housing ", "  \"name\": \"Housing\",")]
    [InlineData("$.name", "12", "  \"name\": \"12\",")]
    [InlineData("$.name", "", "  \"name\": \"\",")]
    [InlineData("$.workOrder", " ", null)]
    [InlineData("$.counterpart.toolDiameterMm", "06.", "\"toolDiameterMm\": 6,")]
    [InlineData("$.counterpart.toolDiameterMm", "6 mm", "\"toolDiameterMm\": \"6 mm\",")]
    [InlineData("$.counterpart.toolDiameterMm", "", "\"toolDiameterMm\": \"\",")]
    [InlineData("$.counterpart.frame.translateMm[1]", "+.50", "\"translateMm\": [0, 0.50]")]
    [InlineData("$.features[0].blocks", "N120, ", "\"blocks\": [\"N120\"],")]
    [InlineData("$.features[0].blocks", "N120 N121..N130", "\"blocks\": [\"N120\", \"N121..N130\"],")]
    [InlineData("$.features[2].degree", "2", "\"degree\": 2,")]
    [InlineData("$.originCheck.point", "O", "  \"originCheck\": { \"point\": \"O\", \"limitMm\": \"\" },")]
    public void A_text_is_kept_as_typed_and_written_as_it_is_meant(string path, string typed, string? written)
    {
        var draft = MatingDraftFiles.Open(Repository.PathTo("samples", "complex-mating", "job.json")).With(path, typed);
        Assert.Equal(typed, draft[path]);
        var job = Encoding.UTF8.GetString(MatingDraftFiles.Job(draft));
        Assert.Contains(written ?? "{", job, StringComparison.Ordinal);
        var key = path[(path.LastIndexOf('.') + 1)..].Split('[')[0];
        Assert.Equal(written is not null, job.Contains($"\"{key}\"", StringComparison.Ordinal));
    }

    [Fact]
    public void Keys_of_another_choice_are_not_written_and_are_there_when_it_is_chosen_again()
    {
        var draft = MatingDraftFiles.Open(Repository.PathTo("samples", "complex-mating", "job.json"))
            .With("$.alignment.kind", "datum")
            .With("$.alignment.origin", "1")
            .With("$.alignment.direction", "2");
        var none = draft.With("$.alignment.kind", "none");
        Assert.Contains("\"alignment\": { \"kind\": \"none\" },", Written(none), StringComparison.Ordinal);
        Assert.Equal(Written(draft), Written(none.With("$.alignment.kind", "datum")));

        // What a new item needs is written without its texts, so that the job's reader says at which fields they are missing.
        var added = draft.WithItem("$.toleranceChain").WithItem("$.verify");
        Assert.Contains(
            """{ "name": "", "nominalMm": "", "toleranceMm": ["", ""], "sign": 1 }""", Written(added), StringComparison.Ordinal);
        Assert.Contains("""{ "name": "", "quantity": "angle", "between": [] }""", Written(added), StringComparison.Ordinal);
        Assert.Equal(Written(draft), Written(added.WithoutItem("$.toleranceChain", 0).WithoutItem("$.verify", 2)));

        static string Written(MatingDraft draft) => Encoding.UTF8.GetString(MatingDraftFiles.Job(draft));
    }

    [Fact]
    public void A_column_that_a_draft_has_no_field_for_is_refused()
    {
        var job = File.ReadAllBytes(Repository.PathTo("samples", "complex-mating", "job.json"));
        var theoretical = File.ReadAllText(Repository.PathTo(
            "samples", "complex-mating", "theoretical.csv")).Replace("\n", ",note\n", StringComparison.Ordinal);
        Assert.Equal(
            "$.part.theoretical",
            Assert.Throws<DraftException>(() => MatingDraftFiles.Read(job, "job.json", Encoding.UTF8.GetBytes(theoretical))).Path);
    }

    [Fact]
    public void Comments_are_seen()
    {
        Assert.True(MatingDraftFiles.HasComments(File.ReadAllBytes(Repository.PathTo("samples", "complex-mating", "job.json"))));
        Assert.False(MatingDraftFiles.HasComments(MatingDraftFiles.Job(RandomDraft.Of(1))));
    }

    private const string Points = "point,x_mm,y_mm\n1,0,0\n2,1,0\n3,2,0\n4,3,0\n5,4,0\n6,5,0\n7,6,0\n8,7,0\n9,8,0\nO,9,0\n";

    // Without spaces outside of texts, and with ranges of labels as single ones.
    private static string Plain(string job) => JsonNode.Parse(job)!.ToJsonString()
        .Replace("\"points\":[\"3..8\"]", """
            "points":["3","4","5","6","7","8"]
            """, StringComparison.Ordinal)
        .Replace("\"points\":[\"1..4\"]", """
            "points":["1","2","3","4"]
            """, StringComparison.Ordinal);

    private static IEnumerable<string> KeysOf(SchemaPlace place, string path) => place.Keys
        .SelectMany(k => KeysOf(place.Member(k), $"{path}.{k}").Prepend($"{path}.{k}"))
        .Concat(place.TakesLists ? KeysOf(place.Item, path) : [])
        .Distinct();

    private static IEnumerable<string> KeysOf(JsonNode value, string path) => value switch
    {
        JsonObject members => members.SelectMany(m => KeysOf(m.Value!, $"{path}.{m.Key}").Prepend($"{path}.{m.Key}")),
        JsonArray items => items.SelectMany(i => KeysOf(i!, path)),
        _ => [],
    };

    // Everything but what names the job's own bytes.
    private static string Report(string job)
    {
        var outcome = MatingRun.Run(new(job), new(), TestContext.Current.CancellationToken);
        Assert.NotNull(outcome.Result);
        var report = JsonNode.Parse(outcome.Result.ReportJson())!.AsObject();
        report["job"]!.AsObject().Remove("sha256");
        foreach (var input in report["inputs"]!.AsArray().Where(i => i!["role"]!.GetValue<string>() == "theoretical"))
        {
            input!.AsObject().Remove("sha256");
        }

        return report.ToJsonString();
    }
}
