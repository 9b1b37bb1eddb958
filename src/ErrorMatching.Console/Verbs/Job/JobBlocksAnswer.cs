using System.Globalization;
using System.Text.Json;
using ErrorMatching.Jobs;
using ErrorMatching.Reporting;

namespace ErrorMatching.Console;

/// <summary>The blocks that appear to cut the features of a job.</summary>
/// <param name="found">The result of the search.</param>
/// <param name="written">The job that was written; null if none was.</param>
internal sealed class JobBlocksAnswer(FoundBlocks found, string? written) : DocumentAnswer
{
    public override string Schema => "errormatch/job-blocks/1";

    public override Failure? Failure => found.Refusals is { Count: > 0 } refusals ? new(ExitCode.Refused, refusals) : null;

    public override void WriteJson(Utf8JsonWriter json)
    {
        json.WriteString("job", found.Job.File);
        json.WriteString("program", found.Program);
        json.WriteString("dialect", found.Path.Dialect.Name);
        json.WriteStartArray("features");
        foreach (var proposed in found.Features)
        {
            var feature = found.Job.Features[proposed.Feature];
            json.WriteStartObject();
            json.WriteString("name", feature.Name);
            json.WriteString("kind", feature.Kind.Word);
            Texts("points", feature.Points);
            Texts("blocks", proposed.Blocks);
            json.WriteStartArray("passes");
            foreach (var pass in proposed.Passes)
            {
                json.WriteStartObject();
                End("first", pass.First);
                End("last", pass.Last);
                json.WriteEndObject();
            }

            json.WriteEndArray();
            Texts("inJob", feature.Blocks);
            json.WriteBoolean("sameAsInJob", found.IsInJob(proposed.Feature));
            json.WriteString("code", proposed.Refusal?.Code);
            json.WriteString("reason", proposed.Refusal?.Message);
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteString("written", written);
        if (Failure is { } failure)
        {
            OutcomeWriter.WriteErrors(json, failure);
        }

        void Texts(string name, IReadOnlyList<string> texts)
        {
            json.WriteStartArray(name);
            foreach (var text in texts)
            {
                json.WriteStringValue(text);
            }

            json.WriteEndArray();
        }

        void End(string name, int block)
        {
            json.WriteStartObject(name);
            json.WriteString("block", found.Path.Program.NumberOf(found.Path.Program[block]));
            json.WriteNumber("line", found.Path.Program[block].Line);
            json.WriteEndObject();
        }
    }

    public override void WriteText(Page page)
    {
        var count = found.Features.Count(f => f.Refusal is null);
        page.Heading(string.Create(
            CultureInfo.InvariantCulture,
            $"{found.Job.Name}: blocks of {count} of {ReportNumber.Count(found.Features.Count, "feature")} found "
                + $"in {found.Program} by their key points"));
        page.Line();
        page.Table(
            ["feature", "kind", "points", "blocks", "lines", "in the job"],
            found.Features.Select(f => (IReadOnlyList<string>)
            [
                f.Name,
                found.Job.Features[f.Feature].Kind.Word,
                found.Job.Features[f.Feature].Points.Count.ToString(CultureInfo.InvariantCulture),
                f.Blocks.Count > 0 ? string.Join(", ", f.Blocks) : "not found",
                string.Join(", ", f.Passes.Select(p => Lines(p.First, p.Last))),
                found.Job.Features[f.Feature].Blocks is not { Count: > 0 } named
                    ? "none"
                    : found.IsInJob(f.Feature)
                    ? "the same"
                    : string.Join(", ", named),
            ]));
        page.Line();
        if (count > 0)
        {
            page.Line("A proposal by the distances of the points: look at the blocks before you use them, by errormatch nc locate.");
        }

        page.Line(written is not null ? $"Wrote {written}. Next: errormatch job check {written}"
            : count < found.Features.Count ? "Nothing was written: a job needs blocks for each of its features."
            : "Nothing was written. Add --out FILE to write the job with these blocks.");
    }

    private string Lines(int first, int last)
    {
        var (from, to) = (found.Path.Program[first].Line, found.Path.Program[last].Line);
        return from == to ? from.ToString(CultureInfo.InvariantCulture) : string.Create(CultureInfo.InvariantCulture, $"{from}..{to}");
    }
}
