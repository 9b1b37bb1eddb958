using System.Globalization;
using System.Text.Json;
using ErrorMatching.Jobs;
using ErrorMatching.Mating;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Console;

/// <summary>The content of a valid job.</summary>
internal sealed class JobCheckAnswer(MatingJob job) : DocumentAnswer
{
    private readonly IReadOnlyList<Refusal> _warnings = [
        .. GaugeCapability.ItemsOf(job), .. MissingMeasured.ItemOf(job) is { } measured ? [measured] : Array.Empty<Refusal>()];

    public override string Schema => "errormatch/job-check/1";

    public override void WriteJson(Utf8JsonWriter json)
    {
        json.WriteString("file", job.File);
        json.WriteString("sha256", job.Sha256);
        json.WriteBoolean("valid", true);
        json.WriteStartObject("summary");
        json.WriteString("kind", "mating");
        json.WriteString("name", job.Name);
        json.WriteString("workOrder", job.WorkOrder);
        json.WriteNumber("keyPoints", job.KeyPoints.Count);
        json.WriteString("dialect", job.Counterpart.Dialect);
        json.WriteString("from", ReportWords.Of(job.Compensation.From));
        json.WriteString("amount", ReportWords.Of(job.Compensation.Amount));
        json.WriteString("along", ReportWords.Of(job.Compensation.Along));
        json.WriteString("rule", ReportWords.Of(job.Rule));
        if (job.Rule.RiskPercent is { } risk)
        {
            json.WriteNumber("riskPercent", risk);
        }

        json.WriteStartArray("features");
        foreach (var feature in job.Features)
        {
            json.WriteStartObject();
            json.WriteString("name", feature.Name);
            json.WriteString("kind", feature.Kind.Word);
            json.WriteNumber("points", feature.Points.Count);
            json.Numbers("toleranceMm", [feature.Tolerance.Band.LowerMm, feature.Tolerance.Band.UpperMm]);
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteEndObject();
        new NamedFiles(Files).WriteJson(json);
        json.WriteStartArray("warnings");
        foreach (var warning in _warnings)
        {
            OutcomeWriter.Write(json, warning);
        }

        json.WriteEndArray();
    }

    public override void WriteText(Page page)
    {
        page.Heading($"{job.File} is a valid mating job: {job.Name}");
        page.Line();
        page.Table(
            ["feature", "kind", "points", "lower", "upper", "blocks"],
            job.Features.Select(f => (IReadOnlyList<string>)
            [
                f.Name, f.Kind.Word, f.Points.Count.ToString(CultureInfo.InvariantCulture), Show.Mm(f.Tolerance.Band.LowerMm),
                Show.Mm(f.Tolerance.Band.UpperMm), string.Join(", ", f.Blocks),
            ]));
        page.Line();
        page.Line(
            $"Compensation from the {ReportWords.Of(job.Compensation.From)}, {ReportWords.Of(job.Compensation.Amount)} deviation along "
                + $"the {ReportWords.Of(job.Compensation.Along)}, dialect {job.Counterpart.Dialect}.");
        page.Line();
        new NamedFiles(Files).WriteText(page);
        foreach (var warning in _warnings)
        {
            page.Warning(warning.Sentence);
        }
    }

    private IEnumerable<(string Role, string File)> Files => new (string Role, string? File)[]
    {
        ("theoretical", job.Part.Theoretical),
        ("part", job.Part.Measured),
        ("counterpart", job.Counterpart.Measured),
        ("program", job.Counterpart.Program),
        ("dialect", NcDialects.IsFile(job.Counterpart.Dialect) ? job.Counterpart.Dialect : null),
    }.Where(f => f.File is not null).Select(f => (f.Role, job.PathOf(f.File!)));
}
