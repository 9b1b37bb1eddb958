using System.Text;
using ErrorMatching.Jobs;
using ErrorMatching.Json;
using ErrorMatching.Refusals;

namespace ErrorMatching.Cell;

/// <summary>Reads the configuration of a cell and checks everything that can be checked without a machine, a store or a folder.</summary>
public static class CellSettingsReader
{
    private static readonly Lazy<JsonSchema> Schema = new(() => JsonSchema.Parse(
        Encoding.UTF8.GetBytes(CellTemplate.Schema), "cell.schema.json"));

    /// <summary>Reads the configuration from a file.</summary>
    /// <param name="file">The file.</param>
    /// <exception cref="InputException">As for <see cref="Parse"/>. The file cannot be opened, or is implausibly large for a
    /// configuration.</exception>
    public static CellSettings Read(string file) => Parse(InputFile.Bytes(file, JsonLimits.Default.MaxBytes), file);

    /// <summary>Parses the configuration from bytes.</summary>
    /// <param name="bytes">JSON with comments and trailing commas allowed.</param>
    /// <param name="file">File name for messages; relative paths start at its folder. The jobs' files are read from there.</param>
    /// <exception cref="InputException">The bytes are not JSON or break the schema, the configuration contradicts itself or its
    /// jobs, or a job's file is missing or wrong. The exception lists all problems, in document order.</exception>
    public static CellSettings Parse(ReadOnlySpan<byte> bytes, string file)
    {
        var document = JsonInput.Read(bytes, file);
        var problems = new CellProblems();
        problems.RefuseControlCharacters(document);
        problems.AddRange(Schema.Value.Check(document).Where(p => p.Place.Path is not { } path || !problems.Has(path)));
        problems.ThrowIfAny(file);
        var settings = new CellReader(document, file, problems).Read();
        problems.ThrowIfAny(file);
        return settings;
    }
}

/// <summary>Builds settings from a document that conforms to the schema, and collects the errors that a schema cannot express.</summary>
internal sealed class CellReader(JsonItem root, string file, CellProblems problems)
{
    private static readonly PolicySettings Cautious = new(false, null, null, null);
    private readonly CellPaths _paths = new(file);

    public CellSettings Read()
    {
        var policy = root.Find("policy") is { } item ? ReadPolicy(item, Cautious) : Cautious;
        var gauges = new GaugeReader(root["gauges"], _paths, problems).Read();
        var machines = new MachineReader(root["machines"], _paths, problems).Read();
        var jobs = new CellJobReader(root["jobs"], _paths, problems, gauges, machines).Read(policy, i => ReadPolicy(i, policy));
        var settings = new CellSettings
        {
            File = file,
            Name = root["name"].Text,
            Store = ReadStore(root["store"]),
            KeysFolder = _paths.Of(root.Find("keys")?.Text ?? "keys"),
            WitnessFile = root.Find("witness") is { } witness ? _paths.Of(witness.Text) : null,
            LogFolder = _paths.Of(root.Find("logs")?.Text ?? "logs"),
            Gauges = [.. gauges.Select(g => g.Settings)],
            Machines = [.. machines.Select(m => m.Settings)],
            Jobs = [.. jobs.Select(j => j.Settings)],
            Policy = policy,
            SignIn = ReadSignIn(root.Find("signIn")),
            RejectionReasons = [.. (root.Find("rejectionReasons")?.Items.Select(i => i.Text) ?? []).Distinct()],
            Events = root.Find("events") is { } events ? EventReader.Read(events, _paths, problems) : null,
        };
        new FolderContradictions(root, settings, problems).Find(_paths.Of(Path.GetFileName(file)), jobs);
        new ForeignWriters(root, settings, problems).Find(_paths.Of(Path.GetFileName(file)), jobs);
        WarnOfUnused();
        return settings with { Warnings = problems.Warnings };
    }

    private static SignInWays ReadSignIn(JsonItem? item) => (item?.Items ?? []).Aggregate(
        SignInWays.Password,
        (ways, way) => ways | way.Text switch
        {
            "pin" => SignInWays.Pin,
            "badge" => SignInWays.Badge,
            _ => SignInWays.BadgeWithPin,
        });

    private StoreSettings ReadStore(JsonItem item)
    {
        StoreSettings store = item["kind"].Text == "sqlite"
            ? new SqliteSettings(_paths.Of(item.Find("file")?.Text ?? "store/cell.db"))
            : new PostgresSettings(
                item["host"].Text,
                (int)(item.Find("port")?.Number ?? 5432),
                item["database"].Text,
                item["user"].Text,
                item.Find("passwordFile") is { } secret ? _paths.Of(secret) : null)
            {
                Schema = item.Find("schema")?.Text,
            };
        return store with { Archives = item.Find("archives") is { } archives ? _paths.Of(archives) : null };
    }

    private PolicySettings ReadPolicy(JsonItem item, PolicySettings outer)
    {
        var policy = new PolicySettings(
            item.Find("approve") is { } approve ? approve.Text == "automatic" : outer.Automatic,
            item.Find("limitMm")?.Number ?? outer.LimitMm,
            item.Find("sumLimitMm")?.Number ?? outer.SumLimitMm,
            item.Find("gain")?.Number ?? outer.Gain);
        if (policy.SumLimitMm < policy.LimitMm && (item.Find("sumLimitMm") ?? item.Find("limitMm")) is { } limit)
        {
            problems.Refuse(
                limit,
                "sum-limit-too-small",
                FormattableString.Invariant(
                    $"a limit of the sum of {policy.SumLimitMm} mm, less than the {policy.LimitMm} mm of one correction"),
                "at least the limit of one correction");
        }

        return policy;
    }

    private void WarnOfUnused()
    {
        var jobs = root["jobs"].Items;
        var heard = jobs.SelectMany(j => j["gauges"].Items).Select(g => g.Text).ToHashSet(StringComparer.Ordinal);
        foreach (var name in root["gauges"].Items.Select(g => g["name"]).Where(n => !heard.Contains(n.Text)))
        {
            problems.Warn(
                name, "unused-gauge", $"the gauge \"{name.Text}\", whose files no job takes", "a job that names it among its gauges");
        }

        var taken = jobs.Select(j => (j["machine"].Text, j["slot"].Text)).ToHashSet();
        foreach (var (machine, name) in root["machines"].Items.SelectMany(m => m["slots"].Items.Select(
            s => (m["name"].Text, s["name"]))).Where(s => !taken.Contains((s.Item1, s.Item2.Text))))
        {
            problems.Warn(name, "unused-slot", $"the slot \"{name.Text}\" of {machine}, which no job uses", "a job that names it");
        }
    }
}
